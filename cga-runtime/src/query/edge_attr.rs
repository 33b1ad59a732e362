//! Attributes of the edges of the initial shape (*edgeAttr functions*).
//!
//! A shape has the value at the edge of the initial shape that it covers most, as projected in the direction in which it faces
//! (`cga-geometry/src/sampled_outline.rs`). Without an attribute of that name and type, or without a value at the edge, the value is 0,
//! an empty text or false.

use crate::run::env::Env;
use crate::shape::{EdgeAttribute, Shape};
use crate::value::text::Text;

/// `edgeAttr.getFloat(attributeName)`.
pub fn edge_attr_float(env: &mut Env, shape: &Shape, name: Text) -> f64 {
    sampled(env, shape, &name, |values, edge| match values {
        EdgeAttribute::Floats(values) => values.get(edge).copied(),
        _ => None,
    })
}

/// `edgeAttr.getString(attributeName)`.
pub fn edge_attr_string(env: &mut Env, shape: &Shape, name: Text) -> Text {
    sampled(env, shape, &name, |values, edge| match values {
        EdgeAttribute::Texts(values) => values.get(edge).cloned(),
        _ => None,
    })
}

/// `edgeAttr.getBool(attributeName)`.
pub fn edge_attr_bool(env: &mut Env, shape: &Shape, name: Text) -> bool {
    sampled(env, shape, &name, |values, edge| match values {
        EdgeAttribute::Bools(values) => values.get(edge).copied(),
        _ => None,
    })
}

fn sampled<T: Default>(
    env: &mut Env,
    shape: &Shape,
    name: &Text,
    value: impl FnOnce(&EdgeAttribute, usize) -> Option<T>,
) -> T {
    let find = || {
        let known = env.edge_attributes()?;
        let values = known.attributes.get(name)?;
        value(values, known.edge_of(shape)?)
    };
    find().unwrap_or_default()
}
