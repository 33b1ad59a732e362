//! A reader of GLB files: vertices, property tables and the numbers of features.

use serde_json::Value as Json;

/// A GLB file: its description and its bytes.
pub(super) struct Read {
    pub(super) json: Json,
    bytes: Vec<u8>,
}

impl Read {
    pub(super) fn new(file: &[u8]) -> Self {
        let word = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!((&file[..4], word(4), word(8)), (&b"glTF"[..], 2, file.len()));
        let length = word(12);
        let json = serde_json::from_slice(&file[20..20 + length]).unwrap();
        let bytes = if 20 + length < file.len() { file[28 + length..].to_vec() } else { Vec::new() };
        Read { json, bytes }
    }

    fn view(&self, number: &Json) -> &[u8] {
        let view = &self.json["bufferViews"][number.as_u64().unwrap() as usize];
        let (start, length) =
            (view["byteOffset"].as_u64().unwrap_or(0) as usize, view["byteLength"].as_u64().unwrap() as usize);
        assert_eq!(start % 8, 0, "metadata begins at a multiple of eight bytes");
        &self.bytes[start..start + length]
    }

    /// The numbers of an accessor with `N` numbers an item.
    pub(super) fn floats<const N: usize>(&self, number: &Json) -> Vec<[f32; N]> {
        let accessor = &self.json["accessors"][number.as_u64().unwrap() as usize];
        assert_eq!(accessor["componentType"], 5126);
        let count = accessor["count"].as_u64().unwrap() as usize;
        if accessor["bufferView"].is_null() {
            return vec![[0.0; N]; count];
        }
        let from = accessor["byteOffset"].as_u64().unwrap_or(0) as usize;
        let bytes = &self.view(&accessor["bufferView"])[from..from + 4 * N * count];
        let numbers: Vec<f32> = bytes.chunks(4).map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap())).collect();
        numbers.as_chunks().0.to_vec()
    }

    /// The number of the table of a class.
    pub(super) fn table(&self, class: &str) -> Option<usize> {
        let tables = self.json["extensions"]["EXT_structural_metadata"]["propertyTables"].as_array()?;
        tables.iter().position(|table| table["class"] == class)
    }

    /// A column of the table of buildings, as JSON values; null for the value that stands for none.
    pub(super) fn column(&self, id: &str) -> Vec<Json> {
        let metadata = &self.json["extensions"]["EXT_structural_metadata"];
        let table = &metadata["propertyTables"][self.table("building").unwrap()];
        let (rows, own) = (table["count"].as_u64().unwrap() as usize, &table["properties"][id]);
        let property = &metadata["schema"]["classes"]["building"]["properties"][id];
        let values = self.view(&own["values"]);
        let offsets = |number: &Json| -> Vec<usize> {
            self.view(number).chunks(4).map(|bytes| u32::from_le_bytes(bytes.try_into().unwrap()) as usize).collect()
        };
        let item = |at: usize| match property["type"].as_str().unwrap() {
            "STRING" => {
                let offsets = offsets(&own["stringOffsets"]);
                Json::from(std::str::from_utf8(&values[offsets[at]..offsets[at + 1]]).unwrap())
            }
            "BOOLEAN" => Json::from(values[at / 8] >> (at % 8) & 1 == 1),
            _ => {
                let bytes = values[8 * at..8 * at + 8].try_into().unwrap();
                match property["componentType"].as_str().unwrap() {
                    "UINT64" => Json::from(u64::from_le_bytes(bytes)),
                    _ => Json::from(f64::from_le_bytes(bytes)),
                }
            }
        };
        let row = |row: usize| match property["array"] == true {
            true => {
                let offsets = offsets(&own["arrayOffsets"]);
                Json::from((offsets[row]..offsets[row + 1]).map(item).collect::<Vec<_>>())
            }
            false => item(row),
        };
        let none = |value: Json| {
            if property["noData"].as_f64().is_some_and(|none| value.as_f64() == Some(none))
                || value == property["noData"]
            {
                Json::Null
            } else {
                value
            }
        };
        (0..rows).map(|at| none(row(at))).collect()
    }

    /// The points of all vertices in place, each with the number of its building.
    pub(super) fn points(&self) -> Vec<(usize, [f64; 3])> {
        let table = self.table("building").unwrap();
        let moved = &self.json["nodes"][0]["translation"];
        let moved: [f64; 3] = std::array::from_fn(|i| moved[i].as_f64().unwrap_or(0.0));
        let mut points = Vec::new();
        for primitive in
            self.json["meshes"].as_array().unwrap().iter().flat_map(|mesh| mesh["primitives"].as_array().unwrap())
        {
            let features = primitive["extensions"]["EXT_mesh_features"]["featureIds"].as_array().unwrap();
            let Some(own) = features.iter().find(|feature| feature["propertyTable"] == table) else { continue };
            let ids = self.floats::<1>(&primitive["attributes"][format!("_FEATURE_ID_{}", own["attribute"])]);
            let places = self.floats::<3>(&primitive["attributes"]["POSITION"]);
            assert_eq!(ids.len(), places.len());
            points.extend(
                ids.iter()
                    .zip(places)
                    .map(|(id, place)| (id[0] as usize, std::array::from_fn(|i| f64::from(place[i]) + moved[i]))),
            );
        }
        points
    }
}
