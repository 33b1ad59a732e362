//! The parts of a GLB file: its description and the numbers of its accessors.

use serde_json::Value as Json;

/// A GLB file, taken apart by other code than the writer's.
pub struct GlbFile {
    /// The description.
    pub json: Json,
    /// The bytes of its buffer.
    pub bytes: Vec<u8>,
}

/// The kinds of chunks.
const JSON_CHUNK: u32 = 0x4e4f_534a;
const BINARY_CHUNK: u32 = 0x004e_4942;

impl GlbFile {
    /// Reads a file.
    ///
    /// # Panics
    /// Panics if the file is not a GLB file of version 2.
    pub fn new(file: &[u8]) -> Self {
        assert_eq!((&file[..4], word(file, 4), word(file, 8) as usize), (&b"glTF"[..], 2, file.len()));
        let (mut json, mut bytes, mut at) = (Json::Null, Vec::new(), 12);
        while at < file.len() {
            let (length, kind) = (word(file, at) as usize, word(file, at + 4));
            let chunk = &file[at + 8..at + 8 + length];
            match kind {
                JSON_CHUNK => json = serde_json::from_slice(chunk).expect("a description"),
                BINARY_CHUNK => bytes = chunk.to_vec(),
                _ => {}
            }
            at += 8 + length;
        }
        GlbFile { json, bytes }
    }

    /// The bytes of a view.
    ///
    /// # Panics
    /// Panics if the view does not exist, or does not begin at a multiple of eight bytes of the buffer.
    pub fn view(&self, view: &Json) -> &[u8] {
        let view = &self.json["bufferViews"][number(view)];
        assert_eq!(number(&view["buffer"]), 0, "the file has one buffer");
        let start = number(&view["byteOffset"]);
        assert_eq!(start % 8, 0, "a view begins at a multiple of eight bytes");
        &self.bytes[start..start + number(&view["byteLength"])]
    }

    /// The items of an accessor, each with `N` numbers. Without a view all are 0.
    ///
    /// # Panics
    /// Panics if the accessor does not exist, or has fewer bytes than its items need.
    pub fn rows<const N: usize>(&self, accessor: &Json) -> Vec<[f64; N]> {
        let accessor = &self.json["accessors"][number(accessor)];
        let count = number(&accessor["count"]);
        if accessor["bufferView"].is_null() {
            return vec![[0.0; N]; count];
        }
        let component = Component::of(number(&accessor["componentType"]), accessor["normalized"] == true);
        let view = &self.json["bufferViews"][number(&accessor["bufferView"])];
        let stride = view["byteStride"].as_u64().map_or(N * component.size, |stride| stride as usize);
        let bytes = &self.view(&accessor["bufferView"])[number(&accessor["byteOffset"])..];
        let item = |at: usize| std::array::from_fn(|k| component.read(&bytes[at * stride + k * component.size..]));
        (0..count).map(item).collect()
    }

    /// The texts of a column of a property table.
    pub(super) fn texts(&self, property: &Json, count: usize) -> Vec<String> {
        let (values, offsets) = (self.view(&property["values"]), self.view(&property["stringOffsets"]));
        assert!(property["stringOffsetType"].is_null() || property["stringOffsetType"] == "UINT32", "{property}");
        let at = |row: usize| word(offsets, 4 * row) as usize;
        (0..count).map(|row| String::from_utf8_lossy(&values[at(row)..at(row + 1)]).into_owned()).collect()
    }
}

/// A type of numbers.
struct Component {
    size: usize,
    read: fn(&[u8]) -> f64,
    /// The number that means 1.
    one: f64,
}

impl Component {
    fn of(kind: usize, normalized: bool) -> Self {
        let (size, read, most): (_, fn(&[u8]) -> f64, _) = match kind {
            5120 => (1, |bytes| f64::from(bytes[0].cast_signed()), 127.0),
            5121 => (1, |bytes| f64::from(bytes[0]), 255.0),
            5122 => (2, |bytes| f64::from(i16::from_le_bytes([bytes[0], bytes[1]])), 32_767.0),
            5123 => (2, |bytes| f64::from(u16::from_le_bytes([bytes[0], bytes[1]])), 65_535.0),
            5125 => (4, |bytes| f64::from(word(bytes, 0)), 4_294_967_295.0),
            5126 => (4, |bytes| f64::from(f32::from_bits(word(bytes, 0))), 1.0),
            other => panic!("{other} is not a type of numbers"),
        };
        Component { size, read, one: if normalized { most } else { 1.0 } }
    }

    fn read(&self, bytes: &[u8]) -> f64 {
        (self.read)(bytes) / self.one
    }
}

fn word(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]])
}

/// A whole number of a file; 0 if it is left out.
pub fn number(value: &Json) -> usize {
    value.as_u64().unwrap_or(0) as usize
}

/// The numbers of a list, or `other` if it is left out.
pub(super) fn numbers<const N: usize>(value: &Json, other: [f64; N]) -> [f64; N] {
    match value.as_array() {
        Some(list) => std::array::from_fn(|k| list[k].as_f64().expect("a number")),
        None => other,
    }
}
