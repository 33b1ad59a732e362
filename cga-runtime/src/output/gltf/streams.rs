//! The streams of a file: its data for each vertex and each triangle, as words.

use glam::Vec2;

use super::binary::FourBytes;
use super::primitive::Primitive;
use super::textures::NormalSpace;
use crate::output::tangents::tangents;
use crate::value::each::Each;

/// Appends numbers.
pub(super) fn write_floats(numbers: &[f32], to: &mut Vec<FourBytes>) {
    to.extend(numbers.iter().map(|number| number.to_le_bytes()));
}

impl Primitive {
    pub(super) fn write_indices(&self, to: &mut Vec<FourBytes>) {
        to.extend(self.indices().iter().map(|index| index.to_le_bytes()));
    }

    pub(super) fn write_positions(&self, to: &mut Vec<FourBytes>) {
        self.write_triples(0, to);
    }

    pub(super) fn write_normals(&self, to: &mut Vec<FourBytes>) {
        self.write_triples(3, to);
    }

    /// Appends three numbers of each vertex, beginning at `first`.
    fn write_triples(&self, first: usize, to: &mut Vec<FourBytes>) {
        let start = to.len();
        to.resize(start + 3 * self.vertices().len(), [0; 4]);
        let (places, _) = to[start..].as_chunks_mut::<3>();
        for (place, vertex) in places.iter_mut().zip(self.vertices()) {
            *place = [vertex[first], vertex[first + 1], vertex[first + 2]].each(f32::to_le_bytes);
        }
    }

    /// Writes the tangents of vertices for a normal map.
    pub(super) fn write_tangents(&self, space: &NormalSpace, to: &mut Vec<FourBytes>) {
        let Some(uvs) = self.uvs.get(space.list) else { return };
        let uv = |at: usize| {
            // The v axis of glTF points down.
            let uv = Vec2::new(uvs[at][0], 1.0 - uvs[at][1]);
            Vec2::new(space.rows[0].dot(uv), space.rows[1].dot(uv))
        };
        write_floats(tangents(self.vertices(), self.indices(), uv).as_flattened(), to);
    }

    /// Writes the rule number of each vertex.
    pub(super) fn write_rules(&self, to: &mut Vec<FourBytes>) {
        let ends = self.rules.iter().skip(1).map(|(_, vertex)| *vertex).chain([self.vertices().len()]);
        for ((rule, start), end) in self.rules.iter().zip(ends) {
            to.extend(std::iter::repeat_n((*rule as f32).to_le_bytes(), end - start));
        }
    }
}
