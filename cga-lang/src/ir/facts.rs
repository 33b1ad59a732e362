//! Facts about rules, functions and expressions: the parts of a shape that they read.
//!
//! A back end makes a seed, a counter or a whole shape only where something reads it. The facts follow from the tables in
//! [`ops`] and from the grammar alone: least fixpoints over the calls of functions and rules.
//!
//! ```
//! use cga_lang::compile::compile_text;
//! use cga_lang::ir::facts::{Facts, Uses};
//! use cga_lang::ir::RuleId;
//!
//! let source = compile_text("Lot --> split(x) { ~1 : Bay }  Bay --> 30% : A. else : B.");
//! let facts = Facts::new(&source.compiled.grammar.unwrap());
//! let lot = facts.rule(RuleId(0));
//! assert!(!lot.own.has(Uses::DRAWS) && lot.below.has(Uses::DRAWS) && !lot.rigid);
//! ```

mod closure;
mod functions;
mod left_shapes;
mod queries;
mod reads;
mod rules;
#[cfg(test)]
mod tests;

use crate::ir::walk;
use crate::ir::{Expr, ExprKind, FunctionId, Grammar, RuleId, Target, Value};
use crate::ops::{self, Param};
use std::ops::BitOr;

pub use crate::ops::Uses;
pub(crate) use closure::closure;
pub use left_shapes::LeftShapes;
pub use queries::Queries;
pub use reads::Reads;

/// The facts of a grammar.
#[derive(Clone, Debug, Default)]
pub struct Facts {
    rules: Vec<RuleFacts>,
    functions: Vec<Uses>,
    /// Uses of reading an attribute or constant.
    globals: Vec<Uses>,
    differing: reads::Differing,
}

/// The facts of a rule.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct RuleFacts {
    /// Uses of the rule's own steps and expressions, with the functions that they call. The counters are those that the rule
    /// gets with its shape: `split.index` in an argument of a part of a split is another one.
    pub own: Uses,
    /// Uses of the rule and of every rule that it reaches. The counters are those that the rule gets with its shape, read by
    /// the rule or by a rule that it hands them on to: parts of a split have new ones.
    pub below: Uses,
    /// True if the result in the coordinates of the scope depends only on the size, the geometry and the material of the shape,
    /// on the arguments, and on attributes and constants. Then these make no difference: the place in the world, the pivot, trim planes,
    /// the seed, the counters.
    pub rigid: bool,
    /// The needs of a template of the steps of the rule itself, without the rules that it calls. `None` if they use so much that there can be
    /// no template.
    pub own_template: Option<TemplateNeeds>,
    /// The attributes and constants that the steps of the rule itself read.
    pub own_reads: Reads,
    /// True if the rule gives its parts equal sizes and looks on all shapes of equal size, apart from the branches of `case` that it takes.
    pub is_even: bool,
}

/// Needs of a template, besides the size of its shape, arguments, attributes and constants.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct TemplateNeeds {
    /// True if it reads or makes more than rectangles and boxes.
    pub whole: bool,
    /// True if it reads the orientation of the shape in the world.
    pub axes: bool,
}

impl BitOr for TemplateNeeds {
    type Output = TemplateNeeds;

    fn bitor(self, other: TemplateNeeds) -> TemplateNeeds {
        TemplateNeeds { whole: self.whole | other.whole, axes: self.axes | other.axes }
    }
}

impl Facts {
    /// Finds the facts of a grammar, in time linear in its size.
    pub fn new(grammar: &Grammar) -> Self {
        let mut facts = Facts::default();
        facts.find_functions(grammar);
        facts.find_reads(grammar);
        facts.find_rules(grammar);
        facts
    }

    /// The facts of a rule.
    pub fn rule(&self, id: RuleId) -> &RuleFacts {
        &self.rules[id.0 as usize]
    }

    /// Uses of the whole grammar: of all rules, attributes and constants.
    pub fn all(&self, grammar: &Grammar) -> Uses {
        self.rules.iter().map(|rule| rule.own).collect::<Uses>()
            | self.exprs(grammar.globals.iter().map(|global| &global.value))
    }

    /// Uses of a function's value, with the functions that it calls.
    pub fn function(&self, id: FunctionId) -> Uses {
        self.functions[id.0 as usize]
    }

    /// Uses of an expression with its parts, with the functions that it calls. The shape is the one that the expression is
    /// evaluated on.
    pub fn expr(&self, expr: &Expr) -> Uses {
        let mut found = Uses::NONE;
        walk::parts(expr, &mut |part| found = found | self.part(part));
        found
    }

    /// Uses of a part of a split or comp that becomes `target`. The arguments are evaluated on the part, so their uses count, and
    /// all uses below the rule. A leaf uses nothing.
    pub fn target(&self, target: &Target) -> Uses {
        match target {
            Target::Rule { rule, args, .. } => self.exprs(args) | self.rule(*rule).below,
            Target::Leaf(..) | Target::Nil => Uses::NONE,
        }
    }

    fn exprs<'e>(&self, list: impl IntoIterator<Item = &'e Expr>) -> Uses {
        list.into_iter().map(|expr| self.expr(expr)).collect()
    }

    /// Uses of an expression without its parts.
    fn part(&self, expr: &Expr) -> Uses {
        match &expr.kind {
            ExprKind::Global(id) => self.globals[id.0 as usize],
            ExprKind::Call(id, ..) => self.function(*id),
            ExprKind::Builtin(row, args) => row.uses | row.params.iter().zip(args).map(selected).collect(),
            ExprKind::Shape(row) => row.uses,
            // Rust code may give another value each time.
            ExprKind::Rust(..) | ExprKind::Host(_) => Uses::SAYS,
            ExprKind::Comp(_) | ExprKind::Word(_) => Uses::WHOLE,
            ExprKind::Chance { .. } => Uses::DRAWS,
            ExprKind::Value(_)
            | ExprKind::Param(_)
            | ExprKind::Style(_)
            | ExprKind::Site(_)
            | ExprKind::Array(_)
            | ExprKind::Range(..)
            | ExprKind::Index(..)
            | ExprKind::EachUnary(..)
            | ExprKind::Each(..)
            | ExprKind::Neg(_)
            | ExprKind::Not(_)
            | ExprKind::Binary(..)
            | ExprKind::Chain(..)
            | ExprKind::ToText(_)
            | ExprKind::File(..)
            | ExprKind::Case(..) => Uses::NONE,
        }
    }
}

/// Uses of an argument that selects faces. Words are constants.
fn selected((param, arg): (&Param, &Expr)) -> Uses {
    match &arg.kind {
        ExprKind::Value(Value::Text(word)) if param.kind.words().is_some() => {
            ops::selector(word).map_or(Uses::NONE, |row| row.uses)
        }
        _ => Uses::NONE,
    }
}
