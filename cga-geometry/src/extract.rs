//! Extraction of faces from a mesh.

use std::collections::HashMap;

use crate::Frame;
use crate::derive::{Derivation, FaceOrigin, Mix, PointOrigin};
use crate::mesh::Mesh;

/// Up to this number of corners, the points so far are searched one by one.
const FEW: usize = 24;

/// A table of all points pays off if at least one of this number of points is a corner.
const SPARSE: usize = 16;

/// The numbers of the points of a mesh in an extract of it.
enum PointNumbers {
    /// The points so far, in the order of their numbers, and their count.
    Few([u32; FEW], usize),
    /// For each point of the mesh its number, or `u32::MAX`.
    All(Vec<u32>),
    /// The numbers by point.
    Some(HashMap<u32, u32>),
}

impl PointNumbers {
    /// No numbers yet, for a number of corners of a mesh with `points` points.
    fn new(corners: usize, points: usize) -> Self {
        if corners <= FEW {
            PointNumbers::Few([0; FEW], 0)
        } else if points / SPARSE <= corners {
            PointNumbers::All(vec![u32::MAX; points])
        } else {
            PointNumbers::Some(HashMap::with_capacity(corners))
        }
    }

    /// The number of a point: `next` if it has none yet.
    fn number(&mut self, point: u32, next: u32) -> u32 {
        match self {
            PointNumbers::Few(seen, count) => match seen[..*count].iter().position(|&other| other == point) {
                Some(number) => number as u32,
                None => {
                    seen[*count] = point;
                    *count += 1;
                    next
                }
            },
            PointNumbers::All(numbers) => {
                let number = &mut numbers[point as usize];
                *number = if *number == u32::MAX { next } else { *number };
                *number
            }
            PointNumbers::Some(numbers) => *numbers.entry(point).or_insert(next),
        }
    }
}

/// A mesh of the given faces, in their order, in the coordinates of a frame. Shared points stay shared, and unused
/// points are dropped. Tags (of faces, edges and vertices), texture coordinates and normals are kept. Faces that do not exist are ignored.
pub fn extract(mesh: &Mesh, faces: &[u32], to: &Frame) -> Mesh {
    let loops = faces.len();
    let faces = faces.iter().map(|&index| index as usize).filter(|&index| index < mesh.face_count());
    let corners = faces.clone().map(|index| mesh.face_corners(index).len()).sum();
    let mut numbers = PointNumbers::new(corners, mesh.points().len());
    let mut part = Derivation::by_corners(mesh, corners);
    // As many points as corners in a single face.
    part.make_room(corners.min(mesh.points().len()), corners, loops);
    for face in faces.map(|index| mesh.face(index)) {
        for ring in face.loop_ranges() {
            for corner in ring {
                let point = mesh.corners()[corner];
                let next = part.point_count() as u32;
                let number = numbers.number(point, next);
                if number == next {
                    part.point(to.to_local(mesh.points()[point as usize]), PointOrigin::Old(point));
                }
                part.corner(number, &Mix::One(corner as u32), false);
            }
            part.end_loop();
        }
        part.end_face(FaceOrigin::piece(&face));
    }
    let mut made = part.finish();
    let into = to.axes.transpose();
    made.bent = into * mesh.bent;
    made.normals.iter_mut().for_each(|normal| *normal = into * *normal);
    made
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::face_frame::face_frame;
    use crate::primitive::{cube, cylinder};

    #[test]
    fn one_face_in_its_own_frame_lies_flat() {
        let mesh = cube();
        for face in 0..6 {
            let frame = face_frame(&mesh, face as usize).unwrap().frame;
            let part = extract(&mesh, &[face], &frame);
            assert_eq!(part.points().len(), 4);
            assert!(part.points().iter().all(|p| p.z == 0.0));
            assert!(part.check().is_empty());
        }
    }

    #[test]
    fn points_are_shared_in_faces_of_few_and_of_many_corners() {
        for sides in [3, 4, 11, 12, 13, 500] {
            // Many points that no face of the first ones has.
            let mut mesh = cylinder(sides);
            let unused = mesh.points.len() * (sides % 2) * 40;
            mesh.points.extend(std::iter::repeat_n(glam::DVec3::ZERO, unused));
            let all: Vec<u32> = (0..mesh.face_count() as u32).collect();
            for faces in [&all[..1], &all[..2], &all[..3], &all] {
                let part = extract(&mesh, faces, &Frame::WORLD);
                let mut used: Vec<u32> =
                    faces.iter().flat_map(|&face| mesh.corners[mesh.face_corners(face as usize)].to_vec()).collect();
                used.sort_unstable();
                used.dedup();
                assert_eq!((part.points().len(), part.check()), (used.len(), vec![]), "{sides}");
            }
        }
    }

    #[test]
    fn all_faces_stay_closed() {
        let mesh = cylinder(12);
        let all: Vec<u32> = (0..mesh.face_count() as u32).collect();
        let part = extract(&mesh, &all, &Frame::WORLD);
        assert_eq!(part.points().len(), mesh.points().len());
        assert!(part.is_closed());
    }
}
