//! The streams of a file: its data for each vertex and each triangle, as words.

use std::ops::Range;

use super::binary::Word;
use super::primitive::{Primitive, Stretch};

/// Appends numbers.
pub(super) fn write_floats(numbers: &[f32], to: &mut Vec<Word>) {
    to.extend(numbers.iter().map(|number| number.to_le_bytes()));
}

impl Primitive {
    /// The stretches, each with the ranges of its vertices and of the indices of meshes.
    fn walk(&self) -> impl Iterator<Item = (&Stretch, Range<usize>, Range<usize>)> {
        self.stretches.iter().enumerate().map(|(i, stretch)| {
            let (vertex, index) = match self.stretches.get(i + 1) {
                Some(next) => (next.vertex as usize, next.index as usize),
                None => (self.positions.len(), self.indices.len()),
            };
            (stretch, stretch.vertex as usize..vertex, stretch.index as usize..index)
        })
    }

    pub(super) fn write_indices(&self, to: &mut Vec<Word>) {
        for (stretch, vertices, indices) in self.walk() {
            if stretch.is_quads {
                for first in vertices.step_by(4) {
                    let quad = [0, 1, 2, 0, 2, 3].map(|corner| first as u32 + corner);
                    to.extend_from_slice(&quad.map(u32::to_le_bytes));
                }
            } else {
                to.extend(self.indices[indices].iter().map(|index| index.to_le_bytes()));
            }
        }
    }

    pub(super) fn write_positions(&self, to: &mut Vec<Word>) {
        write_floats(self.positions.items().as_flattened(), to);
    }

    pub(super) fn write_normals(&self, to: &mut Vec<Word>) {
        let (mut of_quads, mut of_meshes) = (self.quad_normals.items(), &self.normals[..]);
        for (stretch, vertices, _) in self.walk() {
            if stretch.is_quads {
                let (normals, rest) = of_quads.split_at(vertices.len() / 4);
                of_quads = rest;
                for normal in normals {
                    to.extend_from_slice([normal.map(f32::to_le_bytes); 4].as_flattened());
                }
            } else {
                let (normals, rest) = of_meshes.split_at(vertices.len());
                of_meshes = rest;
                write_floats(normals.as_flattened(), to);
            }
        }
    }

    /// Writes the rule number of each vertex.
    pub(super) fn write_rules(&self, to: &mut Vec<Word>) {
        for (stretch, vertices, _) in self.walk() {
            to.extend(std::iter::repeat_n((stretch.rule as f32).to_le_bytes(), vertices.len()));
        }
    }
}
