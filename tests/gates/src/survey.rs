//! The parts of a model and their triangles.

use std::collections::HashMap;

use cga::glam::{DAffine3, DVec3};
use cga::mesh::Bounds;
use cga::{Geometry, LeafView, Mesh, Model};
use cga_geometry::triangulate::Triangulator;

/// A leaf of a model.
#[derive(Clone, Debug)]
pub struct Part {
    pub rule: String,
    /// The rules from the start rule to the leaf.
    pub trail: String,
    /// The number of its building.
    pub building: u32,
    /// True if its geometry is closed. Viewers draw the outside alone.
    pub closed: bool,
    /// True if light passes through it.
    pub clear: bool,
    /// The number of its material.
    pub material: u32,
    /// The enclosed volume in cubic metres, 0 if it is open.
    pub volume: f64,
    /// The middle of its bounds.
    pub middle: DVec3,
}

/// A triangle of a part.
#[derive(Clone, Copy, Debug)]
pub struct Triangle {
    pub corners: [DVec3; 3],
    pub normal: DVec3,
    pub part: u32,
}

/// The parts of a model and their triangles.
#[derive(Clone, Debug)]
pub struct Survey {
    pub parts: Vec<Part>,
    pub triangles: Vec<Triangle>,
    pub bounds: Bounds,
}

impl Survey {
    /// The survey of a model that keeps its trees of shapes. A building is an initial shape, or each shape of one of the rules
    /// `units` inside of it.
    pub fn of(model: &Model, units: &[&str]) -> Self {
        let mut survey = Survey { parts: Vec::new(), triangles: Vec::new(), bounds: model.bounds() };
        let mut triangulator = Triangulator::default();
        let starts: Vec<usize> = model.buildings().map(|(_, leaves)| leaves.start).collect();
        let mut buildings: HashMap<(usize, usize), u32> = HashMap::new();
        for (number, leaf) in model.leaves().enumerate() {
            let first = starts.partition_point(|start| *start <= number);
            let (trail, unit) = trail(&leaf, units);
            let next = buildings.len() as u32;
            let building = *buildings.entry((first, unit)).or_insert(next);
            survey.add(&leaf, building, trail, &mut triangulator);
        }
        survey
    }

    fn add(&mut self, leaf: &LeafView<'_>, building: u32, trail: String, triangulator: &mut Triangulator) {
        let part = self.parts.len() as u32;
        let bounds = leaf.bounds();
        let material = leaf.material();
        let mut added = Part {
            rule: leaf.rule().to_owned(),
            trail,
            building,
            closed: false,
            clear: material.opacity.is_some_and(|opacity| opacity < 1.0),
            material: leaf.material_index() as u32,
            volume: 0.0,
            middle: (bounds.low + bounds.high) * 0.5,
        };
        match leaf.geometry() {
            Geometry::Placement => {}
            Geometry::Quad(quad) => self.quad(quad.corners(), part),
            Geometry::Cuboid(cuboid) => {
                added.closed = true;
                cuboid.faces().iter().for_each(|face| self.quad(face.corners(), part));
            }
            Geometry::Mesh { mesh, placement } | Geometry::Instance { mesh, placement } => {
                added.closed = mesh.is_closed();
                self.mesh(mesh, placement, part, triangulator);
            }
        }
        if added.closed {
            added.volume = leaf.volume();
        }
        self.parts.push(added);
    }

    fn quad(&mut self, [a, b, c, d]: [DVec3; 4], part: u32) {
        self.triangle([a, b, c], part);
        self.triangle([a, c, d], part);
    }

    fn mesh(&mut self, mesh: &Mesh, placement: &DAffine3, part: u32, triangulator: &mut Triangulator) {
        let mut triangles = Vec::new();
        (0..mesh.face_count()).for_each(|face| triangulator.face(mesh, face, &mut triangles));
        for corners in triangles {
            let [a, b, c] = corners
                .map(|corner| placement.transform_point3(mesh.points()[mesh.corners()[corner as usize] as usize]));
            self.triangle([a, b, c], part);
        }
    }

    fn triangle(&mut self, corners: [DVec3; 3], part: u32) {
        let [a, b, c] = corners;
        if let Some(normal) = (b - a).cross(c - a).try_normalize() {
            self.triangles.push(Triangle { corners, normal, part });
        }
    }

    pub fn part(&self, triangle: u32) -> &Part {
        &self.parts[self.triangles[triangle as usize].part as usize]
    }
}

/// The rules from the start rule to a leaf, and the index of the shape that is its building; 0 without one.
fn trail(leaf: &LeafView<'_>, units: &[&str]) -> (String, usize) {
    let (mut rules, mut unit) = (vec![leaf.rule()], 0);
    let mut shape = leaf.node();
    while let Some(node) = shape {
        if units.contains(&node.rule()) {
            unit = node.index() + 1;
        }
        if rules.last() != Some(&node.rule()) {
            rules.push(node.rule());
        }
        shape = node.parent();
    }
    rules.reverse();
    (rules.join(" > "), unit)
}
