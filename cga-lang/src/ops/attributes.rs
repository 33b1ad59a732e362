//! The attributes of shapes.

use super::material::MATERIAL;
use super::{B, Changes, F, Needs, Run, ShapeAttr, T, Uses};
use crate::types::Type;

/// Every attribute of shapes.
pub static SHAPE_ATTRS: &[&[ShapeAttr]] = &[SHAPE, MATERIAL];

/// Cannot be set.
const fn get(name: &'static str, get: &'static str, uses: Uses) -> ShapeAttr {
    ShapeAttr {
        name,
        get: Run::Now(get),
        ty: F,
        needs: Needs::Shape,
        uses,
        set: None,
        set_uses: Uses::NONE,
        set_changes: Changes::Nothing,
        old: None,
    }
}

/// Can be set. Reading and setting use the whole shape.
pub(super) const fn both(name: &'static str, call: &'static str, ty: Type) -> ShapeAttr {
    ShapeAttr {
        ty,
        set: Some(Run::Now(call)),
        set_uses: Uses::WHOLE,
        set_changes: Changes::Whole,
        ..get(name, call, Uses::WHOLE)
    }
}

/// The same row, with other uses.
pub(super) const fn using(uses: Uses, set_uses: Uses, row: ShapeAttr) -> ShapeAttr {
    ShapeAttr { uses, set_uses, ..row }
}

/// Of the initial shape: the run knows it, and it cannot be set.
const fn initial(name: &'static str, call: &'static str) -> ShapeAttr {
    ShapeAttr { needs: Needs::Both, ..get(name, call, Uses::SAYS) }
}

/// In the coordinates of the initial shape.
const fn pivot(name: &'static str, call: &'static str) -> ShapeAttr {
    ShapeAttr { needs: Needs::Both, ..both(name, call, F) }
}

static SHAPE: &[ShapeAttr] = &[
    using(Uses::SIZE, Uses::NONE, both("scope.sx", "scope_sx", F)),
    using(Uses::SIZE, Uses::NONE, both("scope.sy", "scope_sy", F)),
    using(Uses::SIZE, Uses::NONE, both("scope.sz", "scope_sz", F)),
    // Relative to the pivot.
    both("scope.tx", "scope_tx", F),
    both("scope.ty", "scope_ty", F),
    both("scope.tz", "scope_tz", F),
    both("scope.rx", "scope_rx", F),
    both("scope.ry", "scope_ry", F),
    both("scope.rz", "scope_rz", F),
    get("scope.elevation", "scope_elevation", Uses::PLACE),
    get("split.index", "split_index", Uses::INDEX),
    get("split.total", "split_total", Uses::TOTAL),
    get("comp.index", "comp_index", Uses::WHOLE),
    get("comp.total", "comp_total", Uses::WHOLE),
    ShapeAttr { ty: T, ..get("comp.sel", "comp_sel", Uses::WHOLE) },
    both("trim.vertical", "trim_vertical", B),
    both("trim.horizontal", "trim_horizontal", B),
    using(Uses::DRAWS, Uses::DRAWS, both("seedian", "seedian", F)),
    // Old rules tell shapes apart by it; *getTreeKey* came in its place.
    ShapeAttr { get: Run::Later, old: Some("write `getTreeKey()`, which is text"), ..get("uid", "", Uses::WHOLE) },
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
