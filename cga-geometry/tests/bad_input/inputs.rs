//! Meshes and numbers that operations rarely meet.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use cga_geometry::glam::{DAffine3, DMat3, DVec2, DVec3};
use cga_geometry::mesh::{FaceTag, Flaw, Mesh, MeshBuilder, TagSet};
use cga_geometry::primitive;
use cga_geometry::roof::{Rise, RoofForm, roof_over};

/// Numbers at the ends of all ranges.
pub(crate) const NUMBERS: [f64; 11] =
    [-0.0, 1.0, -1.0, 0.3, 90.0, 1e308, -1e308, 5e-324, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

pub(crate) fn vectors() -> Vec<DVec3> {
    let mut all: Vec<DVec3> = NUMBERS.into_iter().map(DVec3::splat).collect();
    all.extend(NUMBERS.into_iter().map(|number| DVec3::new(0.0, number, 0.0)));
    all.push(DVec3::new(f64::NAN, 1.0, 0.0));
    all
}

fn polygon(points: &[[f64; 3]]) -> Mesh {
    let mut builder = MeshBuilder::new();
    let corners: Vec<u32> = points.iter().map(|&point| builder.point(point)).collect();
    builder.polygon(&corners);
    builder.build().unwrap()
}

/// A square with a hole, texture coordinates, normals, and tags of all kinds.
pub(crate) fn courtyard() -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut square = |low: f64, high: f64| {
        [[low, low], [high, low], [high, high], [low, high]].map(|[x, y]| builder.point([x, 0.0, -y]))
    };
    let (outer, hole) = (square(0.0, 9.0), square(3.0, 6.0));
    let turned = [hole[0], hole[3], hole[2], hole[1]];
    builder.tag_sets([TagSet::new(["face"])]).groups(["group".to_owned()]).materials(["brick"]);
    builder.face(&outer, &[&turned], FaceTag { group: 0, material: 0, tags: 0, ..FaceTag::PLAIN });
    builder.uvs(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0].map(DVec2::splat)).normals(&[DVec3::Y; 8]);
    builder.edge_tags([outer[0], outer[1]], &TagSet::new(["edge"])).vertex_tags(outer[2], &TagSet::new(["vertex"]));
    builder.build().unwrap()
}

fn scaled(mesh: &Mesh, by: f64) -> Mesh {
    mesh.map(&DAffine3 { matrix3: DMat3::from_diagonal(DVec3::splat(by)), translation: DVec3::ZERO })
}

/// Meshes with their names.
pub(crate) fn meshes() -> Vec<(&'static str, Arc<Mesh>)> {
    let shapes = [
        ("cube", primitive::cube()),
        ("sphere", primitive::sphere(5, 3)),
        ("courtyard", courtyard()),
        ("line", polygon(&[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]])),
        ("bow", polygon(&[[0.0; 3], [4.0, 0.0, -4.0], [4.0, 0.0, 0.0], [0.0, 0.0, -3.0]])),
        ("fold", polygon(&[[0.0; 3], [4.0, 0.0, 0.0], [4.0, 3.0, -4.0], [0.0, 0.0, -4.0]])),
        ("notch", polygon(&[[0.0; 3], [4.0, 0.0, 0.0], [4.0, 0.0, -4.0], [2.0, 0.0, -1.0], [0.0, 0.0, -4.0]])),
    ];
    let roof = roof_over(
        &polygon(&[[0.0; 3], [9.0, 0.0, 0.0], [8.0, 0.0, -4.0], [1.0, 0.0, -5.0]]),
        RoofForm::Hip { overhang: 0.0, even: true },
        Rise::Slope(0.5),
    );
    let mut all = vec![("empty", Arc::new(Mesh::default())), ("roof", Arc::new(roof.mesh))];
    for (name, mesh) in shapes {
        let count = mesh.points().len();
        let mut with_odd = |at: usize, odd: f64| {
            let mut points = mesh.points().to_vec();
            points[at].x = odd;
            all.push((name, Arc::new(mesh.with_points(points))));
        };
        with_odd(0, f64::NAN);
        with_odd(count - 1, 1e308);
        if name == "notch" || name == "cube" || name == "courtyard" {
            for by in [0.0, 5e-324, 1e200, 1e308, f64::INFINITY] {
                all.push((name, Arc::new(scaled(&mesh, by))));
            }
        }
        all.push((name, Arc::new(mesh)));
    }
    all
}

/// Returns true if the mesh is valid, except that points may not be finite and faces not planar.
fn is_sound(mesh: &Mesh) -> bool {
    mesh.check().iter().all(|flaw| matches!(flaw, Flaw::NotFinite { .. } | Flaw::NotPlanar { .. } | Flaw::Hole { .. }))
}

/// Makes a call whose results must be sound. A panic gets the name of the call in its message.
pub(crate) fn call(name: impl Fn() -> String, call: impl FnOnce() -> Vec<Mesh>) {
    let made = catch_unwind(AssertUnwindSafe(call)).unwrap_or_else(|_| panic!("{} panicked", name()));
    assert!(made.iter().all(is_sound), "{} made a broken mesh", name());
}
