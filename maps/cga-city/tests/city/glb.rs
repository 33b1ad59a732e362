//! A reader of GLB files of its own: features and metadata, which the Khronos validator does not check.

use std::collections::BTreeMap;
use std::path::Path;

use cga_city::glb_bounds::json;
use cga_geo::synthetic::Town;
use serde_json::Value;

use crate::town::{city, files};

/// A building of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Building {
    pub(crate) name: String,
    pub(crate) height: f64,
    pub(crate) kind: String,
    /// The number of its vertices, and their lowest and highest y.
    pub(crate) vertices: usize,
    pub(crate) y: [f32; 2],
}

/// A GLB file.
pub(crate) struct Glb {
    json: Value,
    binary: Vec<u8>,
}

impl Glb {
    pub(crate) fn new(bytes: &[u8]) -> Self {
        let json = json(bytes).expect("GLB");
        let length = u32::from_le_bytes(bytes[12..16].try_into().expect("four bytes")) as usize;
        assert_eq!(bytes.len(), u32::from_le_bytes(bytes[8..12].try_into().expect("four bytes")) as usize);
        Glb { json, binary: bytes[20 + length + 8..].to_vec() }
    }

    fn view(&self, index: &Value) -> &[u8] {
        let view = &self.json["bufferViews"][index.as_u64().expect("an index") as usize];
        let start = view["byteOffset"].as_u64().unwrap_or(0) as usize;
        &self.binary[start..start + view["byteLength"].as_u64().expect("a length") as usize]
    }

    /// The elements of an accessor as numbers, `N` for each.
    fn numbers<const N: usize>(&self, index: &Value) -> Vec<[f32; N]> {
        let accessor = &self.json["accessors"][index.as_u64().expect("an index") as usize];
        let count = accessor["count"].as_u64().expect("a count") as usize;
        // All numbers of the only building are 0.
        let Some(view) = accessor["bufferView"].as_u64() else { return vec![[0.0; N]; count] };
        let view = &self.json["bufferViews"][view as usize];
        let ty = accessor["componentType"].as_u64().expect("a type");
        let size = match ty {
            5121 => 1,
            5123 => 2,
            5125 | 5126 => 4,
            other => panic!("component type {other}"),
        };
        let stride = view["byteStride"].as_u64().map_or(size * N, |stride| stride as usize);
        let bytes = &self.view(&accessor["bufferView"])[accessor["byteOffset"].as_u64().unwrap_or(0) as usize..];
        let number = |at: usize| match ty {
            5121 => f32::from(bytes[at]),
            5123 => f32::from(u16::from_le_bytes(bytes[at..at + 2].try_into().expect("two"))),
            5125 => u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four")) as f32,
            _ => f32::from_le_bytes(bytes[at..at + 4].try_into().expect("four")),
        };
        (0..count).map(|element| std::array::from_fn(|part| number(element * stride + part * size))).collect()
    }

    /// The property table of the buildings, and the set of feature numbers of a primitive that refers to it.
    fn buildings_of(&self, primitive: &Value) -> (usize, usize) {
        let tables = self.json["extensions"]["EXT_structural_metadata"]["propertyTables"].as_array().expect("tables");
        let has_name = |table: &Value| table["properties"].get("seed").is_some();
        let table = tables.iter().position(has_name).expect("a table of buildings");
        let ids = primitive["extensions"]["EXT_mesh_features"]["featureIds"].as_array().expect("features");
        let own = ids.iter().find(|ids| ids["propertyTable"] == table).expect("features of buildings");
        assert_eq!(own["featureCount"], tables[table]["count"]);
        (table, own["attribute"].as_u64().expect("an attribute") as usize)
    }

    fn texts(&self, property: &Value, count: usize) -> Vec<String> {
        let offsets = self.view(&property["stringOffsets"]);
        let size = match property["stringOffsetType"].as_str().unwrap_or("UINT32") {
            "UINT8" => 1,
            "UINT16" => 2,
            _ => 4,
        };
        let offset = |at: usize| (0..size).rev().fold(0, |sum, byte| sum << 8 | usize::from(offsets[at * size + byte]));
        let values = self.view(&property["values"]);
        let text = |at| String::from_utf8(values[offset(at)..offset(at + 1)].to_vec()).expect("UTF-8");
        (0..count).map(text).collect()
    }

