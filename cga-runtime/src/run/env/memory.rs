//! The vertices of meshes, and the bytes of shapes and meshes: [`Limits::bytes`](crate::run::settings::Limits::bytes).

use std::ops::ControlFlow;

use super::Env;
use super::mesh_counts::MeshCounts;
use crate::fault::LimitKind;
use crate::geometry::mesh::Mesh;
use crate::material::Material;
use crate::run::settings::Limits;
use crate::run::sink::Flow;

impl Env {
    /// Counts the vertices of a mesh that an operation made. As in sinks, a vertex counts once for each of its faces.
    pub(crate) fn count_vertices(&mut self, mesh: &Mesh) -> Flow {
        self.count_corners(mesh.corners().len() as u64)
    }

    /// Counts the vertices of a mesh before they are made.
    pub(crate) fn count_corners(&mut self, count: u64) -> Flow {
        self.spend(count as usize)?;
        self.meshes.vertices = self.meshes.vertices.saturating_add(count);
        if self.settings.limits.vertices < self.meshes.vertices {
            return self.limit(LimitKind::Vertices, self.settings.limits.vertices);
        }
        self.count_mesh()
    }

    /// Counts meshes that are made again, if they and `room` more shapes are within the limits.
    pub(crate) fn count_again(&mut self, meshes: MeshCounts, room: u64) -> bool {
        if meshes == MeshCounts::default() {
            return true;
        }
        let before = self.meshes;
        self.meshes.vertices = before.vertices.saturating_add(meshes.vertices);
        self.meshes.bytes = before.bytes.saturating_add(meshes.bytes);
        let most = self.most_shapes();
        let is_within =
            self.meshes.vertices <= self.settings.limits.vertices && self.shape_count().saturating_add(room) <= most;
        if !is_within {
            self.meshes = before;
            return false;
        }
        self.checkpoint.lower(most);
        true
    }

    /// Counts a mesh besides its vertices.
    fn count_mesh(&mut self) -> Flow {
        self.count_bytes(Limits::BYTES_A_MESH)
    }

    /// Counts a leaf that is a mesh, and the vertices that it has for its texture coordinates alone.
    pub(crate) fn count_leaf(&mut self, own_vertices: u64, sets: u64) -> Flow {
        let vertex = Limits::BYTES_A_VERTEX + Limits::BYTES_A_UV * sets.saturating_sub(1);
        self.count_bytes(Limits::BYTES_A_MESH.saturating_add(own_vertices.saturating_mul(vertex)))
    }

    /// Counts a look that an operation makes, with its texts.
    pub(crate) fn count_look(&mut self, material: &Material) -> Flow {
        if !self.counts_looks {
            return ControlFlow::Continue(());
        }
        self.count_bytes(Limits::BYTES_A_LOOK.saturating_add(material.text_bytes()))
    }

    /// Counts bytes of a mesh, a leaf, a look, a text or an array.
    pub(crate) fn count_bytes(&mut self, bytes: u64) -> Flow {
        self.meshes.bytes = self.meshes.bytes.saturating_add(bytes);
        let most = self.most_shapes();
        // A smaller checkpoint: shapes count for bytes, too.
        self.checkpoint.lower(most);
        if most < self.shape_count() { self.too_many_shapes() } else { ControlFlow::Continue(()) }
    }

    /// The largest number of shapes that both limits allow, with the meshes so far.
    pub(crate) fn most_shapes(&self) -> u64 {
        self.settings.limits.shapes_in(self.bytes_left())
    }

    /// The bytes that are left for shapes: all without meshes.
    fn bytes_left(&self) -> u64 {
        let corners = self.meshes.vertices.saturating_mul(Limits::BYTES_A_VERTEX);
        self.settings.limits.bytes.saturating_sub(corners).saturating_sub(self.meshes.bytes)
    }

    /// The number of corners that an operation may still make, if it holds that many copies of each while it lasts.
    pub(crate) fn corners_left(&self, copies: u64) -> usize {
        let [vertices, bytes] = self.corners_in_limits(copies);
        usize::try_from(vertices.min(bytes)).unwrap_or(usize::MAX)
    }

    /// Ends the run because an operation would make more than [`corners_left`](Env::corners_left).
    #[cold]
    pub(crate) fn too_many_corners<T>(&mut self, copies: u64) -> ControlFlow<(), T> {
        let [vertices, bytes] = self.corners_in_limits(copies);
        let limits = self.settings.limits;
        if bytes < vertices {
            self.limit(LimitKind::Bytes, limits.bytes)
        } else {
            self.limit(LimitKind::Vertices, limits.vertices)
        }
    }

    /// The corners that the limit of vertices and the limit of bytes leave.
    fn corners_in_limits(&self, copies: u64) -> [u64; 2] {
        let bytes = self.bytes_left().saturating_sub(self.shape_count().saturating_mul(Limits::BYTES_A_SHAPE));
        let vertices = self.settings.limits.vertices.saturating_sub(self.meshes.vertices);
        [vertices, bytes / (copies * Limits::BYTES_A_VERTEX)]
    }

    /// Ends the run because there are more than [`most_shapes`](Env::most_shapes).
    #[cold]
    pub(crate) fn too_many_shapes(&mut self) -> Flow {
        let limits = self.settings.limits;
        if self.most_shapes() < limits.shapes {
            self.limit(LimitKind::Bytes, limits.bytes)
        } else {
            self.limit(LimitKind::Shapes, limits.shapes)
        }
    }
}
