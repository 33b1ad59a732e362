//! The streams of a file: its data for each vertex and each triangle, as words.

use std::io;

use glam::Vec2;

use super::primitive::{Owner, Primitive};
use super::textures::NormalSpace;
use super::words::Words;
use crate::output::tangents::tangents;

impl Primitive {
    pub(super) fn write_indices(&self, to: &mut Words<'_>) -> io::Result<()> {
        self.faces.indices(to)
    }

    pub(super) fn write_positions(&self, to: &mut Words<'_>) -> io::Result<()> {
        self.faces.positions(to)
    }

    pub(super) fn write_normals(&self, to: &mut Words<'_>) -> io::Result<()> {
        self.faces.normals(to)
    }

    /// Writes the tangents of vertices for a normal map.
    pub(super) fn write_tangents(&self, space: &NormalSpace, to: &mut Words<'_>) -> io::Result<()> {
        let Some(uvs) = self.uvs.get(space.list) else { return Ok(()) };
        let uv = |at: usize| {
            // The v axis of glTF points down.
            let uv = Vec2::new(uvs[at][0], 1.0 - uvs[at][1]);
            Vec2::new(space.rows[0].dot(uv), space.rows[1].dot(uv))
        };
        let triangles = self.faces.triangles();
        to.floats(tangents(triangles.vertices.items(), triangles.indices.items(), uv).as_flattened())
    }

    /// Writes the number of the rule of each vertex.
    pub(super) fn write_rules(&self, to: &mut Words<'_>) -> io::Result<()> {
        self.write_owners(|owner| owner.rule, to)
    }

    /// Writes the number of the building of each vertex.
    pub(super) fn write_buildings(&self, to: &mut Words<'_>) -> io::Result<()> {
        self.write_owners(|owner| owner.building, to)
    }

    fn write_owners(&self, number: impl Fn(Owner) -> u32, to: &mut Words<'_>) -> io::Result<()> {
        for (owner, vertices) in self.owned() {
            to.repeat((number(owner) as f32).to_le_bytes(), vertices.len())?;
        }
        Ok(())
    }
}
