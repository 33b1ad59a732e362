//! GLB 2.0: one binary file with geometry, materials and rule names.
//!
//! Triangles are grouped into one primitive a material. Each vertex carries the number of its rule (`_FEATURE_ID_0`,
//! `EXT_mesh_features`), and a property table (`EXT_structural_metadata`) has the names. Assets inserted more than once
//! are stored once and placed by nodes. Colours are turned from sRGB to linear light; materials are double sided, as
//! CGA's are; textures are referenced by relative address. The same leaves give the same bytes.

mod buffers;
mod json;
mod look;
mod pack;
mod primitive;

use std::collections::HashMap;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use self::look::Looks;
use self::primitive::{INDEX_BYTES, Primitive, VERTEX_BYTES};
use super::error::WriteError;
use super::flatten::Flattener;
use super::table::Table;
use super::{Cuboid, Flow, Leaf, Quad, Sink};
use crate::mesh::{Bounds, Mesh};
use crate::model::Model;
use crate::parallel::Parts;

/// Collects leaves for a GLB file.
#[derive(Debug, Default)]
pub struct Glb {
    origin: DVec3,
    table: Table,
    looks: Looks,
    primitives: Vec<Primitive>,
    /// Primitives by look and whether they have texture coordinates. Only ever asked, never walked.
    by_look: HashMap<(u32, bool), usize>,
    instances: Vec<Instances>,
    by_asset: HashMap<(usize, u32, u32), usize>,
    flattener: Flattener,
    bytes: u64,
}

/// One asset with one rule and one material, at one or more places.
#[derive(Debug)]
struct Instances {
    mesh: Arc<Mesh>,
    rule: u32,
    material: u32,
    placements: Vec<DAffine3>,
}

/// What the 32-bit lengths of the format allow, less room for the description.
const MAX_BYTES: u64 = u32::MAX as u64 - (1 << 24);

impl Glb {
    /// Without leaves.
    pub fn new() -> Self {
        Glb::default()
    }

    /// Stores positions relative to a point of the world, in metres; a node moves them back. Far from the world's
    /// origin 32-bit floats alone are not fine enough.
    pub fn with_origin(mut self, origin: DVec3) -> Self {
        self.origin = origin;
        self
    }

    /// The file.
    ///
    /// # Errors
    /// [`WriteError::TooLarge`] for more than 4 GiB, [`WriteError::NotFinite`] for coordinates that are no `f32`.
    pub fn finish(mut self) -> Result<Vec<u8>, WriteError> {
        let mut shared = self.place_instances();
        // A face can be too thin for a triangle, and the format knows no empty lists.
        self.primitives.retain(|primitive| !primitive.indices.is_empty());
        shared.iter_mut().for_each(|asset| asset.primitives.retain(|primitive| !primitive.indices.is_empty()));
        shared.retain(|asset| !asset.primitives.is_empty());
        if MAX_BYTES < self.bytes {
            return Err(WriteError::TooLarge { what: "bytes", limit: u64::from(u32::MAX) });
        }
        pack::pack(&self, &shared)
    }

