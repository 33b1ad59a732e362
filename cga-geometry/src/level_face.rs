//! A single face of a mesh as a mesh in the coordinates of its own frame, where it is level.
//!
//! A component split makes one such mesh for each face and often drops it before the next one, so the lists of the last mesh can be used again
//! ([`LevelFaces::put`]).

use std::ops::Range;

use glam::DVec3;

use crate::Frame;
use crate::derive::FEW_SETS;
use crate::each::Each;
use crate::extract::extract;
use crate::mesh::{Bounds, Derived, FaceEnds, Mesh};
use crate::tol::PLANAR_EPSILON;

/// Up to this number of corners, points are compared with each other.
const FEW: usize = 24;

/// The smallest capacity for corners that counts as much.
const MUCH: usize = 4 * FEW;

/// The faces of a mesh, one by one.
#[derive(Clone, Copy, Debug)]
pub struct LevelFaces<'m> {
    mesh: &'m Mesh,
    /// True if parts take over the tags of the mesh as they are, and nothing else but values of corners.
    is_simple: bool,
    has_values: bool,
}

impl<'m> LevelFaces<'m> {
    /// The faces of a mesh.
    #[inline]
    pub fn of(mesh: &'m Mesh) -> Self {
        let is_simple = !mesh.needs_origins() && mesh.tag_sets.len() <= FEW_SETS;
        LevelFaces { mesh, is_simple, has_values: mesh.has_corner_values() }
    }

    /// The mesh of a face, as by [`extract`], in the coordinates of a frame. A face in the xy plane of the frame except for rounding, as a triangle always is
    /// in its own frame, is moved into that plane: it has a z size of zero.
    ///
    /// # Panics
    /// Panics if the face does not exist.
    pub fn make(&self, face: usize, to: &Frame) -> Mesh {
        let loops = self.mesh.face_loops(face);
        let corners = self.mesh.corners_of(&loops);
        if !self.is_simple || FEW < corners.len() {
            return levelled(extract(self.mesh, &[face as u32], to));
        }
        let mut made = self.mesh.alike(corners.len());
        made.points = Vec::with_capacity(corners.len());
        made.corners = Vec::with_capacity(corners.len());
        self.fill(&mut made, (face, loops, corners), to);
        made
    }

    /// Replaces another face of the mesh, which [`LevelFaces::make`] has made, without new memory. Returns its bounds. `None` if that cannot be
    /// done; then `made` stays as it is.
    ///
    /// # Panics
    /// Panics if the face does not exist.
    #[inline]
    pub fn put(&self, made: &mut Mesh, face: usize, to: &Frame) -> Option<Bounds> {
        let loops = self.mesh.face_loops(face);
        let corners = self.mesh.corners_of(&loops);
        let may = self.is_simple
            && corners.len() <= FEW
            && made.is_alike(self.mesh)
            && !made.needs_origins()
            // A mesh that someone keeps should not hold the memory of a larger face.
            && made.corners.capacity() <= MUCH;
        may.then(|| self.fill(made, (face, loops, corners), to))
    }

    /// Replaces the only face of a mesh by a face with these loops and corners. Returns its bounds.
    fn fill(&self, made: &mut Mesh, (face, loops, corners): (usize, Range<usize>, Range<usize>), to: &Frame) -> Bounds {
        let mesh = self.mesh;
        let bounds = put_points(made, mesh, loops, &mesh.corners[corners.clone()], to);
        made.tags.put_single(mesh.tags[face]);
        if mesh.bent != DVec3::ZERO {
            made.bent = to.axes.transpose() * mesh.bent;
        }
        if self.has_values {
            put_values(made, mesh, corners, to);
        }
        made.derived.reset(bounds);
        made.check_structure();
        bounds
    }
}

