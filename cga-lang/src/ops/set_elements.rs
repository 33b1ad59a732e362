//! `setElems`, for all types of arrays, values and indices.

use super::base::function;
use super::{B, BS, F, FS, Function, Needs, Params, Str, T, TS, of};
use crate::types::Type;

const fn row(call: Str, params: Params, ty: Type) -> Function {
    let about = "a copy of the array with other values in some places";
    Function { needs: Needs::Env, pure: true, ..function("setElems", call, params, ty, about) }
}

/// The rows for an array and values, with one index, which may be a number, numbers or truth values, and with two
/// indices.
macro_rules! rows {
    ($array:expr, $values:expr) => {
        &[
            rows!(@linear $array, $values, F),
            rows!(@linear $array, $values, FS),
            rows!(@linear $array, $values, BS),
            rows!(@block $array, $values, F, F),
            rows!(@block $array, $values, F, FS),
            rows!(@block $array, $values, F, BS),
            rows!(@block $array, $values, FS, F),
            rows!(@block $array, $values, FS, FS),
            rows!(@block $array, $values, FS, BS),
            rows!(@block $array, $values, BS, F),
            rows!(@block $array, $values, BS, FS),
            rows!(@block $array, $values, BS, BS),
        ]
    };
    (@linear $array:expr, $values:expr, $indices:expr) => {
        row("set_elements", &[of("array", $array), of("indices", $indices), of("values", $values)], $array)
    };
    (@block $array:expr, $values:expr, $rows:expr, $columns:expr) => {
        row(
            "set_elements_at",
            &[of("array", $array), of("rowIndices", $rows), of("colIndices", $columns), of("values", $values)],
            $array,
        )
    };
}

pub(super) static FLOAT: &[Function] = rows!(FS, F);
pub(super) static FLOATS: &[Function] = rows!(FS, FS);
pub(super) static BOOL: &[Function] = rows!(BS, B);
pub(super) static BOOLS: &[Function] = rows!(BS, BS);
pub(super) static TEXT: &[Function] = rows!(TS, T);
pub(super) static TEXTS: &[Function] = rows!(TS, TS);
