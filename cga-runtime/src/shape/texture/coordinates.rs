//! The implicit texture coordinates of a shape.

use std::hash::Hasher;
use std::sync::Arc;

use glam::{DAffine2, DAffine3, DMat3, DVec2, DVec3};

use super::Projections;
use crate::fixed_hash::FixedHasher;
use crate::geometry::Axis;
use crate::geometry::each::Each;
use crate::geometry::mesh::map::normal_map;
use crate::geometry::provenance::Provenance;
use crate::geometry::tol::PLANAR_EPSILON;
use crate::geometry::uv_map::{FaceMaps, SetMap, UvMap};
use crate::geometry::work;
use crate::shape::scope::Scope;
use crate::shape::unit::{UnitFace, UnitMesh};

/// The sets that rules have changed on a shape, sorted by number. Other sets come from its mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Coordinates {
    sets: Vec<SetEntry>,
}

#[derive(Clone, Debug, PartialEq)]
struct SetEntry {
    set: u8,
    source: UvSource,
    /// An affine change of the source's coordinates.
    change: DAffine2,
}

/// The source of a set's coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum UvSource {
    /// The set was deleted.
    Deleted,
    /// An explicit set of the mesh.
    Own(u8),
    /// The stored projection of a set.
    Stored(u8),
    /// A function of the position in the world.
    Fixed(UvMap),
    /// The coordinates of an inserted cube: a map from the world to the unit cube at the origin.
    Cube(DAffine3),
}

impl UvSource {
    /// The coordinates of a cube that fills a scope: 0 to 1 on each side (*primitiveCube operation*).
    pub(crate) fn of_cube(scope: &Scope) -> Self {
        UvSource::Cube(to_unit(scope))
    }

    /// The coordinates of a rectangle across an axis that fills a scope: 0 to 1, u to the right and v away from the
    /// front (*primitiveQuad operation*).
    pub(crate) fn of_quad(scope: &Scope, across: Axis) -> Self {
        let normal = scope.axes.col(across.index());
        UvSource::Fixed(cube_side(&to_unit(scope), normal))
    }

    /// The source with a stored projection as a function of the position.
    fn fixed(self, projections: &Projections) -> Self {
        let UvSource::Stored(set) = self else { return self };
        projections.get(set).map_or(UvSource::Deleted, |map| UvSource::Fixed(*map))
    }

    /// The function of the position on a face with that normal, if there is one.
    pub(crate) fn map(&self, normal: DVec3) -> Option<UvMap> {
        match self {
            UvSource::Deleted | UvSource::Own(_) | UvSource::Stored(_) => None,
            UvSource::Fixed(map) => Some(*map),
            UvSource::Cube(place) => Some(cube_side(place, normal)),
        }
    }
}

/// The map from the world to relative positions in a scope, 0 to 1 along each axis.
fn to_unit(scope: &Scope) -> DAffine3 {
    // Along an axis whose size is zero except for rounding, all points are at 0.
    let least = (PLANAR_EPSILON * scope.size.abs().max_element()).max(1.0 / UvMap::MOST);
    let share = |size: f64| if size.abs() <= least { 1.0 } else { 1.0 / size };
    let matrix = DMat3::from_diagonal(DVec3::from_array(scope.size.to_array().each(share))) * scope.axes.transpose();
    DAffine3 { matrix3: matrix, translation: -(matrix * scope.origin) }
}

impl Coordinates {
    /// Returns true if all sets come from the mesh.
    #[inline]
    pub(crate) fn is_empty(&self) -> bool {
        self.sets.is_empty()
    }

    /// Adds the sets to a hash.
    pub(crate) fn hash(&self, hasher: &mut FixedHasher) {
        for SetEntry { set, source, change } in &self.sets {
            hasher.write_u8(*set);
            let mut numbers = |numbers: &[f64]| numbers.iter().for_each(|number| hasher.write_u64(number.to_bits()));
            numbers(&change.to_cols_array());
            match source {
                UvSource::Deleted => {}
                UvSource::Own(set) | UvSource::Stored(set) => numbers(&[f64::from(*set)]),
                UvSource::Fixed(map) => [map.u, map.v].iter().for_each(|row| numbers(&row.to_array())),
                UvSource::Cube(place) => numbers(&place.to_cols_array()),
            }
        }
    }

    /// Returns true if each side of a box has its own coordinates.
    pub(crate) fn has_cube(&self) -> bool {
        self.sets.iter().any(|entry| matches!(entry.source, UvSource::Cube(_)))
    }

