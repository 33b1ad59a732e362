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
use crate::syntax::written::Written;

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
    let mut before = Earlier::new(cx);
    for selector in selectors {
        let extent = meanings.extent(selector);
        if let Some(why) = meanings.why_hidden(selector, extent, &before) {
            report(selector, &why, &meanings, diags);
        }
        before.add(selector, extent, &meanings);
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

    /// Returns true if it takes the same components entirely.
    fn takes_as(self, other: Extent) -> bool {
        self.least == other.least && self.is_whole == other.is_whole
    }

    /// Returns true if selectors that take some directions leave nothing for it.
    fn is_within(self, taken: Directions) -> bool {
        self.most.within(taken) && !self.has_others
    }
}

/// The earlier selectors of a block, so that each selector is compared with few of them.
struct Earlier<'e> {
    /// By their text.
    selectors: Written<'e, &'e Expr>,
    /// By the text of the operands of `||`, or by their text; those that select the same components each time.
    alternatives: Written<'e, &'e Expr>,
    /// The first selector for each set of components that one takes entirely.
    extents: Vec<(&'e Expr, Extent)>,
    /// The directions that they take together.
    taken: Directions,
}

impl<'e> Earlier<'e> {
    fn new(cx: &'e Context) -> Self {
        let tokens = cx.globals.program.tokens.as_slice();
        let (selectors, alternatives) = (Written::new(tokens), Written::new(tokens));
        Earlier { selectors, alternatives, extents: Vec::new(), taken: Directions::NONE }
    }

    fn add(&mut self, selector: &'e Expr, extent: Extent, meanings: &Meanings) {
        self.selectors.add(selector.span, selector);
        let mut operands = vec![selector];
        while let Some(operand) = operands.pop() {
            match &operand.kind {
                ExprKind::Binary(Binary::Or, _, left, right) => operands.extend([&**left, right]),
                _ if meanings.is_settled(operand) => self.alternatives.add(operand.span, selector),
                _ => {}
            }
        }
        if !self.extents.iter().any(|(_, other)| extent.takes_as(*other)) {
            self.extents.push((selector, extent));
        }
        self.taken = self.taken.and(extent.least);
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
    fn why_hidden<'e>(&self, selector: &'e Expr, own: Extent, before: &Earlier<'e>) -> Option<Why<'e>> {
        if matches!(selector.kind, ExprKind::Number(index) if index.fract() != 0.0) {
            return Some(Why::Fraction);
        }
        if let Some(same) = before.selectors.find(selector.span).filter(|_| self.is_settled(selector)) {
            return Some(Why::Same(same));
        }
        if own.is_nothing() && matches!(selector.kind, ExprKind::Binary(Binary::And, ..)) {
            return Some(Why::Contradiction);
        }
        // The words for a rest take no component.
        let has_rest = self.has_rest(selector);
        let covers = |(_, extent): &&(&Expr, Extent)| extent.is_whole || own.is_within(extent.least);
        if let Some((other, _)) = before.extents.iter().find(covers).filter(|_| !has_rest) {
            return Some(Why::Covered(other));
        }
        if own.is_within(if has_rest { Directions::NONE } else { before.taken }) {
            return Some(Why::Directions);
        }
        self.repeated(selector, before).map(Why::Covered)
    }

    /// An earlier selector that takes all components of a selector, because both have a condition in common.
    fn repeated<'e>(&self, selector: &Expr, before: &Earlier<'e>) -> Option<&'e Expr> {
        match &selector.kind {
            ExprKind::Binary(Binary::And, _, left, right) => {
                self.repeated(left, before).or_else(|| self.repeated(right, before))
            }
            ExprKind::Binary(Binary::Or, _, left, right) => {
                self.repeated(left, before).and(self.repeated(right, before))
            }
            ExprKind::Bool(_) => None,
            _ => before.alternatives.find(selector.span).copied(),
        }
    }

    /// Returns true if a selector that is written twice selects the same components both times.
    fn is_settled(&self, selector: &Expr) -> bool {
        is_settled(selector, self.cx.tables.at(self.own))
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
