//! From implicit coordinates to the explicit sets of a mesh.

use std::ops::Range;
use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec2, DVec3};

use super::{Coordinates, CubeSides, MAPPING, Projections, UvSource};
use crate::geometry::Axis;
use crate::geometry::mesh::{FaceRef, Mesh};
use crate::geometry::work;
use crate::shape::scope::Scope;
use crate::shape::{Geometry, Inserted, Placed, Shape};

impl Shape {
    /// Writes implicit coordinates into the sets of the mesh. A box or a rectangle becomes a mesh.
    #[inline]
    pub(crate) fn bake(&mut self) {
        if !self.state.coordinates().is_empty() {
            self.write_sets();
        }
    }

    #[cold]
    #[inline(never)]
    fn write_sets(&mut self) {
        self.write_sets_of_mesh();
        self.state.change_look().coordinates = Coordinates::default();
    }

    /// Writes implicit coordinates into the sets of the mesh, of a shape whose own coordinates count no more. A cube as it is inserted has a
    /// mesh that all cubes share.
    pub(crate) fn write_sets_of_mesh(&mut self) {
        let cube = match self.geometry {
            Geometry::Box(unit) if self.state.coordinates().is_cube_in(&self.scope) => Some(unit),
            _ => None,
        };
        self.hold_as_mesh();
        let Geometry::Mesh(placed) = &self.geometry else { return };
        let mesh = match cube {
            Some(unit) => unit.with_cube_coordinates().clone(),
            None => self.baked(&placed.mesh, &placed.to_scope(self.scope.size)),
        };
        if let Geometry::Mesh(placed) = &mut self.geometry {
            Arc::make_mut(placed).mesh = mesh;
        }
    }

    /// A mesh of this shape with explicit sets only; `to_scope` maps its coordinates to the scope.
    pub(crate) fn baked(&self, mesh: &Arc<Mesh>, to_scope: &DAffine3) -> Arc<Mesh> {
        let coordinates = self.state.coordinates();
        if coordinates.is_empty() {
            return mesh.clone();
        }
        let place = self.scope.placement() * *to_scope;
        Arc::new(with_sets(mesh, &place, coordinates, self.state.projections()))
    }

    /// The mesh without the sets that a rule has deleted or replaced, so that its faces may be rectangles and nothing carries the sets on.
    pub(crate) fn without_hidden_sets(&self, mesh: &Arc<Mesh>) -> Arc<Mesh> {
        let coordinates = self.state.coordinates();
        if coordinates.is_empty() || mesh.uv_numbers().all(|set| !coordinates.hides(set as u8)) {
            return mesh.clone();
        }
        let mut bare = Mesh::clone(mesh);
        mesh.uv_numbers().filter(|&set| coordinates.hides(set as u8)).for_each(|set| bare.put_uv_set(set, Vec::new()));
        Arc::new(bare)
    }

    /// Replaces the mesh by one with the same points. Geometry without a mesh stays.
    pub(crate) fn change_mesh(&mut self, change: impl FnOnce(&Mesh) -> Mesh) {
        if let Geometry::Mesh(placed) = &self.geometry {
            let mesh = Arc::new(change(&placed.mesh));
            self.geometry = Geometry::Mesh(Arc::new(Placed { mesh, inserted: Inserted::No, ..Placed::clone(placed) }));
        }
    }

    /// Moves implicit coordinates with the geometry, after the scope has changed.
    pub(crate) fn carry(&mut self, before: &Scope) {
        if self.state.coordinates().is_empty() || self.scope == *before {
            return;
        }
        let ratio = |was: f64, is: f64| if is == 0.0 { 1.0 } else { was / is };
        let (was, is) = (before.size, self.scope.size);
        let resize = DMat3::from_diagonal(DVec3::new(ratio(was.x, is.x), ratio(was.y, is.y), ratio(was.z, is.z)));
        let now = self.scope.placement();
        let back = before.placement() * DAffine3::from_mat3(resize) * rigid_inverse(&now);
        let mut carried = self.state.coordinates().clone();
        carried.carry(&back, self.state.projections());
        if carried.is_bounded() {
            self.state.change_look().coordinates = carried;
        } else {
            // The size is nearly zero.
            let now = std::mem::replace(&mut self.scope, *before);
            self.write_sets();
            self.scope = now;
        }
    }
}

