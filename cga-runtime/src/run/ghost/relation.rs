//! The relation of a geometry to closed solids, for boxes along the axes of the world.
//!
//! Geometries count as the boxes around them, so the answers are right for boxes, rectangles, edges and points along the world's axes
//! alone.

use std::marker::PhantomData;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use crate::geometry::mesh::{Bounds, Mesh};

/// The answers for a geometry: each one holds for at least one solid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Relation {
    pub(crate) inside: bool,
    pub(crate) overlaps: bool,
    pub(crate) touches: bool,
}

impl Relation {
    pub(crate) const NONE: Relation = Relation { inside: false, overlaps: false, touches: false };
    pub(crate) const INSIDE: Relation = Relation { inside: true, ..Relation::NONE };
    pub(crate) const OVERLAPS: Relation = Relation { overlaps: true, ..Relation::NONE };
    pub(crate) const TOUCHES: Relation = Relation { touches: true, ..Relation::NONE };

    /// The answers that hold in one of two relations.
    pub(crate) fn or(self, other: Relation) -> Relation {
        Relation {
            inside: self.inside | other.inside,
            overlaps: self.overlaps | other.overlaps,
            touches: self.touches | other.touches,
        }
    }

    /// The answers that hold in both relations.
    pub(crate) fn and(self, other: Relation) -> Relation {
        Relation {
            inside: self.inside & other.inside,
            overlaps: self.overlaps & other.overlaps,
            touches: self.touches & other.touches,
        }
    }
}

/// A closed solid in the world.
#[derive(Debug)]
pub(crate) struct Occluder(Bounds);

impl Occluder {
    /// A mesh that is placed in the world.
    pub(crate) fn mesh(mesh: Arc<Mesh>, placement: DAffine3) -> Self {
        Occluder(placed(mesh.points(), &placement))
    }

    /// The box from (0, 0, 0) to (1, 1, 1), placed in the world.
    pub(crate) fn cuboid(placement: DAffine3) -> Self {
        Occluder(unit_box(&placement))
    }
}

/// A geometry to compare with solids, in the world.
#[derive(Debug)]
pub(crate) struct QueryGeometry<'m> {
    bounds: Bounds,
    mesh: PhantomData<&'m Mesh>,
}

impl<'m> QueryGeometry<'m> {
    fn of(bounds: Bounds) -> Self {
        QueryGeometry { bounds, mesh: PhantomData }
    }

    /// A mesh that is placed in the world.
    pub(crate) fn mesh(mesh: &'m Mesh, placement: DAffine3) -> Self {
        QueryGeometry::of(placed(mesh.points(), &placement))
    }

    /// The box from (0, 0, 0) to (1, 1, 1), placed in the world.
    pub(crate) fn cuboid(placement: DAffine3) -> Self {
        QueryGeometry::of(unit_box(&placement))
    }

    /// The rectangle with a corner and two sides from it.
    pub(crate) fn rectangle(corner: DVec3, [a, b]: [DVec3; 2]) -> Self {
        QueryGeometry::of(Bounds::of([corner, corner + a, corner + b, corner + a + b]))
    }

    /// The segment between two points.
    pub(crate) fn segment(ends: [DVec3; 2]) -> Self {
        QueryGeometry::of(Bounds::of(ends))
    }

    /// A point.
    pub(crate) fn point(point: DVec3) -> Self {
        QueryGeometry::of(Bounds::of([point]))
    }
}

fn placed(points: &[DVec3], placement: &DAffine3) -> Bounds {
    Bounds::of(points.iter().map(|point| placement.transform_point3(*point)))
}

fn unit_box(placement: &DAffine3) -> Bounds {
    let corner = |at: usize| DVec3::new((at & 1) as f64, (at >> 1 & 1) as f64, (at >> 2) as f64);
    placed(&std::array::from_fn::<DVec3, 8, _>(corner), placement)
}

