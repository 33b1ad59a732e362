//! Faces that look to the same side as their neighbours.
//!
//! Faces are connected by edges that exactly two faces have. Such an edge should be used once in each direction. Connected
//! faces are turned until all agree, and then all or none of them, by these rules: closed faces enclose a positive volume, or a
//! negative one if they are a cavity, which means inside an odd number of others. Open faces look up rather than down. Where
//! that decides nothing, most of their area stays as it is. So it does where faces end at edges of more than two faces: they may be
//! parts of solids that touch, and a closed mesh must stay closed.

use glam::{DVec2, DVec3};

use super::mesh::{Bounds, FaceRef, Mesh};
use crate::each::Each;
use crate::exact::orient;
use crate::mesh::pair_table::PairTable;
use crate::work;

/// Open faces are turned up if the vertical part of their area vector is at least this share of their area.
const UPRIGHT: f64 = 0.05;

/// The units of work of a corner in a pass.
const CORNER: usize = 8;

/// The limit on faces that are tested to find out which parts are inside others. Further parts count as outermost.
const MOST_TESTS: usize = 1 << 26;

/// The faces to turn.
#[derive(Debug, Default, PartialEq)]
pub struct Conforming {
    /// True for each face to turn.
    pub turned: Vec<bool>,
    /// The first faces of parts that cannot agree, such as a Möbius strip. They are not turned.
    pub refused: Vec<usize>,
}

/// A set of connected faces.
struct Patch {
    faces: Vec<u32>,
    is_closed: bool,
    /// True if an edge has more than two faces.
    branches: bool,
    bounds: Bounds,
}

/// Finds the faces to turn so that neighbours agree, and look to the side of `up`, of length 1, where a choice is left.
/// [`Mesh::turned`] turns them.
///
/// The time is linear in the corners, and at most quadratic in the number of closed parts, up to a limit. If the work of a
/// [`Supervisor`](crate::work::Supervisor) ends meanwhile, no face is turned.
pub fn conform(mesh: &Mesh, up: DVec3) -> Conforming {
    let none = || Conforming { turned: vec![false; mesh.face_count()], refused: Vec::new() };
    conform_in_time(mesh, up).unwrap_or_else(none)
}

/// [`conform`]. `None` if the work is to end.
fn conform_in_time(mesh: &Mesh, up: DVec3) -> Option<Conforming> {
    mesh.adjacency_in_time()?;
    let mut found = Conforming { turned: vec![false; mesh.face_count()], refused: Vec::new() };
    let mut patches = Vec::new();
    let mut seen = vec![false; mesh.face_count()];
    for face in 0..mesh.face_count() as u32 {
        if seen[face as usize] {
            continue;
        }
        let faces = agree(mesh, face, &mut seen, &mut found.turned);
        match faces {
            Ok(faces) => patches.push(Patch::of(mesh, faces, &found.turned)?),
            Err(faces) => {
                faces.into_iter().for_each(|face| found.turned[face as usize] = false);
                found.refused.push(face as usize);
            }
        }
    }
    let scale = mesh.bounds().scale_to_one();
    let mut tests_left = MOST_TESTS;
    let closed: Vec<usize> = (0..patches.len()).filter(|&patch| patches[patch].is_closed).collect();
    let mut wrong = Vec::new();
    for (number, patch) in patches.iter().enumerate() {
        if !work::spend(CORNER * patch.faces.len()) {
            return None;
        }
        let is_wrong = if patch.is_closed {
            let others = closed.iter().filter(|&&other| other != number).map(|&other| &patches[other]);
            let is_cavity = patch.is_inside_odd(mesh, others, &mut tests_left);
            (patch.volume(mesh, &found.turned, scale) < 0.0) != is_cavity
        } else {
            patch.looks_down(mesh, &found.turned, scale, up)
        };
        if is_wrong {
            wrong.push(number);
        }
    }
    for patch in wrong {
        patches[patch].faces.iter().for_each(|&face| found.turned[face as usize] ^= true);
    }
    work::spend(0).then_some(found)
}

/// Turns the faces that are connected to a face until they agree with it. Returns these faces; an error if they cannot agree.
fn agree(mesh: &Mesh, first: u32, seen: &mut [bool], turned: &mut [bool]) -> Result<Vec<u32>, Vec<u32>> {
    let adjacency = mesh.adjacency();
    let mut faces = vec![first];
    let mut fits = true;
    seen[first as usize] = true;
    let mut next = 0;
    while let Some(&face) = faces.get(next) {
        next += 1;
        let corners = mesh.face(face as usize).corner_range();
        if !work::spend(CORNER * corners.len()) {
            break;
        }
        for corner in corners {
            let &[one, two] = adjacency.uses(adjacency.edge(corner as u32)) else { continue };
            let other = if one == corner as u32 { two } else { one };
            let (neighbour, along) = (adjacency.face(other), mesh.corners[one as usize] == mesh.corners[two as usize]);
            if neighbour == face {
                continue;
            }
            let wanted = turned[face as usize] != along;
            if seen[neighbour as usize] {
                fits &= turned[neighbour as usize] == wanted;
            } else {
                seen[neighbour as usize] = true;
                turned[neighbour as usize] = wanted;
                faces.push(neighbour);
            }
        }
    }
    if fits { Ok(faces) } else { Err(faces) }
}

