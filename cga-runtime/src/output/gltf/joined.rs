//! Files without normals: the faces of a building share their corners.

use std::collections::HashMap;

use super::Glb;
use super::primitive::{Owner, Primitive};
use super::quantized::Grid;
use super::scene::{MeshPlacement, SceneMesh};
use crate::geometry::each::Each;
use crate::output::error::WriteError;
use crate::output::packed::PackedFaces;

/// A vertex: its position and its texture coordinates.
type Key = ([u32; 3], Vec<[u32; 2]>);

impl Glb {
    /// Leaves out normals, so that the faces of a building with one material share their corners. A box has 8 vertices in place of 24. Viewers
    /// compute flat normals; some show such faces without light and shade. Maps of normals have no effect.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::gltf::Glb;
    ///
    /// let glb = Glb::new().with_quantization(0.2).without_normals();
    /// # let _ = glb;
    /// ```
    pub fn without_normals(mut self) -> Self {
        self.has_no_normals = true;
        self
    }

    /// Joins the vertices of each building at equal positions, if the file has no normals.
    pub(super) fn join_vertices(&self, meshes: Vec<SceneMesh>) -> Result<Vec<SceneMesh>, WriteError> {
        if !self.has_no_normals {
            return Ok(meshes);
        }
        let grid = self.grid(&meshes)?;
        let joined = |mesh: SceneMesh| {
            let grid = grid.filter(|_| matches!(mesh.places, MeshPlacement::Root));
            let primitives = mesh.primitives.into_iter().map(|own| own.joined(grid.as_ref(), self.has_no_rules));
            SceneMesh { primitives: primitives.collect(), ..mesh }
        };
        Ok(meshes.into_iter().map(joined).collect())
    }
}

impl Primitive {
    /// The primitive with one vertex for equal positions of an owner: positions with equal numbers on a grid, if there is one. `joins_rules` is
    /// true if the rules of a building share vertices.
    fn joined(self, grid: Option<&Grid>, joins_rules: bool) -> Primitive {
        let triangles = self.faces.triangles();
        let items = triangles.vertices.items();
        let is_one = |a: Owner, b: Owner| a.building == b.building && (joins_rules || a.rule == b.rule);
        // Only for look-ups, never iterated.
        let mut known: HashMap<Key, u32> = HashMap::new();
        let (mut kept, mut number_of, mut owners) = (Vec::new(), Vec::with_capacity(items.len()), Vec::new());
        for (owner, vertices) in self.owned() {
            if owners.last().is_none_or(|(last, _)| !is_one(*last, owner)) {
                known.clear();
                owners.push((owner, kept.len()));
            }
            for vertex in vertices {
                let [x, y, z, ..] = items[vertex];
                let place = match grid {
                    Some(grid) => grid.numbers([x, y, z]).map(u32::from),
                    None => [x, y, z].each(f32::to_bits),
                };
                let uvs = self.uvs.iter().map(|list| list[vertex].each(f32::to_bits)).collect();
                number_of.push(*known.entry((place, uvs)).or_insert_with(|| {
                    kept.push(vertex);
                    kept.len() as u32 - 1
                }));
            }
        }
        let mut faces = PackedFaces::default();
        let indices = triangles.indices.items().iter().map(|index| number_of[*index as usize]);
        faces.extend(kept.iter().map(|vertex| items[*vertex]), indices);
        let uvs = self.uvs.iter().map(|list| kept.iter().map(|vertex| list[*vertex]).collect()).collect();
        Primitive { faces, uvs, owners, look: self.look, sets: self.sets }
    }
}