    /// Returns true if the only coordinates are a cube's as it is inserted, and the cube fills a scope.
    pub(crate) fn is_cube_in(&self, scope: &Scope) -> bool {
        let [SetEntry { set: 0, source: UvSource::Cube(place), change }] = &self.sets[..] else { return false };
        if *change != DAffine2::IDENTITY || !scope.size.cmpgt(DVec3::ZERO).all() {
            return false;
        }
        let of_unit = *place * scope.placement() * DAffine3::from_scale(scope.size);
        // The numbers of a place far from the origin are rounded.
        let most = 8.0 * f64::EPSILON * (1.0 + place.translation.abs().max_element());
        of_unit.abs_diff_eq(DAffine3::IDENTITY, most)
    }

    /// Returns true if they follow from the mesh alone, wherever it is.
    pub(crate) fn follow_the_mesh(&self) -> bool {
        self.sets.iter().all(|entry| matches!(entry.source, UvSource::Deleted | UvSource::Own(_)))
    }

    /// Returns true if some coordinates follow from the stored projection of a set.
    pub(crate) fn is_projected(&self, set: u8) -> bool {
        self.sets.iter().any(|entry| entry.source == UvSource::Stored(set))
    }

    /// The functions of the position.
    pub(crate) fn maps(&self) -> impl Iterator<Item = &UvMap> {
        self.sets.iter().filter_map(|entry| match &entry.source {
            UvSource::Fixed(map) => Some(map),
            UvSource::Deleted | UvSource::Own(_) | UvSource::Stored(_) | UvSource::Cube(_) => None,
        })
    }

    /// The sets that rules have changed.
    pub(crate) fn sets(&self) -> impl Iterator<Item = u8> {
        self.sets.iter().map(|entry| entry.set)
    }

    /// Returns true if no coordinates come from that set of the mesh.
    pub(crate) fn hides(&self, set: u8) -> bool {
        self.sets.iter().any(|entry| entry.set == set)
            && self.sets.iter().all(|entry| entry.source != UvSource::Own(set))
    }

    /// Sets the source of a set.
    pub(crate) fn set(&mut self, set: u8, source: UvSource) {
        self.put(SetEntry { set, source, change: DAffine2::IDENTITY });
    }

    /// Gives the set `to` the coordinates of the set `from`.
    pub(crate) fn copy(&mut self, from: u8, to: u8) {
        let entry = self.entry(from);
        self.put(SetEntry { set: to, ..entry });
    }

    /// Changes the coordinates of a set. Returns false and changes nothing if the result is too large.
    #[must_use]
    pub(crate) fn change(&mut self, set: u8, change: &DAffine2) -> bool {
        let entry = self.entry(set);
        let change = *change * entry.change;
        let is_bounded = change.to_cols_array().iter().all(|number| number.abs() <= UvMap::MOST);
        if is_bounded {
            self.put(SetEntry { change, ..entry });
        }
        is_bounded
    }

    /// Returns true if no function of the position is too large.
    pub(crate) fn is_bounded(&self) -> bool {
        self.sets.iter().all(|entry| match &entry.source {
            UvSource::Fixed(map) => map.is_bounded(),
            UvSource::Cube(place) => place.to_cols_array().iter().all(|number| number.abs() <= UvMap::MOST),
            UvSource::Deleted | UvSource::Own(_) | UvSource::Stored(_) => true,
        })
    }

    /// Replaces the coordinates of a cube by the coordinates of its side with that normal.
    pub(crate) fn choose_side(&mut self, normal: DVec3) {
        for entry in &mut self.sets {
            if let UvSource::Cube(place) = &entry.source {
                entry.source = UvSource::Fixed(cube_side(place, normal));
            }
        }
    }

    /// Turns coordinates from a stored projection into a function of the position, before another projection is
    /// stored.
    pub(crate) fn fix(&mut self, stored: u8, projections: &Projections) {
        for entry in &mut self.sets {
            if entry.source == UvSource::Stored(stored) {
                entry.source = entry.source.fixed(projections);
            }
        }
    }

    /// Updates the coordinates of geometry that has moved; `back` maps a point to its old position.
    pub(crate) fn carry(&mut self, back: &DAffine3, projections: &Projections) {
        for entry in &mut self.sets {
            entry.source = match entry.source.fixed(projections) {
                UvSource::Fixed(map) => UvSource::Fixed(map.after(back)),
                UvSource::Cube(place) => UvSource::Cube(place * *back),
                other => other,
            };
        }
    }

    /// The source of a set and the change of its coordinates, with stored projections as functions of the position.
    /// `None` if they come from the mesh unchanged.
    pub(crate) fn resolve(&self, set: u8, projections: &Projections) -> Option<(UvSource, DAffine2)> {
        let entry = self.sets.iter().find(|entry| entry.set == set)?;
        Some((entry.source.fixed(projections), entry.change))
    }

