//! The faces of a shape as functions see them: where they look and how large they are.

use glam::{DMat3, DVec3};

use crate::comp::outwards;
use crate::comp::select::Select;
use crate::env::Env;
use crate::place;
use crate::shape::{Geometry, ShapeRef};

/// Which faces count (*geometry.area function*, *geometry.isOriented function*). Directions are quadrants, as for the
/// component split: in the axes of the scope, of object coordinates or of the world. Those of streets are those of object
/// coordinates: there is no map of street widths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names say it")]
pub enum FaceSelector {
    All,
    Front,
    Back,
    Left,
    Right,
    Top,
    Bottom,
    Side,
    ObjectFront,
    ObjectBack,
    ObjectLeft,
    ObjectRight,
    ObjectTop,
    ObjectBottom,
    ObjectSide,
    WorldSouth,
    WorldNorth,
    WorldWest,
    WorldEast,
    WorldUp,
    WorldDown,
    WorldSide,
    StreetFront,
    StreetBack,
    StreetLeft,
    StreetRight,
    StreetSide,
}

/// The axes that a direction is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Axes {
    Scope,
    Object,
    World,
}

impl FaceSelector {
    fn parts(self) -> (Axes, Select) {
        use FaceSelector as F;
        match self {
            F::All => (Axes::Scope, Select::All),
            F::Front => (Axes::Scope, Select::Front),
            F::Back => (Axes::Scope, Select::Back),
            F::Left => (Axes::Scope, Select::Left),
            F::Right => (Axes::Scope, Select::Right),
            F::Top => (Axes::Scope, Select::Top),
            F::Bottom => (Axes::Scope, Select::Bottom),
            F::Side => (Axes::Scope, Select::Side),
            F::ObjectFront | F::StreetFront => (Axes::Object, Select::Front),
            F::ObjectBack | F::StreetBack => (Axes::Object, Select::Back),
            F::ObjectLeft | F::StreetLeft => (Axes::Object, Select::Left),
            F::ObjectRight | F::StreetRight => (Axes::Object, Select::Right),
            F::ObjectTop => (Axes::Object, Select::Top),
            F::ObjectBottom => (Axes::Object, Select::Bottom),
            F::ObjectSide | F::StreetSide => (Axes::Object, Select::Side),
            // *comp operation*: y is up, z is south.
            F::WorldSouth => (Axes::World, Select::Front),
            F::WorldNorth => (Axes::World, Select::Back),
            F::WorldWest => (Axes::World, Select::Left),
            F::WorldEast => (Axes::World, Select::Right),
            F::WorldUp => (Axes::World, Select::Top),
            F::WorldDown => (Axes::World, Select::Bottom),
            F::WorldSide => (Axes::World, Select::Side),
        }
    }
}

/// Calls with the area, in square metres, of every face that a selector takes. A face without area looks nowhere.
pub(super) fn selected(env: &Env, shape: &ShapeRef<'_>, selector: FaceSelector, mut each: impl FnMut(f64)) {
    let (axes, select) = selector.parts();
    let turn = match axes {
        Axes::Scope => DMat3::IDENTITY,
        Axes::Object => env.initial.object.axes.transpose() * shape.scope.axes,
        Axes::World => shape.scope.axes,
    };
    let outwards = outwards(shape.scope.size);
    area_vectors(shape, |vector| {
        let length = vector.length();
        if 0.0 < length && select.takes(0, turn * (vector / length) * outwards) {
            each(length);
        }
    });
}

/// Calls with the area of every face along its normal, in the axes of the scope.
pub(super) fn area_vectors(shape: &ShapeRef<'_>, mut each: impl FnMut(DVec3)) {
    let local = crate::scope::Scope::new(shape.scope.size);
    match &shape.geometry {
        Geometry::Empty | Geometry::Vertex | Geometry::Edge => {}
        Geometry::Rect(axis) => {
            let quad = place::rect(&local, *axis);
            each(quad.u.cross(quad.v));
        }
        Geometry::Box => place::cuboid(&local).faces().iter().for_each(|face| each(face.u.cross(face.v))),
        Geometry::Mesh(placed) => {
            let stretch = placed.stretch(shape.scope.size);
            // What cross products of stretched vectors are stretched by.
            let across = DVec3::new(stretch.y * stretch.z, stretch.z * stretch.x, stretch.x * stretch.y);
            placed.mesh.faces().for_each(|face| each(face.area_vector() * across * 0.5));
        }
    }
}
