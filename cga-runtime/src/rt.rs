//! Everything generated code may touch, and nothing else. Not part of the public promise: versions are pinned to each
//! other.

pub use std::boxed::Box;
pub use std::ops::ControlFlow;
pub use std::string::String;

pub use crate::asset::File;
pub use crate::comp::select::Word;
pub use crate::comp::{Align, Arm, Candidate, Components, Mode, Select, comp, comp_values, never};
pub use crate::func::{host, later};
pub use crate::geometry::Axis;
pub use crate::geometry::mesh::UvAxis;
pub use crate::grammar::attribute::{Attribute, AttributeDefault, AttributeKind, ChoiceValues, Choices, Range, check};
pub use crate::grammar::lazy::{Lazy, Origin, computed};
pub use crate::grammar::parallel::{Parts, ShapeError, Stretch, generate_all, run_all};
pub use crate::grammar::session::{DynSession, Session, generate, run};
pub use crate::grammar::{Field, Grammar, Unrunnable};
pub use crate::op::Length;
pub use crate::op::set;
pub use crate::op::slim;
pub use crate::output::model::Model;
pub use crate::query::get;
pub use crate::run::context::{Cx, Painting};
pub use crate::run::env::Env;
pub use crate::run::fault::{Error, Fault};
pub use crate::run::report::Report;
pub use crate::run::rules::Rules;
pub use crate::run::settings::Settings;
pub use crate::run::sink::{Flow, Sink};
pub use crate::run::start_rule::StartRule;
pub use crate::run::template::Last;
pub use crate::shape::base::Base;
pub use crate::shape::scope::Scope;
pub use crate::shape::slim::{become_successor, hand_on, push, successor};
pub use crate::shape::view::View;
pub use crate::shape::{Shape, ShapeRef};
pub use crate::split::divide::{areas, extent, sizes, solved};
pub use crate::split::division::{Division, Made, Slot};
pub use crate::split::row::{Pattern, Row};
pub use crate::split::texture::{TextureSpace, texture};
pub use crate::split::{Adjust, Item, Piece, Size, solve, solve_any};
pub use crate::value::Value;
pub use crate::value::array::{Array, Element};
pub use crate::value::text::Text;
pub use crate::{op, query};

/// Functions of the language.
pub mod func {
    pub use crate::comp::{Subcomponent, is_tagged, is_tagged_at};
    pub use crate::func::*;
    pub use crate::query::*;
}
pub use cga_split::List;

use crate::shape::seed::Tag;

/// The default of a text attribute.
pub fn string(text: &str) -> String {
    text.to_owned()
}

/// The text of an attribute.
pub fn text(value: &str) -> Text {
    Text::from(value)
}

/// The name of an image as models have it: a relative one is looked for from the folder of the rule file.
pub fn image(env: &Env, file: File) -> Text {
    env.settings.assets.image(file)
}

/// Writes texture coordinates that follow from the place, before an operation that changes geometry in any way.
#[inline]
pub fn bake(shape: &mut Shape) {
    shape.bake();
}

/// An array that is known while compiling: its elements in rows of so many.
pub fn array<T: Element, const N: usize>(columns: usize, elements: [T; N]) -> Array<T> {
    Array::new(elements.to_vec(), N.checked_div(columns).unwrap_or_default(), columns)
}

/// The initial shape with the random stream of one attribute or constant, numbered by its name (*CGA changelog 2018.0*: each has its own).
pub fn global(shape: &Shape, number: u32) -> Shape {
    Shape { seed: shape.seed.child(Tag::Global, number), ..shape.clone() }
}

/// The same for an attribute or constant of an import that starts anew: evaluated on the current shape, which draws nothing
/// of its own for it.
pub fn anew<T>(shape: &mut Shape, number: u32, value: impl FnOnce(&mut Shape) -> T) -> T {
    let seed = shape.seed;
    shape.seed = seed.child(Tag::Global, number);
    let value = value(shape);
    shape.seed = seed;
    value
}

/// One branch of a stochastic rule: a draw with the probability that is left (`30% : … 5% : …` draws 0.30, then
/// 0.05 / 0.70; see the digest's fact 95).
#[inline]
pub fn branch(shape: &mut impl View, percent: f64, before: f64) -> bool {
    func::drawn_below(shape, percent / (100.0 - before))
}
