//! `roofHip`, `roofGable`, `roofPyramid`, `roofShed` and `roofRidge`.

use glam::DVec3;

use crate::fault::FaultKind;
use crate::geometry::roof::{Rise, RoofForm, RoofRefusal, Roofs, roof_over};
use crate::op::create::extrude::stand;
use crate::op::face::refused::{report_faces, report_refused};
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::trim::Trims;

/// The meaning of the value of a roof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoofValue {
    /// The angle between the roof planes and the face, in degrees.
    ByAngle,
    /// The height of the highest point over the face, without overhangs, in metres.
    ByHeight,
}

/// `roofHip(angle, overhang, even)`: see [`roof_hip_by`].
pub fn roof_hip(env: &mut Env, shape: &mut Shape, angle: f64, overhang: f64, even: bool) {
    roof_hip_by(env, shape, RoofValue::ByAngle, angle, overhang, even);
}

/// `roofHip(byAngle | byHeight, value, overhang, even)`: a roof over each face, with a plane that rises at each edge
/// (*roofHip operation*). The faces of the roof are in the order of edges, and the face itself is the bottom, which comes
/// last. The new scope's y axis is the normal of the first face, its x axis stays as near to the old one as it can, and
/// the pivot stays. Trim planes of the face do not cut its roof.
///
/// The overhang is measured on the planes, in metres. It continues the roof faces below the edges, so the roof is not
/// closed. A negative one takes the roof faces back from the edges. A positive one leads too far at edges that are nearly opposite,
/// as of a thin spike: then the roof has none, and a fault names the face. The same holds if no roof face is left. With `even` the
/// points of each ridge get their mean height, and the faces beside it are bent. A ridge is between edges that run against each
/// other; hips and valleys keep their slope.
///
/// The new geometry has no texture coordinates and no vertex normals.
///
/// A face stays with a fault that names it if it has no normal, touches itself, or has more than 5000 corners. So does a
/// shape with an angle that is not between 0 and 90 degrees, or a height that is not positive.
pub fn roof_hip_by(env: &mut Env, shape: &mut Shape, by: RoofValue, value: f64, overhang: f64, even: bool) {
    let overhang = overhang_of(env, overhang, "the overhang of `roofHip`");
    build(env, shape, "roofHip", RoofForm::Hip { overhang, even }, by, value);
}

/// `roofGable(angle, overhangX, overhangY, even)`: see [`roof_gable_by`].
pub fn roof_gable(env: &mut Env, shape: &mut Shape, angle: f64, across: f64, along: f64, even: bool) {
    roof_gable_by(env, shape, RoofValue::ByAngle, angle, across, along, even);
}

/// `roofGable(byAngle | byHeight, value, overhangX, overhangY, even)`: a roof as of [`roof_hip_by`], but with upright
/// pediments at its ends (*roofGable operation*). An end is a side whose hip would be a triangle, between convex corners
/// and neighbours that run against each other. `overhangX` is the overhang at the eaves, on the planes; `overhangY` is the
/// overhang in front of the pediments, across their edges. Both are in metres, and negative ones take the planes back
/// from eaves or pediments. A pediment that goes around a corner, or whose
/// overhang would meet another part of the roof, has none in front.
pub fn roof_gable_by(env: &mut Env, shape: &mut Shape, by: RoofValue, value: f64, across: f64, along: f64, even: bool) {
    gable(env, shape, by, value, [across, along], even, None);
}

/// `roofGable(angle, overhangX, overhangY, even, index)`: a gable roof whose ridge is parallel to an edge (*roofGable
/// operation*). Sides across the edge get pediments. The index is a whole number; negative ones count from the end. It is
/// meant for convex faces. Over other faces, overhangs that would bend a plane are left out, with a fault. `even` is ignored.
pub fn roof_gable_along(
    env: &mut Env,
    shape: &mut Shape,
    angle: f64,
    across: f64,
    along: f64,
    _even: bool,
    index: f64,
) {
    let index = env.finite(index, "the index of `roofGable`");
    gable(env, shape, RoofValue::ByAngle, angle, [across, along], false, Some(index));
}

fn gable(
    env: &mut Env,
    shape: &mut Shape,
    by: RoofValue,
    value: f64,
    [across, along]: [f64; 2],
    even: bool,
    index: Option<f64>,
) {
    let across = overhang_of(env, across, "the first overhang of `roofGable`");
    let along = overhang_of(env, along, "the second overhang of `roofGable`");
    let edge = index.map(whole);
    build(env, shape, "roofGable", RoofForm::Gable { across, along, even, edge }, by, value);
}

