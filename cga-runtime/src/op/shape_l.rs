//! `shapeL`: front and left edges set back.

use std::ops::ControlFlow;

use glam::{DVec2, DVec3};

use crate::comp::select::Word;
use crate::comp::{Arm, Arms, Faces, Mode, Select, face_edges, never};
use crate::fault::FaultKind;
use crate::geometry::mesh::{FaceRef, Mesh, Spread, unit};
use crate::geometry::tol::{ANGLE_EPSILON, PLANAR_EPSILON};
use crate::run::env::Env;

/// `shapeL(frontWidth, leftWidth) { shape : … | remainder : … }`: the edges of each face that face the scope's front and left
/// are set back by these distances. Each connected part that they sweep is a `shape`, the rest of the face is a `remainder`
/// (*shapeL, shapeU, shapeO operations*). A distance that is not positive sets nothing back.
///
/// Faces with holes and concave faces stay whole, as remainders, with a fault. Ends of strips lie on the neighbouring edges.
pub fn shape_l(env: &mut Env, arms: &mut Arms<'_>, front: f64, left: f64) -> ControlFlow<(), Faces> {
    let widths = [front, left].map(|width| env.finite(width, "a width of `shapeL`").max(0.0));
    if !arms.shape().geometry.has_surface() {
        return ControlFlow::Continue(Faces::default());
    }
    let sides = [Word::Front, Word::Left].map(|word| Arm { select: Select::Word(word), mode: Mode::Each, text: "" });
    let edges = face_edges(env, arms.shape(), &sides, &mut never)?;
    let mesh = arms.shape().to_mesh();
    let labels = [Word::Shape, Word::Remainder].map(|word| arms.of(word));
    let mut made = Faces { mesh: mesh.alike(0), arms: Vec::new() };
    for face in mesh.faces() {
        let range = face.corner_range();
        let by: Vec<f64> = edges[range].iter().map(|arm| arm.map_or(0.0, |arm| widths[arm as usize])).collect();
        match ConvexFace::of(&mesh, &face) {
            Some(plane) => {
                let [strips, rest] = plane.set_back(&by);
                plane.add(&strips, labels[0], &mut made);
                plane.add(&rest, labels[1], &mut made);
            }
            None => {
                let number = face.index();
                env.fault(FaultKind::Geometry, format!("`shapeL`: face {number} is not convex; it stays whole"));
                whole(&mesh, &face, labels[1], &mut made);
            }
        }
    }
    ControlFlow::Continue(made)
}

/// A corner of a part, and the edge of the face that the side after it lies on.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PartCorner {
    at: DVec2,
    edge: Option<usize>,
}

/// The loops of a part: its outline, then its holes.
type PartLoops = Vec<Vec<PartCorner>>;

/// A convex face laid flat.
struct ConvexFace<'a> {
    mesh: &'a Mesh,
    face: FaceRef<'a>,
    origin: DVec3,
    axes: [DVec3; 2],
    flat: Vec<DVec2>,
}

impl<'a> ConvexFace<'a> {
    fn of(mesh: &'a Mesh, face: &FaceRef<'a>) -> Option<Self> {
        let normal = face.normal();
        let outline: Vec<DVec3> = face.outline().collect();
        let edges = || (0..outline.len()).map(|at| outline[(at + 1) % outline.len()] - outline[at]);
        let x = edges().map(unit).find(|edge| *edge != DVec3::ZERO)?;
        if normal == DVec3::ZERO || face.holes().len() != 0 {
            return None;
        }
        let axes = [x, normal.cross(x)];
        let flat = outline.iter().map(|at| axes.map(|axis| (*at - outline[0]).dot(axis)).into()).collect();
        let plane = ConvexFace { mesh, face: *face, origin: outline[0], axes, flat };
        let is_convex = |at: usize| {
            let [a, b] = [plane.edge(at), plane.edge((at + 1) % plane.flat.len())];
            -ANGLE_EPSILON * a.length() * b.length() <= a.perp_dot(b)
        };
        (0..plane.flat.len()).all(is_convex).then_some(plane)
    }

    fn edge(&self, at: usize) -> DVec2 {
        self.flat[(at + 1) % self.flat.len()] - self.flat[at]
    }

    /// The strips that edges sweep when they are set back, and what is left.
    fn set_back(&self, by: &[f64]) -> [Vec<PartLoops>; 2] {
        let all = || self.flat.iter().enumerate().map(|(edge, &at)| PartCorner { at, edge: Some(edge) });
        let mut rest: Vec<PartCorner> = all().collect();
        for (edge, &by) in by.iter().enumerate().filter(|(_, by)| 0.0 < **by) {
            rest = clip(&rest, self.flat[edge], self.edge(edge), by);
        }
        let cut = (0..rest.len()).filter(|&at| rest[at].edge.is_none()).count();
        let strips = match () {
            () if cut == 0 && !rest.is_empty() => Vec::new(),
            () if rest.is_empty() => vec![vec![all().collect()]],
            () if cut == rest.len() => vec![vec![all().collect(), reversed(&rest)]],
            () => self.strips(&rest, by),
        };
        let rest = if rest.is_empty() { Vec::new() } else { vec![vec![rest]] };
        [strips, rest]
    }

