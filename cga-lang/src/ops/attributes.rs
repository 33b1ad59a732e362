//! The attributes of shapes.

use super::material::MATERIAL;
use super::{B, F, Needs, Run, ShapeAttr, T};
use crate::ir::Type;

/// Every attribute of shapes.
pub static SHAPE_ATTRS: &[&[ShapeAttr]] = &[SHAPE, MATERIAL];

const fn get(name: &'static str, get: &'static str) -> ShapeAttr {
    ShapeAttr { name, get: Run::Now(get), ty: F, needs: Needs::Shape, set: None, old: None }
}

pub(super) const fn both(name: &'static str, call: &'static str, ty: Type) -> ShapeAttr {
    ShapeAttr { name, get: Run::Now(call), ty, needs: Needs::Shape, set: Some(Run::Now(call)), old: None }
}

/// Of the initial shape: it cannot be set.
const fn initial(name: &'static str, call: &'static str) -> ShapeAttr {
    ShapeAttr { needs: Needs::Both, ..get(name, call) }
}

/// In the coordinates of the initial shape.
const fn pivot(name: &'static str, call: &'static str) -> ShapeAttr {
    ShapeAttr { needs: Needs::Both, ..both(name, call, F) }
}

static SHAPE: &[ShapeAttr] = &[
    both("scope.sx", "scope_sx", F),
    both("scope.sy", "scope_sy", F),
    both("scope.sz", "scope_sz", F),
    both("scope.tx", "scope_tx", F),
    both("scope.ty", "scope_ty", F),
    both("scope.tz", "scope_tz", F),
    both("scope.rx", "scope_rx", F),
    both("scope.ry", "scope_ry", F),
    both("scope.rz", "scope_rz", F),
    get("scope.elevation", "scope_elevation"),
    get("split.index", "split_index"),
    get("split.total", "split_total"),
    get("comp.index", "comp_index"),
    get("comp.total", "comp_total"),
    ShapeAttr { ty: T, ..get("comp.sel", "comp_sel") },
    both("trim.vertical", "trim_vertical", B),
    both("trim.horizontal", "trim_horizontal", B),
    both("seedian", "seedian", F),
    // Old rules tell shapes apart by it; *getTreeKey* came in its place.
    ShapeAttr { get: Run::Later, old: Some("write `getTreeKey()`, which is text"), ..get("uid", "") },
    ShapeAttr { ty: T, ..initial("initialShape.name", "initial_shape_name") },
    ShapeAttr { ty: T, ..initial("initialShape.startRule", "initial_shape_start_rule") },
    ShapeAttr {
        ty: T,
        old: Some("write `initialShape.startRule`"),
        ..initial("initialShape.symbol", "initial_shape_start_rule")
    },
    initial("initialShape.origin.px", "initial_shape_origin_px"),
    initial("initialShape.origin.py", "initial_shape_origin_py"),
    initial("initialShape.origin.pz", "initial_shape_origin_pz"),
    initial("initialShape.origin.ox", "initial_shape_origin_ox"),
    initial("initialShape.origin.oy", "initial_shape_origin_oy"),
    initial("initialShape.origin.oz", "initial_shape_origin_oz"),
    pivot("pivot.px", "pivot_px"),
    pivot("pivot.py", "pivot_py"),
    pivot("pivot.pz", "pivot_pz"),
    pivot("pivot.ox", "pivot_ox"),
    pivot("pivot.oy", "pivot_oy"),
    pivot("pivot.oz", "pivot_oz"),
];
