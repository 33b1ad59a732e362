//! Roadways, sidewalks and junctions from the centre lines of streets: `streets.glb` and `streets.png`.
//!
//! `cargo run --release --example streets -- lines.geojson` reads GeoJSON lines in longitude and latitude. Without a
//! path it uses a small made-up network.

use std::collections::BTreeMap;
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;

use cga::sink::picture::Picture;
use cga::street::{Centerline, Network, NetworkOptions};
use cga::{Model, Settings, cga};
use serde_json::Value;

cga! {
    /// Streets with CityEngine's start rules.
    pub grammar Streets;

    const kerb = 0.15

    Street   --> color("#5c5e63") Roadway.
    Joint    --> color("#64666c") Roadway.
    Junction --> color("#6d7078") Roadway.
    Crossing --> color("#6d7078") Roadway.
    Sidewalk --> color("#c9c2b4") extrude(world.up, kerb) Pavement.
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let text = match std::env::args_os().nth(1) {
        Some(path) => std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?,
        None => SAMPLE.to_owned(),
    };
    let (lines, skipped) = read(&text)?;
    for line in &skipped {
        eprintln!("{line}");
    }

    let begin = Instant::now();
    let network = Network::new(&lines, &NetworkOptions::default())?;
    let laid_out = begin.elapsed();
    let streets = model(&network, &Settings::default())?;
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    network.parts().iter().for_each(|part| *counts.entry(part.start_rule()).or_default() += 1);
    println!("{} lines in {:.1} ms, {} triangles", lines.len(), laid_out.as_secs_f64() * 1e3, streets.triangle_count());
    for (rule, count) in counts {
        println!("{count:6} {rule}");
    }
    streets.write_glb("streets.glb")?;
    Picture::new(1600, 1200).looking_from(20.0, 60.0).render(&streets).write_png("streets.png")?;
    println!("wrote streets.glb and streets.png");
    Ok(())
}

/// The streets, part by part.
pub(crate) fn model(network: &Network, settings: &Settings) -> Result<Model, cga::Error> {
    let mut streets = Model::new();
    for part in network.parts() {
        let lot = part.shape().start(part.start_rule());
        streets.append(&Streets::default().generate_with(&lot, settings)?);
    }
    Ok(streets)
}

/// The lines of a GeoJSON file in metres relative to their middle, and a note for each feature without lines.
pub(crate) fn read(text: &str) -> Result<(Vec<Centerline>, Vec<String>), Box<dyn Error>> {
    let file: Value = serde_json::from_str(text).map_err(|error| format!("the lines are not JSON: {error}"))?;
    let features = file["features"].as_array().ok_or("no `features`: is it a GeoJSON feature collection?")?;
    let (mut lines, mut problems) = (Vec::new(), Vec::new());
    for (number, feature) in features.iter().enumerate() {
        let geometry = &feature["geometry"];
        let parts: Vec<&Value> = match geometry["type"].as_str() {
            Some("LineString") => vec![&geometry["coordinates"]],
            Some("MultiLineString") => geometry["coordinates"].as_array().into_iter().flatten().collect(),
            kind => {
                problems.push(format!("feature {number}: skipped: {} is not a line", kind.unwrap_or("nothing")));
                continue;
            }
        };
        let widths = &feature["properties"];
        for part in parts {
            match part.as_array().and_then(|points| points.iter().map(point).collect::<Option<Vec<_>>>()) {
                Some(points) => lines.push((points, widths)),
                None => problems.push(format!("feature {number}: skipped: its coordinates cannot be read")),
            }
        }
    }
    let all = || lines.iter().flat_map(|(points, _)| points);
    let (low, high) = all().fold(([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]), |(low, high), p| {
        ([low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])])
    });
    let middle = [(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0];
    // At the size of a district the earth is flat.
    const METRES_A_DEGREE: f64 = 111_319.490_8;
    let shrink = libm::cos(middle[1].to_radians());
    let metres = |p: &[f64; 2]| [(p[0] - middle[0]) * shrink * METRES_A_DEGREE, (middle[1] - p[1]) * METRES_A_DEGREE];
    let line = |(points, widths): &(Vec<[f64; 2]>, &Value)| {
        let line = Centerline::new(&points.iter().map(metres).collect::<Vec<_>>());
        match (widths["roadway"].as_f64(), widths["sidewalk"].as_f64()) {
            (Some(roadway), Some(sidewalk)) => line.roadway(roadway).sidewalks(sidewalk, sidewalk),
            (Some(roadway), None) => line.roadway(roadway),
            (None, Some(sidewalk)) => line.sidewalks(sidewalk, sidewalk),
            (None, None) => line,
        }
    };
    Ok((lines.iter().map(line).collect(), problems))
}

fn point(point: &Value) -> Option<[f64; 2]> {
    Some([point.get(0)?.as_f64()?, point.get(1)?.as_f64()?])
}

/// A main street with an X-junction, two T-junctions, a side street with bends, a lane and a dead end; and a feature
/// that is not a line.
pub(crate) const SAMPLE: &str = r#"{ "type": "FeatureCollection", "features": [
    { "type": "Feature", "properties": { "roadway": 11, "sidewalk": 3 }, "geometry": { "type": "LineString", "coordinates": [
        [10.0000, 50.0000], [10.0012, 50.0001], [10.0030, 50.0001]] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "LineString", "coordinates": [
        [10.0012, 50.0010], [10.0012, 50.0001], [10.0013, 49.9993]] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "LineString", "coordinates": [
        [10.0022, 50.0001], [10.0022, 50.0006], [10.0017, 50.0009], [10.0012, 50.0009]] } },
    { "type": "Feature", "properties": { "roadway": 5, "sidewalk": 1.5 }, "geometry": { "type": "LineString", "coordinates": [
        [10.0004, 50.00003], [10.0004, 50.0006], [10.0012, 50.0006]] } },
    { "type": "Feature", "properties": { "roadway": 5, "sidewalk": 0 }, "geometry": { "type": "LineString", "coordinates": [
        [10.0022, 50.0003], [10.0027, 50.0005]] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Point", "coordinates": [10.0, 50.0] } }
] }"#;
