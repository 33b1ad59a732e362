//! Selectors that never find a component, because earlier selectors take all candidates or because they contradict
//! themselves.

use super::branches::is_settled;
use crate::analysis::AbstractState;
use crate::diag::code::Code;
use crate::diag::{Diag, Diags, RELATIVE};
use crate::link::InstanceId;
use crate::ops::{self, Directions, Selector, SelectorPlaces};
use crate::resolve::context::Context;
use crate::resolve::tables::Use;
use crate::syntax::ast::{Binary, CompValue, Expr, ExprKind, Unary};

/// The maximum length of a quoted selector in a message, in bytes.
const LONGEST: usize = 40;

const ONCE: &str = "a component goes to the first selector that matches";

/// Checks the selectors of a `comp` as a value.
pub(crate) fn values(comp: &CompValue, facts: &AbstractState, cx: &Context, diags: &mut Diags) {
    let place = comp.args.first().and_then(Expr::word).and_then(ops::component).map(|kind| kind.place);
    let selectors = comp.arms.iter().map(|(selector, ..)| selector);
    check(selectors, place.unwrap_or(SelectorPlaces::NONE), facts.own, cx, diags);
}

/// Checks the selectors of arms, in their order.
pub(crate) fn check<'e>(
    selectors: impl Iterator<Item = &'e Expr>,
    place: SelectorPlaces,
    own: InstanceId,
    cx: &Context,
    diags: &mut Diags,
) {
    // One matching face is enough for a group or a material, which may thus have several directions.
    let has_one_direction = !SelectorPlaces::GROUPS.and(SelectorPlaces::MATERIALS).meets(place);
    let meanings = Meanings { cx, own, has_one_direction };
    let mut before: Vec<(&Expr, Extent)> = Vec::new();
    for selector in selectors {
        let extent = meanings.extent(selector);
        if let Some(why) = meanings.why_hidden(selector, extent, &before) {
            report(selector, &why, &meanings, diags);
        }
        before.push((selector, extent));
    }
}

/// The reason why a selector never finds a component.
enum Why<'e> {
    /// Its index is not a whole number.
    Fraction,
    /// Its parts have no common direction.
    Contradiction,
    /// Earlier selectors together take all its directions.
    Directions,
    /// This selector is written before it.
    Same(&'e Expr),
    /// This selector takes all its components.
    Covered(&'e Expr),
}

fn report(selector: &Expr, why: &Why, meanings: &Meanings, diags: &mut Diags) {
    let message = format!("{} never finds a component", meanings.shown(selector));
    let diag = diags.report(Code::SelectorHidden, selector.span, message);
    let taken = |diag: &mut Diag, by: &Expr| {
        diag.note(ONCE).related(format!("{} takes all of them", meanings.shown(by)), by.span);
    };
    match why {
        Why::Fraction => {
            diag.note("indices of components are whole numbers from 0").help("write another index, or leave it out");
        }
        Why::Contradiction => {
            diag.note("no component has all these directions").help("write `||` for components with one of them");
        }
        Why::Directions => {
            diag.note(ONCE).note("the selectors before it take all its directions");
            diag.help(EARLIER);
        }
        Why::Same(by) => {
            taken(diag, by);
            diag.help("leave it out");
        }
        Why::Covered(by) => {
            taken(diag, by);
            diag.help(EARLIER);
        }
    }
}

const EARLIER: &str = "move it before the others, or leave it out";

/// The components that a selector takes, where its text says so.
#[derive(Clone, Copy)]
struct Extent {
    /// The directions of which it takes all components.
    least: Directions,
    /// The directions of the components that it may take.
    most: Directions,
    /// True if it takes every component.
    is_whole: bool,
    /// True if a component may match for another reason than its direction.
    has_others: bool,
}

impl Extent {
    const ANY: Extent = Extent { least: Directions::NONE, most: Directions::ALL, is_whole: false, has_others: true };
    const WHOLE: Extent = Extent { least: Directions::ALL, is_whole: true, ..Extent::ANY };

    /// The components with some directions.
    fn towards(directions: Directions) -> Extent {
        Extent { least: directions, most: directions, is_whole: false, has_others: false }
    }

    fn not(self) -> Extent {
        Extent {
            least: Directions::ALL.but(self.most),
            most: Directions::ALL.but(self.least),
            is_whole: self.is_nothing(),
            has_others: !self.is_whole,
        }
    }

    fn or(self, other: Extent) -> Extent {
        Extent {
            least: self.least.and(other.least),
            most: self.most.and(other.most),
            is_whole: self.is_whole || other.is_whole,
            has_others: self.has_others || other.has_others,
        }
    }

    fn and(self, other: Extent) -> Extent {
        Extent {
            least: self.least.common(other.least),
            most: self.most.common(other.most),
            is_whole: self.is_whole && other.is_whole,
            has_others: self.has_others && other.has_others,
        }
    }

    fn is_nothing(self) -> bool {
        self.most == Directions::NONE && !self.has_others
    }

    /// Returns true if selectors that take some directions leave nothing for it.
    fn is_within(self, taken: Directions) -> bool {
        self.most.within(taken) && !self.has_others
    }
}

/// The meanings of the selectors of one block.
struct Meanings<'c, 'a, 'd> {
    cx: &'c Context<'a, 'd>,
    own: InstanceId,
    /// True if a component has one direction.
    has_one_direction: bool,
}

