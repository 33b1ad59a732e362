//! Meshes, bars and dots in a model.

use std::collections::BTreeMap;
use std::sync::Arc;

use cga::glam::{DAffine3, DMat3, DVec3};
use cga::mesh::{FaceRef, FaceTag};
use cga::{Color, Cuboid, Leaf, Material, Mesh, MeshBuilder, Model, Scope, Sink, Text};

pub(crate) type Paint = [f64; 3];

pub(crate) const STONE: Paint = [0.80, 0.77, 0.70];
pub(crate) const INK: Paint = [0.08, 0.08, 0.1];
pub(crate) const RED: Paint = [0.85, 0.10, 0.08];
pub(crate) const BLUE: Paint = [0.08, 0.25, 0.80];
pub(crate) const ORANGE: Paint = [0.95, 0.50, 0.05];
pub(crate) const GREEN: Paint = [0.10, 0.55, 0.20];

/// A colour for each number, neighbours apart.
pub(crate) fn hue(number: usize) -> Paint {
    const ALL: [Paint; 8] = [
        [0.52, 0.68, 0.85],
        [0.93, 0.74, 0.45],
        [0.60, 0.78, 0.56],
        [0.88, 0.58, 0.56],
        [0.72, 0.63, 0.83],
        [0.90, 0.86, 0.50],
        [0.55, 0.80, 0.80],
        [0.85, 0.66, 0.78],
    ];
    ALL[number % ALL.len()]
}

/// The corners of a loop in space.
pub(crate) fn places(mesh: &Mesh, ring: &[u32]) -> Vec<DVec3> {
    ring.iter().map(|&corner| mesh.points()[corner as usize]).collect()
}

/// All loops of a mesh.
pub(crate) fn rings(mesh: &Mesh) -> Vec<Vec<DVec3>> {
    let of_face = |face: FaceRef<'_>| face.loops().map(|ring| places(mesh, ring)).collect::<Vec<_>>();
    mesh.faces().flat_map(of_face).collect()
}

/// The edges of a loop.
pub(crate) fn edges(ring: &[DVec3]) -> impl Iterator<Item = (DVec3, DVec3)> + '_ {
    ring.iter().copied().zip(ring.iter().copied().cycle().skip(1))
}

/// Draws into a model.
#[derive(Default)]
pub(crate) struct Pen {
    pub(crate) model: Model,
}

impl Pen {
    /// A mesh, moved.
    pub(crate) fn mesh(&mut self, mesh: &Arc<Mesh>, paint: Paint, by: DVec3) {
        let place = DAffine3::from_translation(by);
        let scope = Scope { origin: by, axes: DMat3::IDENTITY, size: mesh.bounds().size() };
        let _ = self.model.mesh(&Leaf::new(&Text::fixed("Mesh"), &material(paint), &scope), mesh, &place);
    }

    /// Some faces of a mesh, moved.
    pub(crate) fn faces<'m>(
        &mut self,
        faces: impl IntoIterator<Item = FaceRef<'m>>,
        mesh: &Mesh,
        paint: Paint,
        by: DVec3,
    ) {
        let mut builder = MeshBuilder::new();
        let mut numbers = BTreeMap::new();
        let mut count = 0;
        for face in faces {
            let mut number = |corner: &u32| {
                *numbers.entry(*corner).or_insert_with(|| builder.point(mesh.points()[*corner as usize]))
            };
            let rings: Vec<Vec<u32>> = face.loops().map(|ring| ring.iter().map(&mut number).collect()).collect();
            let holes: Vec<&[u32]> = rings[1..].iter().map(Vec::as_slice).collect();
            builder.face(&rings[0], &holes, FaceTag::PLAIN);
            count += 1;
        }
        if 0 < count {
            self.mesh(&Arc::new(builder.build().expect("faces of a mesh")), paint, by);
        }
    }

    /// A bar from point to point.
    pub(crate) fn bar(&mut self, from: DVec3, to: DVec3, width: f64, paint: Paint) {
        let along = to - from;
        let Some(x) = along.try_normalize() else { return };
        let (y, z) = x.any_orthonormal_pair();
        let axes = DMat3::from_cols(along + x * width, y * width, z * width);
        self.cuboid(from - (x + y + z) * (0.5 * width), axes, paint);
    }

    /// A bar with an arrow head in its middle.
    pub(crate) fn arrow(&mut self, from: DVec3, to: DVec3, width: f64, paint: Paint) {
        self.bar(from, to, width, paint);
        let along = (to - from).normalize_or_zero();
        let mut builder = MeshBuilder::new();
        let middle = from.midpoint(to);
        let (y, z) = along.any_orthonormal_pair();
        let ring = [y + z, z - y, -y - z, y - z].map(|side| builder.point(middle + (side * 1.5 - along * 3.0) * width));
        let tip = builder.point(middle + along * (3.0 * width));
        (0..4).for_each(|at| {
            builder.face(&[ring[at], ring[(at + 1) % 4], tip], &[], FaceTag::PLAIN);
        });
        builder.polygon(&[ring[3], ring[2], ring[1], ring[0]]);
        self.mesh(&Arc::new(builder.build().expect("an arrow head")), paint, DVec3::ZERO);
    }

    /// The edges of a loop as bars.
    pub(crate) fn ring(&mut self, ring: &[DVec3], width: f64, paint: Paint, by: DVec3) {
        edges(ring).for_each(|(from, to)| self.bar(from + by, to + by, width, paint));
    }

    /// A cube around a point.
    pub(crate) fn dot(&mut self, at: DVec3, width: f64, paint: Paint) {
        self.cuboid(at - DVec3::splat(0.5 * width), DMat3::from_diagonal(DVec3::splat(width)), paint);
    }

    fn cuboid(&mut self, origin: DVec3, edges: DMat3, paint: Paint) {
        let scope = Scope { origin, axes: DMat3::IDENTITY, size: DVec3::ONE };
        let _ =
            self.model.cuboid(&Leaf::new(&Text::fixed("Mark"), &material(paint), &scope), &Cuboid::new(origin, edges));
    }
}

fn material([r, g, b]: Paint) -> Arc<Material> {
    let mut material = Material::default();
    material.color = Some(Color::new(r, g, b));
    Arc::new(material)
}
