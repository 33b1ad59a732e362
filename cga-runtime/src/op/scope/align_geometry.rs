//! `alignScopeToGeometry`: the scope turns to an edge of a face.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use crate::fault::FaultKind;
use crate::geometry::Frame;
use crate::geometry::mesh::{Mesh, unit};
use crate::geometry::tol::TIE_EPSILON;
use crate::op::UpAxis;
use crate::op::scope::new_axes::refit;
use crate::run::env::Env;
use crate::shape::{Geometry, Shape};

/// The choice of the face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AlignFace {
    /// The face whose corners are lowest in the world, on average.
    WorldLowest,
    /// The face with the largest area.
    Largest,
    /// The face with the best edge. With an edge by number, the first face.
    Any,
}

/// The choice of the edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AlignEdge {
    /// The edge whose middle is lowest in the world.
    WorldLowest,
    /// The longest edge.
    Longest,
}

/// The word of the old form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AlignAuto {
    /// The lowest edge of all faces; of equally low edges the longest.
    Auto,
}

#[derive(Clone, Copy)]
enum FacePick {
    Number(f64),
    Word(AlignFace),
}

#[derive(Clone, Copy)]
enum EdgePick {
    Number(f64),
    Word(AlignEdge),
    Auto,
}

/// `alignScopeToGeometry(up, faceIndex, edgeIndex)` (*alignScopeToGeometry operation*).
pub fn align_to_indices(env: &mut Env, shape: &mut Shape, up: UpAxis, face: f64, edge: f64) {
    align(env, shape, up, FacePick::Number(face), EdgePick::Number(edge));
}

/// `alignScopeToGeometry(up, faceSelector, edgeIndex)` (*alignScopeToGeometry operation*).
pub fn align_to_face(env: &mut Env, shape: &mut Shape, up: UpAxis, face: AlignFace, edge: f64) {
    align(env, shape, up, FacePick::Word(face), EdgePick::Number(edge));
}

/// `alignScopeToGeometry(up, faceIndex, edgeSelector)` (*alignScopeToGeometry operation*).
pub fn align_to_edge(env: &mut Env, shape: &mut Shape, up: UpAxis, face: f64, edge: AlignEdge) {
    align(env, shape, up, FacePick::Number(face), EdgePick::Word(edge));
}

/// `alignScopeToGeometry(up, faceSelector, edgeSelector)` (*alignScopeToGeometry operation*).
pub fn align_to_selected(env: &mut Env, shape: &mut Shape, up: UpAxis, face: AlignFace, edge: AlignEdge) {
    align(env, shape, up, FacePick::Word(face), EdgePick::Word(edge));
}

/// `alignScopeToGeometry(up, faceIndex)`, the old form: the first edge (*CGA changelog 2010.1*).
pub fn align_to_first_edge(env: &mut Env, shape: &mut Shape, up: UpAxis, face: f64) {
    align(env, shape, up, FacePick::Number(face), EdgePick::Number(0.0));
}

/// `alignScopeToGeometry(up, auto)`, the old form: the lowest edge, or the longest of several (*CGA changelog
/// 2010.1*).
pub fn align_to_auto(env: &mut Env, shape: &mut Shape, up: UpAxis, _: AlignAuto) {
    align(env, shape, up, FacePick::Word(AlignFace::Any), EdgePick::Auto);
}

/// Turns the scope so that its x axis runs along the edge and its up axis along the face's normal. It becomes the box
/// of the geometry along these axes. The pivot moves to the start of the edge: the page says so beside its second
/// picture and all pictures show it, although its description has the pivot at the corner of the box. Of equal
/// candidates the first is taken (*CGA changelog 2018.1*). Numbers wrap around in both directions. A point or a line
/// has no face: only the pivot moves to its scope.
fn align(env: &mut Env, shape: &mut Shape, up: UpAxis, face: FacePick, edge: EdgePick) {
    if !shape.geometry.has_surface() {
        if !matches!(shape.geometry, Geometry::Empty) {
            shape.set_pivot(shape.scope.frame());
        }
        return;
    }
    let Some(found) = pick(env, shape, face, edge) else {
        let what = "`alignScopeToGeometry` finds no face with an area and an edge with a length; the scope stays";
        return env.fault(FaultKind::Geometry, what);
    };
    let axes = shape.scope.axes;
    // The edge is in its face except for rounding.
    let x = unit(found.edge - found.normal * found.normal.dot(found.edge));
    let turned = match up {
        UpAxis::YUp => DMat3::from_cols(x, found.normal, x.cross(found.normal)),
        UpAxis::ZUp => DMat3::from_cols(x, found.normal.cross(x), found.normal),
    };
    let at = shape.scope.frame().to_world(found.start);
    if refit(env, shape, axes * turned, "`alignScopeToGeometry`") {
        shape.set_pivot(Frame { origin: at, axes: shape.scope.axes });
    }
}

