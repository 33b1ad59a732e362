//! A GLB file, taken apart by other code than the writer's.

use serde_json::Value as Json;

/// A GLB file: its description and its bytes.
pub(crate) struct GlbFile {
    pub(crate) json: Json,
    pub(crate) bytes: Vec<u8>,
}

impl GlbFile {
    pub(crate) fn new(file: &[u8]) -> Self {
        let word = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!((&file[..4], word(4), word(8)), (&b"glTF"[..], 2, file.len()));
        let length = word(12);
        let json = serde_json::from_slice(&file[20..20 + length]).unwrap();
        let bytes = if 20 + length < file.len() { file[28 + length..].to_vec() } else { Vec::new() };
        GlbFile { json, bytes }
    }

    pub(crate) fn view(&self, view: &Json) -> &[u8] {
        let view = &self.json["bufferViews"][number(view)];
        let start = number(&view["byteOffset"]);
        assert_eq!(start % 8, 0, "a view begins at a multiple of eight bytes");
        &self.bytes[start..start + number(&view["byteLength"])]
    }

    /// The numbers of an accessor with `N` numbers an item. Without a view all are 0.
    pub(crate) fn rows<const N: usize>(&self, accessor: &Json) -> Vec<[f64; N]> {
        let accessor = &self.json["accessors"][number(accessor)];
        let count = number(&accessor["count"]);
        if accessor["bufferView"].is_null() {
            return vec![[0.0; N]; count];
        }
        let from = number(&accessor["byteOffset"]);
        let words = self.view(&accessor["bufferView"])[from..from + 4 * N * count].as_chunks::<4>().0;
        let numbers: Vec<f64> = match accessor["componentType"] == 5126 {
            true => words.iter().map(|word| f64::from(f32::from_le_bytes(*word))).collect(),
            false => words.iter().map(|word| f64::from(u32::from_le_bytes(*word))).collect(),
        };
        numbers.as_chunks().0.to_vec()
    }
}

/// A whole number of a file; 0 if it is left out.
pub(crate) fn number(value: &Json) -> usize {
    value.as_u64().unwrap_or(0) as usize
}
