//! `geometry.area`, `volume`, `height`, `boundaryLength` and `angle`.

use glam::DVec3;

use super::faces::{area_vectors, selected};
use super::readable::{may_read, placed};
use crate::comp::select::Word;
use crate::geometry::tol::{ANGLE_EPSILON, TIE_EPSILON};
use crate::geometry::wire::Wire;
use crate::run::env::Env;
use crate::shape::{Geometry, Shape};

/// `geometry.area(selector)`: the sum of the areas of the faces without their holes, in square metres (*geometry.area
/// function*).
pub fn geometry_area(env: &Env, shape: &Shape, selector: Word) -> f64 {
    let size = shape.scope.size.abs();
    if selector == Word::All && matches!(shape.geometry, Geometry::Box(_)) {
        return 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
    }
    let mut sum = 0.0;
    selected(env, shape, selector, |area| sum += area);
    sum
}

/// `geometry.volume()`: the volume enclosed by the faces, in cubic metres (*geometry.volume function*). It is never
/// negative, even for a shape that is inside out. Flat geometry has none. For an open mesh it is the volume of the
/// cones from the faces to the middle.
pub fn geometry_volume(shape: &Shape) -> f64 {
    let Some(placed) = placed(shape) else { return 0.0 };
    if shape.scope.size.cmpeq(DVec3::ZERO).any() {
        return 0.0;
    }
    (placed.mesh.volume() * placed.stretch(shape.scope.size).element_product()).abs()
}

/// `geometry.height()`: the height from the lowest to the highest point in the world, in metres (*geometry.height
/// function*).
pub fn geometry_height(shape: &Shape) -> f64 {
    let (size, axes) = (shape.scope.size, shape.scope.axes);
    let rise = DVec3::new(axes.x_axis.y, axes.y_axis.y, axes.z_axis.y);
    let height = |points: &[DVec3], rise: DVec3| {
        let heights = points.iter().map(|point| rise.dot(*point));
        let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), y| (l.min(y), h.max(y)));
        if low <= high { high - low } else { 0.0 }
    };
    if !may_read(shape) {
        return 0.0;
    }
    match &shape.geometry {
        Geometry::Rect(axis, _) => {
            let mut rises = (rise * size).abs();
            rises[axis.index()] = 0.0;
            rises.element_sum()
        }
        Geometry::Box(_) => (rise * size).abs().element_sum(),
        Geometry::Mesh(placed) => height(placed.mesh.points(), rise * placed.stretch(size)),
        _ => shape.to_wire().map_or(0.0, |wire| height(&wire.points, rise)),
    }
}

/// `geometry.boundaryLength()`: the length of all edges with at most one face, in metres (*geometry.boundaryLength
/// function*).
pub fn geometry_boundary_length(shape: &Shape) -> f64 {
    let mut size = shape.scope.size;
    if let Geometry::Rect(axis, _) = shape.geometry {
        size[axis.index()] = 0.0;
        return 2.0 * size.abs().element_sum();
    }
    if let Some(placed) = placed(shape) {
        let (mesh, stretch) = (&placed.mesh, placed.stretch(size));
        let adjacency = mesh.adjacency();
        let border = (0..adjacency.edge_count()).filter(|&edge| adjacency.is_border(edge));
        return border.map(|edge| ((mesh.edge_ends(edge)[1] - mesh.edge_ends(edge)[0]) * stretch).length()).sum();
    }
    let ends = |wire: Wire| (0..wire.edges.len()).map(move |edge| wire.ends(edge));
    shape.to_wire().into_iter().flat_map(ends).map(|[a, b]| a.distance(b)).sum()
}

/// The result of `geometry.angle`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AngleType {
    /// The slope of the steepest face: 0 is level, 90 upright.
    MaxSlope,
    /// The direction of that face: 0 is north (−z), 90 east (+x). A level face has 0.
    Azimuth,
    /// 90 minus the slope.
    Zenith,
}

/// `geometry.angle(maxSlope | azimuth | zenith)`, in degrees (*geometry.angle function*). Slopes are relative to the
/// world. Of equally steep faces the first counts.
pub fn geometry_angle(shape: &Shape, angle: AngleType) -> f64 {
    let mut steepest = (0.0, 0.0);
    area_vectors(shape, |vector, _, _| {
        let normal = shape.scope.axes * crate::geometry::mesh::unit(vector);
        let level = (normal.x * normal.x + normal.z * normal.z).sqrt();
        let slope = libm::atan2(level, normal.y.abs()).to_degrees();
        // Opposite faces are equally steep except for rounding.
        if steepest.0 + TIE_EPSILON < slope && ANGLE_EPSILON < level {
            let azimuth = libm::atan2(normal.x, -normal.z).to_degrees().rem_euclid(360.0);
            // Angles just below 0 round to 360.
            steepest = (slope, if azimuth < 360.0 { azimuth } else { 0.0 });
        }
    });
    match angle {
        AngleType::MaxSlope => steepest.0,
        AngleType::Azimuth => steepest.1,
        AngleType::Zenith => 90.0 - steepest.0,
    }
}
