//! The box around the contents of a GLB file, from the limits of its positions and the places of its nodes.

use cga_geo::frame::Vector;
use serde_json::Value;

/// A box by its lowest and its highest corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The lowest corner.
    pub low: Vector,
    /// The highest corner.
    pub high: Vector,
}

impl Bounds {
    /// A box without points.
    pub const EMPTY: Bounds = Bounds { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };

    /// Grows the box to a point.
    pub fn add(&mut self, point: Vector) {
        self.low = [0, 1, 2].map(|axis| self.low[axis].min(point[axis]));
        self.high = [0, 1, 2].map(|axis| self.high[axis].max(point[axis]));
    }

    /// True without points.
    pub fn is_empty(&self) -> bool {
        self.high[0] < self.low[0]
    }

    /// The eight corners.
    pub fn corners(&self) -> [Vector; 8] {
        std::array::from_fn(|corner| {
            std::array::from_fn(|axis| if corner >> axis & 1 == 0 { self.low[axis] } else { self.high[axis] })
        })
    }
}

/// The JSON text of a GLB file.
///
/// # Errors
/// A sentence: the bytes are not GLB 2.0.
pub fn json(glb: &[u8]) -> Result<Value, String> {
    let number = |at: usize| Some(u32::from_le_bytes(*glb.get(at..)?.first_chunk()?));
    if glb.get(..4) != Some(b"glTF") || number(4) != Some(2) || number(16) != Some(0x4e4f_534a) {
        return Err("it is not GLB 2.0".to_owned());
    }
    let length = number(12).unwrap_or_default() as usize;
    let text = glb.get(20..).and_then(|rest| rest.get(..length)).ok_or("it ends early")?;
    serde_json::from_slice(text).map_err(|why| format!("its JSON is broken: {why}"))
}

/// The box around all meshes of a GLB file, in its own axes with y up.
///
/// # Errors
/// As [`json`].
pub fn glb_bounds(glb: &[u8]) -> Result<Bounds, String> {
    let file = json(glb)?;
    let mut bounds = Bounds::EMPTY;
    let scene = file["scene"].as_u64().unwrap_or_default() as usize;
    for node in indices(&file["scenes"][scene]["nodes"]) {
        add_node(&file, node, &IDENTITY, 0, &mut bounds);
    }
    Ok(bounds)
}

/// A matrix by columns.
type Matrix = [f64; 16];

const IDENTITY: Matrix = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

/// Nodes are nested less deep than this.
const MOST_DEPTH: usize = 64;

fn add_node(file: &Value, node: usize, outer: &Matrix, depth: usize, bounds: &mut Bounds) {
    let node = &file["nodes"][node];
    let place = product(outer, &own_matrix(node));
    for primitive in file["meshes"][index(&node["mesh"])]["primitives"].as_array().into_iter().flatten() {
        let accessor = &file["accessors"][index(&primitive["attributes"]["POSITION"])];
        let corner = |name: &str| numbers::<3>(&accessor[name]);
        if let (Some(low), Some(high)) = (corner("min"), corner("max")) {
            Bounds { low, high }.corners().iter().for_each(|corner| bounds.add(moved(&place, *corner)));
        }
    }
    if depth < MOST_DEPTH {
        indices(&node["children"]).for_each(|child| add_node(file, child, &place, depth + 1, bounds));
    }
}

fn own_matrix(node: &Value) -> Matrix {
    if let Some(matrix) = numbers(&node["matrix"]) {
        return matrix;
    }
    let [x, y, z, w] = numbers(&node["rotation"]).unwrap_or([0.0, 0.0, 0.0, 1.0]);
    let scale: Vector = numbers(&node["scale"]).unwrap_or([1.0; 3]);
    let [tx, ty, tz] = numbers(&node["translation"]).unwrap_or([0.0; 3]);
    let columns = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)],
        [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)],
        [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)],
    ];
    let [a, b, c] = [0, 1, 2].map(|axis| columns[axis].map(|number| number * scale[axis]));
    [a[0], a[1], a[2], 0.0, b[0], b[1], b[2], 0.0, c[0], c[1], c[2], 0.0, tx, ty, tz, 1.0]
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|at| {
        let (column, row) = (at / 4, at % 4);
        (0..4).map(|inner| a[4 * inner + row] * b[4 * column + inner]).sum()
    })
}

fn moved(matrix: &Matrix, point: Vector) -> Vector {
    [0, 1, 2].map(|row| (0..3).map(|axis| matrix[4 * axis + row] * point[axis]).sum::<f64>() + matrix[12 + row])
}

/// An index, or one beyond every list.
fn index(value: &Value) -> usize {
    value.as_u64().map_or(usize::MAX, |index| index as usize)
}

fn indices(value: &Value) -> impl Iterator<Item = usize> {
    value.as_array().into_iter().flatten().map(index)
}

fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let list: Vec<f64> = value.as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?;
    list.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use cga::{Grammar as _, RuleFile, Shape};

    #[test]
    fn the_box_of_a_file_is_the_box_of_its_model() {
        let rules = RuleFile::from_text("Lot --> extrude(7) [ t(1, 2, 3) X. ] t(50, 0, -9) Y.").expect("rules");
        let model = rules.generate(&Shape::rectangle(4.0, 5.0).at([1e5, 3.0, -2e5])).expect("a model");
        let (found, expected) = (glb_bounds(&model.to_glb().expect("a file")).expect("GLB"), model.bounds());
        for (a, b) in
            found.low.iter().chain(&found.high).zip(expected.low.to_array().iter().chain(&expected.high.to_array()))
        {
            assert!((a - b).abs() < 0.01, "{found:?} {expected:?}");
        }
    }

    #[test]
    fn other_bytes_are_refused() {
        assert!(glb_bounds(b"").is_err() && glb_bounds(b"glTF\x02\0\0\0").is_err());
        assert!(Bounds::EMPTY.is_empty());
    }
}
