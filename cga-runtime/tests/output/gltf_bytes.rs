//! The equivalent of `fuzz/fuzz_targets/gltf.rs` for a stable compiler: files with changed bytes, and files with changed
//! values.

use crate::sink_support::{Fill, color, mixed, plate};
use cga_runtime::output::gltf::Glb;
use serde_json::Value;

struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit
    }
}

/// Two files that this crate writes: one with all kinds of leaves, one with nodes that place an asset.
fn files() -> [Vec<u8>; 2] {
    let mut fill = Fill(Glb::new());
    for x in 0..3 {
        let place = glam::DAffine3::from_translation(glam::DVec3::X * f64::from(x));
        fill.instance("Plate", &color(0.5, 0.25, 1.0), &plate(), place);
    }
    [mixed().to_glb().expect("a file"), fill.0.into_bytes().expect("a file")]
}

#[test]
fn changed_bytes_do_no_harm() {
    let mut random = Random(1);
    for file in files() {
        crate::gltf_support::check(&file);
        for _ in 0..3_000 {
            let mut bytes = file.clone();
            for _ in 0..1 + random.below(6) {
                let at = random.below(bytes.len());
                match random.below(3) {
                    0 => bytes[at] = b"0123456789-.e\\\"[]{},:\xff"[random.below(22)],
                    1 => drop(bytes.remove(at)),
                    _ => bytes.insert(at, random.below(256) as u8),
                }
            }
            crate::gltf_support::check(&bytes);
        }
    }
}

/// The values of a JSON text that are not lists or objects, in order.
fn leaves<'a>(value: &'a mut Value, found: &mut Vec<&'a mut Value>) {
    match value {
        Value::Array(values) => values.iter_mut().for_each(|value| leaves(value, found)),
        Value::Object(members) => members.values_mut().for_each(|value| leaves(value, found)),
        leaf => found.push(leaf),
    }
}

#[test]
fn changed_values_do_no_harm() {
    let values = ["-1", "0", "1", "2", "255", "5121", "4294967295", "1e300", "0.5", "null", "[]", "{}", "\"\"", "true"];
    let mut random = Random(2);
    for file in files() {
        let length = u32::from_le_bytes([file[12], file[13], file[14], file[15]]) as usize;
        let json: Value = serde_json::from_slice(&file[20..20 + length]).expect("JSON");
        for _ in 0..3_000 {
            let mut json = json.clone();
            let mut found = Vec::new();
            leaves(&mut json, &mut found);
            for _ in 0..1 + random.below(3) {
                let at = random.below(found.len());
                *found[at] = serde_json::from_str(values[random.below(values.len())]).expect("a value");
            }
            let text = json.to_string();
            let length = 12 + 8 + text.len() + file.len() - 20 - length;
            let header = [&b"glTF\x02\0\0\0"[..], &(length as u32).to_le_bytes(), &(text.len() as u32).to_le_bytes()];
            let rest = &file[20 + u32::from_le_bytes([file[12], file[13], file[14], file[15]]) as usize..];
            crate::gltf_support::check(&[&header.concat(), &b"JSON"[..], text.as_bytes(), rest].concat());
        }
    }
}