/// Caps, which have the coordinates (0, 0).
impl Shape {
    /// Returns true if a face closes a cut, and no operation on texture coordinates has reached it.
    pub(crate) fn has_unmapped_caps(&self) -> bool {
        match &self.geometry {
            Geometry::Rect(_, unit) | Geometry::Box(unit) => unit.has_unmapped_caps(),
            Geometry::Mesh(placed) => placed.mesh.has_unmapped_caps(),
            Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => false,
        }
    }

    /// Writes the coordinates of caps into explicit sets, before an operation on texture coordinates reaches them.
    pub(crate) fn map_caps(&mut self) {
        if !self.has_unmapped_caps() {
            return;
        }
        self.bake();
        match &mut self.geometry {
            Geometry::Rect(_, unit) | Geometry::Box(unit) => *unit = unit.with_mapped_caps(),
            Geometry::Mesh(placed) => {
                let mesh = Arc::new(placed.mesh.with_mapped_caps());
                *placed = Arc::new(Placed { mesh, ..Placed::clone(placed) });
            }
            Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => {}
        }
    }
}

/// The implicit coordinates of geometry that grows.
impl Shape {
    /// Gives all points above a plane of the scope, across an axis, the coordinates of the point below them.
    #[inline]
    pub(crate) fn raise_coordinates(&mut self, axis: Axis) {
        if !self.state.coordinates().is_empty() {
            let (up, origin) = (self.scope.axes.col(axis.index()), self.scope.origin);
            if self.state.coordinates().has_cube() {
                let Some(normal) = self.flat_normal(axis) else { return self.bake() };
                self.state.change_look().coordinates.choose_side(normal);
            }
            let flat = DMat3::IDENTITY - DMat3::from_cols(up * up.x, up * up.y, up * up.z);
            let back = DAffine3 { matrix3: flat, translation: up * up.dot(origin) };
            let projections = self.state.projections().clone();
            self.state.change_look().coordinates.carry(&back, &projections);
        }
    }

    /// The normal of all faces of geometry that is flat across an axis. `None` if some look up and some down.
    fn flat_normal(&self, axis: Axis) -> Option<DVec3> {
        let up = self.scope.axes.col(axis.index());
        let Geometry::Mesh(placed) = &self.geometry else { return Some(up) };
        let turn = crate::geometry::mesh::map::normal_map(&placed.to_scope(self.scope.size).matrix3);
        let mut sides = placed.mesh.faces().map(|face| 0.0 < (turn * face.normal())[axis.index()]);
        let is_up = sides.next()?;
        sides.all(|side| side == is_up).then_some(if is_up { up } else { -up })
    }
}

/// The inverse of a rotation and a translation.
fn rigid_inverse(place: &DAffine3) -> DAffine3 {
    let turned = place.matrix3.transpose();
    DAffine3 { matrix3: turned, translation: -(turned * place.translation) }
}

/// The mesh with all sets explicit. `place` maps it to the world. Some sets are missing if the work is to end.
fn with_sets(mesh: &Mesh, place: &DAffine3, coordinates: &Coordinates, projections: &Projections) -> Mesh {
    let mut baked = mesh.clone();
    let is_cap = |face: &FaceRef<'_>| face.tag().is_unmapped_cap();
    let caps: Vec<Range<usize>> = match mesh.has_unmapped_caps() {
        true => mesh.faces().filter(is_cap).map(|face| face.corner_range()).collect(),
        false => Vec::new(),
    };
    for set in coordinates.sets() {
        if !work::spend(MAPPING * mesh.corners().len()) {
            break;
        }
        let Some((source, change)) = coordinates.resolve(set, projections) else { continue };
        let mut list = match source {
            UvSource::Deleted | UvSource::Stored(_) => Vec::new(),
            UvSource::Own(own) => {
                let list = mesh.uv_set(usize::from(own));
                list.iter().map(|&uv| change.transform_point2(uv)).collect()
            }
            UvSource::Fixed(map) => {
                let local = map.then(&change).after(place);
                mesh.corners().iter().map(|&corner| local.at(mesh.points()[corner as usize])).collect()
            }
            UvSource::Cube(cube) => {
                let sides = CubeSides::new(&cube, place);
                let mut list = Vec::with_capacity(mesh.corners().len());
                for face in mesh.faces() {
                    let side = sides.of(face.area_vector()).then(&change);
                    let corners = &mesh.corners()[face.corner_range()];
                    list.extend(corners.iter().map(|&corner| side.at(mesh.points()[corner as usize])));
                }
                list
            }
        };
        if !list.is_empty() {
            caps.iter().for_each(|cap| list[cap.clone()].fill(DVec2::ZERO));
        }
        baked.put_uv_set(usize::from(set), list);
    }
    baked
}
