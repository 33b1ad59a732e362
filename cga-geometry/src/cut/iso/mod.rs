//! Cuts a mesh along lines of constant texture coordinate.
//!
//! One pass cuts at all lines. The side of a corner is one comparison of its coordinate with the line: exact, and no
//! point moves. Along an edge the coordinate is linear. The crossing of an edge with a line is computed once, from the
//! end that comes first in lexicographic order, for all faces that have the same coordinates, up to rounding, at both ends of
//! the edge (`crossings.rs`). At a seam the faces differ, and each has crossings of its own. Only faces are cut: there are no
//! caps.
//!
//! A triangle, or a face with one loop on which the coordinate rises once and falls once, is cut from crossing to
//! crossing (`faces/chain.rs`) if it is convex or the coordinate is affine over it. Any other face is cut triangle by
//! triangle, and the pieces of its triangles are joined again by index (`patch.rs`).

mod affine;
mod band;
mod coordinate;
mod crossings;
mod patch;
mod sites;

use std::ops::Range;
use std::sync::Arc;

use super::class::ClassRange;
use super::faces::chain::{Chain, rises_once, runs};
use super::rising;
use crate::each::Each;
use crate::mesh::{FaceRef, FaceTag, Mesh, TooManyCorners, UvAxis};
use crate::origin::PointOrigin;
use crate::work;
use affine::is_affine;
use band::{BandNumbers, LineBand};
use coordinate::Coordinate;
use crossings::Crossings;
use patch::PatchBuffers;
use sites::Sites;

/// Cuts the faces of a mesh along the lines where a coordinate of a texture set equals a value. Values must increase
/// strictly.
///
/// There is one band more than lines, from low to high. A band without a face is `None`. A band contains the
/// coordinates from its lower line up to its upper line. A face with a constant coordinate on a line is in the band
/// above the line. A band that contains the whole mesh gets the same mesh, not a copy.
///
/// - Faces keep their order, tags, groups and materials. The values of corners are interpolated; the cut coordinate is
///   the coordinate of the line. A piece begins with the remaining part of the face's first edge, as in
///   [`slabs`](super::slabs()).
/// - Faces that agree in the coordinate at both ends of a common edge, up to rounding, share the crossings of the edge: they
///   stay connected. At a seam each face has crossings of its own. Mirrored faces need no special rule.
/// - The coordinate is linear along edges. A convex face on which it rises once and falls once is cut straight from
///   edge to edge, even if the coordinate is not affine, as in a trapezoid of a street. A face that is not convex, with
///   a coordinate that is not affine, is cut triangle by triangle. In both cases the areas of the pieces add up.
/// - A mesh without the set, or without a line in its range, is not cut. A mesh without the set is in the first band.
/// - Values that are NaN or do not increase cut nothing: the band below them stays empty.
///
/// # Errors
/// An error if the bands would have more than `most` corners together. A corner of the mesh on a line counts once.
///
/// ```
/// use std::sync::Arc;
/// use cga_geometry::{cut, mesh::{FaceTag, MeshBuilder, UvAxis}};
/// use cga_geometry::glam::DVec2;
///
/// let mut builder = MeshBuilder::new();
/// let corners = [[0.0, 0.0], [8.0, 0.0], [8.0, -2.0], [0.0, -2.0]].map(|[x, z]| builder.point([x, 0.0, z]));
/// builder.face(&corners, &[], FaceTag::PLAIN).uvs(&[DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y]);
/// let street = Arc::new(builder.build()?);
/// let bands = cut::iso_bands(&street, 0, UvAxis::U, &[0.25, 0.75], 1000)?;
/// let areas: Vec<f64> = bands.iter().flatten().map(|band| band.area()).collect();
/// assert_eq!(areas, [4.0, 8.0, 4.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn iso_bands(
    mesh: &Arc<Mesh>,
    set: usize,
    axis: UvAxis,
    lines: &[f64],
    most: usize,
) -> Result<Vec<Option<Arc<Mesh>>>, TooManyCorners> {
    traced_iso_bands(mesh, set, axis, lines, most).map(|(bands, _)| bands)
}

/// Bands, and for each band the origins of its points, if the mesh has a trace.
pub(crate) type TracedBands = (Vec<Option<Arc<Mesh>>>, Vec<Vec<PointOrigin>>);

