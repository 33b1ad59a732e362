//! The attributes of shapes.

use super::base::{both, get, using};
use super::material::MATERIAL;
use super::{AttrValues, B, Effect, F, Needs, ParamKind, ShapeAttr, T, Uses};

/// All attributes of shapes.
pub static SHAPE_ATTRS: &[&[ShapeAttr]] = &[SHAPE, MATERIAL];

/// A row of the initial shape: the run knows it, and it cannot be set.
const fn initial(name: &'static str, call: &'static str) -> ShapeAttr {
    ShapeAttr { needs: Needs::Both, ..get(name, call, Uses::SAYS) }
}

/// A row in the coordinates of the initial shape.
const fn pivot(name: &'static str, call: &'static str) -> ShapeAttr {
    ShapeAttr { needs: Needs::Both, ..both(name, call, F) }
}

/// A number of the scope. Setting it changes the scope.
const fn scope(name: &'static str, call: &'static str) -> ShapeAttr {
    ShapeAttr { set_scope: Effect::Any, ..both(name, call, F) }
}

/// The size of the scope along an axis.
const fn scope_size(name: &'static str, call: &'static str, axis: usize) -> ShapeAttr {
    ShapeAttr { values: AttrValues::Size(axis), ..using(Uses::SIZE, Uses::NONE, scope(name, call)) }
}

/// The row for finite values from `least`.
const fn from(least: f64, row: ShapeAttr) -> ShapeAttr {
    ShapeAttr { values: AttrValues::From(least), ..row }
}

const TEXT: ParamKind = ParamKind::Value(T);

static SHAPE: &[ShapeAttr] = &[
    scope_size("scope.sx", "scope_sx", 0),
    scope_size("scope.sy", "scope_sy", 1),
    scope_size("scope.sz", "scope_sz", 2),
    // Relative to the pivot.
    scope("scope.tx", "scope_tx"),
    scope("scope.ty", "scope_ty"),
    scope("scope.tz", "scope_tz"),
    scope("scope.rx", "scope_rx"),
    scope("scope.ry", "scope_ry"),
    scope("scope.rz", "scope_rz"),
    // The coordinate system of the scene may change it.
    ShapeAttr { needs: Needs::Both, ..get("scope.elevation", "scope_elevation", Uses::PLACE) },
    // Before the first split, the index is -1 and the total is 0.
    from(-1.0, get("split.index", "split_index", Uses::INDEX)),
    from(0.0, get("split.total", "split_total", Uses::TOTAL)),
    get("comp.index", "comp_index", Uses::WHOLE),
    get("comp.total", "comp_total", Uses::WHOLE),
    ShapeAttr { kind: TEXT, ..get("comp.sel", "comp_sel", Uses::WHOLE) },
    // Inserted geometry depends on them. A template has their values in its key.
    using(Uses::BODY, Uses::BODY, both("trim.vertical", "trim_vertical", B)),
    using(Uses::BODY, Uses::BODY, both("trim.horizontal", "trim_horizontal", B)),
    using(Uses::DRAWS, Uses::DRAWS, both("seedian", "seedian", F)),
    // Old rules distinguish shapes by it; *getTreeKey* replaced it.
    ShapeAttr {
        needs: Needs::Env,
        old: Some("write `getTreeKey()`, which is text"),
        ..get("uid", "uid", Uses::TREE_KEY)
    },
    ShapeAttr { kind: TEXT, ..initial("initialShape.name", "initial_shape_name") },
    ShapeAttr { kind: TEXT, ..initial("initialShape.startRule", "initial_shape_start_rule") },
    ShapeAttr {
        kind: TEXT,
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