/// An edge of a face, in coordinates of the scope.
struct FoundEdge {
    start: DVec3,
    edge: DVec3,
    normal: DVec3,
}

fn pick(env: &mut Env, shape: &Shape, face: FacePick, edge: EdgePick) -> Option<FoundEdge> {
    let placed = shape.geometry.placed()?;
    let faces = ScopeFaces { to_scope: placed.to_scope(shape.scope.size), mesh: placed.mesh };
    let count = faces.mesh.face_count();
    let size = shape.scope.size.abs().max_element();
    // Heights in the world are coordinates along this direction, up to a constant.
    let rise = shape.scope.axes.transpose() * DVec3::Y;
    let face = match face {
        FacePick::Number(number) => Some(whole(env, number, "the number of the face", count)?),
        FacePick::Word(AlignFace::Any) if matches!(edge, EdgePick::Number(_)) => Some(0),
        FacePick::Word(AlignFace::Any) => None,
        FacePick::Word(AlignFace::WorldLowest) => {
            let mut lowest = Best::new(size);
            for face in 0..count {
                let (mut sum, mut corners) = (0.0, 0.0);
                faces.edges(face, |a, _| (sum, corners) = (sum + rise.dot(a), corners + 1.0));
                lowest.offer([-sum / corners, 0.0], face);
            }
            Some(lowest.best?.1)
        }
        FacePick::Word(AlignFace::Largest) => {
            let mut largest = Best::new(size * size);
            (0..count).for_each(|face| largest.offer([faces.area(face).length(), 0.0], face));
            Some(largest.best?.1)
        }
    };
    let number = match (edge, face) {
        (EdgePick::Number(number), Some(face)) => {
            let edges = faces.mesh.face(face).corner_count();
            Some(whole(env, number, "the number of the edge", edges)?)
        }
        _ => None,
    };
    let mut best = Best::new(size);
    for at in face.map_or(0..count, |face| face..face + 1) {
        let normal = unit(faces.area(at));
        if normal == DVec3::ZERO {
            continue;
        }
        let mut index = 0;
        faces.edges(at, |start, end| {
            let edge_here = end - start;
            let found = || FoundEdge { start, edge: edge_here, normal };
            let low = -rise.dot(start + end) * 0.5;
            match edge {
                _ if edge_here == DVec3::ZERO => {}
                EdgePick::Number(_) if number == Some(index) => best.offer([0.0; 2], found()),
                EdgePick::Number(_) => {}
                EdgePick::Word(AlignEdge::Longest) => best.offer([edge_here.length(), 0.0], found()),
                EdgePick::Word(AlignEdge::WorldLowest) => best.offer([low, 0.0], found()),
                EdgePick::Auto => best.offer([low, edge_here.length()], found()),
            }
            index += 1;
        });
    }
    best.best.map(|(_, found)| found)
}

/// The first candidate with the largest value; of equal values, the one with the largest second value.
struct Best<T> {
    best: Option<([f64; 2], T)>,
    /// Values that differ by less than this are equal.
    near: f64,
}

impl<T> Best<T> {
    fn new(size: f64) -> Self {
        Best { best: None, near: size * TIE_EPSILON }
    }

    fn offer(&mut self, value: [f64; 2], what: T) {
        let larger = |a: f64, b: f64| b + self.near < a;
        let better =
            |best: &[f64; 2]| larger(value[0], best[0]) || !larger(best[0], value[0]) && larger(value[1], best[1]);
        if self.best.as_ref().is_none_or(|(best, _)| better(best)) {
            self.best = Some((value, what));
        }
    }
}

/// An integer that wraps around.
fn whole(env: &mut Env, number: f64, what: &str, count: usize) -> Option<usize> {
    let wanted = env.finite(number, what);
    if wanted != wanted.floor() {
        env.fault(FaultKind::Value, format!("{what} is {wanted}; {} is used instead", wanted.floor()));
    }
    (count != 0).then(|| wanted.floor().rem_euclid(count as f64) as usize)
}

/// The faces of a shape in coordinates of its scope.
struct ScopeFaces {
    mesh: Arc<Mesh>,
    to_scope: DAffine3,
}

impl ScopeFaces {
    /// Twice the area vector: twice the area times the normal.
    fn area(&self, face: usize) -> DVec3 {
        let matrix = self.to_scope.matrix3;
        let [x, y, z] = [matrix.x_axis.x, matrix.y_axis.y, matrix.z_axis.z];
        self.mesh.face(face).area_vector() * DVec3::new(y * z, z * x, x * y)
    }

    /// Calls `each` with both ends of every edge of a face, outline first.
    fn edges(&self, face: usize, mut each: impl FnMut(DVec3, DVec3)) {
        let at = |point: u32| self.to_scope.transform_point3(self.mesh.points()[point as usize]);
        for ring in self.mesh.face(face).loops() {
            let ends = ring.iter().zip(ring.iter().cycle().skip(1));
            ends.for_each(|(&a, &b)| each(at(a), at(b)));
        }
    }
}
