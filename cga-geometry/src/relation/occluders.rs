//! Many closed solids, and the relation of a geometry to each of them.

use std::sync::{Arc, OnceLock};

use glam::DAffine3;

use super::cuboid::Cuboid;
use super::query_geometry::{Form, LARGEST, QueryGeometry, is_finite, placed_bounds, sheared_faces};
use super::surface::Surface;
use super::tolerance::{largest_tolerance, tolerance};
use super::{Relation, cuboid_pair, segment_pair, surface_pair};
use crate::bounds::Bounds;
use crate::bounds_tree::{BoundsTree, overlap};
use crate::mesh::Mesh;

/// A solid that geometries are compared with: a closed mesh or a box, in the world, in metres.
#[derive(Clone, Debug)]
pub struct Occluder {
    /// `None` for the unit box.
    mesh: Option<Arc<Mesh>>,
    placement: DAffine3,
}

impl Occluder {
    /// A mesh that is placed in the world. It occludes if it is closed ([`Mesh::is_closed`]); boxes are found.
    pub fn mesh(mesh: Arc<Mesh>, placement: DAffine3) -> Self {
        Occluder { mesh: Some(mesh), placement }
    }

    /// The box from (0, 0, 0) to (1, 1, 1), placed in the world.
    pub fn cuboid(placement: DAffine3) -> Self {
        Occluder { mesh: None, placement }
    }

    /// The solid; `None` if it is open, flat, not finite or too large.
    fn solid(self, number: u32) -> Option<(Bounds, Solid)> {
        let Occluder { mesh, placement } = self;
        let matrix = placement.matrix3;
        let sides = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
        let cuboid = match &mesh {
            Some(mesh) if !mesh.is_closed() || !is_finite(mesh, &placement) => return None,
            Some(mesh) => Cuboid::of_mesh(mesh, &placement),
            None => Cuboid::of_sides(placement.translation, sides),
        };
        let bounds = match (&cuboid, &mesh) {
            (Some(cuboid), _) => cuboid.bounds(),
            (None, Some(mesh)) => placed_bounds(mesh, &placement),
            (None, None) => {
                let faces = sheared_faces(placement.translation, sides);
                Bounds::of(faces.iter().flatten().copied())
            }
        };
        let far = bounds.low.abs().max(bounds.high.abs()).max_element();
        let is_flat = cuboid.is_some_and(|cuboid| !cuboid.is_solid()) || matrix.determinant() == 0.0;
        if is_flat || LARGEST < far || !(bounds.low + bounds.high).is_finite() || !placement.is_finite() {
            return None;
        }
        let extent = cuboid.map_or(bounds.size().max_element(), |cuboid| cuboid.extent());
        // A box needs no mesh.
        let source = if cuboid.is_some() { None } else { Some(Box::new(Occluder { mesh, placement })) };
        Some((bounds, Solid { number, extent, far, cuboid, source, surface: OnceLock::new() }))
    }
}

impl From<Arc<Mesh>> for Occluder {
    fn from(mesh: Arc<Mesh>) -> Self {
        Occluder::mesh(mesh, DAffine3::IDENTITY)
    }
}

impl From<(Arc<Mesh>, DAffine3)> for Occluder {
    fn from((mesh, placement): (Arc<Mesh>, DAffine3)) -> Self {
        Occluder::mesh(mesh, placement)
    }
}

/// Many solids, in a tree of boxes. Solids may overlap; they are not united.
///
/// Their faces are prepared when a query needs them for the first time.
#[derive(Debug, Default)]
pub struct Occluders {
    pub(super) tree: BoundsTree,
    /// The box of each solid.
    pub(super) bounds: Vec<Bounds>,
    pub(super) solids: Vec<Solid>,
    /// The largest coordinate.
    pub(super) far: f64,
    count: usize,
}

#[derive(Debug)]
pub(super) struct Solid {
    /// The number of the occluder.
    pub(super) number: u32,
    /// The longest side.
    pub(super) extent: f64,
    /// The largest coordinate.
    pub(super) far: f64,
    pub(super) cuboid: Option<Cuboid>,
    /// `None` for a box.
    source: Option<Box<Occluder>>,
    surface: OnceLock<Box<Surface>>,
}

impl Occluders {
    /// The occluders of a list, numbered from 0 in its order, in time n log n.
    ///
    /// Meshes that are open, flat boxes, and occluders with coordinates that are not finite or above 1e60 have a number, but no geometry has a
    /// relation to them.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use cga_geometry::glam::DVec3;
    /// use cga_geometry::primitive;
    /// use cga_geometry::relation::{Occluders, QueryGeometry, Relation};
    ///
    /// let occluders = Occluders::new([Arc::new(primitive::sphere(24, 12))]);
    /// let middle = QueryGeometry::point(DVec3::splat(0.5));
    /// assert_eq!(occluders.query(&middle, Relation::ALL, &mut |_| true), Relation::ALL);
    /// assert_eq!(occluders.query(&middle, Relation::ALL, &mut |number| number != 0), Relation::NONE);
    /// ```
    pub fn new(list: impl IntoIterator<Item = impl Into<Occluder>>) -> Self {
        let (mut bounds, mut solids, mut count) = (Vec::new(), Vec::new(), 0);
        for occluder in list {
            let Ok(number) = u32::try_from(count) else { break };
            count += 1;
            if let Some((box_of, solid)) = occluder.into().solid(number) {
                bounds.push(box_of);
                solids.push(solid);
            }
        }
        let far = solids.iter().fold(0.0, |far: f64, solid| far.max(solid.far));
        Occluders { tree: BoundsTree::of(&bounds), bounds, solids, far, count }
    }

