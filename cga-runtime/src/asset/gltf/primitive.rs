//! Primitives: triangles with the attributes of their vertices.

use std::collections::HashMap;
use std::rc::Rc;

use glam::{DVec2, DVec3};

use super::accessor;
use super::document::Document;
use super::item::{Item, item};
use super::{GltfError, MOST_TRIANGLES};

/// The triangles of a primitive.
pub(super) struct PrimitiveTriangles {
    /// The vertices that triangles use.
    pub(super) points: Vec<DVec3>,
    /// One normal per vertex, if the primitive has normals.
    pub(super) normals: Option<Vec<DVec3>>,
    /// The coordinates `TEXCOORD_n` by `n`, with v upwards, as far as they exist. One pair per vertex.
    pub(super) coordinates: Vec<Option<Vec<DVec2>>>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) material: Option<usize>,
}

/// The greatest number of `TEXCOORD_n`.
const MOST_COORDINATES: usize = 10;

/// The greatest number of elements that are read from accessors, so that memory and time stay bounded when many
/// accessors share bytes.
const MOST_ELEMENTS: usize = 1 << 25;

/// The number of elements that a file of any size may have. Each byte of its buffers allows some more.
const FREE_ELEMENTS: usize = 1 << 21;
const ELEMENTS_PER_BYTE: usize = 4;

/// The number for a vertex that the triangles of a primitive do not use.
const UNUSED: u32 = u32::MAX;

/// Reads primitives. Accessors that several primitives share are read once.
pub(super) struct PrimitiveReader<'a, 'b> {
    document: &'a Document<'b>,
    vectors: HashMap<usize, Rc<Vec<[f64; 3]>>>,
    pairs: HashMap<usize, Rc<Vec<[f64; 2]>>>,
    /// The number of elements that may still be read.
    elements_left: usize,
    /// The new numbers of vertices, for [`renumber`](Self::renumber). All are `UNUSED` between primitives.
    new_numbers: Vec<u32>,
    /// The number of primitives with lines or points.
    pub(super) others: usize,
}

impl<'a, 'b> PrimitiveReader<'a, 'b> {
    pub(super) fn new(document: &'a Document<'b>) -> Self {
        let (vectors, pairs) = (HashMap::new(), HashMap::new());
        let elements_left = (FREE_ELEMENTS + ELEMENTS_PER_BYTE * document.byte_count()).min(MOST_ELEMENTS);
        PrimitiveReader { document, vectors, pairs, elements_left, new_numbers: Vec::new(), others: 0 }
    }

    /// The primitives of a mesh that have triangles.
    pub(super) fn primitives(&mut self, mesh: usize) -> Result<Vec<PrimitiveTriangles>, GltfError> {
        let mesh = item(&self.document.json, "meshes", mesh)?;
        let mut all = Vec::new();
        for primitive in mesh.objects("primitives")? {
            all.extend(self.primitive(&primitive)?.filter(|primitive| !primitive.triangles.is_empty()));
        }
        Ok(all)
    }

    fn primitive(&mut self, primitive: &Item<'a>) -> Result<Option<PrimitiveTriangles>, GltfError> {
        let mode = primitive.whole("mode")?.unwrap_or(4);
        if mode < 4 {
            self.others += 1;
            return Ok(None);
        }
        let Some(attributes) = primitive.object("attributes")? else { return Ok(None) };
        let Some(positions) = attributes.whole("POSITION")? else { return Ok(None) };
        let positions = self.vectors(positions)?;
        let order = match primitive.whole("indices")? {
            Some(indices) => {
                let indices = accessor::indices(self.document, indices)?;
                self.count(indices.len())?;
                indices
            }
            None => {
                // Every primitive without indices is another copy of the positions.
                self.count(positions.len())?;
                (0..positions.len() as u32).collect()
            }
        };
        if order.iter().any(|&index| positions.len() <= index as usize) {
            return Err(primitive.error("an index of a primitive is out of range"));
        }
        let mut triangles = match mode {
            4 => order.as_chunks::<3>().0.to_vec(),
            5 => order.windows(3).enumerate().map(strip).collect(),
            6 => order.windows(2).skip(1).map(|pair| [order[0], pair[0], pair[1]]).collect(),
            _ => return Err(primitive.error("the `mode` of a primitive is unknown")),
        };
        if MOST_TRIANGLES < triangles.len() {
            return Err(GltfError::TooLarge);
        }
        let used = self.renumber(&mut triangles, positions.len());
        let fits = |count: usize| match count == positions.len() {
            true => Ok(()),
            false => Err(primitive.error("the attributes of a primitive differ in length")),
        };
        let vectors = |list: &[[f64; 3]]| used.iter().map(|&at| DVec3::from(list[at as usize])).collect();
        let normals = match attributes.whole("NORMAL")? {
            Some(normals) => {
                let normals = self.vectors(normals)?;
                fits(normals.len())?;
                Some(vectors(&normals))
            }
            None => None,
        };
        let mut coordinates = Vec::new();
        for number in 0..MOST_COORDINATES {
            coordinates.push(match attributes.whole(&format!("TEXCOORD_{number}"))? {
                Some(pairs) => {
                    let pairs = self.pairs(pairs)?;
                    fits(pairs.len())?;
                    Some(used.iter().map(|&at| pairs[at as usize]).map(|[u, v]| DVec2::new(u, 1.0 - v)).collect())
                }
                None => None,
            });
        }
        let material = primitive.whole("material")?;
        Ok(Some(PrimitiveTriangles { points: vectors(&positions), normals, coordinates, triangles, material }))
    }

    fn vectors(&mut self, index: usize) -> Result<Rc<Vec<[f64; 3]>>, GltfError> {
        if let Some(known) = self.vectors.get(&index) {
            return Ok(known.clone());
        }
        let list = Rc::new(accessor::vectors(self.document, index)?);
        self.count(list.len())?;
        self.vectors.insert(index, list.clone());
        Ok(list)
    }

    fn pairs(&mut self, index: usize) -> Result<Rc<Vec<[f64; 2]>>, GltfError> {
        if let Some(known) = self.pairs.get(&index) {
            return Ok(known.clone());
        }
        let list = Rc::new(accessor::vectors(self.document, index)?);
        self.count(list.len())?;
        self.pairs.insert(index, list.clone());
        Ok(list)
    }

    /// Numbers the used vertices in the order of their first use. Returns their old numbers.
    fn renumber(&mut self, triangles: &mut [[u32; 3]], count: usize) -> Vec<u32> {
        // Many primitives may each use a few of very many vertices.
        if self.new_numbers.len() < count {
            self.new_numbers.resize(count, UNUSED);
        }
        let mut used = Vec::new();
        for corner in triangles.as_flattened_mut() {
            let number = &mut self.new_numbers[*corner as usize];
            if *number == UNUSED {
                *number = used.len() as u32;
                used.push(*corner);
            }
            *corner = *number;
        }
        used.iter().for_each(|old| self.new_numbers[*old as usize] = UNUSED);
        used
    }

    fn count(&mut self, elements: usize) -> Result<(), GltfError> {
        self.elements_left = self.elements_left.checked_sub(elements).ok_or(GltfError::TooLarge)?;
        Ok(())
    }
}

/// A triangle of a strip. Every second one is turned over.
fn strip((at, corners): (usize, &[u32])) -> [u32; 3] {
    let turned = at % 2;
    [corners[0], corners[1 + turned], corners[2 - turned]]
}