/// `roofPyramid(angle)`: see [`roof_pyramid_by`].
pub fn roof_pyramid(env: &mut Env, shape: &mut Shape, angle: f64) {
    roof_pyramid_by(env, shape, RoofValue::ByAngle, angle);
}

/// `roofPyramid(byAngle | byHeight, value)`: a pyramid over each face, with its apex over the mean of all corners
/// (*roofPyramid operation*). An angle is measured at the triangle over the first edge, or over the first edge that is not in
/// line with the apex as seen from above. Triangles are in the order of edges, then the bottom.
pub fn roof_pyramid_by(env: &mut Env, shape: &mut Shape, by: RoofValue, value: f64) {
    build(env, shape, "roofPyramid", RoofForm::Pyramid, by, value);
}

/// `roofShed(angle, index)`: see [`roof_shed_by`].
pub fn roof_shed(env: &mut Env, shape: &mut Shape, angle: f64, index: f64) {
    roof_shed_by(env, shape, RoofValue::ByAngle, angle, index);
}

/// `roofShed(byAngle | byHeight, value, index)`: one plane over each face that rises from an edge, and an upright side at
/// each other edge (*roofShed operation*). Faces are in the order of edges, with the plane for the edge that it rises
/// from, then the bottom. The index is a whole number; negative ones count from the end.
///
/// The lowest corner is in the face, also if the edge is not the lowest one. A negative value makes the plane fall: the
/// roof is below the face, and the highest corner is in it.
pub fn roof_shed_by(env: &mut Env, shape: &mut Shape, by: RoofValue, value: f64, index: f64) {
    let edge = whole(env.finite(index, "the index of `roofShed`"));
    build(env, shape, "roofShed", RoofForm::Shed { edge }, by, value);
}

/// `roofRidge(byAngle | byHeight, value)`: two planes over each face, with a ridge parallel to the scope's x axis, and an
/// upright side at each edge (*roofRidge operation*). The planes begin at the outermost corners, and the ridge is half way
/// between them. The planes come first, then the sides in the order of edges, then the bottom.
pub fn roof_ridge_by(env: &mut Env, shape: &mut Shape, by: RoofValue, value: f64) {
    build(env, shape, "roofRidge", RoofForm::Ridge, by, value);
}

fn overhang_of(env: &mut Env, overhang: f64, what: &str) -> f64 {
    env.finite(overhang, what)
}

/// The whole part of an index.
fn whole(index: f64) -> i64 {
    index as i64
}

fn build(env: &mut Env, shape: &mut Shape, name: &str, form: RoofForm, by: RoofValue, value: f64) {
    let value = env.finite(value, format_args!("the value of `{name}`"));
    if !shape.geometry.has_surface() {
        return;
    }
    let falls = matches!(form, RoofForm::Shed { .. });
    let size = if falls { value.abs() } else { value };
    let rise = match by {
        RoofValue::ByAngle if 0.0 < size && size < 90.0 => Rise::Slope(libm::tan(value.to_radians())),
        RoofValue::ByHeight if 0.0 < size => Rise::Height(value),
        RoofValue::ByAngle => return refuse(env, name, "the angle is not between 0 and 90 degrees"),
        RoofValue::ByHeight => return refuse(env, name, "the height is not positive"),
    };
    // Each edge has a face of about four corners, and the bottom. The mesh in the scope is a copy.
    if env.count_corners(6 * shape.corner_count() as u64).is_break() {
        return;
    }
    let mesh = shape.to_mesh();
    let Some(up) = mesh.faces().map(|face| face.normal()).find(|normal| *normal != DVec3::ZERO) else {
        return refuse(env, name, "no face has a normal");
    };
    let Roofs { mesh: made, refused, without_overhangs } = roof_over(&mesh, form, rise);
    if env.spend(0).is_break() {
        return;
    }
    report_refused(env, name, &refused, &REFUSALS);
    report_faces(env, name, without_overhangs.into_iter(), |face, more| {
        format!("face {face} has no room for its overhang{more}; the roof has none")
    });
    if refused.len() < mesh.face_count() {
        // They would cut overhangs, and all that is inserted at eaves.
        shape.trims = Trims::None;
        stand(env, shape, made, up, 1.0, &format!("`{name}`"));
    }
}

#[cold]
fn refuse(env: &mut Env, name: &str, why: &str) {
    env.fault(FaultKind::Value, format!("`{name}`: {why}; the shape stays as it is"));
}

/// The reasons for which a face stays.
const REFUSALS: [(RoofRefusal, &str); 3] = [
    (RoofRefusal::NoNormal, "has no normal"),
    (RoofRefusal::TooMany, "has too many corners"),
    (RoofRefusal::Tangled, "touches itself or leads too far"),
];

#[cfg(test)]
mod tests;
