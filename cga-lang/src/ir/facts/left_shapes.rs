//! The shapes that a rule can leave for queries of other shapes.
//!
//! A derivation that collects shapes for queries leaves out the rules that can leave none: mostly façades, which are most of a derivation.

use super::closure::closure;
use crate::ir::{BlockParts, Grammar, StepKind, walk};
use crate::ops::Uses;
use std::ops::BitOr;

/// The shapes that a rule and the rules that it reaches can leave for queries.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct LeftShapes {
    /// Labelled copies.
    pub labels: bool,
    /// Closed shapes, even if the rule gets a single flat face.
    pub solids_of_faces: bool,
}

impl LeftShapes {
    /// By rule of a grammar.
    pub fn by_rule(grammar: &Grammar) -> Vec<LeftShapes> {
        let own = grammar.rules.iter().map(|rule| {
            let mut found = LeftShapes::default();
            walk::steps(&rule.body, &mut |step| found = found | of_step(&step.kind));
            found
        });
        closure(&walk::calls(grammar, |_| true), &own.collect::<Vec<_>>())
    }
}

impl BitOr for LeftShapes {
    type Output = LeftShapes;

    fn bitor(self, other: LeftShapes) -> LeftShapes {
        LeftShapes {
            labels: self.labels || other.labels,
            solids_of_faces: self.solids_of_faces || other.solids_of_faces,
        }
    }
}

/// A step without its parts. Operations that keep the geometry, and parts of it, leave a flat face flat.
fn of_step(kind: &StepKind) -> LeftShapes {
    let solids_of_faces = match kind {
        StepKind::Do(row, _) => !row.scope.keeps_flat_faces(),
        StepKind::SetShape(attr, _) => !attr.set_scope.keeps_flat_faces(),
        StepKind::Block(block) => {
            !block.row.scope.keeps_flat_faces()
                || matches!(block.parts, BlockParts::Operands(_))
                || block.row.recomposes
        }
        StepKind::Rust(..) => true,
        StepKind::SetAttr(..) | StepKind::Give(_) | StepKind::Renew(_) | StepKind::Push(_) | StepKind::Case { .. } => {
            false
        }
    };
    let labels = matches!(kind, StepKind::Do(row, _) if row.uses.has(Uses::LABELS));
    LeftShapes { labels, solids_of_faces }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_text;

    /// The first rule.
    fn first(text: &str) -> (bool, bool) {
        let compiled = compile_text(text).compiled;
        let grammar = compiled.grammar.unwrap_or_else(|| panic!("{text}: {:?}", compiled.diags));
        let LeftShapes { labels, solids_of_faces } = LeftShapes::by_rule(&grammar)[0];
        (labels, solids_of_faces)
    }

    #[test]
    fn facades_leave_nothing() {
        for text in [
            "Facade --> split(y) { { ~3 : Floor }* }  Floor --> split(x) { 1 : t(0, 0, 1) Tile. }*",
            "Facade --> setupProjection(0, scope.xy, 1, 1) projectUV(0) color(1, 0, 0) [ s('0.5, '1, '1) center(x) A. ] B.",
            "Facade --> comp(e) { all : A. } setback(1) { all : NIL | remainder : B. } set(trim.vertical, false) alignScopeToAxes(y) C.",
        ] {
            assert_eq!(first(text), (false, false), "{text}");
        }
    }

    #[test]
    fn operations_that_make_geometry_and_labels_count_wherever_they_are() {
        for (text, expected) in [
            ("Lot --> extrude(3) X.", (false, true)),
            (
                "Lot --> split(x) { ~1 : split(z) { ~1 : A } }*  A --> case scope.sx > 1 : B else : NIL  B --> [ i(\"builtin:cube\") X. ] Y.",
                (false, true),
            ),
            ("Lot --> union { A | B } X.", (false, true)),
            ("Lot --> A  A --> 50% : label(\"a\") X. else : X.", (true, false)),
            ("Lot --> comp(f) { all : roofHip(30) X. }", (false, true)),
        ] {
            assert_eq!(first(text), expected, "{text}");
        }
    }
}
