//! The rows that other rows are made from.

use super::{AttrValues, Changes, Effect, F, Function, Meaning, Needs, ParamKind, Params, ShapeAttr, Str, Uses};
use crate::types::Type;

/// The row of a function that reads nothing.
pub(super) const fn function(name: Str, call: Str, params: Params, ty: Type, about: Str) -> Function {
    Function {
        name,
        run: call,
        params,
        ty,
        needs: Needs::Nothing,
        uses: Uses::NONE,
        pure: false,
        meaning: Meaning::Opaque,
        needs_uv_set: false,
        names: None,
        old: None,
        about,
    }
}

/// A row that cannot be set.
pub(super) const fn get(name: Str, get: Str, uses: Uses) -> ShapeAttr {
    ShapeAttr {
        name,
        get,
        kind: ParamKind::Value(F),
        values: AttrValues::Any,
        needs: Needs::Shape,
        uses,
        set: None,
        set_uses: Uses::NONE,
        set_changes: Changes::Nothing,
        set_scope: Effect::Keeps,
        old: None,
    }
}

/// A row that can be set. Reading and setting use the whole shape.
pub(super) const fn both(name: Str, call: Str, ty: Type) -> ShapeAttr {
    ShapeAttr {
        kind: ParamKind::Value(ty),
        set: Some(call),
        set_uses: Uses::WHOLE,
        set_changes: Changes::Whole,
        ..get(name, call, Uses::WHOLE)
    }
}

/// The row with other uses.
pub(super) const fn using(uses: Uses, set_uses: Uses, row: ShapeAttr) -> ShapeAttr {
    ShapeAttr { uses, set_uses, ..row }
}
