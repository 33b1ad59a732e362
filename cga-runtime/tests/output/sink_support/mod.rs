//! Models for the tests of sinks.
#![allow(unreachable_pub)]

use std::sync::Arc;

use cga_runtime::geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use cga_runtime::material::{Color, Material};
use cga_runtime::output::model::Model;
use cga_runtime::run::sink::{Cuboid, Leaf, Quad, Sink};
use cga_runtime::shape::scope::Scope;
use cga_runtime::value::text::Text;
use glam::{DAffine3, DMat3, DVec3, dvec2, dvec3};

pub fn color(r: f64, g: f64, b: f64) -> Arc<Material> {
    Arc::new(Material::with(|look| look.color = Some(Color::new(r, g, b))))
}

/// The front of a scope.
pub fn front(origin: DVec3, width: f64, height: f64) -> Quad {
    Quad::new(origin, DVec3::X * width, DVec3::Y * height)
}

pub fn upright(origin: DVec3, size: DVec3) -> Cuboid {
    Cuboid::new(origin, DMat3::from_diagonal(size))
}

/// Shortens adding leaves.
pub struct Fill<S>(pub S);

impl<S: Sink> Fill<S> {
    pub fn quad(&mut self, rule: &'static str, material: &Arc<Material>, quad: Quad) {
        let scope = Scope { origin: quad.origin, ..Scope::new(dvec3(quad.u.length(), quad.v.length(), 0.0)) };
        assert!(self.0.quad(&Leaf::new(&Text::fixed(rule), material, &scope), &quad).is_continue());
    }

    pub fn cuboid(&mut self, rule: &'static str, material: &Arc<Material>, cuboid: Cuboid) {
        let sides = [cuboid.sides.x_axis, cuboid.sides.y_axis, cuboid.sides.z_axis].map(|side| side.length());
        let scope = Scope { origin: cuboid.origin, ..Scope::new(sides.into()) };
        assert!(self.0.cuboid(&Leaf::new(&Text::fixed(rule), material, &scope), &cuboid).is_continue());
    }

    pub fn mesh(&mut self, rule: &'static str, material: &Arc<Material>, mesh: &Arc<Mesh>, placement: DAffine3) {
        let scope = Scope::new(DVec3::ONE);
        assert!(self.0.mesh(&Leaf::new(&Text::fixed(rule), material, &scope), mesh, &placement).is_continue());
    }

    pub fn instance(&mut self, rule: &'static str, material: &Arc<Material>, mesh: &Arc<Mesh>, placement: DAffine3) {
        let scope = Scope::new(DVec3::ONE);
        assert!(self.0.instance(&Leaf::new(&Text::fixed(rule), material, &scope), mesh, &placement).is_continue());
    }
}

/// A closed plate of 4 by 3 by 1 with a hole of 2 by 1 through it: two faces with holes and eight quads. Volume 10.
pub fn plate() -> Arc<Mesh> {
    Arc::new(plate_builder().build().expect("the plate is well formed"))
}

fn plate_builder() -> MeshBuilder {
    let mut builder = MeshBuilder::new();
    let ring = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)];
    let hole = [(1.0, 1.0), (3.0, 1.0), (3.0, 2.0), (1.0, 2.0)];
    let mut points = |z: f64, ring: [(f64, f64); 4]| ring.map(|(x, y)| builder.point([x, y, z]));
    let (back, front) = (points(0.0, ring), points(1.0, ring));
    let (inner_back, inner_front) = (points(0.0, hole), points(1.0, hole));
    let turned = |ring: [u32; 4]| [ring[3], ring[2], ring[1], ring[0]];
    builder.face(&front, &[&turned(inner_front)], FaceTag { material: 0, ..FaceTag::PLAIN });
    builder.face(&turned(back), &[&inner_back], FaceTag { material: 0, ..FaceTag::PLAIN });
    for i in 0..4 {
        let j = (i + 1) % 4;
        builder.face(&[back[i], back[j], front[j], front[i]], &[], FaceTag { material: 1, ..FaceTag::PLAIN });
        builder.face(&[inner_back[j], inner_back[i], inner_front[i], inner_front[j]], &[], FaceTag::PLAIN);
    }
    let painted = |r, g, b| Material::with(|look| look.color = Some(Color::new(r, g, b)));
    builder.materials([painted(0.8, 0.3, 0.2), painted(0.2, 0.4, 0.7)]);
    builder
}