/// The same as [`iso_bands`], with the origins of points.
pub fn traced_iso_bands(
    mesh: &Arc<Mesh>,
    set: usize,
    axis: UvAxis,
    lines: &[f64],
    most: usize,
) -> Result<TracedBands, TooManyCorners> {
    let mut bands = vec![None; lines.len() + 1];
    let mut points = vec![Vec::new(); lines.len() + 1];
    let uvs = mesh.uv_set(set);
    if uvs.is_empty() {
        bands[0] = (!mesh.is_empty()).then(|| mesh.clone());
        return Ok((bands, points));
    }
    let kept = rising(lines);
    let (low, high) = range(uvs.iter().map(|uv| uv[axis.index()]));
    // The whole mesh is above a line at the lowest value. A line at the highest value has only the faces on it above.
    let first = kept.partition_point(|&line| lines[line] <= low);
    let end = kept.partition_point(|&line| lines[line] <= high);
    let number = |band: usize| kept.get(band + first).copied().unwrap_or(lines.len());
    if first == end {
        bands[number(0)] = Some(mesh.clone());
        return Ok((bands, points));
    }
    let lines = kept[first..end].iter().map(|&line| lines[line] + 0.0).collect();
    let is_ended = TooManyCorners { most };
    let mut cutter = IsoCutter::new(mesh, Coordinate { set, axis: axis.index() }, lines, most).ok_or(is_ended)?;
    cutter.cut_faces()?;
    let mut numbers = BandNumbers::new(mesh, &cutter.crossings);
    for (band, made) in cutter.bands.into_iter().enumerate() {
        if !work::spend(CORNER * made.mesh.corners.len()) {
            return Err(is_ended);
        }
        bands[number(band)] = made.finish(mesh, &mut numbers, &mut points[number(band)]);
    }
    Ok((bands, points))
}

/// The smallest and the largest value.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// The units of work of a corner.
const CORNER: usize = 16;

/// A cut in progress.
struct IsoCutter<'m> {
    mesh: &'m Mesh,
    most: usize,
    sites: Sites,
    crossings: Crossings,
    bands: Vec<LineBand>,
    chain: Chain,
    patch: PatchBuffers,
    /// The number of corners made so far.
    made: usize,
}

impl<'m> IsoCutter<'m> {
    /// Prepares a cut; `None` if the work is to end.
    fn new(mesh: &'m Mesh, coordinate: Coordinate, lines: Vec<f64>, most: usize) -> Option<Self> {
        let sites = Sites::of(mesh, coordinate, &lines)?;
        let crossings = Crossings::new(coordinate, lines, sites.len(), mesh.points.len());
        let count = crossings.lines.len() + 1;
        let bands = (0..count).map(|_| LineBand::new(mesh, count)).collect();
        let (chain, patch) = Default::default();
        // Points and crossings have 32-bit numbers.
        let most = most.min(u32::MAX as usize / 16);
        Some(IsoCutter { mesh, most, sites, crossings, bands, chain, patch, made: 0 })
    }

    fn cut_faces(&mut self) -> Result<(), TooManyCorners> {
        let mut start = 0;
        for face in 0..self.mesh.face_count() {
            let corners = start..self.mesh.loop_ends[self.mesh.face_loops(face).end - 1] as usize;
            start = corners.end;
            let span = ClassRange::of(corners.clone().map(|corner| self.sites.class(corner)));
            self.cut_face(face, corners, span)?;
        }
        Ok(())
    }

    fn cut_face(&mut self, face: usize, corners: Range<usize>, span: ClassRange) -> Result<(), TooManyCorners> {
        let (mesh, tag) = (self.mesh, self.mesh.tags[face]);
        if span.bottom() == span.top() || span.is_flat() {
            // A face on a line is in the band above it.
            let band = span.bottom();
            self.count(corners.len())?;
            self.bands[band as usize].keep(mesh, face, tag);
            return Ok(());
        }
        let is_triangle = corners.len() == 3;
        let is_one_way = mesh.face_loops(face).len() == 1 && (is_triangle || self.rises_once(corners.clone()));
        if is_one_way
            && (is_triangle || mesh.face(face).is_convex() || is_affine(mesh, face, self.crossings.coordinate))
        {
            self.count(self.crossings_of(&mesh.face(face)))?;
            self.cut_chain(corners, tag, span);
            return Ok(());
        }
        let is_affine = is_affine(mesh, face, self.crossings.coordinate);
        let mut patch = std::mem::take(&mut self.patch);
        let result = patch.cut(self, face, is_affine);
        self.patch = patch;
        result
    }

    /// Counts corners before they are made.
    fn count(&mut self, corners: usize) -> Result<(), TooManyCorners> {
        self.spend(corners)?;
        self.made = self.made.saturating_add(corners);
        if self.most < self.made { Err(TooManyCorners { most: self.most }) } else { Ok(()) }
    }

    /// Counts the work of corners. An error if the work is to end.
    fn spend(&self, corners: usize) -> Result<(), TooManyCorners> {
        if work::spend(CORNER * corners) { Ok(()) } else { Err(TooManyCorners { most: self.most }) }
    }

