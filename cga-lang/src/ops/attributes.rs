//! The attributes of shapes.

use super::{F, Needs, Run, ShapeAttr, T};
use crate::ir::Type;

/// Every attribute of shapes.
pub static SHAPE_ATTRS: &[&[ShapeAttr]] = &[SHAPE];

const fn get(name: &'static str, get: &'static str) -> ShapeAttr {
    ShapeAttr { name, get: Run::Now(get), ty: F, needs: Needs::Shape, set: None, old: None }
}

const fn both(name: &'static str, call: &'static str, ty: Type) -> ShapeAttr {
    ShapeAttr { name, get: Run::Now(call), ty, needs: Needs::Shape, set: Some(Run::Now(call)), old: None }
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
    both("material.color.r", "material_color_r", F),
    both("material.color.g", "material_color_g", F),
    both("material.color.b", "material_color_b", F),
    both("material.opacity", "material_opacity", F),
    both("material.metallic", "material_metallic", F),
    both("material.roughness", "material_roughness", F),
    both("material.name", "material_name", T),
    both("material.colormap", "material_colormap", T),
];