    /// The buildings with their vertices.
    pub(crate) fn buildings(&self) -> Vec<Building> {
        let mut buildings: Vec<Building> = Vec::new();
        for (number, mesh) in self.json["meshes"].as_array().expect("meshes").iter().enumerate() {
            let [translation, scale] = self.place(number);
            for primitive in mesh["primitives"].as_array().expect("primitives") {
                let (table, set) = self.buildings_of(primitive);
                if buildings.is_empty() {
                    buildings = self.rows(table);
                }
                let ids = self.numbers::<1>(&primitive["attributes"][format!("_FEATURE_ID_{set}")]);
                let positions = self.numbers::<3>(&primitive["attributes"]["POSITION"]);
                assert_eq!(ids.len(), positions.len());
                for ([id], [_, y, _]) in ids.into_iter().zip(positions) {
                    let y = translation + scale * y;
                    let building = &mut buildings[id as usize];
                    building.y = [building.y[0].min(y), building.y[1].max(y)];
                    building.vertices += 1;
                }
            }
        }
        buildings
    }

    /// The height of the node of a mesh, and its scale.
    fn place(&self, mesh: usize) -> [f32; 2] {
        let nodes = self.json["nodes"].as_array().expect("nodes");
        let node = nodes.iter().find(|node| node["mesh"] == mesh).expect("a node");
        let y = |name: &str, usual: f64| node[name][1].as_f64().unwrap_or(usual) as f32;
        [y("translation", 0.0), y("scale", 1.0)]
    }

    fn rows(&self, table: usize) -> Vec<Building> {
        let metadata = &self.json["extensions"]["EXT_structural_metadata"];
        let table = &metadata["propertyTables"][table];
        let class = &metadata["schema"]["classes"][table["class"].as_str().expect("a class")]["properties"];
        let count = table["count"].as_u64().expect("a count") as usize;
        assert_eq!(
            (class["height"]["type"].as_str(), class["height"]["componentType"].as_str()),
            (Some("SCALAR"), Some("FLOAT64"))
        );
        let (heights, _) = self.view(&table["properties"]["height"]["values"]).as_chunks::<8>();
        let names = self.texts(&table["properties"]["name"], count);
        let kinds = self.texts(&table["properties"]["kind"], count);
        assert_eq!(heights.len(), count);
        let row = |((name, height), kind)| Building {
            name,
            height: f64::from_le_bytes(height),
            kind,
            vertices: 0,
            y: [f32::INFINITY, f32::NEG_INFINITY],
        };
        names.into_iter().zip(heights.iter().copied()).zip(kinds).map(row).collect()
    }
}

#[test]
fn each_building_is_a_feature_with_the_values_of_its_row_at_each_level() {
    let folder = tempfile::tempdir().expect("a folder");
    let lots = folder.path().join("town.fgb");
    let town = Town::new(500);
    town.write(&lots).expect("room");
    let out = folder.path().join("out");
    let summary = city(&lots, &out);
    for level in 0..2 {
        let mut found: BTreeMap<i64, Vec<Building>> = BTreeMap::new();
        let of_level = files(&out).into_iter().filter(|(name, _)| is_tile(name, level));
        let buildings = of_level.flat_map(|(_, bytes)| Glb::new(&bytes).buildings());
        buildings.for_each(|building| found.entry(building.name.parse().expect("an id")).or_default().push(building));
        assert_eq!(summary.levels[level].buildings, found.values().map(|list| list.len() as u64).sum::<u64>());
        for row in town.iter() {
            let own = &found[&row.id];
            assert_eq!(own.len(), row.polygons.len());
            for building in own {
                assert_eq!((building.height, building.kind.as_str()), (row.height, row.kind));
                assert!(16 <= building.vertices, "{building:?}");
                // Lots of a tile that is some hundred metres wide stand a little below its plane.
                assert!(-0.5 < building.y[0] && building.y[0] < 0.01, "{building:?}");
                let top = row.height as f32 + if level == 1 { 1.0 } else { 0.0 };
                assert!(top - 0.5 < building.y[1] && building.y[1] < top + 12.0, "{building:?}");
            }
        }
    }
}

pub(crate) fn is_tile(name: &str, level: usize) -> bool {
    Path::new(name).starts_with(format!("tiles/{level}")) && name.ends_with(".glb")
}
