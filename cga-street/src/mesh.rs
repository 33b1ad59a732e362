//! Meshes of polygons on the grid.

use glam::{DVec2, DVec3};

use super::grid::{GridMap, Point};
use cga_geometry::each::Each;
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use cga_geometry::triangulate::Triangulator;

/// A face: its outline and holes, and three sets of coordinates at each of their points.
pub(super) struct StreetFace {
    pub(super) rings: Vec<Vec<Point>>,
    pub(super) uvs: Vec<[DVec2; 3]>,
}

/// A mesh of faces with `sets` sets of coordinates. `None` if the faces have no area. Faces that are not flat are
/// divided into triangles.
pub(super) fn mesh(faces: &[StreetFace], heights: &GridMap<Point, f64>, sets: usize) -> Option<Mesh> {
    let mut builder = MeshBuilder::new();
    let mut numbers: GridMap<Point, u32> = GridMap::default();
    for face in faces {
        let points: Vec<Point> = face.rings.iter().flatten().copied().collect();
        let levels = levels(&points, heights);
        let place = |at: usize| {
            let flat = points[at].place();
            DVec3::new(flat.x, levels[at], 0.0 - flat.y)
        };
        let corners: Vec<u32> = (0..points.len())
            .map(|at| *numbers.entry(points[at]).or_insert_with(|| builder.point(place(at))))
            .collect();
        if is_flat(face.rings[0].len(), points.len(), place) {
            let mut rings: Vec<&[u32]> = Vec::new();
            let mut start = 0;
            for ring in &face.rings {
                rings.push(&corners[start..start + ring.len()]);
                start += ring.len();
            }
            builder.face(rings.first()?, &rings[1..], FaceTag::PLAIN);
            for set in 0..sets {
                builder.uv_set(set, &face.uvs.iter().map(|uvs| uvs[set]).collect::<Vec<_>>());
            }
            continue;
        }
        let flat: Vec<DVec2> = points.iter().map(|point| point.place()).collect();
        let mut end = 0;
        let ends = face.rings.iter().map(|ring| {
            end += ring.len() as u32;
            end
        });
        let mut triangles = Vec::new();
        Triangulator::new().polygon(&flat, &ends.collect::<Vec<_>>(), &mut triangles);
        for triangle in triangles {
            let triangle = triangle.each(|corner| corner as usize);
            builder.face(&triangle.each(|corner| corners[corner]), &[], FaceTag::PLAIN);
            for set in 0..sets {
                builder.uv_set(set, &triangle.each(|corner| face.uvs[corner][set]));
            }
        }
    }
    let mesh = builder.build().ok()?;
    (0 < mesh.face_count()).then_some(mesh)
}

/// The heights of the points of a face. Unknown heights are means of the known ones, weighted by the inverse square of
/// the distance.
fn levels(points: &[Point], heights: &GridMap<Point, f64>) -> Vec<f64> {
    let known: Vec<Option<f64>> = points.iter().map(|point| heights.get(point).copied()).collect();
    let first = known.iter().flatten().next().copied().unwrap_or(0.0);
    let level = |at: usize| match known[at] {
        Some(height) => height,
        None if known.iter().flatten().all(|&height| height == first) => first,
        None => {
            let weighted = known.iter().zip(points).filter_map(|(height, point)| {
                let distance = point.place().distance_squared(points[at].place());
                height.map(|height| (height / distance, 1.0 / distance))
            });
            let (sum, weights) = weighted.fold((0.0, 0.0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
            sum / weights
        }
    };
    (0..points.len()).map(level).collect()
}

/// Returns true if points are in one plane. The first `outer` of them are the outline.
fn is_flat(outer: usize, count: usize, place: impl Fn(usize) -> DVec3) -> bool {
    let from = place(0);
    if (1..count).all(|at| place(at).y == from.y) {
        return true;
    }
    let normal: DVec3 = (2..outer).map(|at| (place(at - 1) - from).cross(place(at) - from)).sum();
    let normal = cga_geometry::mesh::unit(normal);
    let extent = (1..count).map(|at| (place(at) - from).abs().max_element()).fold(0.0, f64::max);
    // A margin, because the mesh computes its normal differently.
    (1..count).all(|at| normal.dot(place(at) - from).abs() <= 0.5 * cga_geometry::tol::PLANAR_EPSILON * extent)
}