    /// The number of occluders, with occluders that have no relation to any geometry.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Returns true if the list is empty.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The answers for a geometry: each one of the `wanted` answers that holds for at least one occluder. Other answers are false.
    ///
    /// `accept` gets the number of each occluder whose box meets the box of the geometry, in no particular order, and returns false for
    /// occluders that are to be left out. It is not called again when all wanted answers are true.
    pub fn query(
        &self,
        geometry: &QueryGeometry<'_>,
        wanted: Relation,
        accept: &mut dyn FnMut(u32) -> bool,
    ) -> Relation {
        self.query_counted(geometry, wanted, accept).0
    }

    /// The answers, and the number of boxes of the tree that were compared.
    pub(super) fn query_counted(
        &self,
        geometry: &QueryGeometry<'_>,
        wanted: Relation,
        accept: &mut dyn FnMut(u32) -> bool,
    ) -> (Relation, usize) {
        let mut search = Search { occluders: self, geometry, wanted, found: Relation::NONE };
        if search.is_over() {
            return (search.found, 0);
        }
        let reach = self.reach(&geometry.bounds);
        let compared = self.tree.visit(
            |bounds| overlap(bounds, &reach),
            |at| !overlap(&self.bounds[at as usize], &reach) || search.compare(at, accept),
        );
        (search.found, compared)
    }

    /// The box that meets the boxes of all occluders to which a geometry can have a relation: the box around the geometry, wider by the
    /// tolerance.
    #[inline]
    pub fn reach(&self, bounds: &Bounds) -> Bounds {
        let far = bounds.low.abs().max(bounds.high.abs()).max_element();
        let margin = largest_tolerance(self.far.max(far));
        Bounds { low: bounds.low - margin, high: bounds.high + margin }
    }
}

/// The comparison of a geometry with occluders.
pub(super) struct Search<'s> {
    pub(super) occluders: &'s Occluders,
    pub(super) geometry: &'s QueryGeometry<'s>,
    pub(super) wanted: Relation,
    pub(super) found: Relation,
}

impl Search<'_> {
    /// Returns true if all answers are found before the search.
    #[inline]
    pub(super) fn is_over(&self) -> bool {
        matches!(self.geometry.form, Form::Nothing) || self.wanted == Relation::NONE
    }

    /// Compares the geometry with an occluder. Returns true while answers are missing.
    #[inline]
    pub(super) fn compare(&mut self, at: u32, accept: &mut dyn FnMut(u32) -> bool) -> bool {
        let Some(solid) = self.occluders.solids.get(at as usize) else { return true };
        if !accept(solid.number) {
            return true;
        }
        let relation = solid.relation(self.geometry, self.wanted.without(self.found));
        self.found = self.found.or(relation.and(self.wanted));
        self.found != self.wanted
    }
}

impl Solid {
    /// The relation of a geometry to the solid, at least the `wanted` answers.
    pub(super) fn relation(&self, geometry: &QueryGeometry<'_>, wanted: Relation) -> Relation {
        let tolerance = tolerance([self.extent, geometry.extent], self.far.max(geometry.far));
        match (&geometry.form, &self.cuboid) {
            (Form::Nothing, _) => Relation::NONE,
            (Form::Cuboid(cuboid), Some(own)) => cuboid_pair::relate(cuboid, own, tolerance, wanted),
            (Form::Segment(ends), Some(own)) => cuboid_pair::relate_segment(*ends, own, tolerance),
            (Form::Point(point), Some(own)) => cuboid_pair::relate_point(*point, own, tolerance),
            (Form::Segment(ends), None) => segment_pair::relate_segment(*ends, self.surface(), tolerance),
            (Form::Point(point), None) => segment_pair::relate_point(*point, self.surface(), tolerance),
            (Form::Cuboid(_) | Form::Mesh(..) | Form::Faces(_), _) => {
                let surface = geometry.surface();
                match surface.flat_ends() {
                    None => surface_pair::relate(surface, self.surface(), tolerance, wanted),
                    Some(ends) if ends[0] == ends[1] => segment_pair::relate_point(ends[0], self.surface(), tolerance),
                    Some(ends) => segment_pair::relate_segment(ends, self.surface(), tolerance),
                }
            }
        }
    }

    fn surface(&self) -> &Surface {
        self.surface.get_or_init(|| {
            Box::new(match (&self.source, &self.cuboid) {
                (Some(source), _) => source.surface(),
                (None, Some(cuboid)) => Surface::of_faces(&cuboid.faces()),
                (None, None) => Surface::of_faces(&[]),
            })
        })
    }
}

impl Occluder {
    fn surface(&self) -> Surface {
        let Occluder { mesh, placement } = self;
        let DAffine3 { matrix3, translation } = *placement;
        match mesh {
            Some(mesh) => Surface::of_mesh(mesh, placement),
            None => Surface::of_faces(&sheared_faces(translation, [matrix3.x_axis, matrix3.y_axis, matrix3.z_axis])),
        }
    }
}
