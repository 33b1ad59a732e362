//! Functions that only generated code calls.

use crate::asset::File;
use crate::func;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::seed::Tag;
use crate::shape::view::View;
use crate::value::array::{Array, Element};
use crate::value::text::Text;

/// Imported under a name, it hides the constant that has the name outside.
pub fn hidden() {}

/// The default of a text attribute.
pub fn string(text: &str) -> String {
    text.to_owned()
}

/// The text of an attribute.
pub fn text(value: &str) -> Text {
    Text::from(value)
}

/// The name of an image in models: a relative name is resolved from the folder of the rule file.
pub fn image(env: &Env, file: File) -> Text {
    env.settings.assets.image(file)
}

/// Writes implicit texture coordinates into the mesh, before an operation that changes geometry in any way.
#[inline]
pub fn bake(shape: &mut Shape) {
    shape.bake();
}

/// A constant array, with its elements in rows of `columns`.
pub fn array<T: Element, const N: usize>(columns: usize, elements: [T; N]) -> Array<T> {
    Array::new(elements.to_vec(), N.checked_div(columns).unwrap_or_default(), columns)
}

/// The initial shape with the random stream of one attribute or constant, numbered by its name (*CGA changelog
/// 2018.0*: each has its own stream).
pub fn global(shape: &Shape, number: u32) -> Shape {
    Shape { seed: shape.seed.child(Tag::Global, number), ..shape.clone() }
}

/// Evaluates an attribute or constant of an import that starts again, with its own random stream. The current shape
/// itself draws nothing for it.
pub fn renew<T>(shape: &mut Shape, number: u32, value: impl FnOnce(&mut Shape) -> T) -> T {
    let seed = shape.seed;
    shape.seed = seed.child(Tag::Global, number);
    let value = value(shape);
    shape.seed = seed;
    value
}

/// Decides one branch of a stochastic rule by a draw with its conditional probability (`30% : … 5% : …` draws 0.30,
/// then 0.05 / 0.70; *Stochastic rule*).
#[inline]
pub fn branch(shape: &mut impl View, percent: f64, before: f64) -> bool {
    func::drawn_below(shape, percent / (100.0 - before))
}
