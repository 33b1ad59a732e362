//! The leaves of a model as triangles with colours, ready to be drawn.

use std::collections::HashMap;
use std::ops::ControlFlow;
use std::sync::Arc;

use glam::{DAffine3, DVec2, DVec3, Vec3};

use super::placeholder;
use super::texel::{Maps, PLAIN, Textures};
use crate::asset::Assets;
use crate::geometry::each::Each;
use crate::geometry::mesh::{Bounds, Mesh};
use crate::geometry::uv_map::{self, SetMap};
use crate::material::Material;
use crate::material::layer::SetMask;
use crate::output::flatten::{Flattener, unit};
use crate::output::number::{linear, share};
use crate::output::sink_table::SinkTable;
use crate::run::sink::{Cuboid, Flow, Leaf, Quad, Sink};

/// A triangle, its coordinates relative to [`Scene::centre`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle {
    corners: [Vec3; 3],
    normal: Vec3,
    /// The index in [`Scene::paints`].
    pub(super) paint: u32,
    /// The plane, equal for all triangles in one plane.
    pub(super) plane: u32,
    /// The number of its leaf, from 1.
    pub(super) leaf: u32,
    /// The index in the scene's smooth normals; [`FLAT`] for flat triangles.
    smooth: u32,
    /// The index of the corners' places in images; [`PLAIN`] without texture coordinates.
    pub(super) uvs: u32,
}

const FLAT: u32 = u32::MAX;

/// The numbers of a material; colours are linear light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Paint {
    pub(super) color: Vec3,
    pub(super) opacity: f32,
    pub(super) metallic: f32,
    pub(super) gloss: f32,
    pub(super) maps: Maps,
}

#[derive(Debug, Default)]
pub(super) struct Scene {
    pub(super) centre: DVec3,
    pub(super) triangles: Vec<Triangle>,
    pub(super) paints: Vec<Paint>,
    pub(super) textures: Textures,
    /// True if facets may represent round surfaces.
    pub(super) round: bool,
    smooth: Vec<[Vec3; 3]>,
    table: SinkTable,
    /// Only for look-ups, never iterated.
    planes: HashMap<[i64; 4], u32>,
    /// Coordinates closer than this belong to one plane.
    grain: f64,
    leaves: u32,
    flattener: Flattener,
}

impl Triangle {
    pub(super) fn corners(&self) -> [DVec3; 3] {
        self.corners.each(|corner| corner.as_dvec3())
    }

    pub(super) fn normal(&self) -> DVec3 {
        self.normal.as_dvec3()
    }
}

impl Scene {
    pub(super) fn new(bounds: &Bounds, assets: Option<Arc<Assets>>) -> Scene {
        let finite = bounds.low.is_finite() && bounds.high.is_finite();
        Scene {
            centre: if finite { (bounds.low + bounds.high) * 0.5 } else { DVec3::ZERO },
            textures: Textures::new(assets),
            grain: if finite { (bounds.size().length() * 1e-5).max(1e-9) } else { 1e-3 },
            ..Scene::default()
        }
    }

    /// The normal at a point of a triangle, in the scene's coordinates. Smooth normals are interpolated.
    pub(super) fn normal_at(&self, triangle: &Triangle, point: DVec3) -> DVec3 {
        if triangle.smooth == FLAT {
            return triangle.normal();
        }
        let [a, b, c] = triangle.corners();
        let n = triangle.normal();
        let area = (b - a).cross(c - a).dot(n);
        let u = (c - b).cross(point - b).dot(n) / area;
        let v = (a - c).cross(point - c).dot(n) / area;
        let [na, nb, nc] = self.smooth[triangle.smooth as usize].each(|normal| normal.as_dvec3());
        (na * u + nb * v + nc * (1.0 - u - v)).normalize_or(n)
    }

    fn paint(&mut self, id: u32) -> u32 {
        // Materials are numbered in the order of their first use, and so are paints.
        for known in self.paints.len()..self.table.materials().len() {
            let material = &self.table.materials()[known];
            self.paints.push(paint(material, self.textures.maps(material)));
        }
        id
    }

    fn plane(&mut self, point: DVec3, normal: DVec3) -> u32 {
        let key = normal * 512.0;
        let at = point.dot(normal) / self.grain;
        let key = [key.x, key.y, key.z, at].each(|c| libm::floor(c + 0.5) as i64);
        let next = self.planes.len() as u32;
        *self.planes.entry(key).or_insert(next)
    }