impl Patch {
    /// `None` if the work is to end.
    fn of(mesh: &Mesh, faces: Vec<u32>, turned: &[bool]) -> Option<Self> {
        let mut net = PairTable::default();
        for &face in &faces {
            if !work::spend(4 * CORNER * mesh.face(face as usize).corner_count()) {
                return None;
            }
            for edge in mesh.face(face as usize).edges() {
                let [a, b] = edge.each(|corner| mesh.corners[corner]);
                let (count, _) = net.entry(a.min(b), a.max(b), 0);
                *count = if (a < b) != turned[face as usize] { count.wrapping_add(1) } else { count.wrapping_sub(1) };
            }
        }
        let is_closed = net.pairs().all(|(_, count)| count == 0);
        let corners = faces.iter().flat_map(|&face| mesh.face(face as usize).corner_range());
        let uses = |corner: usize| mesh.adjacency().uses(mesh.adjacency().edge(corner as u32)).len();
        let branches = corners.clone().any(|corner| 2 < uses(corner));
        let bounds = Bounds::of(corners.map(|corner| mesh.points[mesh.corners[corner] as usize]));
        Some(Patch { faces, is_closed, branches, bounds })
    }

    fn faces<'m>(&self, mesh: &'m Mesh) -> impl Iterator<Item = FaceRef<'m>> + Clone {
        self.faces.iter().map(|&face| mesh.face(face as usize))
    }

    /// The enclosed volume, in a unit that keeps it finite.
    fn volume(&self, mesh: &Mesh, turned: &[bool], scale: f64) -> f64 {
        let from = self.bounds.low * scale;
        let of_face = |face: FaceRef<'_>| -> f64 {
            let area = scaled_area(&face, scale);
            let height = face.position(face.corner_range().start) * scale - from;
            if turned[face.index()] { -area.dot(height) } else { area.dot(height) }
        };
        self.faces(mesh).map(of_face).sum()
    }

    /// Returns true if open faces are to be turned.
    fn looks_down(&self, mesh: &Mesh, turned: &[bool], scale: f64, up: DVec3) -> bool {
        let (mut rise, mut all, mut turned_area) = (0.0, 0.0, 0.0);
        for face in self.faces(mesh) {
            let area = scaled_area(&face, scale);
            let is_turned = turned[face.index()];
            rise += if is_turned { -area.dot(up) } else { area.dot(up) };
            all += area.length();
            turned_area += if is_turned { area.length() } else { 0.0 };
        }
        if !self.branches && UPRIGHT * all <= rise.abs() { rise < 0.0 } else { all < 2.0 * turned_area }
    }

    /// Returns true if these faces are inside an odd number of others.
    fn is_inside_odd<'p>(&self, mesh: &Mesh, others: impl Iterator<Item = &'p Patch>, tests_left: &mut usize) -> bool {
        let at = mesh.face(self.faces[0] as usize).position(mesh.face(self.faces[0] as usize).corner_range().start);
        let mut is_inside = false;
        for other in others {
            if !(other.bounds.low.cmple(self.bounds.low).all() && self.bounds.high.cmple(other.bounds.high).all()) {
                continue;
            }
            let tests = other.faces.len();
            let Some(left) = tests_left.checked_sub(tests).filter(|_| work::spend(CORNER * tests)) else {
                return is_inside;
            };
            *tests_left = left;
            // A ray upwards passes an odd number of faces.
            is_inside ^= other.faces(mesh).filter(|face| is_over(face, at)).count() % 2 == 1;
        }
        is_inside
    }
}

/// The area vector of a face whose mesh is scaled to a size of about 1.
fn scaled_area(face: &FaceRef<'_>, scale: f64) -> DVec3 {
    let from = face.position(face.corner_range().start) * scale;
    face.edges().map(|edge| edge.each(|corner| face.position(corner) * scale - from)).map(|[a, b]| a.cross(b)).sum()
}

/// Returns true if a ray from a point upwards passes a face. At an edge of two faces it passes one of them.
fn is_over(face: &FaceRef<'_>, at: DVec3) -> bool {
    let flat = |p: DVec3| DVec2::new(p.z, p.x);
    let place = flat(at);
    let mut winding = 0;
    for edge in face.edges() {
        let [a, b] = edge.each(|corner| flat(face.position(corner)));
        let is_after = |p: DVec2| place.y < p.y;
        if is_after(a) != is_after(b) {
            // The sides of an edge are the same for all its faces: from its lower end up.
            let (low, high) = if is_after(b) { (a, b) } else { (b, a) };
            let is_left = 0 < orient(low, high, place);
            winding += if is_left { if is_after(b) { 1 } else { -1 } } else { 0 };
        }
    }
    if winding == 0 {
        return false;
    }
    let normal = face.normal();
    let from = face.position(face.corner_range().start);
    // The height of the face over the point has the sign of this quotient.
    ((from - at).dot(normal) < 0.0) == (normal.y < 0.0) && normal.y != 0.0
}

#[cfg(test)]
mod tests;
