//! Removes very short edges.

use super::components::{components, is_closed};
use super::merge::merged_into;
use super::{slits, spend, without_unused_points};
use crate::each::Each;
use crate::mesh::Mesh;
use crate::small_sort::SmallSort;

/// The mesh without edges shorter than a length in metres: their ends become one. `None` if it has no such edge, or if no
/// face would be left.
///
/// In a row of short edges, ends that are at least that far apart stay. A closed mesh stays closed, and no face turns over
/// or crosses itself. A closed part that would lose more than half of its volume, as a pane of glass, keeps all its edges. A length that is
/// NaN or not positive removes nothing.
pub fn without_short_edges(mesh: &Mesh, length: f64) -> Option<Mesh> {
    let mut short: Vec<[u32; 2]> = mesh
        .faces()
        .flat_map(|face| face.edges())
        .map(|edge| edge.each(|corner| mesh.corners[corner]))
        .map(|[a, b]| [a.max(b), a.min(b)])
        .filter(|&[a, b]| a != b && is_short(mesh, [a, b], length))
        .collect();
    if short.is_empty() {
        return None;
    }
    short.small_sort_unstable();
    short.dedup();
    let kept = flattened(mesh, &targets(mesh, &short, length, &|_| false))?;
    let made = merged_into(mesh, |stays| {
        targets(mesh, &short, length, &|point| stays[point as usize] || kept[point as usize])
    })?;
    let made = slits::without_slits(&made, &slits::tagged_slits(mesh)).unwrap_or(made);
    (!made.is_empty()).then(|| without_unused_points(made, mesh))
}

fn is_short(mesh: &Mesh, [a, b]: [u32; 2], length: f64) -> bool {
    mesh.points[a as usize].distance(mesh.points[b as usize]) < length
}

/// For each point the point that it becomes: itself, or the nearest target of the earlier ends of its short edges. The edges are
/// sorted by their later ends.
fn targets(mesh: &Mesh, short: &[[u32; 2]], length: f64, stays: &dyn Fn(u32) -> bool) -> Vec<u32> {
    let mut targets: Vec<u32> = (0..mesh.points.len() as u32).collect();
    for edges in short.chunk_by(|[a, _], [b, _]| a == b) {
        let point = edges[0][0];
        let near = edges
            .iter()
            .map(|&[_, earlier]| targets[earlier as usize])
            .filter(|&target| is_short(mesh, [point, target], length));
        let apart = |target: u32| mesh.points[point as usize].distance_squared(mesh.points[target as usize]);
        let nearest = near.min_by(|&a, &b| apart(a).total_cmp(&apart(b)).then(a.cmp(&b)));
        if let Some(target) = nearest.filter(|_| !stays(point)) {
            targets[point as usize] = target;
        }
    }
    targets
}

/// The points of closed parts that lose more than half of their volume if points become their targets. `None` if the work is to end.
fn flattened(mesh: &Mesh, targets: &[u32]) -> Option<Vec<bool>> {
    let mut kept = vec![false; mesh.points.len()];
    for faces in components(mesh).sets() {
        let points = || faces.iter().flat_map(|&face| &mesh.corners[mesh.face_corners(face as usize)]);
        spend(points().count())?;
        if points().all(|&point| targets[point as usize] == point) || !is_closed(mesh, &faces, &[]) {
            continue;
        }
        let [before, after] =
            [volume(mesh, &faces, |point| point), volume(mesh, &faces, |point| targets[point as usize])];
        if after.abs() < 0.5 * before.abs() {
            points().for_each(|&point| kept[point as usize] = true);
        }
    }
    Some(kept)
}

/// Six times the volume of a closed part whose points have the places of others.
fn volume(mesh: &Mesh, faces: &[u32], place: impl Fn(u32) -> u32) -> f64 {
    let from = mesh.points[mesh.corners[mesh.face_corners(faces[0] as usize).start] as usize];
    let at = |point: u32| mesh.points[place(point) as usize] - from;
    let rings = faces.iter().flat_map(|&face| mesh.face(face as usize).loops().collect::<Vec<_>>());
    rings.map(|ring| ring.windows(2).map(|ends| at(ring[0]).dot(at(ends[0]).cross(at(ends[1])))).sum::<f64>()).sum()
}

#[cfg(test)]
mod tests {
    use glam::{DAffine3, DVec3};

    use super::*;
    use crate::mesh::join::join;
    use crate::mesh::{FaceTag, Flaw, MeshBuilder};
    use crate::primitive::{cube, cylinder, sphere};

    #[test]
    fn a_row_of_short_edges_leaves_corners_that_far_apart() {
        // Sides of 0.63 mm: each second corner goes, as the next one is too far from the target of the first.
        let fine = cylinder(5_000);
        let made = without_short_edges(&fine, 0.001).expect("short edges");
        assert_eq!(made.check(), []);
        assert!(made.is_closed() && (made.volume() - fine.volume()).abs() < 1e-5);
        assert_eq!(made.face_count(), 2 + 2_500);
        assert!(without_short_edges(&made, 0.001).is_none());
    }

    #[test]
    fn what_is_near_without_an_edge_stays() {
        // Two triangles half a millimetre apart.
        let mut builder = MeshBuilder::new();
        for height in [0.0, 0.0005] {
            let points = [[0.0, height, 0.0], [1.0, height, 0.0], [0.0, height, 1.0]].map(|point| builder.point(point));
            builder.face(&points, &[], FaceTag::PLAIN);
        }
        assert!(without_short_edges(&builder.build().expect("a mesh"), 0.001).is_none());
    }

    #[test]
    fn a_thin_pane_keeps_its_thickness() {
        // A pane of 0.9 mm, alone and beside a cylinder whose sides are 0.63 mm wide.
        let pane = cube().map(&DAffine3::from_scale(DVec3::new(1.0, 1.5, 0.000_9)));
        assert!(without_short_edges(&pane, 0.001).is_none());
        let both = join([&pane, &cylinder(5_000).map(&DAffine3::from_translation(DVec3::X * 3.0))].into_iter());
        let made = without_short_edges(&both, 0.001).expect("short edges");
        assert_eq!((made.face_count(), made.check()), (6 + 2 + 2_500, vec![]));
        assert!(made.is_closed() && (made.volume() - both.volume()).abs() < 1e-5);
        // An open sheet has no volume to keep.
        let mut builder = MeshBuilder::new();
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.000_5, 1.0], [0.0, 0.999_5]];
        let points = corners.map(|[x, y]| builder.point([x, y, 0.3]));
        builder.polygon(&points);
        assert_eq!(
            without_short_edges(&builder.build().expect("a mesh"), 0.001).map(|made| made.points().len()),
            Some(4)
        );
    }

    #[test]
    fn a_tiny_asset_stays_and_closed_meshes_stay_closed() {
        for scale in [1e-6, 1e-4, 1e-3, 4e-3, 0.02, 0.1] {
            let tiny = sphere(24, 24).map(&DAffine3::from_scale(DVec3::splat(scale)));
            if let Some(made) = without_short_edges(&tiny, 0.001) {
                assert!(made.is_closed() && !made.is_empty(), "{scale}");
                let flaws = made.check().into_iter();
                // As after every merge, a face may be bent by the distance of its points.
                assert_eq!(flaws.filter(|flaw| !matches!(flaw, Flaw::NotPlanar { .. })).count(), 0, "{scale}");
                assert!(0.0 <= made.volume() && made.volume() <= tiny.volume() * 1.01, "{scale}");
            }
        }
        assert!(without_short_edges(&Mesh::default(), 0.001).is_none());
    }
}
