//! Small numbers: positions on a grid, normals in bytes (`KHR_mesh_quantization`), indices of 16 bits, and vertices without rules.

use std::io;

use glam::DVec3;

use super::Glb;
use super::primitive::Primitive;
use super::scene::{MeshPlacement, SceneMesh};
use super::words::{FourBytes, Words};
use crate::geometry::each::Each;
use crate::output::error::WriteError;
use crate::output::packed::Collect;

/// The extension for positions of 16 bits and normals of 8 bits.
pub(super) const QUANTIZATION: &str = "KHR_mesh_quantization";

/// The largest number of a position.
const MOST: f64 = 65_535.0;

/// The smallest step of a grid: 2⁻²⁰ metres.
const FINEST: f64 = 1.0 / 1_048_576.0;

/// The most vertices that indices of 16 bits can name. Some interfaces reserve the largest index.
const MOST_VERTICES: usize = 65_535;

impl Glb {
    /// Writes positions as 16-bit numbers on one grid for the whole file and normals as 8-bit numbers (`KHR_mesh_quantization`), and indices
    /// of 16 bits where they suffice. A vertex then has 12 bytes for both in place of 24. A reader must support the extension.
    ///
    /// Positions move by at most `most_error` metres along each axis. If the file is too large for that, its positions stay 32-bit floats. So do
    /// meshes in nodes of their own: repeated assets and parts, and all meshes of [`by_rule`](Glb::by_rule) and
    /// [`by_building`](Glb::by_building). The step of the grid is a power of two, and the grid contains the origin of the file.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::gltf::Glb;
    ///
    /// let glb = Glb::new().with_quantization(0.01);
    /// # let _ = glb;
    /// ```
    pub fn with_quantization(mut self, most_error: f64) -> Self {
        self.quantization = Some(most_error);
        self
    }

    /// Leaves out the number of the rule of each vertex, and the table with the names of the rules. Buildings keep their numbers.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::gltf::Glb;
    ///
    /// let glb = Glb::new().without_rules();
    /// # let _ = glb;
    /// ```
    pub fn without_rules(mut self) -> Self {
        self.has_no_rules = true;
        self
    }

    /// The grid of the positions in the root node, if they have one.
    pub(super) fn grid(&self, meshes: &[SceneMesh]) -> Result<Option<Grid>, WriteError> {
        let Some(most_error) = self.quantization else { return Ok(None) };
        let root = meshes.iter().filter(|mesh| matches!(mesh.places, MeshPlacement::Root));
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for primitive in root.flat_map(|mesh| &mesh.primitives) {
            let (own_low, own_high) = primitive.faces.bounds().ok_or(WriteError::NotFinite)?;
            (low, high) = (low.min(own_low.as_dvec3()), high.max(own_high.as_dvec3()));
        }
        Ok(if low.x <= high.x { Grid::around(low, high, most_error) } else { None })
    }
}

/// Returns true if indices of 16 bits name all vertices of each primitive.
pub(super) fn has_short_indices(primitives: &[&Primitive]) -> bool {
    primitives.iter().all(|primitive| primitive.faces.vertex_count() <= MOST_VERTICES)
}

/// A grid of positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Grid {
    /// The position with the numbers 0, at a multiple of the step.
    pub(super) low: DVec3,
    /// The metres from a number to the next one: a power of two.
    pub(super) step: f64,
}

impl Grid {
    /// The finest grid with two corners of a box. `None` if it moves positions by more than `most_error`.
    fn around(low: DVec3, high: DVec3, most_error: f64) -> Option<Self> {
        let extent = (high - low).max_element();
        let mut step = FINEST;
        // The lowest corner moves down by up to a step.
        while (MOST - 1.0) * step < extent {
            step *= 2.0;
        }
        (step / 2.0 <= most_error).then(|| Grid { low: (low / step).floor() * step + DVec3::ZERO, step })
    }

    /// The numbers of a position.
    pub(super) fn numbers(&self, position: [f32; 3]) -> [u16; 3] {
        let numbers = (DVec3::from_array(position.each(f64::from)) - self.low) / self.step;
        numbers.to_array().each(|number| number.round().clamp(0.0, MOST) as u16)
    }
}