    /// Adds the triangles of a flat face. `uv` returns the coordinates of a corner in one of the sets `sets`. Returns
    /// false if some triangles were not finite; then the others have no texture coordinates.
    fn face(
        &mut self,
        corners: &[DVec3],
        triangles: &[[u32; 3]],
        normal: DVec3,
        paint: u32,
        sets: SetMask,
        uv: impl Fn(usize, usize) -> DVec2,
    ) -> bool {
        let (Some(&point), first) = (corners.first(), self.triangles.len()) else { return true };
        let (plane, normal, leaf) = (self.plane(point, normal), normal.as_vec3(), self.leaves);
        for triangle in triangles {
            let corners = triangle.each(|i| corners[i as usize].as_vec3());
            // Coordinates that are not finite cannot be drawn.
            if corners.iter().all(|corner| corner.is_finite()) {
                self.triangles.push(Triangle { corners, normal, paint, plane, leaf, smooth: FLAT, uvs: PLAIN });
            }
        }
        let added = &mut self.triangles[first..];
        let (maps, is_whole) = (self.paints[paint as usize].maps, added.len() == triangles.len());
        if is_whole && maps != Maps::default() && sets != SetMask::default() {
            for (triangle, corners) in added.iter_mut().zip(triangles) {
                triangle.uvs = self.textures.add(&maps, sets, corners.each(|i| i as usize), &uv);
            }
        }
        is_whole
    }

    fn rectangle(&mut self, quad: &Quad, paint: u32, uvs: &[SetMap]) {
        let (points, normal) = (quad.corners(), unit(quad.u.cross(quad.v)));
        let corners = points.each(|corner| corner - self.centre);
        let sets = SetMask::of(|set| uv_map::find(uvs, set).is_some());
        let uv = |set, corner: usize| uv_map::find(uvs, set).map_or(DVec2::ZERO, |map| map.at(points[corner]));
        self.face(&corners, &[[0, 1, 2], [0, 2, 3]], normal, paint, sets, uv);
    }

    fn leaf(&mut self, leaf: &Leaf<'_>) -> u32 {
        self.leaves += 1;
        let id = self.table.material(leaf.material);
        self.paint(id)
    }
}

fn paint(material: &Material, maps: Maps) -> Paint {
    let color = material.color();
    Paint {
        color: Vec3::from_array([color.r, color.g, color.b].each(|c| linear(c) as f32)),
        opacity: share(material.opacity, 1.0) as f32,
        metallic: share(material.metallic, 0.0) as f32,
        gloss: 1.0 - share(material.roughness, 1.0) as f32,
        maps,
    }
}

impl Sink for Scene {
    fn placement(&mut self, _: &Leaf<'_>) -> Flow {
        // It has a number and no triangles.
        self.leaves += 1;
        ControlFlow::Continue(())
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        let paint = self.leaf(leaf);
        self.rectangle(quad, paint, leaf.uvs());
        ControlFlow::Continue(())
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        let paint = self.leaf(leaf);
        cuboid.faces().iter().for_each(|face| self.rectangle(face, paint, leaf.uvs()));
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let material = self.leaf(leaf);
        if let Some(cuboid) = placeholder::placeholder(mesh, &leaf.scope()) {
            let id = self.table.material(&placeholder::material());
            let paint = self.paint(id);
            cuboid.faces().iter().for_each(|face| self.rectangle(face, paint, &[]));
        }
        self.round = true;
        let mut flattener = std::mem::take(&mut self.flattener);
        let mut corners = Vec::new();
        let sets = SetMask::of(|set| !mesh.uv_set(set).is_empty());
        flattener.faces(mesh, placement, |face| {
            let shown = face.material(&mut self.table, material);
            let paint = self.paint(shown);
            corners.clear();
            corners.extend(face.corners.clone().map(|corner| face.point(corner) - self.centre));
            let uv = |set, corner: usize| face.uvs(set)[corner];
            let is_whole = self.face(&corners, face.triangles, face.normal, paint, sets, uv);
            if is_whole && !mesh.normals().is_empty() {
                let first = self.triangles.len() - face.triangles.len();
                for (triangle, corners) in self.triangles[first..].iter_mut().zip(face.triangles) {
                    triangle.smooth = self.smooth.len() as u32;
                    let normal = |i| face.normal_at(face.corners.start + i as usize).as_vec3();
                    self.smooth.push(corners.each(normal));
                }
            }
            true
        });
        self.flattener = flattener;
        ControlFlow::Continue(())
    }
}
