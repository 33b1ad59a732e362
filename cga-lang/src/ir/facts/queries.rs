//! The queries of other shapes that a run can reach, by start rule.
//!
//! A run that asks about its own shapes (`intra`) needs a derivation before it, and a run that asks about its neighbours (`inter`) needs theirs.
//! Runs without such queries need neither, so this is known before a run begins.

use super::closure::closure;
use crate::ir::{Expr, ExprKind, Grammar, StepKind, Value, walk};
use crate::ops::Uses;
use std::ops::BitOr;

/// A set of queries of other shapes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Queries(u8);

impl Queries {
    /// No queries.
    pub const NONE: Queries = Queries(0);
    /// Occlusion queries of shapes of the same initial shape.
    pub const INTRA_OCCLUSION: Queries = Queries(1);
    /// Occlusion queries of shapes of other initial shapes.
    pub const INTER_OCCLUSION: Queries = Queries(1 << 1);
    /// Queries of labelled shapes of the same initial shape.
    pub const INTRA_CONTEXT: Queries = Queries(1 << 2);
    /// Queries of labelled shapes of other initial shapes.
    pub const INTER_CONTEXT: Queries = Queries(1 << 3);
    /// Queries of the place in the tree of shapes.
    pub const TREE_KEY: Queries = Queries(1 << 4);
    /// Labels, which queries find.
    pub const LABELS: Queries = Queries(1 << 5);

    /// The set as a number, for generated code. The runtime has the same constants.
    pub fn bits(self) -> u8 {
        self.0
    }

    /// Returns true if it has all of `other`.
    pub fn has(self, other: Queries) -> bool {
        self.0 & other.0 == other.0
    }

    /// By start rule of a grammar, the queries that a run from it can reach. Attributes and constants are evaluated in every run, so their
    /// queries count for each start rule.
    pub fn by_start(grammar: &Grammar) -> Vec<Queries> {
        let functions: Vec<Queries> =
            grammar.functions.iter().map(|it| of_exprs(it.locals.iter().chain([&it.body]))).collect();
        let calls: Vec<Vec<usize>> = grammar.functions.iter().map(walk::called_functions).collect();
        let functions = closure(&calls, &functions);
        // An expression with the functions that it calls.
        let with_calls = |expr: &Expr, found: &mut Queries| {
            *found = *found | of_part(expr);
            if let ExprKind::Call(id, ..) = &expr.kind {
                *found = *found | functions[id.0 as usize];
            }
        };
        let mut of_globals = Queries::NONE;
        for global in &grammar.globals {
            walk::parts(&global.value, &mut |part| with_calls(part, &mut of_globals));
        }
        let rules = grammar.rules.iter().map(|rule| {
            let mut found = Queries::NONE;
            walk::in_rule(rule, &mut |part| with_calls(part, &mut found));
            walk::steps(&rule.body, &mut |step| {
                if let StepKind::Do(row, _) = &step.kind
                    && row.uses.has(Uses::LABELS)
                {
                    found = found | Queries::LABELS;
                }
            });
            found
        });
        let rules = closure(&walk::calls(grammar, |_| true), &rules.collect::<Vec<_>>());
        grammar.starts.iter().map(|start| rules[start.rule.0 as usize] | of_globals).collect()
    }
}

impl BitOr for Queries {
    type Output = Queries;

    fn bitor(self, other: Queries) -> Queries {
        Queries(self.0 | other.0)
    }
}

/// The queries of expressions, without the functions that they call.
fn of_exprs<'e>(list: impl Iterator<Item = &'e Expr>) -> Queries {
    let mut found = Queries::NONE;
    list.for_each(|expr| walk::parts(expr, &mut |part| found = found | of_part(part)));
    found
}

/// The queries of an expression without its parts.
fn of_part(expr: &Expr) -> Queries {
    let (uses, target) = match &expr.kind {
        ExprKind::Builtin(row, args) => (row.uses, args.first()),
        ExprKind::Shape(row) => (row.uses, None),
        _ => return Queries::NONE,
    };
    // Targets are words, so they are constants.
    let (is_intra, is_inter) = match target.map(|target| &target.kind) {
        Some(ExprKind::Value(Value::Text(word))) => (word != "inter", word != "intra"),
        _ => (true, true),
    };
    let queries = [
        (Uses::OCCLUSION, is_intra, Queries::INTRA_OCCLUSION),
        (Uses::OCCLUSION, is_inter, Queries::INTER_OCCLUSION),
        (Uses::CONTEXT, is_intra, Queries::INTRA_CONTEXT),
        (Uses::CONTEXT, is_inter, Queries::INTER_CONTEXT),
        (Uses::TREE_KEY, true, Queries::TREE_KEY),
    ];
    let asked = queries.into_iter().filter(|(kind, is_target, _)| *is_target && uses.has(*kind));
    asked.fold(Queries::NONE, |found, (.., query)| found | query)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_text;

    /// The queries of the first start rule.
    fn queries(text: &str) -> Queries {
        let compiled = compile_text(text).compiled;
        let grammar = compiled.grammar.unwrap_or_else(|| panic!("{text}: {:?}", compiled.diags));
        Queries::by_start(&grammar)[0]
    }

    #[test]
    fn a_query_counts_wherever_it_is_evaluated() {
        let context = Queries::INTRA_CONTEXT;
        for text in [
            "Lot --> case contextCount(intra, \"a\") > 1 : X. else : Y.",
            "Lot --> split(x) { ~contextCount(intra, \"a\") : X. }",
            "Lot --> comp(f) { contextCount(intra, \"a\") > 1 : X. }",
            "Lot --> setbackPerEdge(contextCount(intra, \"a\")) { all : X. }",
            "Lot --> A(contextCount(intra, \"a\"))  A(n) --> X.",
            "Lot --> A  A --> [ t(contextCount(intra, \"a\"), 0, 0) X. ]",
            "Lot --> t(f, 0, 0) X.  f = g(1)  g(n) = case n > 0 : f else : contextCount(intra, \"a\")",
            "attr n = contextCount(intra, \"a\")  Lot --> X.",
            "const n = size(comp(f) { all : contextCount(intra, \"a\") })  Lot --> X.",
        ] {
            assert_eq!(queries(text), context, "{text}");
        }
    }

    #[test]
    fn the_target_decides_which_shapes_are_asked_about() {
        for (query, expected) in [
            ("touches", Queries::INTRA_OCCLUSION | Queries::INTER_OCCLUSION),
            ("overlaps(all)", Queries::INTRA_OCCLUSION | Queries::INTER_OCCLUSION),
            ("inside(inter)", Queries::INTER_OCCLUSION),
            ("touches(intra, \"a\")", Queries::INTRA_OCCLUSION),
            ("minimumDistance(inter, \"a\") > 1", Queries::INTER_CONTEXT),
            ("contextCompare(all, \"a\", world.highest) > 1", Queries::INTRA_CONTEXT | Queries::INTER_CONTEXT),
            ("geometry.isClosedSurface", Queries::NONE),
        ] {
            assert_eq!(queries(&format!("Lot --> case {query} : X. else : Y.")), expected, "{query}");
        }
    }

    #[test]
    fn rules_that_are_not_reached_do_not_count() {
        let text = "@StartRule Lot --> X.  @StartRule Other --> label(\"a\") A  A --> print(touches(intra)) X.";
        let grammar = compile_text(text).compiled.grammar.expect("good rules");
        let by_start = Queries::by_start(&grammar);
        assert_eq!(by_start[0], Queries::NONE);
        assert_eq!(by_start[1], Queries::LABELS | Queries::INTRA_OCCLUSION);
    }
}
