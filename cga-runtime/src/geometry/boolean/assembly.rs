//! The mesh of a result.

use glam::{DVec2, DVec3};

use super::component_tags::EdgeTags;
use super::edge_table::NO_CORNER;
use super::facet::Facet;
use super::operation::BooleanOp;
use super::polygon::{PolygonCorner, ResultPolygon};
use crate::geometry::mesh::{FaceTag, Mesh, SubcomponentTagger, SubcomponentTags, TagSet, TagSetTable, flip, unit};
use crate::geometry::triangulate::{PlaneProjection, Triangulator};
use crate::value::text::Text;

/// Makes the mesh of polygons.
pub(super) struct Assembly<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) facets: &'a [Facet],
    /// The operand of each facet.
    pub(super) operands: &'a [u8],
    /// The places of points.
    pub(super) places: &'a [DVec3],
    pub(super) edge_tags: &'a EdgeTags,
    /// The tags of points, sorted.
    pub(super) vertex_tags: &'a [(u32, TagSet)],
    pub(super) op: BooleanOp,
}

/// The values of a corner, as shares of corners of the mesh.
type Shares = [(u32, f64); 3];

fn only(corner: u32) -> Shares {
    [(corner, 1.0), (corner, 0.0), (corner, 0.0)]
}

impl Assembly<'_> {
    /// The mesh of the result.
    pub(super) fn mesh_of(&self, polygons: &[ResultPolygon]) -> Mesh {
        // Points keep their order; new points come last.
        let corners = || polygons.iter().flat_map(|polygon| polygon.rings.iter().flatten());
        let mut used: Vec<u32> = corners().map(|corner| corner.point).collect();
        let mut made = self.mesh.alike(used.len());
        used.sort_unstable();
        used.dedup();
        made.points.extend(used.iter().map(|point| self.places[*point as usize] + 0.0));
        let mut sets = TagSetTable::default();
        let mut triangulator = Triangulator::new();
        let mut triangles: Option<(u32, Vec<[u32; 3]>)> = None;
        for polygon in polygons {
            let facet = &self.facets[polygon.sources[0] as usize];
            for ring in &polygon.rings {
                let shares = |place: usize| -> Shares {
                    let last = &ring[if place == 0 { ring.len() - 1 } else { place - 1 }];
                    self.on_outline(facet, last, &ring[place]).unwrap_or([(NO_CORNER, 0.0); 3])
                };
                let mut corners: Vec<(u32, Shares)> =
                    (0..ring.len()).map(|place| (ring[place].point, shares(place))).collect();
                if !made.uvs.is_empty() || !self.mesh.normals().is_empty() {
                    for (point, shares) in corners.iter_mut().filter(|(_, shares)| shares[0].0 == NO_CORNER) {
                        if triangles.as_ref().is_none_or(|known| known.0 != facet.face) {
                            let mut list = Vec::new();
                            triangulator.face(self.mesh, facet.face as usize, &mut list);
                            triangles = Some((facet.face, list));
                        }
                        let list = triangles.as_ref().map_or(&[][..], |known| &known.1);
                        *shares = self.inside_face(facet, list, self.places[*point as usize]);
                    }
                }
                if polygon.is_turned {
                    flip(&mut corners);
                }
                for (point, shares) in corners {
                    made.corners.push(used.binary_search(&point).unwrap_or_default() as u32);
                    self.add_values(&mut made, &shares, polygon.is_turned);
                }
                made.end_loop();
            }
            let tag = self.mesh.face(facet.face as usize).tag();
            let tags = self.tags(polygon);
            let tags = if tags.names().is_empty() { FaceTag::NONE } else { sets.number(&tags) };
            made.end_face(FaceTag { tags, ..tag });
        }
        made.tag_sets = sets.into_sets();
        made.subcomponent_tags = self.subcomponent_tags(polygons, &used);
        made
    }

    /// The tags of edges and vertices. `used` are the points of the result.
    fn subcomponent_tags(&self, polygons: &[ResultPolygon], used: &[u32]) -> SubcomponentTags {
        let mut tagger = SubcomponentTagger::default();
        let number = |point: u32| used.binary_search(&point).ok().map(|number| number as u32);
        for ring in polygons.iter().flat_map(|polygon| &polygon.rings) {
            for (corner, next) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                if let Some(tags) = self.edge_tags.set(corner.tags)
                    && let (Some(a), Some(b)) = (number(corner.point), number(next.point))
                {
                    tagger.edge([a, b], tags);
                }
            }
        }
        for (point, tags) in self.vertex_tags {
            number(*point).into_iter().for_each(|point| tagger.vertex(point, tags));
        }
        tagger.finish()
    }

    fn add_values(&self, made: &mut Mesh, shares: &Shares, is_turned: bool) {
        made.uvs.push_from(&self.mesh.uvs, |list| {
            if shares[0].1 == 1.0 {
                return list[shares[0].0 as usize];
            }
            shares.iter().map(|(corner, share)| list[*corner as usize] * *share).sum()
        });
        if !self.mesh.normals().is_empty() {
            let normal = |corner: u32| self.mesh.normals()[corner as usize];
            let sum = if shares[0].1 == 1.0 {
                normal(shares[0].0)
            } else {
                unit(shares.iter().map(|(corner, share)| normal(*corner) * *share).sum())
            };
            made.normals.push(if is_turned { -sum } else { sum });
        }
    }

    /// The shares of a corner on the outline of its face: a corner or two of the face. `None` for a corner inside.
    fn on_outline(&self, facet: &Facet, last: &PolygonCorner, corner: &PolygonCorner) -> Option<Shares> {
        let is_here = |source: &u32| {
            let at = facet.sources.iter().position(|known| known == source);
            at.is_some_and(|at| facet.corners[at] == corner.point)
        };
        for along in [corner.along, last.along] {
            if along[0] == NO_CORNER {
                continue;
            }
            if let Some(source) = along.iter().find(|source| is_here(source)) {
                return Some(only(*source));
            }
            let [a, b] = along.map(|source| self.mesh.points()[self.mesh.corners()[source as usize] as usize]);
            let place = self.places[corner.point as usize];
            let share = ((place - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            return Some([(along[0], 1.0 - share), (along[1], share), (along[1], 0.0)]);
        }
        let at = facet.corners.iter().position(|point| *point == corner.point)?;
        Some(only(facet.sources[at]))
    }

    /// The shares of a place inside a face: the corners of its triangle.
    fn inside_face(&self, facet: &Facet, triangles: &[[u32; 3]], place: DVec3) -> Shares {
        let flat = PlaneProjection::along(self.mesh.face(facet.face as usize).normal());
        let at = |corner: u32| flat.apply(self.mesh.points()[self.mesh.corners()[corner as usize] as usize]);
        let place = flat.apply(place);
        let shares = |triangle: &[u32; 3]| -> [f64; 3] {
            let [a, b, c] = triangle.map(at);
            let whole = (b - a).perp_dot(c - a);
            let part = |a: DVec2, b: DVec2| (a - place).perp_dot(b - place) / whole;
            [part(b, c), part(c, a), part(a, b)]
        };
        let least = |shares: &[f64; 3]| shares.iter().copied().fold(f64::INFINITY, f64::min);
        let all = triangles.iter().map(|triangle| (triangle, shares(triangle)));
        let best = all
            .filter(|(_, shares)| shares.iter().all(|share| share.is_finite()))
            .max_by(|a, b| least(&a.1).total_cmp(&least(&b.1)));
        best.map_or_else(
            || only(facet.sources[0]),
            |(triangle, shares)| [0, 1, 2].map(|end| (triangle[end], shares[end])),
        )
    }

    /// The tags of a face: those of all its sources, with new ones for the operands (*Boolean operations*, component tags).
    fn tags(&self, polygon: &ResultPolygon) -> TagSet {
        let of = |facet: &u32| {
            let tag = self.mesh.face(self.facets[*facet as usize].face as usize).tag();
            self.mesh.tag_sets().get(tag.tags as usize).map_or(&[][..], TagSet::names).iter().cloned()
        };
        let names = polygon.sources.iter().flat_map(of);
        if self.op == BooleanOp::Unify {
            return TagSet::new(names);
        }
        let operand = |facet: &u32| ["bool.A", "bool.B"][usize::from(self.operands[*facet as usize])];
        let own = polygon.sources.iter().map(|facet| Text::from(operand(facet)));
        TagSet::new(names).without(Some("bool")).union(&TagSet::new(own))
    }
}