    /// The maps of the sets on a box that fills a scope, sorted by set. Caps have the coordinates (0, 0). Some sets are missing if the work is
    /// to end.
    pub(crate) fn on_box(&self, unit: UnitMesh, scope: &Scope, projections: &Projections) -> Vec<SetMap> {
        let corners = 4 * unit.face_count();
        let entries = self.sets.iter().take_while(|_| work::spend(super::MAPPING * corners));
        let maps = entries.filter_map(|SetEntry { set, source, change }| {
            let source = source.fixed(projections);
            let maps = match &source {
                UvSource::Deleted | UvSource::Own(_) | UvSource::Stored(_) => return None,
                UvSource::Fixed(map) if !unit.has_unmapped_caps() => FaceMaps::Same(map.then(change)),
                UvSource::Fixed(map) => {
                    let map = map.then(change);
                    each_side(unit, |_| map)
                }
                UvSource::Cube(cube) => {
                    let turn = directions(cube) * scope.axes;
                    each_side(unit, |normal| unit_cube_side(turn * normal).after(cube).then(change))
                }
            };
            Some(SetMap { set: usize::from(*set), maps })
        });
        maps.collect()
    }

    /// The entry of a set. A set of the mesh gets an entry with that source.
    fn entry(&self, set: u8) -> SetEntry {
        let own = || SetEntry { set, source: UvSource::Own(set), change: DAffine2::IDENTITY };
        self.sets.iter().find(|entry| entry.set == set).cloned().unwrap_or_else(own)
    }

    fn put(&mut self, entry: SetEntry) {
        match self.sets.binary_search_by_key(&entry.set, |entry| entry.set) {
            Ok(at) => self.sets[at] = entry,
            Err(at) => self.sets.insert(at, entry),
        }
    }
}

/// The maps of the faces of a box, by their normals in its scope. Caps have the coordinates (0, 0).
fn each_side(unit: UnitMesh, map: impl Fn(DVec3) -> UvMap) -> FaceMaps {
    let of_side =
        |side: &UnitFace| if side.provenance == Provenance::Cut { UvMap::ZERO } else { map(side.side.normal()) };
    FaceMaps::Each(Arc::new(unit.sides().each_ref().map(of_side)))
}

/// The coordinates of the side of a cube that contains a face with that normal (*primitiveCube operation*). `place` maps the world to the
/// cube.
fn cube_side(place: &DAffine3, normal: DVec3) -> UvMap {
    unit_cube_side(directions(place) * normal).after(place)
}

/// The directions of a cube's axes in the world, as rows. The lengths of sides make no difference.
fn directions(place: &DAffine3) -> DMat3 {
    let rows = place.matrix3.transpose();
    let [x, y, z] = [rows.x_axis, rows.y_axis, rows.z_axis].each(DVec3::normalize_or_zero);
    DMat3::from_cols(x, y, z).transpose()
}

/// The coordinates of the sides of a cube, for the faces of a mesh.
pub(crate) struct CubeSides {
    /// The map from the mesh to the cube with sides of length 1.
    to_cube: DAffine3,
    /// The map of normals to the directions of the cube.
    turn: DMat3,
}

impl CubeSides {
    /// The sides of a cube; `cube` maps the world to it and `place` the mesh to the world.
    pub(crate) fn new(cube: &DAffine3, place: &DAffine3) -> Self {
        CubeSides { to_cube: cube * place, turn: directions(cube) * normal_map(&place.matrix3) }
    }

    /// The coordinates on a face whose normal, of any length, is `normal` in the coordinates of the mesh.
    pub(crate) fn of(&self, normal: DVec3) -> UvMap {
        unit_cube_side(self.turn * normal).after(&self.to_cube)
    }
}

/// The coordinates of a side of the cube with sides of length 1 at the origin: u to the right as seen from outside, v upwards. On top and
/// bottom v = 0 is at the front. The side is the one that looks most along a normal, which may have any length.
pub(crate) fn unit_cube_side(normal: DVec3) -> UvMap {
    let (n, a) = (normal, normal.abs());
    let (u, v, from) = if a.y >= a.x && a.y >= a.z {
        match n.y < 0.0 {
            false => (DVec3::X, -DVec3::Z, DVec2::Y),
            true => (DVec3::X, DVec3::Z, DVec2::ZERO),
        }
    } else if a.x > a.z {
        match n.x < 0.0 {
            false => (-DVec3::Z, DVec3::Y, DVec2::X),
            true => (DVec3::Z, DVec3::Y, DVec2::ZERO),
        }
    } else {
        match n.z < 0.0 {
            false => (DVec3::X, DVec3::Y, DVec2::ZERO),
            true => (-DVec3::X, DVec3::Y, DVec2::X),
        }
    };
    UvMap { u: u.extend(from.x), v: v.extend(from.y) }
}
