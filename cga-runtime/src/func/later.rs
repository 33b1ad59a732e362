//! Parts of the language that are not implemented yet: a no-op or the type's default, and one fault per name and run.

use crate::run::env::Env;
use crate::value::array::Array;
use crate::value::text::Text;

/// An operation that is not implemented: the shape stays as it is.
pub fn operation(env: &mut Env, name: &str) {
    env.not_implemented(name, "the shape stays as it is");
}

/// A function or attribute that is not implemented: 0.
pub fn float(env: &mut Env, name: &str) -> f64 {
    env.not_implemented(name, "it gives 0");
    0.0
}

/// A function or attribute that is not implemented: false.
pub fn bool(env: &mut Env, name: &str) -> bool {
    env.not_implemented(name, "it gives false");
    false
}

/// A function or attribute that is not implemented: empty text.
pub fn text(env: &mut Env, name: &str) -> Text {
    env.not_implemented(name, "it gives empty text");
    Text::default()
}

/// A function or attribute that is not implemented: an empty array.
fn array<T>(env: &mut Env, name: &str) -> Array<T> {
    env.not_implemented(name, "it gives an empty array");
    Array::default()
}

/// A function or attribute that is not implemented: an empty array of numbers.
pub fn floats(env: &mut Env, name: &str) -> Array<f64> {
    array(env, name)
}

/// A function or attribute that is not implemented: an empty array of truth values.
pub fn bools(env: &mut Env, name: &str) -> Array<bool> {
    array(env, name)
}

/// A function or attribute that is not implemented: an empty array of texts.
pub fn texts(env: &mut Env, name: &str) -> Array<Text> {
    array(env, name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fault::FaultKind;

    #[test]
    fn a_name_is_missed_once_a_run() {
        let env = &mut Env::for_tests();
        for _ in 0..3 {
            operation(env, "roofHip");
            assert_eq!((float(env, "geometry.du"), bool(env, "touches")), (0.0, false));
            assert_eq!(text(env, "getTreeKey").as_str(), "");
        }
        let (faults, left_out) = env.take_faults();
        let said: Vec<_> = faults.iter().map(|fault| fault.message.as_str()).collect();
        assert_eq!(
            said,
            [
                "`roofHip` is not implemented yet; the shape stays as it is",
                "`geometry.du` is not implemented yet; it gives 0",
                "`touches` is not implemented yet; it gives false",
                "`getTreeKey` is not implemented yet; it gives empty text",
            ]
        );
        assert!(left_out == 0 && faults.iter().all(|fault| fault.kind == FaultKind::NotImplemented));
    }
}