/// A triangle with texture coordinates and normals that lean.
pub fn textured() -> Arc<Mesh> {
    let mut builder = MeshBuilder::new();
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|p| builder.point(p));
    builder.face(&corners, &[], FaceTag { material: 0, ..FaceTag::PLAIN });
    builder.uvs(&[dvec2(0.0, 0.0), dvec2(1.0, 0.0), dvec2(0.0, 0.25)]);
    builder.normals(&[dvec3(0.6, 0.0, 0.8), DVec3::Z, DVec3::Z]);
    builder.materials([Material::with(|look| look.texture = Some("maps/brick wall.png".into()))]);
    Arc::new(builder.build().expect("the triangle is well formed"))
}

/// Thousands of leaves in a few colours: walls, frames, glass.
pub fn tower(floors: usize) -> Model {
    let (wall, frame) = (color(0.86, 0.8, 0.7), color(0.95, 0.94, 0.92));
    let glass = Arc::new(Material::with(|look| {
        look.color = Some(Color::new(0.3, 0.45, 0.55));
        (look.opacity, look.roughness) = (Some(0.6), Some(0.1));
    }));
    let mut fill = Fill(Model::new());
    for floor in 0..floors {
        for bay in 0..8 {
            let at = dvec3(2.5 * bay as f64, 3.0 * floor as f64, 0.0);
            fill.quad("Wall", &wall, front(at, 2.5, 0.8));
            fill.quad("Wall", &wall, front(at + dvec3(0.0, 2.4, 0.0), 2.5, 0.6));
            fill.quad("Wall", &wall, front(at + dvec3(0.0, 0.8, 0.0), 0.6, 1.6));
            fill.quad("Wall", &wall, front(at + dvec3(1.9, 0.8, 0.0), 0.6, 1.6));
            fill.quad("Glass", &glass, front(at + dvec3(0.6, 0.8, -0.15), 1.3, 1.6));
            fill.cuboid("Frame", &frame, upright(at + dvec3(0.6, 0.8, -0.15), dvec3(0.1, 1.6, 0.1)));
            fill.cuboid("Frame", &frame, upright(at + dvec3(1.8, 0.8, -0.15), dvec3(0.1, 1.6, 0.1)));
        }
    }
    fill.cuboid("Core", &wall, upright(dvec3(0.0, 0.0, -12.0), dvec3(20.0, 3.0 * floors as f64 + 1.0, 11.8)));
    fill.0
}

/// Some of each kind of leaf.
pub fn mixed() -> Model {
    let mut fill = Fill(Model::new());
    let plain = Arc::new(Material::UNSET);
    fill.quad("Lot", &color(0.4, 0.6, 0.3), Quad::new(dvec3(0.0, 0.0, 10.0), DVec3::X * 10.0, DVec3::Z * -10.0));
    fill.cuboid("Box", &color(0.9, 0.2, 0.1), upright(dvec3(1.0, 0.0, 1.0), dvec3(2.0, 3.0, 2.0)));
    fill.mesh("Plate", &plain, &plate(), DAffine3::from_translation(dvec3(5.0, 0.0, 5.0)));
    fill.mesh("Sign", &plain, &textured(), DAffine3::from_translation(dvec3(1.0, 3.0, 8.0)));
    let asset = plate();
    for i in 0..3 {
        let place = DAffine3::from_scale_rotation_translation(
            DVec3::splat(0.25),
            glam::DQuat::from_rotation_y(f64::from(i)),
            dvec3(2.0 + 2.0 * f64::from(i), 0.0, 9.0),
        );
        fill.instance("Bench", &color(0.5, 0.35, 0.2), &asset, place);
    }
    fill.0
}

/// Some of each kind of leaf except faces with holes, whose triangulation may change.
pub fn steady() -> Model {
    let mut fill = Fill(tower(2));
    let sign = textured();
    fill.mesh("Sign", &Arc::default(), &sign, DAffine3::from_translation(dvec3(1.0, 3.0, 2.0)));
    for i in 0..3 {
        let place = DAffine3::from_rotation_y(f64::from(i)) * DAffine3::from_scale(DVec3::splat(2.0));
        fill.instance("Flag", &color(0.7, 0.2, 0.2), &sign, place);
    }
    fill.0
}

/// FNV-1a: golden values in a few characters.
pub fn hash(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}
