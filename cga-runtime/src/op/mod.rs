//! Operations that change the current shape, named as in the table of the language.
//!
//! Every function takes the run's [`Env`] first and the shape second. Numbers that are not finite count as 0 and
//! leave a fault.

mod create;
mod face;
pub(crate) mod look;
mod mesh;
mod report;
mod scope;
#[cfg(test)]
mod scope_tests;
pub mod set;
mod set_by_name;
pub mod slim;
mod tagging;

pub use crate::comp::{Align, Components};
pub use crate::geometry::along_uv::{HeightAlignment, HeightDirection};
pub use crate::geometry::mesh::TaggedComponents;
pub use crate::geometry::offset::OffsetFaces;
pub use create::along_uv::{insert_along_uv, insert_along_uv_with};
pub use create::envelope::{
    EnvelopeAlong, envelope_all, envelope_edges, envelope_front, envelope_front_back, envelope_old_all,
    envelope_old_front, envelope_old_front_back, envelope_old_sides, envelope_sides,
};
pub use create::extrude::{ExtrudeAlong, ExtrudeAxis, extrude, extrude_along, extrude_axis};
pub use create::footprint::footprint;
pub use create::insert::{CleanupMode, InsertMode, UpAxis, insert, insert_with};
pub use create::primitive::{
    cone, cone_sized, cube, cube_sized, cylinder, cylinder_sides, cylinder_sized, disk, disk_sized, quad, quad_sized,
    sphere, sphere_sides, sphere_sized,
};
pub use create::reset_geometry::reset_geometry;
pub use create::roof::{
    RoofValue, roof_gable, roof_gable_along, roof_gable_by, roof_hip, roof_hip_by, roof_pyramid, roof_pyramid_by,
    roof_ridge_by, roof_shed, roof_shed_by,
};
pub use create::scatter::{Distribution, ScatterDomain, ScatterMean, scatter, scatter_around};
pub use create::taper::taper;
pub use create::trim::trim;
pub use face::delete_holes::delete_holes;
pub use face::inner_rectangle::{RectangleAlignment, inner_rect, inner_rectangle};
pub use face::offset::{offset, offset_selected};
pub use face::perimeter::{perimeter, perimeter_of};
pub use face::setback::{setback, setback_each, setback_per_edge};
pub use face::setback_to_area::{setback_to_area, setback_to_area_between, setback_to_area_from};
pub use face::shape_l::shape_l;
pub use face::shape_o::shape_o;
pub use face::shape_u::shape_u;
pub(crate) use look::material::image;
pub use look::material::{
    MaterialTarget, color_hex, color_rgb, color_rgba, opacity, reset_material, set_material, texture,
};
pub use look::texture::{
    NormalizeMode, NormalizeType, ProjectionAxes, copy_uv, delete_uv, normalize_uv, project_uv, rotate_uv, scale_uv,
    setup_projection, setup_projection_at, setup_projection_uw, setup_uv, tile_uv, translate_uv,
};
pub use mesh::boolean::{SwapMode, intersect, intersect_current, subtract, subtract_current, union, union_current};
pub use mesh::cleanup::{CleanupComponents, cleanup_geometry};
pub use mesh::convexify::{convexify, convexify_within};
pub use mesh::inline::{MergeStrategy, inline};
pub use mesh::mirror::{mirror, reverse_normals};
pub use mesh::normals::{NormalsMode, set_normals, soften_normals};
pub use mesh::recompose::modify;
pub use mesh::rectify::rectify;
pub use mesh::reduce::reduce_geometry;
pub use report::{label, print, report};
pub use scope::align::{AlignAxes, align_to_axes, rotate_scope};
pub use scope::align_box::{BoxAxes, align_to_box};
pub use scope::align_geometry::{
    AlignAuto, AlignEdge, AlignFace, align_to_auto, align_to_edge, align_to_face, align_to_first_edge,
    align_to_indices, align_to_selected,
};
pub use scope::coordinates::{System, TransformMode, rotate_in, translate_in};
pub use scope::pivot::{AxisMap, mirror_scope, set_pivot};
pub use scope::transform::{CenterAxes, RotateAbout, center, rotate, rotate_about, size, translate};
pub use set_by_name::set_by_name;
pub use tagging::delete_tags::{delete_tags, delete_tags_of};
pub use tagging::edge_attr_tags::set_tags_from_edge_attrs;
pub use tagging::tag::{TagTarget, tag};

use std::fmt::Display;

use glam::DVec3;

use crate::fault::FaultKind;
use crate::geometry::each::Each;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::scope::Scope;

/// Restores the scope before an operation if finite arguments have led to an overflow.
pub(crate) fn settle(env: &mut Env, shape: &mut Shape, before: &Scope, what: &str) {
    if !shape.scope.is_bounded() {
        shape.scope = *before;
        leads_beyond(env, what);
    }
}

/// Returns true if an origin is in range; leaves a fault otherwise.
#[inline]
fn settle_origin(env: &mut Env, origin: DVec3, what: &str) -> bool {
    let fits = origin.abs().element_sum() <= Scope::MOST_DISTANCE;
    if !fits {
        leads_beyond(env, what);
    }
    fits
}

#[cold]
fn leads_beyond(env: &mut Env, what: &str) {
    env.fault(FaultKind::Value, format!("{what} overflows; the shape stays as it is"));
}

/// Three numbers, one for each axis. Those that are not finite become 0, with a fault.
fn finite(env: &mut Env, what: &str, numbers: [f64; 3]) -> DVec3 {
    let names = ["x", "y", "z"];
    DVec3::from_array([0, 1, 2].each(|axis| env.finite(numbers[axis], format_args!("{what} {}", names[axis]))))
}

/// Three lengths in metres, one for each axis of a scope of that size.
#[inline]
fn lengths(env: &mut Env, what: &str, [x, y, z]: [Length; 3], size: DVec3) -> DVec3 {
    DVec3::new(
        x.of(size.x, env, format_args!("{what} along x")),
        y.of(size.y, env, format_args!("{what} along y")),
        z.of(size.z, env, format_args!("{what} along z")),
    )
}

/// Marks geometry that does not come from the initial shape: its groups do not have that shape's name.
pub(crate) fn inserted(env: &Env, shape: &mut Shape) {
    if !env.initial.name.is_empty() {
        shape.state.change().foreign = true;
    }
}

/// A length in metres, or relative to the scope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Length {
    /// A length in metres.
    Absolute(f64),
    /// A share of the scope's size along the axis of the length.
    Relative(f64),
}

impl Length {
    /// The length in metres, for a size of the scope; it may be NaN or infinite.
    #[inline]
    fn plain(self, size: f64) -> f64 {
        match self {
            Length::Absolute(metres) => metres,
            Length::Relative(share) => share * size,
        }
    }

    /// The length in metres, for a size of the scope.
    #[inline]
    pub(crate) fn of(self, size: f64, env: &mut Env, what: impl Display) -> f64 {
        match self {
            Length::Absolute(metres) => env.finite(metres, what),
            Length::Relative(share) => env.finite(share, what) * size,
        }
    }
}
