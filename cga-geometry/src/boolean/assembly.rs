//! The mesh of a result.

use glam::DVec3;

use super::component_tags::EdgeTags;
use super::edge_table::NO_CORNER;
use super::face_values::{FaceValues, Shares, only};
use super::facet::Facet;
use super::operation::{BooleanError, BooleanOp};
use super::polygon::{PolygonCorner, ResultPolygon, ResultPolygons};
use super::progress::goes_on;
use crate::derive::{CornerValues, Derivation, FaceOrigin, Mix, PointOrigin};
use crate::each::Each;
use crate::mesh::{Mesh, TagSet, flip};
use crate::small_sort::SmallSort;
use crate::triangulate::Triangulator;

/// Makes the mesh of polygons.
pub(super) struct Assembly<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) facets: &'a [Facet<'a>],
    /// The operand of each facet.
    pub(super) operands: &'a [u8],
    /// The places of points.
    pub(super) places: &'a [DVec3],
    pub(super) edge_tags: &'a EdgeTags,
    /// The tags of points, sorted.
    pub(super) vertex_tags: &'a [(u32, TagSet)],
    pub(super) op: BooleanOp,
}

impl Assembly<'_> {
    /// The mesh of the result.
    pub(super) fn mesh_of(&self, polygons: &ResultPolygons<'_>) -> Result<Mesh, BooleanError> {
        let corners = polygons.iter().map(|polygon| polygon.rings.corners.len()).sum();
        let mut made = Derivation::new(self.mesh, CornerValues::All, corners).without_trace();
        let numbers = self.numbers(polygons, &mut made)?;
        let mut triangulator = Triangulator::new();
        let mut values: Option<FaceValues> = None;
        // The facet of the last polygon, and its corners of the mesh by their points.
        let (mut last_facet, mut corner_at) = (None, Vec::new());
        for polygon in polygons.iter() {
            goes_on(polygon.rings.corners.len())?;
            let facet = &self.facets[polygon.sources[0] as usize];
            if last_facet.replace(polygon.sources[0]) != Some(polygon.sources[0]) {
                corner_at = facet.rings.corners.iter().copied().zip(facet.sources.iter().copied()).collect();
                corner_at.small_sort();
            }
            for ring in polygon.rings.iter() {
                let shares = |place: usize| -> Shares {
                    let last = &ring[if place == 0 { ring.len() - 1 } else { place - 1 }];
                    self.on_outline(facet, &corner_at, last, &ring[place]).unwrap_or(only(NO_CORNER))
                };
                let mut corners: Vec<(u32, Shares)> =
                    (0..ring.len()).map(|place| (ring[place].point, shares(place))).collect();
                if made.has_values() {
                    for (point, shares) in corners.iter_mut().filter(|(_, shares)| shares[0].0 == NO_CORNER) {
                        let known = values.take().filter(|known| known.face == facet.face);
                        let known = values
                            .insert(known.unwrap_or_else(|| FaceValues::of(self.mesh, facet.face, &mut triangulator)));
                        *shares = known.shares(facet, self.places[*point as usize]);
                    }
                }
                if polygon.is_turned {
                    flip(&mut corners);
                }
                for (point, shares) in corners {
                    let mix = if shares[0].1 == 1.0 { Mix::One(shares[0].0) } else { Mix::Three(shares) };
                    made.corner(numbers[point as usize], &mix, polygon.is_turned);
                }
                made.end_loop();
            }
            let origin = FaceOrigin::piece(&self.mesh.face(facet.face as usize));
            made.end_tagged_face(origin, &self.tags(&polygon));
        }
        self.tag_components(&mut made, polygons, &numbers)?;
        goes_on(made.point_count())?;
        Ok(made.finish())
    }

    /// Adds the points of the result. Returns the number of each, [`NO_CORNER`] for a point that is not in the result.
    ///
    /// Points of the operands keep their order. New points come last, in the order of the polygons: their own order follows
    /// coordinates, and so rounding errors.
    fn numbers(&self, polygons: &ResultPolygons<'_>, made: &mut Derivation<'_>) -> Result<Vec<u32>, BooleanError> {
        const IN_RESULT: u32 = NO_CORNER - 1;
        let (mut numbers, old) = (vec![NO_CORNER; self.places.len()], self.mesh.points().len());
        let mut add = |point: usize| made.point(self.places[point] + 0.0, PointOrigin::New);
        for polygon in polygons.iter() {
            goes_on(polygon.rings.corners.len())?;
            polygon.rings.corners.iter().for_each(|corner| numbers[corner.point as usize] = IN_RESULT);
        }
        for (point, number) in numbers.iter_mut().enumerate().take(old).filter(|(_, number)| **number == IN_RESULT) {
            *number = add(point);
        }
        for polygon in polygons.iter() {
            for point in polygon.rings.corners.iter().map(|corner| corner.point as usize) {
                if numbers[point] == IN_RESULT {
                    numbers[point] = add(point);
                }
            }
        }
        Ok(numbers)
    }

    /// Gives edges and vertices their tags. `numbers` has the number of each point in the result.
    fn tag_components(
        &self,
        made: &mut Derivation<'_>,
        polygons: &ResultPolygons<'_>,
        numbers: &[u32],
    ) -> Result<(), BooleanError> {
        let number = |point: u32| numbers.get(point as usize).copied().filter(|number| *number != NO_CORNER);
        for ring in polygons.iter().flat_map(|polygon| polygon.rings.iter()) {
            goes_on(ring.len())?;
            for (corner, next) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                if let Some(tags) = self.edge_tags.set(corner.tags)
                    && let (Some(a), Some(b)) = (number(corner.point), number(next.point))
                {
                    made.tag_edge([a, b], tags);
                }
            }
        }
        for (point, tags) in self.vertex_tags {
            number(*point).into_iter().for_each(|point| made.tag_vertex(point, tags));
        }
        Ok(())
    }

    /// The shares of a corner on the outline of its face: a corner or two of the face. `None` for a corner inside.
    /// `corner_at` has the facet's corners of the mesh by their points.
    fn on_outline(
        &self,
        facet: &Facet<'_>,
        corner_at: &[(u32, u32)],
        last: &PolygonCorner,
        corner: &PolygonCorner,
    ) -> Option<Shares> {
        let is_here = |source: &u32| facet.point_at(*source) == Some(corner.point);
        for along in [corner.along, last.along] {
            if along[0] == NO_CORNER {
                continue;
            }
            if let Some(source) = along.iter().find(|source| is_here(source)) {
                return Some(only(*source));
            }
            let [a, b] = along.each(|source| self.mesh.points()[self.mesh.corners()[source as usize] as usize]);
            let place = self.places[corner.point as usize];
            let share = ((place - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            return Some([(along[0], 1.0 - share), (along[1], share), (along[1], 0.0)]);
        }
        let at = corner_at.partition_point(|known| known.0 < corner.point);
        corner_at.get(at).filter(|known| known.0 == corner.point).map(|known| only(known.1))
    }

    /// The tags of a face: the tags of all its sources, with new ones for the operands.
    fn tags(&self, polygon: &ResultPolygon<'_>) -> TagSet {
        let of = |facet: &u32| {
            let tags = self.mesh.face(self.facets[*facet as usize].face as usize).tags();
            tags.map_or(&[][..], TagSet::names).iter().cloned()
        };
        let names = polygon.sources.iter().flat_map(of);
        if self.op == BooleanOp::Unify {
            return TagSet::new(names);
        }
        let operand = |facet: &u32| ["bool.A", "bool.B"][usize::from(self.operands[*facet as usize])];
        let own = polygon.sources.iter().map(operand);
        TagSet::new(names).without_below("bool").union(&TagSet::new(own))
    }
}
