//! `inline(recompose)` and `modify`: the parts of a shape as one mesh again (*Shape recomposition*).

use crate::comp::{Align, Components};
use crate::geometry::recompose::{Origins, Weld, welded_wire};
use crate::geometry::trace::{Trace, TraceLayer, TracedPoint, UNTRACED};
use crate::geometry::wire::Wire;
use crate::op::mesh::joined::{joined_state, part_meshes, retain_parts};
use crate::run::env::Env;
use crate::shape::{Geometry, Shape};

/// Edits the components of the current shape (*modify operation*). `leaves` are the edited components and the rest of the
/// geometry; they become one mesh with the axes and the pivot of the shape.
pub fn modify(env: &mut Env, shape: &mut Shape, [leaves]: [Vec<Shape>; 1], _: Components, _: Align) {
    recompose(env, shape, leaves);
}

/// Makes the current shape of the leaves of an operand that [`Env::begin_recomposition`] has begun. Points with the same origin
/// become one, and points on edges of other leaves are inserted there. A point moves by the sum of the movements of all
/// leaves that have it.
pub(in crate::op) fn recompose(env: &mut Env, shape: &mut Shape, mut leaves: Vec<Shape>) {
    let points: Vec<Vec<u32>> = leaves.iter_mut().map(|leaf| env.end_trace(leaf)).collect();
    let mut origins = env.end_recomposition();
    let places = origins.settle();
    let outer = OuterTrace::of(env.recomposed_depth(), &origins, &leaves, &points);
    let mut parts: Vec<(Shape, Vec<u32>)> = leaves.into_iter().zip(points).collect();
    // Edges and vertices beside faces only have tags for them.
    let tags: Vec<(Wire, Vec<u32>)> = parts
        .iter()
        .filter(|(leaf, _)| !leaf.trace().is_some_and(Trace::is_gone))
        .filter_map(|(leaf, points)| Some((leaf.to_wire().filter(|wire| !wire.tags.is_empty())?, points.clone())))
        .collect();
    retain_parts(&mut parts, |(leaf, _)| leaf);
    let (leaves, points): (Vec<Shape>, Vec<Vec<u32>>) = parts.into_iter().unzip();
    let Some((first, others)) = leaves.split_first() else {
        shape.geometry = Geometry::Empty;
        return;
    };
    shape.state = joined_state(shape, first, others);
    let to_scope = shape.scope.placement().inverse();
    if !first.geometry.has_surface() {
        let wires: Vec<(Wire, Vec<u32>)> =
            leaves.iter().zip(points).filter_map(|(leaf, points)| Some((turned(leaf, shape)?, points))).collect();
        let (mut wire, numbers) = welded_wire(&wires, &places, &to_scope);
        wire.trace = outer.pick(&numbers);
        shape.set_wire(wire);
        return;
    }
    let mut weld = Weld::default();
    tags.iter().for_each(|(wire, points)| weld.add_tags(&origins, wire, points));
    for (mesh, points) in part_meshes(shape, &leaves).zip(points) {
        let before = weld.corner_count();
        weld.add(&origins, mesh, &points);
        if env.count_corners(weld.corner_count() - before).is_break() {
            return;
        }
    }
    let (mut mesh, numbers) = weld.finish(&places, &to_scope);
    mesh.set_trace(outer.pick(&numbers));
    if mesh.is_empty() {
        shape.geometry = Geometry::Empty;
    } else {
        shape.set_mesh(mesh);
    }
}

/// The wire of a leaf, with normals in the coordinates of a shape.
fn turned(leaf: &Shape, shape: &Shape) -> Option<Wire> {
    let mut wire = leaf.to_wire()?;
    let turn = shape.scope.axes.transpose() * leaf.scope.axes;
    wire.normals.iter_mut().for_each(|normal| *normal = turn * *normal);
    Some(wire)
}

/// The trace of the points of a result for the operands around it, by the numbers of points.
struct OuterTrace(Vec<TraceLayer>);

impl OuterTrace {
    fn of(depth: usize, origins: &Origins, leaves: &[Shape], points: &[Vec<u32>]) -> Self {
        let mut list = vec![TraceLayer { division: 0, points: vec![TracedPoint::NONE; origins.point_count()] }; depth];
        for (leaf, points) in leaves.iter().zip(points) {
            let layers = leaf.trace().map_or(&[][..], Trace::layers);
            for (found, layer) in list.iter_mut().zip(layers) {
                found.division = found.division.max(layer.division);
                for (point, own) in points.iter().zip(&layer.points) {
                    let known = &mut found.points[*point as usize];
                    if known.id == UNTRACED {
                        *known = *own;
                    }
                }
            }
        }
        OuterTrace(list)
    }

    fn pick(self, numbers: &[u32]) -> Trace {
        Trace::of(self.0).pick(&mut numbers.iter().map(|number| Some(*number)))
    }
}