/// Replaces the points and the loops of the only face of a mesh. Returns their bounds.
#[inline]
fn put_points(made: &mut Mesh, mesh: &Mesh, loops: Range<usize>, corners: &[u32], to: &Frame) -> Bounds {
    let place = |point: u32| to.to_local(mesh.points[point as usize]);
    let counts = [made.corners.len(), made.points.len(), made.loop_ends.len()];
    // In the triangle before, the loop is the same.
    if let (&[a, b, c], [3, 3, 1], [x, y, z]) = (corners, counts, &mut made.points[..]) {
        let triangle = [a, b, c].each(|point| level_point(place(point)));
        [*x, *y, *z] = triangle;
        return Bounds::of(triangle);
    }
    let number = |corner: usize| corners[..corner].iter().position(|&other| other == corners[corner]);
    // Neighbours are at different points.
    let is_polygon = match *corners {
        [_, _, _] => true,
        [a, b, c, d] => a != c && b != d,
        _ => loops.len() == 1 && (1..corners.len()).all(|corner| number(corner).is_none()),
    };
    if is_polygon && counts == [corners.len(), corners.len(), 1] {
        // The old face has the same loop, over the points in their order.
        made.points.iter_mut().zip(corners).for_each(|(old, &point)| *old = place(point));
    } else {
        made.points.clear();
        made.corners.clear();
        made.loop_ends.clear();
        for (corner, &point) in corners.iter().enumerate() {
            let earlier = if is_polygon { None } else { number(corner) };
            let number = match earlier {
                Some(earlier) => made.corners[earlier],
                None => made.add_point(place(point)),
            };
            made.corners.push(number);
        }
        let start = mesh.loop_range(loops.start).start as u32;
        made.loop_ends.extend(mesh.loop_ends[loops.clone()].iter().map(|end| end - start));
        made.face_ends = FaceEnds::default();
        made.face_ends.push(loops.len());
    }
    level(&mut made.points, corners.len() == 3)
}

/// Replaces the values of corners.
#[inline(never)]
fn put_values(made: &mut Mesh, mesh: &Mesh, corners: Range<usize>, to: &Frame) {
    let into = to.axes.transpose();
    made.uvs.clear();
    made.uvs.copy_from(&mesh.uvs, corners.clone());
    if !mesh.normals.is_empty() {
        made.normals.clear();
        made.normals.extend(mesh.normals[corners].iter().map(|normal| into * *normal));
    }
}

/// The mesh of a part, moved into the xy plane if it is a triangle or in that plane except for rounding.
pub fn levelled(mut mesh: Mesh) -> Mesh {
    let is_triangle = mesh.corners.len() == 3;
    let bounds = level(&mut mesh.points, is_triangle);
    mesh.derived = Derived::bounded(bounds);
    mesh
}

/// Moves points into the xy plane if they belong to a triangle, or are in that plane except for rounding. Returns their bounds.
fn level(points: &mut [DVec3], is_triangle: bool) -> Bounds {
    let mut bounds = Bounds::of(points.iter().copied());
    let size = bounds.size();
    if !points.is_empty() && (is_triangle || size.z <= PLANAR_EPSILON * size.max_element()) {
        points.iter_mut().for_each(|point| *point = level_point(*point));
        [bounds.low, bounds.high] = [bounds.low, bounds.high].each(level_point);
    }
    bounds
}

