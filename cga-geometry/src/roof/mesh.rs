//! Roofs over the faces of a mesh.

use glam::{DVec2, DVec3};

use super::rectangle::roof_by_formula;
use super::{Outline, Rise, Roof, RoofFace, RoofForm, RoofPart, roof_with_or_without_overhangs};
use crate::derive::{CornerValues, Derivation, FaceOrigin, PointOrigin};
use crate::each::Each;
use crate::mesh::{FaceRef, FlatFace, Mesh, flip, unit};
use crate::skeleton::{SkeletonError, any_cross};
use crate::tol::{TOUCH_EPSILON, UP_EPSILON};
use crate::triangulate::highest;
use crate::work;

/// The units of work of a corner of a face.
const CORNER: usize = 128;

/// The reason why a face has no roof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoofRefusal {
    /// The face has no normal: its area is 0 or not finite.
    NoNormal,
    /// The face has too many corners.
    TooMany,
    /// The outlines of the face cross, or a number leads too far.
    Tangled,
}

/// The roofs over the faces of a mesh.
#[derive(Debug)]
pub struct Roofs {
    /// The mesh with the roofs.
    pub mesh: Mesh,
    /// The faces without a roof, and why. They are copied unchanged.
    pub refused: Vec<(usize, RoofRefusal)>,
    /// The faces whose roofs have no overhangs, although the form has some.
    pub without_overhangs: Vec<usize>,
}

/// Builds a roof over each face: the faces of the roof in the order of edges, then the face itself, turned over, as the bottom.
/// Faces that cannot have a roof are copied unchanged, and are listed with the reason.
///
/// The time is quadratic in the number of corners of a face. If the work of a [`Supervisor`](crate::work::Supervisor) ends meanwhile,
/// the mesh and the lists have no meaning.
///
/// ```
/// use cga_geometry::primitive;
/// use cga_geometry::roof::{Rise, RoofForm, roof_over};
///
/// // A pyramid of height 2 over a square with sides of 1.
/// let roofs = roof_over(&primitive::quad(), RoofForm::Pyramid, Rise::Height(2.0));
/// assert!(roofs.refused.is_empty() && roofs.mesh.is_closed());
/// assert_eq!(roofs.mesh.face_count(), 5);
/// assert!((roofs.mesh.volume() - 2.0 / 3.0).abs() < 1e-12);
/// ```
pub fn roof_over(source: &Mesh, form: RoofForm, rise: Rise) -> Roofs {
    let mut made = Derivation::new(source, CornerValues::Dropped, 0);
    let mut bent = source.bent;
    let (mut refused, mut without_overhangs) = (Vec::new(), Vec::new());
    for face in source.faces() {
        if !work::spend(CORNER * face.corner_count()) {
            break;
        }
        match add_roof(&face, form, rise, &mut made, &mut bent) {
            Ok(true) => {}
            Ok(false) => without_overhangs.push(face.index()),
            Err(why) => {
                refused.push((face.index(), why));
                made.copy(&face);
            }
        }
    }
    Roofs { mesh: Mesh { bent, ..made.finish_by_use() }, refused, without_overhangs }
}

/// Adds the roof over a face. Returns true if it has the overhangs of its form.
fn add_roof(
    face: &FaceRef<'_>,
    form: RoofForm,
    rise: Rise,
    made: &mut Derivation<'_>,
    bent: &mut DVec3,
) -> Result<bool, RoofRefusal> {
    if !rise.is_finite() || !form.has_numbers() {
        return Err(RoofRefusal::Tangled);
    }
    let flat = FlatFace::of(face).ok_or(RoofRefusal::NoNormal)?;
    let (_, rings) = flat.edges(false);
    // Across the face: along its first edge.
    let x = DVec2::new(flat.axes[0].x, flat.axes[1].x).try_normalize().unwrap_or(DVec2::X);
    let outline = Outline { points: &flat.flat, rings: &rings, x };
    let (Roof { points, faces, moved, below }, is_complete) = match roof_by_formula(&outline, form, rise) {
        Some(made) => (made, true),
        None => general_roof(&outline, form, rise)?,
    };
    if faces.is_empty() || !points.iter().all(|point| point.is_finite()) {
        return Err(RoofRefusal::Tangled);
    }
    // A mesh has one direction along which bent faces have no folds. Other roofs have triangles.
    let is_bent = moved.contains(&true);
    let is_flat = is_bent && UP_EPSILON < unit(*bent).cross(flat.normal).length();
    if is_bent && *bent == DVec3::ZERO {
        *bent = flat.normal;
    }
    let faces = if is_flat { faces.into_iter().flat_map(|face| triangles(face, &points)).collect() } else { faces };
    let base = made.point_count() as u32;
    flat.points.iter().for_each(|&point| _ = made.old_point(point));
    let place = |p: &DVec3| flat.origin + flat.axes[0] * p.x + flat.axes[1] * p.y + flat.normal * p.z;
    points[flat.points.len()..].iter().for_each(|point| _ = made.point(place(point), PointOrigin::Grown));
    let edges: Vec<[usize; 2]> = face.edges().collect();
    let mut bottom = RoofFace { part: RoofPart::Bottom, edge: None, rings: rings.clone() };
    bottom.rings.iter_mut().for_each(|ring| flip(ring));
    for RoofFace { part, edge, mut rings } in faces.into_iter().chain([bottom]) {
        for ring in &mut rings {
            if below {
                flip(ring);
            }
            ring.iter_mut().for_each(|point| *point += base);
        }
        made.face(
            &rings,
            match edge.and_then(|edge| edges.get(edge as usize)) {
                Some(edge) => FaceOrigin::over_edge(face, part.tag(), *edge),
                None => FaceOrigin::over(face, part.tag()),
            },
        );
    }
    Ok(is_complete)
}

/// Makes a roof over a polygon whose outlines may cross.
fn general_roof(outline: &Outline<'_>, form: RoofForm, rise: Rise) -> Result<(Roof, bool), RoofRefusal> {
    let ends = |[a, b]: [u32; 2]| [outline.at(a), outline.at(b)];
    let extent = outline.points.iter().fold(0.0, |most: f64, p| most.max(p.abs().max_element()));
    if any_cross(outline.edges().into_iter().map(ends).collect(), TOUCH_EPSILON * extent) {
        return Err(RoofRefusal::Tangled);
    }
    roof_with_or_without_overhangs(outline, form, rise).map_err(|failure| match failure {
        SkeletonError::TooMany => RoofRefusal::TooMany,
        SkeletonError::Tangled => RoofRefusal::Tangled,
    })
}

/// A face of a roof as triangles, or whole if it is a triangle or has several rings.
fn triangles(face: RoofFace, points: &[DVec3]) -> Vec<RoofFace> {
    let [ring] = &face.rings[..] else { return vec![face] };
    let at = |&point: &u32| points[point as usize];
    let made = highest(&ring.iter().map(at).collect::<Vec<_>>()).filter(|_| face.part == RoofPart::Top);
    let Some(made) = made else { return vec![face] };
    let rings = made.into_iter().map(|numbers| vec![numbers.each(|number| ring[number]).to_vec()]);
    rings.map(|rings| RoofFace { part: face.part, edge: face.edge, rings }).collect()
}
