//! Picking: the leaf that a ray hits, and the triangles of a leaf or of a rule's leaves.

use cga::Model;
use cga::glam::{DAffine3, DVec3};
use cga::sink::meshes::{Granularity, MeshLeaf, Meshes, TriangleMesh};

/// The triangles of a model by leaf.
pub struct Picker {
    meshes: Meshes,
    /// The rule of each leaf.
    rules: Vec<String>,
}

/// Some triangles of a leaf, and the map that places them.
type LeafTriangles<'p> = (&'p TriangleMesh, &'p MeshLeaf, DAffine3);

impl Picker {
    /// Prepares a model.
    pub fn new(model: &Model) -> Self {
        let rules = model.leaves().map(|leaf| leaf.rule().to_owned()).collect();
        Picker { meshes: model.meshes(Granularity::Material), rules }
    }

    /// The rule of a leaf.
    pub fn rule(&self, leaf: usize) -> Option<&str> {
        self.rules.get(leaf).map(String::as_str)
    }

    /// The leaf that a ray hits first. Faces are hit from both sides.
    pub fn hit(&self, origin: DVec3, direction: DVec3) -> Option<usize> {
        let mut nearest: Option<(f64, usize)> = None;
        for (mesh, leaf, place) in self.parts() {
            for triangle in triangles(mesh, leaf, place) {
                let Some(distance) = distance(origin, direction, triangle) else { continue };
                if nearest.is_none_or(|(least, _)| distance < least) {
                    nearest = Some((distance, leaf.leaf));
                }
            }
        }
        nearest.map(|(_, leaf)| leaf)
    }

    /// The corners of a leaf's triangles: nine numbers for each triangle.
    pub fn triangles_of_leaf(&self, leaf: usize) -> Vec<f32> {
        self.corners(|of| of == leaf)
    }

    /// The corners of the triangles of all leaves of a rule.
    pub fn triangles_of_rule(&self, rule: &str) -> Vec<f32> {
        self.corners(|leaf| self.rule(leaf) == Some(rule))
    }

    fn corners(&self, wanted: impl Fn(usize) -> bool) -> Vec<f32> {
        let parts = self.parts().filter(|(_, leaf, _)| wanted(leaf.leaf));
        let corners = parts.flat_map(|(mesh, leaf, place)| triangles(mesh, leaf, place)).flatten();
        corners.flat_map(|corner| corner.as_vec3().to_array()).collect()
    }

    fn parts(&self) -> impl Iterator<Item = LeafTriangles<'_>> {
        let origin = DAffine3::from_translation(self.meshes.origin);
        self.meshes.list.iter().flat_map(move |mesh| {
            let leaves = mesh.leaves.iter().enumerate();
            leaves.map(move |(at, leaf)| (mesh, leaf, mesh.places.get(at).map_or(origin, |place| origin * *place)))
        })
    }
}

fn triangles<'p>(
    mesh: &'p TriangleMesh,
    leaf: &'p MeshLeaf,
    place: DAffine3,
) -> impl Iterator<Item = [DVec3; 3]> + use<'p> {
    let corner = move |index: u32| {
        let [x, y, z] = mesh.positions[index as usize].map(f64::from);
        place.transform_point3(DVec3::new(x, y, z))
    };
    mesh.indices[leaf.indices.clone()]
        .as_chunks::<3>()
        .0
        .iter()
        .map(move |&[a, b, c]| [corner(a), corner(b), corner(c)])
}

/// The distance along a ray to a triangle that it hits.
fn distance(origin: DVec3, direction: DVec3, [a, b, c]: [DVec3; 3]) -> Option<f64> {
    let (ab, ac) = (b - a, c - a);
    let across = direction.cross(ac);
    let determinant = ab.dot(across);
    if determinant == 0.0 {
        return None;
    }
    let to_origin = origin - a;
    let u = to_origin.dot(across) / determinant;
    let normal = to_origin.cross(ab);
    let v = direction.dot(normal) / determinant;
    let at = ac.dot(normal) / determinant;
    (0.0 <= u && 0.0 <= v && u + v <= 1.0 && 0.0 < at).then_some(at)
}

#[cfg(test)]
mod tests {
    use cga::glam::DVec3;
    use cga::{Assets, MeshBuilder, Model, Settings, Shape, cga};

    use super::Picker;

    cga! {
        @Allow(missing_asset)
        grammar Row;
        Lot --> extrude(2) split(x) { 1 : Low. | 1 : [ color("#ff0000") High. ] | 1 : i("wedge") Wedge. | 1 : i("wedge") Wedge. }
    }

    fn row(at: [f64; 3]) -> Model {
        let mut builder = MeshBuilder::new();
        let [a, b, c] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|corner| builder.point(corner));
        builder.polygon(&[a, b, c]);
        let assets = Assets::new().with("wedge", builder.build().expect("a triangle"));
        let settings = Settings { assets: assets.into(), ..Settings::default() };
        Row::default().generate_with(&Shape::rectangle(4.0, 1.0).at(at), &settings).expect("a model")
    }

    #[test]
    fn a_ray_hits_the_first_leaf() {
        for at in [[0.0; 3], [3e6, 100.0, -2e6]] {
            let model = row(at);
            let picker = Picker::new(&model);
            let bounds = model.bounds();
            let from = |x: f64, y: f64| DVec3::new(bounds.low.x + x, bounds.low.y + y, bounds.high.z + 10.0);
            let pick =
                |x: f64, y: f64| picker.hit(from(x, y), DVec3::NEG_Z).map(|leaf| (leaf, picker.rule(leaf).unwrap()));
            assert_eq!(pick(0.5, 1.0), Some((0, "Low")));
            assert_eq!(pick(1.5, 1.0), Some((1, "High")));
            assert_eq!(pick(2.1, 0.1), Some((2, "Wedge")));
            assert_eq!(pick(3.1, 0.1), Some((3, "Wedge")));
            assert_eq!(pick(2.9, 1.9), None);
            assert_eq!(pick(9.0, 1.0), None);
            // From the other side, and away from the model.
            assert_eq!(picker.hit(from(-5.0, 1.0) - 10.5 * DVec3::Z, DVec3::X), Some(0));
            assert_eq!(picker.hit(from(0.5, 1.0), DVec3::Z), None);
            assert_eq!(picker.hit(from(0.5, 1.0), DVec3::ZERO), None);
            assert_eq!(picker.hit(from(0.5, f64::NAN), DVec3::NEG_Z), None);
        }
    }

    #[test]
    fn triangles_belong_to_leaves() {
        let model = row([0.0; 3]);
        let picker = Picker::new(&model);
        assert_eq!(picker.triangles_of_leaf(0).len(), 12 * 9);
        assert_eq!(picker.triangles_of_leaf(2).len(), 9);
        assert_eq!(picker.triangles_of_rule("Wedge").len(), 2 * 9);
        assert!(picker.triangles_of_leaf(4).is_empty());
        let all: usize = (0..4).map(|leaf| picker.triangles_of_leaf(leaf).len()).sum();
        assert_eq!(all, 9 * model.triangle_count());
        let x: Vec<f32> = picker.triangles_of_leaf(3).iter().copied().step_by(3).collect();
        assert!(x.iter().all(|x| (3.0..=4.0).contains(x)), "{x:?}");
    }
}
