//! The assets of the pages' examples. The pages have files; the meshes here have their names.

use std::f64::consts::TAU;
use std::sync::Arc;

use cga::mesh::FaceTag;
use cga::{Assets, Color, Material, Mesh, MeshBuilder, Settings};

use super::meshes::{reversed, wall};
use super::{cutting, meshes};

/// Settings with all assets of the pages.
pub fn settings() -> Settings {
    settings_with(meshes::lying_cylinder(cutting::SIDES, 0.5, 4.0))
}

/// The same with another mesh in place of the lying cylinder.
pub fn settings_with(lying_cylinder: Mesh) -> Settings {
    let assets = Assets::new()
        .with("cylinder.hor.obj", lying_cylinder)
        .with("building.obj", meshes::house())
        .with("window.obj", window())
        .with("cylinder.vert.obj", standing_cylinder())
        .with("barrier.obj", barrier())
        .with("guardrail.obj", guardrail())
        .with("sphere.obj", meshes::sphere(16, 8, 0.5))
        .with("Orange_Tree_Analytical_0.obj", tree())
        .with("windowAligned.obj", lying_window())
        .with("pyramid.obj", pyramid())
        .with("circles2D.obj", flat_ring())
        .with("circles3D.obj", ring());
    Settings { assets: Arc::new(assets), ..Settings::default() }
}

fn blocks(parts: &[([f64; 3], [f64; 3])]) -> Mesh {
    let mut builder = MeshBuilder::new();
    parts.iter().for_each(|(low, size)| meshes::block(&mut builder, *low, *size, FaceTag::PLAIN));
    builder.build().expect("boxes")
}

/// A window of 1.2 by 1.6 m that faces z: a frame with a cross, a sill, and glass.
fn window() -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut glass = Material::default();
    (glass.name, glass.color) = (Some("Glass".into()), Some(Color::new(0.36, 0.44, 0.52)));
    builder.materials([glass]);
    for (low, size) in [
        ([0.0, 0.08, 0.0], [0.1, 1.52, 0.12]),
        ([1.1, 0.08, 0.0], [0.1, 1.52, 0.12]),
        ([0.1, 0.08, 0.0], [1.0, 0.1, 0.12]),
        ([0.1, 1.5, 0.0], [1.0, 0.1, 0.12]),
        ([0.56, 0.18, 0.05], [0.08, 1.32, 0.05]),
        ([0.1, 1.1, 0.05], [0.46, 0.06, 0.05]),
        ([0.64, 1.1, 0.05], [0.46, 0.06, 0.05]),
        ([0.0, 0.0, 0.0], [1.2, 0.08, 0.2]),
    ] {
        meshes::block(&mut builder, low, size, FaceTag::PLAIN);
    }
    let pane = FaceTag { material: 0, ..FaceTag::PLAIN };
    meshes::block(&mut builder, [0.1, 0.18, 0.02], [1.0, 1.32, 0.02], pane);
    builder.build().expect("a window")
}

/// A frame with a cross that lies on the ground, 1 by 1.2 m. Its origin is in the middle of its height.
fn lying_window() -> Mesh {
    blocks(&[
        ([0.0, -0.1, 0.0], [0.12, 0.2, 1.2]),
        ([0.88, -0.1, 0.0], [0.12, 0.2, 1.2]),
        ([0.12, -0.1, 0.0], [0.76, 0.2, 0.12]),
        ([0.12, -0.1, 1.08], [0.76, 0.2, 0.12]),
        ([0.47, -0.04, 0.12], [0.06, 0.08, 0.96]),
        ([0.12, -0.04, 0.57], [0.35, 0.08, 0.06]),
        ([0.53, -0.04, 0.57], [0.35, 0.08, 0.06]),
    ])
}

/// A closed prism along z over a profile in x and y, counter-clockwise.
fn prism(profile: &[[f64; 2]], length: f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut ring = |z: f64| -> Vec<u32> { profile.iter().map(|[x, y]| builder.point([*x, *y, z])).collect() };
    let (back, front) = (ring(0.0), ring(length));
    wall(&mut builder, &back, &front, FaceTag::PLAIN);
    builder.polygon(&front).polygon(&reversed(&back));
    builder.build().expect("a prism")
}