/// A direction in three bytes, and a byte to fill the word.
fn bytes(normal: [f32; 3]) -> FourBytes {
    let [x, y, z] = normal.each(|part| ((part * 127.0).round() as i8).to_le_bytes()[0]);
    [x, y, z, 0]
}

/// Writes positions on a grid.
pub(super) struct GridPositions<'t, 'w> {
    pub(super) to: &'t mut Words<'w>,
    pub(super) grid: Grid,
}

impl Collect<[f32; 3]> for GridPositions<'_, '_> {
    type Error = io::Error;

    fn add<const N: usize>(&mut self, items: [[f32; 3]; N]) -> io::Result<()> {
        self.to.each(&items, |position| {
            let [x, y, z] = self.grid.numbers(*position).map(u16::to_le_bytes);
            [[x[0], x[1], y[0], y[1]], [z[0], z[1], 0, 0]]
        })
    }
}

/// Writes normals of three bytes.
pub(super) struct ByteNormals<'t, 'w>(pub(super) &'t mut Words<'w>);

impl Collect<[f32; 3]> for ByteNormals<'_, '_> {
    type Error = io::Error;

    fn add<const N: usize>(&mut self, items: [[f32; 3]; N]) -> io::Result<()> {
        self.0.each(&items, |normal| [bytes(*normal)])
    }
}

/// Writes indices of 16 bits, two a word.
struct ShortIndices<'t, 'w> {
    to: &'t mut Words<'w>,
    /// The first index of a word.
    first: Option<u16>,
}

impl ShortIndices<'_, '_> {
    fn word(&mut self, first: u16, second: u16) -> io::Result<()> {
        let ([a, b], [c, d]) = (first.to_le_bytes(), second.to_le_bytes());
        self.to.repeat([a, b, c, d], 1)
    }
}

impl Collect<u32> for ShortIndices<'_, '_> {
    type Error = io::Error;

    fn add<const N: usize>(&mut self, items: [u32; N]) -> io::Result<()> {
        items.into_iter().try_for_each(|index| match self.first.take() {
            Some(first) => self.word(first, index as u16),
            None => {
                self.first = Some(index as u16);
                Ok(())
            }
        })
    }
}

impl Primitive {
    /// Writes indices of 16 bits, up to a whole word.
    pub(super) fn write_short_indices(&self, to: &mut Words<'_>) -> io::Result<()> {
        let mut indices = ShortIndices { to, first: None };
        self.faces.indices(&mut indices)?;
        match indices.first.take() {
            Some(last) => indices.word(last, 0),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_are_as_fine_as_their_box_allows() {
        let low = DVec3::new(-10.25, 0.0, 4.0);
        for (extent, step) in
            [(0.0, FINEST), (511.5, 1.0 / 128.0), (512.0, 1.0 / 64.0), (65_534.0, 1.0), (65_535.0, 2.0)]
        {
            let high = low + DVec3::new(1.0_f64.min(extent), extent, 0.0);
            let grid = Grid::around(low, high, 1.0).expect("fine enough");
            assert_eq!(grid.step, step, "{extent}");
            assert_eq!(grid.low, (grid.low / step).round() * step);
            // Positions and their box are 32-bit floats.
            for point in [low.as_vec3(), high.as_vec3(), ((low + high) / 2.0).as_vec3()] {
                let numbers = grid.numbers(point.to_array()).map(f64::from);
                let moved = grid.low + DVec3::from_array(numbers) * step - point.as_dvec3();
                assert!(moved.abs().max_element() <= step / 2.0, "{extent}: {moved}");
            }
        }
        assert_eq!(Grid::around(low, low + DVec3::splat(512.0), 0.005), None);
        assert_eq!(Grid::around(low, DVec3::splat(3e38), 1.0), None);
        assert_eq!(Grid::around(low, low, 0.0), None);
    }

    #[test]
    fn directions_are_bytes() {
        assert_eq!(bytes([0.0, 1.0, -1.0]), [0, 127, 129, 0]);
        assert_eq!(bytes([0.6, 0.0, 0.8]), [76, 0, 102, 0]);
    }
}