impl Meanings<'_, '_, '_> {
    fn why_hidden<'e>(&self, selector: &'e Expr, own: Extent, before: &[(&'e Expr, Extent)]) -> Option<Why<'e>> {
        if matches!(selector.kind, ExprKind::Number(index) if index.fract() != 0.0) {
            return Some(Why::Fraction);
        }
        if let Some(same) = before.iter().find(|(other, _)| self.is_same(selector, other)) {
            return Some(Why::Same(same.0));
        }
        if own.is_nothing() && matches!(selector.kind, ExprKind::Binary(Binary::And, ..)) {
            return Some(Why::Contradiction);
        }
        // The words for a rest take no component.
        let has_rest = self.has_rest(selector);
        let mut taken = Directions::NONE;
        for (other, extent) in before.iter().filter(|_| !has_rest) {
            if extent.is_whole || own.is_within(extent.least) {
                return Some(Why::Covered(other));
            }
            taken = taken.and(extent.least);
        }
        if own.is_within(taken) {
            return Some(Why::Directions);
        }
        self.repeated(selector, before).map(Why::Covered)
    }

    /// An earlier selector that takes all components of a selector, because both have a condition in common.
    fn repeated<'e>(&self, selector: &Expr, before: &[(&'e Expr, Extent)]) -> Option<&'e Expr> {
        match &selector.kind {
            ExprKind::Binary(Binary::And, _, left, right) => {
                self.repeated(left, before).or_else(|| self.repeated(right, before))
            }
            ExprKind::Binary(Binary::Or, _, left, right) => {
                self.repeated(left, before).and(self.repeated(right, before))
            }
            ExprKind::Bool(_) => None,
            _ => before.iter().map(|(other, _)| *other).find(|other| self.has_alternative(other, selector)),
        }
    }

    /// Returns true if a condition is one of the operands of `||` in a selector, or the selector itself.
    fn has_alternative(&self, selector: &Expr, condition: &Expr) -> bool {
        match &selector.kind {
            ExprKind::Binary(Binary::Or, _, left, right) => {
                self.has_alternative(left, condition) || self.has_alternative(right, condition)
            }
            _ => self.is_same(selector, condition),
        }
    }

    /// Returns true if two selectors are equal word for word and always select the same components.
    fn is_same(&self, one: &Expr, other: &Expr) -> bool {
        let tokens = self.cx.globals.program.tokens.as_slice();
        let written = |expr: &Expr| tokens.get(expr.span.first as usize..=expr.span.last as usize);
        written(one) == written(other) && is_settled(one, self.cx.tables.at(self.own))
    }

    fn word(&self, part: &Expr) -> Option<&'static Selector> {
        let ExprKind::Name(name) = &part.kind else { return None };
        match self.cx.tables.at(self.own).of(name)? {
            Use::Selector(word) => ops::selector(word),
            _ => None,
        }
    }

    fn has_rest(&self, part: &Expr) -> bool {
        self.word(part).is_some_and(|word| word.is_rest) || part.parts().into_iter().any(|part| self.has_rest(part))
    }

    fn extent(&self, part: &Expr) -> Extent {
        match &part.kind {
            ExprKind::Bool(true) => Extent::WHOLE,
            ExprKind::Name(_) => match self.word(part).map(|word| word.directions) {
                Some(Directions::ALL) => Extent::WHOLE,
                Some(directions) if directions != Directions::NONE => Extent::towards(directions),
                _ => Extent::ANY,
            },
            ExprKind::Unary(Unary::Not, operand) if self.has_one_direction => self.extent(operand).not(),
            ExprKind::Binary(Binary::Or, _, left, right) => self.extent(left).or(self.extent(right)),
            ExprKind::Binary(Binary::And, _, left, right) => {
                let (left, right) = (self.extent(left), self.extent(right));
                match (left.has_others, right.has_others) {
                    // Each operand may hold for another of its directions.
                    (false, false) if !self.has_one_direction => Extent { least: left.and(right).least, ..left },
                    _ => left.and(right),
                }
            }
            _ => Extent::ANY,
        }
    }

    /// A selector in a message.
    fn shown(&self, selector: &Expr) -> String {
        match &selector.kind {
            ExprKind::Number(index) => format!("index {index}"),
            ExprKind::Unary(Unary::Minus, operand) => format!("{} from the end", self.shown(operand)),
            _ => format!("`{}`", self.cx.globals.program.tokens.text(selector.span, LONGEST, RELATIVE)),
        }
    }
}
