//! Extraction of faces from a mesh.

use super::Mesh;
use crate::geometry::Frame;
use crate::geometry::trace::PartPoint;

/// Up to this number of corners, the points so far are searched one by one.
const FEW: usize = 24;

/// A mesh of the given faces, in their order, in the coordinates of a frame. Shared points stay shared, and unused
/// points are dropped. Tags (of faces, edges and vertices), texture coordinates and normals are kept. Faces that do not exist are ignored.
pub fn extract(mesh: &Mesh, faces: &[u32], to: &Frame) -> Mesh {
    let into = to.axes.transpose();
    let mut part = Mesh { bent: into * mesh.bent, ..mesh.alike(0) };
    let mut new: Vec<u32> = Vec::new();
    // A table of all points pays off only if many are used.
    let known = faces.iter().filter(|&&index| (index as usize) < mesh.face_count());
    let few = known.map(|&index| mesh.face(index as usize).corner_count()).sum::<usize>() <= FEW;
    if !few {
        new.resize(mesh.points.len(), u32::MAX);
    }
    let mut seen: Vec<u32> = Vec::new();
    // The points of a mesh that needs origins.
    let mut taken: Vec<u32> = Vec::new();
    let takes = mesh.needs_origins();
    for &index in faces {
        if index as usize >= mesh.face_count() {
            continue;
        }
        let face = mesh.face(index as usize);
        for ring in face.loop_ranges() {
            for corner in ring {
                let point = mesh.corners[corner];
                let known = if few {
                    seen.iter().position(|&p| p == point).map(|i| i as u32)
                } else {
                    Some(new[point as usize]).filter(|&p| p != u32::MAX)
                };
                let number = known.unwrap_or_else(|| {
                    let number = part.add_point(to.to_local(mesh.points[point as usize]));
                    if takes {
                        taken.push(point);
                    }
                    if few {
                        seen.push(point);
                    } else {
                        new[point as usize] = number;
                    }
                    number
                });
                part.corners.push(number);
                part.uvs.push_from(&mesh.uvs, |list| list[corner]);
                if let Some(&normal) = mesh.normals.get(corner) {
                    part.normals.push(into * normal);
                }
            }
            part.end_loop();
        }
        part.end_face(face.tag());
    }
    part.trace = mesh.trace.pick(&mut taken.iter().map(|point| Some(*point)));
    part.carry_tags(mesh, |point| PartPoint::old(taken[point as usize]));
    part
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::face_frame::face_frame;
    use crate::geometry::mesh::primitive::{cube, cylinder};

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
            let mesh = cylinder(sides);
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