    /// The strips beside the cuts of what is left: each goes back along a run of cuts, then along the outline.
    fn strips(&self, rest: &[PartCorner], by: &[f64]) -> Vec<PartLoops> {
        let count = rest.len();
        let is_cut = |at: usize| rest[at % count].edge.is_none();
        let starts = (0..count).filter(|&at| is_cut(at) && !is_cut(at + count - 1));
        let strip = |start: usize| {
            let end = (start + 1..).find(|&at| !is_cut(at)).unwrap_or(start);
            let run = (start + 1..=end).rev().map(|at| PartCorner { at: rest[at % count].at, edge: None });
            let mut ring: Vec<PartCorner> = run.collect();
            // From where the cut begins, on the edge before it, to where it ends.
            let (Some(mut edge), Some(last)) = (rest[(start + count - 1) % count].edge, rest[end % count].edge) else {
                return ring;
            };
            ring.push(PartCorner { at: rest[start].at, edge: Some(edge) });
            loop {
                edge = (edge + 1) % self.flat.len();
                ring.push(PartCorner { at: self.flat[edge], edge: Some(edge) });
                // A single edge that is left has both ends of the cut.
                if edge == last {
                    break;
                }
            }
            ring.dedup_by(|next, corner| {
                let is_same = next.at == corner.at;
                corner.edge = if is_same { next.edge } else { corner.edge };
                is_same
            });
            // It begins with an edge that was set back.
            let first = ring.iter().position(|corner| corner.edge.is_some_and(|edge| 0.0 < by[edge]));
            ring.rotate_left(first.unwrap_or(0));
            ring
        };
        starts.map(|start| vec![strip(start)]).collect()
    }

    /// Adds parts to the faces that were made. Texture coordinates and normals of new corners continue those of the face.
    fn add(&self, parts: &[PartLoops], arm: Option<u32>, made: &mut Faces) {
        let source = self.mesh;
        let range = self.face.corner_range();
        let spread = Spread::of(self.flat.clone());
        let mesh = &mut made.mesh;
        for part in parts {
            for ring in part {
                for corner in ring {
                    if let Some(at) = self.flat.iter().position(|at| *at == corner.at) {
                        copy(&self.face, range.start + at, source, mesh);
                        continue;
                    }
                    let weights = spread.weights(corner.at);
                    mesh.corners.push(mesh.points.len() as u32);
                    mesh.points.push(self.origin + self.axes[0] * corner.at.x + self.axes[1] * corner.at.y);
                    mesh.uvs.push_from(&source.uvs, |list| {
                        list[range.clone()].iter().zip(&weights).map(|(&uv, &weight)| uv * weight).sum()
                    });
                    if let Some(normals) = source.normals.get(range.clone()) {
                        let mixed = normals.iter().zip(&weights).map(|(&normal, &weight)| normal * weight);
                        mesh.normals.push(unit(mixed.sum()));
                    }
                }
                mesh.loop_ends.push(mesh.corners.len() as u32);
            }
            mesh.face_ends.push(mesh.loop_ends.len());
            mesh.tags.push(self.face.tag());
            made.arms.push(arm);
        }
    }
}

/// Adds a face as it is.
fn whole(source: &Mesh, face: &FaceRef<'_>, arm: Option<u32>, made: &mut Faces) {
    let mesh = &mut made.mesh;
    for ring in face.loop_ranges() {
        ring.for_each(|corner| copy(face, corner, source, mesh));
        mesh.loop_ends.push(mesh.corners.len() as u32);
    }
    mesh.face_ends.push(mesh.loop_ends.len());
    mesh.tags.push(face.tag());
    made.arms.push(arm);
}

/// Adds a corner of a face as it is, with a point of its own.
fn copy(face: &FaceRef<'_>, corner: usize, source: &Mesh, mesh: &mut Mesh) {
    mesh.corners.push(mesh.points.len() as u32);
    mesh.points.push(face.position(corner));
    mesh.uvs.push_from(&source.uvs, |list| list[corner]);
    mesh.normals.extend(source.normals.get(corner));
}

/// The same loop the other way round, as a hole.
fn reversed(ring: &[PartCorner]) -> Vec<PartCorner> {
    ring.iter().rev().map(|corner| PartCorner { edge: None, ..*corner }).collect()
}

/// The part of a convex polygon that is at least that far to the left of a line.
fn clip(ring: &[PartCorner], from: DVec2, along: DVec2, by: f64) -> Vec<PartCorner> {
    let near = PLANAR_EPSILON * (along.length() + by);
    let inwards = along.perp().normalize_or_zero();
    let side = |corner: &PartCorner| {
        let distance = (corner.at - from).dot(inwards) - by;
        if distance.abs() <= near { 0.0 } else { distance }
    };
    let mut kept = Vec::new();
    for (at, corner) in ring.iter().enumerate() {
        let next = &ring[(at + 1) % ring.len()];
        let (a, b) = (side(corner), side(next));
        let crossing = || corner.at.lerp(next.at, a / (a - b));
        if 0.0 < a || a == 0.0 && 0.0 <= b {
            kept.push(*corner);
        }
        if a == 0.0 && b < 0.0 {
            kept.push(PartCorner { edge: None, ..*corner });
        } else if 0.0 < a && b < 0.0 {
            kept.push(PartCorner { at: crossing(), edge: None });
        } else if a < 0.0 && 0.0 < b {
            kept.push(PartCorner { at: crossing(), edge: corner.edge });
        }
    }
    let is_flat = kept.iter().all(|corner| side(corner) == 0.0);
    if is_flat { Vec::new() } else { kept }
}

#[cfg(test)]
mod tests;