    fn add(&mut self, vertices: usize, indices: usize) -> Flow {
        self.bytes += vertices as u64 * VERTEX_BYTES + indices as u64 * INDEX_BYTES;
        if MAX_BYTES < self.bytes { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn primitive(&mut self, material: u32, has_uvs: bool) -> &mut Primitive {
        let look = self.looks.of(material, &self.table.materials()[material as usize], has_uvs);
        let primitives = &mut self.primitives;
        let index = *self.by_look.entry((look, has_uvs)).or_insert_with(|| {
            primitives.push(Primitive::new(look));
            primitives.len() - 1
        });
        &mut self.primitives[index]
    }

    fn add_mesh(&mut self, rule: u32, material: u32, mesh: &Mesh, placement: &DAffine3) {
        let origin = self.origin;
        let mut flattener = std::mem::take(&mut self.flattener);
        flattener.faces(mesh, placement, |face| {
            let shown = self.table.face_material(material, &mesh.materials, mesh.tags[face.index].material);
            self.primitive(shown, !mesh.uvs().is_empty()).face(mesh, placement, &face, rule, origin);
            true
        });
        self.flattener = flattener;
    }

    /// Assets at several places become meshes of their own; the others join the rest.
    fn place_instances(&mut self) -> Vec<Shared> {
        let mut shared = Vec::new();
        for instances in std::mem::take(&mut self.instances) {
            let Instances { mesh, rule, material, placements } = instances;
            let (own, loose): (Vec<_>, Vec<_>) = placements.into_iter().partition(is_node_transform);
            if 2 <= own.len() {
                // Filled in the mesh's own coordinates, with a list of primitives of its own.
                let main = std::mem::take(&mut self.primitives);
                let by_look = std::mem::take(&mut self.by_look);
                let origin = std::mem::take(&mut self.origin);
                self.add_mesh(rule, material, &mesh, &DAffine3::IDENTITY);
                self.origin = origin;
                self.by_look = by_look;
                let primitives = std::mem::replace(&mut self.primitives, main);
                shared.push(Shared { primitives, placements: own });
            } else {
                own.iter().for_each(|placement| self.add_mesh(rule, material, &mesh, placement));
            }
            loose.iter().for_each(|placement| self.add_mesh(rule, material, &mesh, placement));
        }
        shared
    }
}

/// A glTF mesh that several nodes show.
struct Shared {
    primitives: Vec<Primitive>,
    placements: Vec<DAffine3>,
}

/// Whether a glTF node can express it: no shear, and no mirroring, which would turn the faces there.
fn is_node_transform(placement: &DAffine3) -> bool {
    let [x, y, z] = [placement.matrix3.x_axis, placement.matrix3.y_axis, placement.matrix3.z_axis];
    let right = |a: DVec3, b: DVec3| a.dot(b).abs() <= 1e-9 * a.length() * b.length();
    0.0 < placement.matrix3.determinant() && right(x, y) && right(y, z) && right(z, x)
}

impl Sink for Glb {
    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        let (rule, origin) = (self.table.rule(leaf.rule), self.origin);
        let material = self.table.material(leaf.material);
        self.primitive(material, false).quad(quad, rule, origin);
        self.add(4, 6)
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        let (rule, origin) = (self.table.rule(leaf.rule), self.origin);
        let material = self.table.material(leaf.material);
        self.primitive(material, false).cuboid(cuboid, rule, origin);
        self.add(24, 36)
    }

    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let (rule, material) = (self.table.rule(leaf.rule), self.table.material(leaf.material));
        let instances = &mut self.instances;
        // The address stays the mesh's own: the first one seen is kept in the list.
        let index = *self.by_asset.entry((Arc::as_ptr(mesh).addr(), rule, material)).or_insert_with(|| {
            instances.push(Instances { mesh: mesh.clone(), rule, material, placements: Vec::new() });
            instances.len() - 1
        });
        self.instances[index].placements.push(*placement);
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let (rule, material) = (self.table.rule(leaf.rule), self.table.material(leaf.material));
        self.add_mesh(rule, material, mesh, placement);
        self.add(mesh.corners.len(), 3 * mesh.corners.len())
    }
}

impl Model {
    /// The model as a GLB file; see [`Glb`]. A model far from the origin of the world is stored about its own middle.
    ///
    /// # Errors
    /// As [`Glb::finish`].
    pub fn to_glb(&self) -> Result<Vec<u8>, WriteError> {
        let mut glb = Glb::new().with_origin(near_origin(self.bounds()));
        // It stops when it is full; finishing tells.
        let _ = self.replay(&mut glb);
        glb.finish()
    }

    /// Writes the model as a GLB file; see [`Model::to_glb`].
    ///
    /// # Errors
    /// As [`Glb::finish`], and what the file system says.
    pub fn write_glb(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        Ok(std::fs::write(path, self.to_glb()?)?)
    }
}

impl Parts<Model> {
    /// All models as one GLB file, the same as that of one model with all leaves.
    ///
    /// # Errors
    /// As [`Glb::finish`].
    pub fn to_glb(&self) -> Result<Vec<u8>, WriteError> {
        let mut glb = Glb::new().with_origin(near_origin(self.bounds()));
        let _ = self.replay(&mut glb);
        glb.finish()
    }

    /// Writes all models as one GLB file.
    ///
    /// # Errors
    /// As [`Glb::finish`], and what the file system says.
    pub fn write_glb(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        Ok(std::fs::write(path, self.to_glb()?)?)
    }
}

/// The origin of the world, or a point in whole metres near geometry of those bounds if 32-bit floats about the former would
/// be off by more than a millimetre.
fn near_origin(bounds: Bounds) -> DVec3 {
    const FINE: f64 = 8192.0;
    let reach = bounds.low.abs().max(bounds.high.abs()).max_element();
    if !bounds.low.is_finite() || !bounds.high.is_finite() || reach <= FINE {
        return DVec3::ZERO;
    }
    let middle = (bounds.low + bounds.high) * 0.5;
    DVec3::new(middle.x, bounds.low.y, middle.z).round()
}
