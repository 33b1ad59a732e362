//! The leaves of a model as a scene of triangles.

use std::ops::ControlFlow;
use std::sync::Arc;

use cga_picture::{Face, Paint, PaintId, Scene};
use glam::{DAffine3, DVec2, DVec3, Vec3};

use super::images::{Images, Maps};
use super::placeholder;
use crate::geometry::each::Each;
use crate::geometry::mesh::Mesh;
use crate::geometry::uv_map::{self, SetMap};
use crate::material::Material;
use crate::material::layer::SetMask;
use crate::output::flatten::{Flattener, unit};
use crate::output::model::Model;
use crate::output::number_text::share;
use crate::output::sink_table::SinkTable;
use crate::run::sink::{Cuboid, Flow, Leaf, Quad, Sink};

/// The scene of a model. The number of a face's leaf is its index in [`Model::leaves`].
pub(super) fn scene(model: &Model) -> Scene {
    let mut sink = SceneSink {
        scene: Scene::new(placeholder::bounds(model)),
        images: Images::new(model.assets().cloned()),
        table: SinkTable::new(),
        paints: Vec::new(),
        leaves: 0,
        flattener: Flattener::default(),
        corners: Vec::new(),
        normals: Vec::new(),
        places: Default::default(),
    };
    let _ = model.replay(&mut sink);
    sink.scene
}

/// Adds leaves to a scene.
#[derive(Debug)]
struct SceneSink {
    scene: Scene,
    images: Images,
    table: SinkTable,
    /// The paints of the table's materials, with their images.
    paints: Vec<(PaintId, Maps)>,
    /// The number of leaves so far.
    leaves: u32,
    flattener: Flattener,
    // Memory that is used again.
    corners: Vec<DVec3>,
    normals: Vec<DVec3>,
    places: [Vec<DVec2>; 3],
}

impl SceneSink {
    /// Begins a leaf, and returns the number of its material.
    fn leaf(&mut self, leaf: &Leaf<'_>) -> u32 {
        self.leaves += 1;
        self.table.material(leaf.material)
    }

    /// The paint of a material, and its images.
    fn paint(&mut self, material: u32) -> (PaintId, Maps) {
        // Materials are numbered in the order of their first use, and so are paints.
        for known in self.paints.len()..self.table.materials().len() {
            let material = &self.table.materials()[known];
            let maps = self.images.maps(material, &mut self.scene);
            self.paints.push((self.scene.add_paint(paint(material, &maps)), maps));
        }
        self.paints[material as usize]
    }

    /// Adds a face of the leaf with the images `maps`. `uv` returns the coordinates of a corner in one of the sets `sets`.
    fn add(&mut self, face: Face<'_>, maps: &Maps, sets: SetMask, uv: impl Fn(usize, usize) -> DVec2) {
        let count = face.corners.len();
        let [color, opacity, normal] = &mut self.places;
        self.scene.add_face(&Face {
            leaf: self.leaves - 1,
            color_uvs: maps.color.and_then(|map| map.places(sets, count, &uv, color)),
            opacity_uvs: maps.opacity.and_then(|(map, _)| map.places(sets, count, &uv, opacity)),
            normal_uvs: maps.normal.and_then(|map| map.places(sets, count, &uv, normal)),
            ..face
        });
    }

    /// Adds a rectangle, or a face of a box by its number.
    fn rectangle(&mut self, quad: &Quad, face: usize, (paint, maps): (PaintId, Maps), uvs: &[SetMap]) {
        let (corners, normal) = (quad.corners(), unit(quad.u.cross(quad.v)));
        let sets = SetMask::of(|set| uv_map::find(uvs, set).is_some());
        let uv = |set, corner: usize| {
            uv_map::find(uvs, set).map_or(DVec2::ZERO, |maps| maps.of_face(face).at(corners[corner]))
        };
        self.add(Face::new(&corners, &[[0, 1, 2], [0, 2, 3]], normal, paint), &maps, sets, uv);
    }
}

fn paint(material: &Material, maps: &Maps) -> Paint {
    let color = material.color();
    Paint {
        color: Vec3::from_array([color.r, color.g, color.b].each(|c| cga_picture::linear(c) as f32)),
        opacity: share(material.opacity, 1.0) as f32,
        metallic: share(material.metallic, 0.0) as f32,
        gloss: 1.0 - share(material.roughness, 1.0) as f32,
        color_image: maps.color.map(|map| map.image),
        opacity_image: maps.opacity.map(|(map, alpha)| (map.image, alpha)),
        normal_image: maps.normal.map(|map| map.image),
    }
}

impl Sink for SceneSink {
    fn placement(&mut self, _: &Leaf<'_>) -> Flow {
        // It has a number and no triangles.
        self.leaves += 1;
        ControlFlow::Continue(())
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        let material = self.leaf(leaf);
        let paint = self.paint(material);
        self.rectangle(quad, 0, paint, leaf.uvs());
        ControlFlow::Continue(())
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        let material = self.leaf(leaf);
        let paint = self.paint(material);
        cuboid.faces().iter().enumerate().for_each(|(at, face)| self.rectangle(face, at, paint, leaf.uvs()));
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let material = self.leaf(leaf);
        if let Some(cuboid) = placeholder::placeholder(mesh, &leaf.scope()) {
            let shown = self.table.material(&placeholder::material());
            let paint = self.paint(shown);
            cuboid.faces().iter().for_each(|face| self.rectangle(face, 0, paint, &[]));
        }
        let mut flattener = std::mem::take(&mut self.flattener);
        let (mut corners, mut normals) = (std::mem::take(&mut self.corners), std::mem::take(&mut self.normals));
        let sets = SetMask::of(|set| !mesh.uv_set(set).is_empty());
        flattener.faces(mesh, placement, |face| {
            let shown = face.material(&mut self.table, material);
            let (paint, maps) = self.paint(shown);
            corners.clear();
            corners.extend(face.corners.clone().map(|corner| face.point(corner)));
            normals.clear();
            if !mesh.normals().is_empty() {
                normals.extend(face.corners.clone().map(|corner| face.normal_at(corner)));
            }
            let flat = Face {
                round: true,
                normals: (!normals.is_empty()).then_some(&*normals),
                ..Face::new(&corners, face.triangles, face.normal, paint)
            };
            self.add(flat, &maps, sets, |set, corner: usize| face.uvs(set)[corner]);
            true
        });
        (self.flattener, self.corners, self.normals) = (flattener, corners, normals);
        ControlFlow::Continue(())
    }
}