fn level_point(point: DVec3) -> DVec3 {
    DVec3 { z: 0.0, ..point }
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};

    use super::*;
    use crate::extrude::{Extrude, extrude};
    use crate::face_frame::face_frame;
    use crate::mesh::TagSet;
    use crate::primitive;

    /// All bits of the points and the bounds, and everything else as text.
    fn bits(mesh: &Mesh) -> (Vec<[u64; 3]>, String) {
        let Bounds { low, high } = mesh.bounds();
        let all = mesh.points.iter().chain([&low, &high]).chain(&mesh.normals);
        // A direction of zero may have any sign.
        let text = format!("{:?}", Mesh { derived: Derived::default(), bent: mesh.bent + 0.0, ..mesh.clone() });
        (all.map(|point| point.to_array().map(f64::to_bits)).collect(), text)
    }

    fn prism_with_a_hole() -> Mesh {
        let square = |low: f64, high: f64| {
            [(low, low), (high, low), (high, high), (low, high)].map(|(x, z)| DVec3::new(x, 0.0, -z)).to_vec()
        };
        extrude(&Mesh::from_polygon(&square(0.0, 9.0), &[square(3.0, 6.0)]).unwrap(), Extrude::FaceNormal, 4.0)
    }

    fn meshes() -> Vec<Mesh> {
        let textured = |mesh: Mesh| {
            let uvs = (0..mesh.corners.len()).map(|corner| DVec2::splat(corner as f64)).collect();
            mesh.with_uv_set(2, uvs)
        };
        let ball = primitive::sphere(9, 7);
        let smooth =
            Mesh { normals: ball.points.iter().cycle().take(ball.corners.len()).copied().collect(), ..ball.clone() };
        let tagged = prism_with_a_hole().with_tagged_edges("wall");
        let sets = (0..20).map(|number| TagSet::new([format!("t{number}")]));
        let many = Mesh { tag_sets: sets.collect::<Vec<_>>().into(), ..primitive::cube() };
        vec![
            ball.clone(),
            textured(ball),
            smooth,
            primitive::cylinder(40),
            prism_with_a_hole().in_group("house"),
            textured(prism_with_a_hole()),
            Mesh { bent: DVec3::Y, ..primitive::cylinder(5) },
            tagged,
            many,
        ]
    }

    #[test]
    fn a_face_is_the_same_as_its_extract_alone_and_after_another_face() {
        for mesh in meshes() {
            let faces = LevelFaces::of(&mesh);
            let mut last = faces.make(0, &Frame::WORLD);
            let mut put = 0;
            for face in (0..mesh.face_count()).chain([0]) {
                for frame in [Frame::WORLD, face_frame(&mesh, face).unwrap().frame] {
                    let expected = bits(&levelled(extract(&mesh, &[face as u32], &frame)));
                    let alone = faces.make(face, &frame);
                    assert_eq!(bits(&alone), expected);
                    let before = bits(&last);
                    // Properties of the last face must not stay.
                    let _ = (last.is_closed(), last.adjacency());
                    if let Some(bounds) = faces.put(&mut last, face, &frame) {
                        put += 1;
                        assert_eq!(bounds, last.bounds());
                        assert_eq!(bits(&last), expected);
                        assert!(last.derived.adjacency.get().is_none() && last.derived.closed.get().is_none());
                    } else {
                        assert_eq!(bits(&last), before);
                        last = alone;
                    }
                }
            }
            assert_eq!(0 < put, faces.is_simple, "{mesh:?}");
        }
    }

    #[test]
    fn a_face_does_not_replace_a_face_of_a_mesh_with_other_names() {
        let (plain, named) = (primitive::cube(), primitive::cube().in_group("house"));
        let mut made = LevelFaces::of(&plain).make(0, &Frame::WORLD);
        assert!(LevelFaces::of(&plain).put(&mut made, 1, &Frame::WORLD).is_some());
        assert!(LevelFaces::of(&named).put(&mut made, 1, &Frame::WORLD).is_none());
    }

    #[test]
    fn a_face_at_a_point_twice_has_the_point_once() {
        let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
        let mut builder = crate::mesh::MeshBuilder::new();
        let numbers: Vec<u32> = points.iter().map(|[x, z]| builder.point([*x, 0.0, -*z])).collect();
        builder.polygon(&numbers);
        let mesh = builder.build().unwrap();
        let made = LevelFaces::of(&mesh).make(0, &Frame::WORLD);
        assert_eq!((made.points.len(), &made.corners[..]), (5, &[0, 1, 2, 3, 4, 2][..]));
    }
}
