//! Property tables and the numbers of features in GLB files.

use cga_gates::GlbFile;
use serde_json::Value as Json;

/// The table of buildings of a file.
pub(super) trait BuildingTable {
    /// The number of the table of a class.
    fn table(&self, class: &str) -> Option<usize>;

    /// A column of the table of buildings, as JSON values; null for the value that means none.
    fn column(&self, id: &str) -> Vec<Json>;

    /// The points of all vertices in place, each with the number of its building.
    fn points_of_buildings(&self) -> Vec<(usize, [f64; 3])>;
}

impl BuildingTable for GlbFile {
    fn table(&self, class: &str) -> Option<usize> {
        let tables = self.json["extensions"]["EXT_structural_metadata"]["propertyTables"].as_array()?;
        tables.iter().position(|table| table["class"] == class)
    }

    fn column(&self, id: &str) -> Vec<Json> {
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

    fn points_of_buildings(&self) -> Vec<(usize, [f64; 3])> {
        let table = self.table("building").unwrap();
        let moved = &self.json["nodes"][0]["translation"];
        let moved: [f64; 3] = std::array::from_fn(|i| moved[i].as_f64().unwrap_or(0.0));
        let mut points = Vec::new();
        for primitive in
            self.json["meshes"].as_array().unwrap().iter().flat_map(|mesh| mesh["primitives"].as_array().unwrap())
        {
            let features = primitive["extensions"]["EXT_mesh_features"]["featureIds"].as_array().unwrap();
            let Some(own) = features.iter().find(|feature| feature["propertyTable"] == table) else { continue };
            let ids = self.rows::<1>(&primitive["attributes"][format!("_FEATURE_ID_{}", own["attribute"])]);
            let places = self.rows::<3>(&primitive["attributes"]["POSITION"]);
            assert_eq!(ids.len(), places.len());
            points.extend(
                ids.iter()
                    .zip(places)
                    .map(|(id, place)| (id[0] as usize, std::array::from_fn(|i| place[i] + moved[i]))),
            );
        }
        points
    }
}
