//! `print` as a function.

use crate::run::env::Env;
use crate::value::Value;

/// `print(value)`: keeps a line with the model and returns the value (*print function*).
pub fn print<V: Clone + Into<Value>>(env: &mut Env, value: V) -> V {
    env.print(value.clone().into());
    value
}