    /// Returns an error for a face whose triangles would far exceed the limit.
    fn foresee(&self, corners: usize) -> Result<(), TooManyCorners> {
        // Joining the pieces of triangles reduces their corners several times, hence the factor.
        let is_too_many = self.most.saturating_sub(self.made).saturating_mul(8) < corners;
        if is_too_many { Err(TooManyCorners { most: self.most }) } else { Ok(()) }
    }

    /// The corners of a face and all its crossings, which both sides of a line have.
    fn crossings_of(&self, face: &FaceRef<'_>) -> usize {
        let between = |edge: [usize; 2]| {
            let [a, b] = edge.each(|corner| self.sites.class(corner));
            2 * ClassRange::between(a, b).planes().len() + 1
        };
        face.edges().map(between).sum()
    }

    /// Returns true if the coordinate rises once and falls once around a loop, and repeats only at its ends.
    fn rises_once(&self, corners: Range<usize>) -> bool {
        let values = corners.map(|corner| self.sites.value(corner));
        let (low, high) = range(values.clone());
        rises_once(values, |value| value == low || value == high)
    }

    /// Cuts a face with one way up and one way down.
    fn cut_chain(&mut self, corners: Range<usize>, tag: FaceTag, span: ClassRange) {
        let IsoCutter { mesh, sites, crossings, chain, .. } = self;
        let node = |i: usize| sites.node(mesh, corners.start + i);
        chain.walk(corners.len(), span, node, |from, to, nodes| crossings.cross(mesh, sites, from, to, nodes));
        chain.pieces(span, |band, ahead, back, _| {
            let Some(runs) = runs(ahead, back, &corners) else { return };
            let band = &mut self.bands[band as usize];
            runs.into_iter().for_each(|run| band.corners(mesh, crossings, run));
            band.mesh.end_loop();
            band.mesh.end_face(tag);
        });
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::rc::Rc;

    use glam::DVec2;

    use super::*;
    use crate::mesh::MeshBuilder;
    use crate::work::{Supervisor, UNITS_A_QUESTION};

    #[test]
    fn faces_whose_coordinates_differ_by_rounding_stay_connected() {
        // Three strips; at their two seams the coordinates differ by one bit, and by more.
        let bands = |off: f64| {
            let mut builder = MeshBuilder::new();
            for x in 0..3_u32 {
                let corners = [[x, 0], [x + 1, 0], [x + 1, 1], [x, 1]].map(|corner| corner.map(f64::from));
                let points = corners.map(|[x, z]| builder.point([x, 0.0, -z]));
                let uvs = corners.map(|[u, v]| DVec2::new(u, 0.3 + v + off * f64::from(x)));
                builder.face(&points, &[], FaceTag::PLAIN).uvs(&uvs);
            }
            let mesh = Arc::new(builder.build().unwrap());
            iso_bands(&mesh, 0, UvAxis::V, &[0.7, 0.9], usize::MAX).unwrap()
        };
        let points = |off: f64| bands(off).iter().flatten().map(|band| band.points().len()).collect::<Vec<_>>();
        assert_eq!([points(0.0), points(f64::EPSILON), points(-f64::EPSILON)], [[8; 3]; 3]);
        assert_eq!(points(1e-6), [10, 12, 10]);
        for value in [0.4 * f64::MAX, -1e300, f64::MIN_POSITIVE] {
            assert!(bands(value).len() == 3);
        }
    }

    #[test]
    fn every_pass_over_many_corners_can_end() {
        let mut builder = MeshBuilder::new();
        for x in 0..5000_u32 {
            let corners = [[x, 0], [x + 1, 0], [x + 1, 1], [x, 1]].map(|corner| corner.map(f64::from));
            let points = corners.map(|[x, z]| builder.point([x, 0.0, -z]));
            builder.face(&points, &[], FaceTag::PLAIN).uvs(&corners.map(DVec2::from));
        }
        let mesh = Arc::new(builder.build().unwrap());
        let cut = |last: u64| {
            let count = Rc::new(Cell::new(0));
            let asked = count.clone();
            let _supervisor = Supervisor::new(move |_| asked.replace(asked.get() + 1) < last);
            (traced_iso_bands(&mesh, 0, UvAxis::U, &[2000.5], usize::MAX).is_ok(), count.get())
        };
        let (is_cut, questions) = cut(u64::MAX);
        let pass = (CORNER * mesh.corners.len()) as u64 / UNITS_A_QUESTION;
        // Finishing a band counts all its corners at once.
        assert!(is_cut && 2 * pass + 2 <= questions, "{questions} questions, {pass} in a pass");
        for last in 0..questions {
            assert_eq!(cut(last), (false, last + 1));
        }
    }
}