/// A barrier of a road: 0.8 m wide, 1 m high, 2 m long.
fn barrier() -> Mesh {
    prism(&[[0.0, 0.0], [0.8, 0.0], [0.8, 0.1], [0.55, 0.4], [0.5, 1.0], [0.3, 1.0], [0.25, 0.4], [0.0, 0.1]], 2.0)
}

/// A rail on two posts along x, 4 m long.
fn guardrail() -> Mesh {
    blocks(&[
        ([0.6, 0.0, 0.1], [0.15, 0.9, 0.15]),
        ([3.25, 0.0, 0.1], [0.15, 0.9, 0.15]),
        ([0.0, 0.5, 0.25], [4.0, 0.35, 0.1]),
    ])
}

/// Points on a circle about the y axis, counter-clockwise as seen from above.
fn circle(builder: &mut MeshBuilder, sides: u32, radius: f64, y: f64) -> Vec<u32> {
    let angle = |at: u32| TAU * f64::from(at) / f64::from(sides);
    (0..sides).map(|at| builder.point([radius * libm::sin(angle(at)), y, radius * libm::cos(angle(at))])).collect()
}

/// A closed cylinder about the y axis, of 16 sides.
fn standing_cylinder() -> Mesh {
    let mut builder = MeshBuilder::new();
    let [low, high] = [0.0, 4.0].map(|y| circle(&mut builder, 16, 0.5, y));
    wall(&mut builder, &low, &high, FaceTag::PLAIN);
    builder.polygon(&high).polygon(&reversed(&low));
    builder.build().expect("a cylinder")
}

/// A crown and a trunk, in the groups 0 and 1.
fn tree() -> Mesh {
    let mut builder = MeshBuilder::new();
    builder.groups(["Foliage", "Trunk"].map(str::to_owned));
    builder.materials([[0.45, 0.62, 0.32], [0.42, 0.29, 0.17]].map(|[r, g, b]| {
        let mut material = Material::default();
        material.color = Some(Color::new(r, g, b));
        material
    }));
    let crown = FaceTag { group: 0, material: 0, ..FaceTag::PLAIN };
    let profile = [[0.6, 2.2], [1.5, 2.8], [2.0, 4.0], [1.7, 5.6], [0.9, 6.6], [0.2, 7.0]];
    let rings = profile.map(|[radius, y]| circle(&mut builder, 12, radius, y));
    rings.windows(2).for_each(|pair| wall(&mut builder, &pair[0], &pair[1], crown));
    builder.face(&reversed(&rings[0]), &[], crown).face(&rings[5], &[], crown);
    let trunk = FaceTag { group: 1, material: 1, ..FaceTag::PLAIN };
    meshes::block(&mut builder, [-0.25, 0.0, -0.25], [0.5, 3.5, 0.5], trunk);
    builder.build().expect("a tree")
}

/// The four sides of a pyramid.
fn pyramid() -> Mesh {
    let mut builder = MeshBuilder::new();
    let base = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]].map(|[x, z]| builder.point([x, 0.0, z]));
    let tip = builder.point([0.5, 1.0, 0.5]);
    (0..4).for_each(|at| _ = builder.polygon(&[base[at], base[(at + 1) % 4], tip]));
    builder.build().expect("a pyramid")
}

/// A flat ring that touches the sides of its square.
fn flat_ring() -> Mesh {
    let mut builder = MeshBuilder::new();
    let [inner, outer] = [0.38, 0.5].map(|radius| circle(&mut builder, 16, radius, 0.0));
    wall(&mut builder, &outer, &inner, FaceTag::PLAIN);
    builder.build().expect("a ring")
}

/// A ring with a square section.
fn ring() -> Mesh {
    let mut builder = MeshBuilder::new();
    let section = [[0.36, 0.0], [0.5, 0.0], [0.5, 1.0], [0.36, 1.0]];
    let rings = section.map(|[radius, y]| circle(&mut builder, 16, radius, y));
    for (ring, next) in rings.iter().zip(rings.iter().cycle().skip(1)) {
        wall(&mut builder, ring, next, FaceTag::PLAIN);
    }
    builder.build().expect("a ring")
}