/// Many closed solids. They are not united.
#[derive(Debug, Default)]
pub(crate) struct Occluders {
    boxes: Vec<Bounds>,
}

/// Lengths below this count as contact, in metres.
const TOLERANCE: f64 = 1e-3;

impl Occluders {
    /// The solids of a list, numbered from 0.
    pub(crate) fn new(list: impl IntoIterator<Item = Occluder>) -> Self {
        Occluders { boxes: list.into_iter().map(|occluder| occluder.0).collect() }
    }

    /// The wanted answers for a geometry. `accept` returns false for the numbers of solids that are to be left out.
    pub(crate) fn query(
        &self,
        geometry: &QueryGeometry<'_>,
        wanted: Relation,
        accept: &mut dyn FnMut(u32) -> bool,
    ) -> Relation {
        let found = self.boxes.iter().zip(0..).map(|(solid, number)| (relation(&geometry.bounds, solid), number));
        let found = found.filter(|(relation, number)| *relation != Relation::NONE && accept(*number));
        found.fold(Relation::NONE, |all, (relation, _)| all.or(relation)).and(wanted)
    }
}

fn relation(query: &Bounds, solid: &Bounds) -> Relation {
    let (size, shared) = (query.high - query.low, query.high.min(solid.high) - query.low.max(solid.low));
    let is_apart = shared.min_element() < -TOLERANCE || shared.is_nan();
    if is_apart {
        return Relation::NONE;
    }
    let axes = || 0..3;
    let is_thin = |length: f64| length <= TOLERANCE;
    // Along an axis without extent, the geometry is between the sides of the solid or on one of them.
    let is_between =
        |axis: usize| solid.low[axis] + TOLERANCE < query.low[axis] && query.high[axis] < solid.high[axis] - TOLERANCE;
    let overlaps = axes().all(|axis| if is_thin(size[axis]) { is_between(axis) } else { !is_thin(shared[axis]) });
    let inside = (query.low - solid.low).min(solid.high - query.high).min_element() >= -TOLERANCE;
    // Contact along an area: one axis is across it.
    let has_area = axes().filter(|axis| is_thin(shared[*axis])).count() == 1;
    let contact = has_area && axes().all(|axis| !is_thin(shared[axis]) || !is_between(axis));
    Relation { inside, overlaps, touches: inside | overlaps | contact }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ten_relations_of_the_reference() {
        let solid = Occluder::cuboid(DAffine3::from_scale(DVec3::splat(2.0)));
        let occluders = Occluders::new([solid]);
        let all = Relation { inside: true, overlaps: true, touches: true };
        for (name, low, high, expected) in [
            ("a", [1., 1., 2.], [3., 3., 2.], [true, false, false]),
            ("b", [1., 2., 0.], [3., 4., 2.], [true, false, false]),
            ("c", [0.5, 2., 1.], [1.5, 3., 1.], [false, false, false]),
            ("d", [-2., 2., 0.], [0., 4., 2.], [false, false, false]),
            ("e", [-1., 1., 1.], [1., 3., 1.], [true, true, false]),
            ("f", [-1., 0., 0.], [1., 2., 2.], [true, true, false]),
            ("g", [-1., -1., -1.], [3., 3., 2.], [true, true, false]),
            ("h", [0., 0., 2.], [1., 1., 2.], [true, false, true]),
            ("i", [0.5, 0., 1.], [1.5, 1., 1.], [true, true, true]),
            ("j", [0.5, 0., 1.], [1.5, 1., 2.], [true, true, true]),
        ] {
            let query = QueryGeometry::segment([DVec3::from_array(low), DVec3::from_array(high)]);
            let Relation { inside, overlaps, touches } = occluders.query(&query, all, &mut |_| true);
            assert_eq!([touches, overlaps, inside], expected, "{name}");
            assert_eq!(occluders.query(&query, all, &mut |_| false), Relation::NONE);
        }
    }
}
