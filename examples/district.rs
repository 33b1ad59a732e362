//! A district from building outlines: `district.glb` and `district.png`. Buildings, streets and gardens are one scene, so walls that touch
//! a neighbour have no windows, shops face a street, and trees stand clear of houses.
//!
//! `cargo run --release --example district -- outlines.geojson` reads GeoJSON polygons in longitude and latitude. The property `start` is
//! `Street`, `Square` or `Garden`; other polygons are buildings. Without a path it uses a small sample of made-up outlines.

use std::error::Error;
use std::io::{IsTerminal, Write};
use std::ops::ControlFlow;
use std::process::ExitCode;
use std::time::Instant;

use cga::sink::picture::Picture;
use cga::{Model, RunError, Scene, Settings, Shape, cga};
use serde_json::Value;

cga! {
    /// A town house on any footprint, with a roof that fits its outline. Storeys, colours and the form of the roof are random
    /// values of each building, from its seed.
    pub grammar House;

    /// The number of storeys above the ground floor.
    @Range(min = 0, max = 30)
    attr storeys = rint(rand(2, 5))
    attr wall = 22% : "#e6d3b1" 20% : "#d8c3a5" 16% : "#c9d1c8" 14% : "#d9b8a0" 12% : "#cfc6bd" else : "#eadfca"
    attr roof = 60% : "#9a5a44" 25% : "#7c4a3c" else : "#5d5f63"
    /// The slope of hips and gables in degrees.
    @Range(min = 10, max = 60)
    attr slope = rand(30, 42)
    /// True if the ground floor has shops.
    attr shops = p(0.4)
    /// True if the building is in a scene, with its neighbours and streets.
    attr neighbours = false

    const ground = 3.9
    const storey = 3.2
    const cornice = 0.45
    const eaves = 0.6
    const tiles = 0.14
    height = ground + storeys * storey + 1
    light = 15% : "#f0d48c" else : "#5b7583"
    leaves = 40% : "#6d8f4e" 35% : "#587d46" else : "#86a05a"
    toStreet = minimumDistance(inter, "street")

    @StartRule
    Lot    --> case geometry.area < 60 : Build(3.2) else : Build(height)
    // Eaves would reach into a neighbour at the same wall.
    Build(h) --> color(wall) Mass(h) extrude(h) Topped(case neighbours && touches(inter) : 0 else : eaves)
    Topped(overhang) --> set(trim.horizontal, false) set(trim.vertical, false) comp(f) { top : alignScopeToAxes(y) Top(overhang) }
    Mass(h) --> extrude(h) split(y) { ~1 : Body | cornice : Cornice }
    Body   --> comp(f) { side : Facade }
    Cornice --> color("#efe9dc") comp(f) { side : Cornice. }

    // Halls and sheds are flat, blocks with a courtyard have hips on both sides, and other houses hips or gables.
    Top(overhang) --> case geometry.area > 4000 : Flat
               case geometry.nHoles > 0 : Hip(overhang)
               case geometry.area > 1500 || geometry.area < 60 : Flat
               case geometry.area < 140 : Shed
               else : Pitched(overhang)
    Pitched(overhang) --> 55% : Gable(overhang) else : Hip(overhang)
    Hip(overhang) --> roofHip(slope, overhang) Planes
    Gable(overhang) --> roofGable(slope, overhang, max(0.02, overhang / 2)) Planes
    Shed   --> roofShed(rand(8, 14)) Planes
    Planes --> comp(f) { isTagged("roof.side") : Pediment | isTagged("roof.bottom") : NIL | all : Plane }
    Pediment --> case scope.sy < 3 : Wall.
               else : split(y) { 0.5 : Wall. | 2.2 : split(x) { ~1 : Wall. | { ~2.8 : Attic }* | ~1 : Wall. } | ~1 : Wall. }
    Attic  --> case geometry.isRectangular(3) && scope.sx > 2 : Bay(0.5, 1.4) else : Wall.
    Plane  --> [ color(roof) t(0, 0, -tiles) extrude(tiles) Tiles. ] Dormers

    // Dormers stand in one row above the eaves, where the plane is long and high enough.
    Dormers --> case scope.sx > 6 && scope.sy > 4.5 && geometry.isRectangular(3) : DormerRow(1.5)
                else : case scope.sx > 14 && scope.sy > 4.5 : DormerRow(4.5) else : NIL
    DormerRow(gap) -->
        split(y) { 1.4 : NIL | 2 : split(x) { gap : NIL | { ~2 : NIL | 1.5 : Dormer | ~2 : NIL }* | gap : NIL } }
    Dormer --> case geometry.isRectangular(3) :
                   alignScopeToAxes(y) primitiveCube color(wall)
                   comp(f) { front : DormerFront | side : Wall. | top : DormerRoof }
               else : NIL
    DormerFront --> split(x) { ~1 : Wall. | 0.9 : split(y) { ~1 : Wall. | ^0.75 : Pane | ~1 : Wall. } | ~1 : Wall. }
    Pane   --> color(light) Glass.
    DormerRoof --> color(roof) roofGable(35) DormerTiles.

    // A flat roof has a parapet and machines.
    Flat   --> offset(-0.4) comp(f) { inside : Terrace | border : Parapet }
    Terrace --> color("#8d8f8c") [ Gravel. ] scatter(surface, 1 + geometry.area / 150, uniform) { Plant }
    Plant  --> s(rand(0.8, 2.6), rand(0.7, 1.8), rand(0.8, 2.6)) primitiveCube center(xz) color("#b9bcbd") Plant.
    Parapet --> extrude(0.8) color("#efe9dc") Parapet.

    Facade --> case scope.sx < 2.6 || scope.sy < 3.5 : Wall.
               case neighbours : Ahead(toStreet)
               else : Free(shops)
    // A side faces a street if three metres ahead are nearer to it.
    Ahead(before) --> t(0, 0, 3) Back(before < 15 && toStreet < before - 0.9)
    Back(faces) --> t(0, 0, -3) Side(faces)
    // A party wall has windows above the roof of the neighbour.
    Side(faces) --> case touches(inter) && !faces : Party else : Free(shops && faces)
    Party  --> split(y) { ground : PartyFloor(1.1, 2.0) | { ~storey : PartyFloor(0.85, 1.75) }* }
    PartyFloor(sill, h) --> split(x) { ~0.4 : Wall. | { ~2.8 : PartyBay(sill, h) }* | ~0.4 : Wall. }
    PartyBay(sill, h) --> case touches(inter) : Wall. else : Bay(sill, h)

    Free(selling) --> split(y) { ground : Ground(selling) | { ~storey : Floor }* }
    Ground(selling) -->
               case selling && scope.sx > 5 : split(x) { 0.5 : Wall. | { ~3.4 : Shop | 0.4 : Wall. }* }
               else : split(x) { ~0.4 : Wall. | { ~2.8 : Bay(1.1, 2.0) }* | ~0.4 : Wall. }
    Shop   --> split(y) { 3 : Display | ~1 : color("#6b4a3a") Sign. }
    Display --> [ t(0, 0, -0.2) color("#39464d") Glass. ]
               set(trim.vertical, false) t(0, 0, -0.2) s(^1, ^1, 0.2) primitiveCube reverseNormals comp(f) { front : NIL | back : NIL | all : Wall. }
    Floor  --> split(x) { ~0.4 : Wall. | { ~2.8 : Bay(0.85, 1.75) }* | ~0.4 : Wall. }
    Bay(sill, h) --> split(x) { ~1 : Wall. | 1.15 : Column(sill, h) | ~1 : Wall. }
    Column(sill, h) --> split(y) { sill : Wall. | h : Window | ~1 : Wall. }
    Window --> [ t(0, 0, -0.12) color(light) Glass. ]
               color("#f4f1ea") split(x) { 0.09 : Frame | ~1 : Middle | 0.09 : Frame }
    Middle --> split(y) { 0.09 : Frame | ~1 : NIL | 0.09 : Frame }
    Frame  --> t(0, 0, -0.12) extrude(0.15) Frame.

    @StartRule
    Street --> label("street") color("#62646a") Roadway.

    @StartRule
    Square --> t(0, -0.1, 0) color("#c6c0b4") Paving.

    // Trees that would grow into a house are left out.
    @StartRule
    Garden --> [ color("#8dab66") Lawn. ] scatter(surface, 1 + geometry.area / 25, uniform) { Tree(rand(3, 5)) }
    Tree(size) --> s(size, 1.8 * size, size) center(xz) primitiveCube Planted
    Planted --> case overlaps(inter) : NIL
                else : [ s(^0.1, ^0.5, ^0.1) center(xz) color("#6b5138") Trunk. ]
                       t(0, ^0.3, 0) s(^1, ^0.7, ^1) primitiveSphere(10, 7) color(leaves) Crown.
}

/// An outline with its holes, in metres: x to the east, z to the south.
pub(crate) struct Footprint {
    label: String,
    /// The start rule.
    pub(crate) start: &'static str,
    outer: Vec<[f64; 2]>,
    holes: Vec<Vec<[f64; 2]>>,
}

impl Footprint {
    /// The initial shape. Its number is its seed.
    pub(crate) fn lot(&self, number: usize) -> Result<Shape, cga::Error> {
        let shape = Shape::footprint(&self.outer, &self.holes)?.seed(number as u64);
        Ok(shape.named(self.label.as_str()).start(self.start))
    }
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
    let (lots, mut skipped) = lots(&text)?;
    let begin = Instant::now();
    let (district, shapes) = derive(&lots, &Settings::default(), |at, model| {
        progress(at + 1, lots.len());
        skipped.extend(model.faults().iter().map(|fault| format!("{}: {fault}", lots[at].name())));
    })?;
    let took = begin.elapsed();

    for line in &skipped {
        eprintln!("{line}");
    }
    district.write_glb("district.glb")?;
    Picture::new(1200, 800).looking_from(25.0, 28.0).render(&district).write_png("district.png")?;
    println!("{} outlines, {} reports, {} shapes", lots.len(), skipped.len(), shapes);
    println!("{} triangles in {:.2} s", district.triangle_count(), took.as_secs_f64());
    println!("wrote district.glb and district.png");
    Ok(())
}

/// The initial shapes of a GeoJSON file, and a line for each feature without one.
pub(crate) fn lots(text: &str) -> Result<(Vec<Shape>, Vec<String>), Box<dyn Error>> {
    let (footprints, mut skipped) = read(text)?;
    let mut lots = Vec::new();
    for (number, footprint) in footprints.iter().enumerate() {
        match footprint.lot(number) {
            Ok(lot) => lots.push(lot),
            Err(error) => skipped.push(format!("{}: skipped: {error}", footprint.label)),
        }
    }
    Ok((lots, skipped))
}

/// The district on its lots, and the number of shapes. `each` gets the number and the model of each lot.
pub(crate) fn derive(
    lots: &[Shape],
    settings: &Settings,
    mut each: impl FnMut(usize, &Model) + Send,
) -> Result<(Model, u64), RunError> {
    let grammar = House { neighbours: true, ..House::default() };
    let mut district = Model::new();
    // Crowns reach further than a metre beyond their garden.
    let report = Scene::new(&grammar, lots).occlusion_distance(4.0).generate_each(settings, |at, model| {
        each(at, &model);
        district.append(&model);
        ControlFlow::Continue(())
    })?;
    Ok((district, report.shapes))
}

fn progress(done: usize, all: usize) {
    let mut out = std::io::stderr();
    if out.is_terminal() {
        let filled = 40 * done / all.max(1);
        let end = if done == all { "\n" } else { "" };
        let _ = write!(out, "\r[{:<40}] {done}/{all}{end}", "#".repeat(filled));
        let _ = out.flush();
    }
}

/// The polygons of a GeoJSON file in metres relative to their middle, and a line for each feature without polygons.
pub(crate) fn read(text: &str) -> Result<(Vec<Footprint>, Vec<String>), Box<dyn Error>> {
    let file: Value = serde_json::from_str(text).map_err(|error| format!("the outlines are not JSON: {error}"))?;
    let features = file["features"].as_array().ok_or("no `features`: is it a GeoJSON feature collection?")?;
    let (mut footprints, mut problems) = (Vec::new(), Vec::new());
    for (number, feature) in features.iter().enumerate() {
        let label = format!("feature {number}");
        let start = match feature["properties"]["start"].as_str() {
            Some("Street") => "Street",
            Some("Garden") => "Garden",
            Some("Square") => "Square",
            _ => "Lot",
        };
        let geometry = &feature["geometry"];
        let polygons: Vec<&Value> = match geometry["type"].as_str() {
            Some("Polygon") => vec![&geometry["coordinates"]],
            Some("MultiPolygon") => geometry["coordinates"].as_array().into_iter().flatten().collect(),
            other => {
                problems.push(format!(
                    "{label}: skipped: {}",
                    other.map_or("no geometry".into(), |kind| format!("a {kind} is not a polygon"))
                ));
                continue;
            }
        };
        for polygon in polygons {
            let rings: Option<Vec<Vec<[f64; 2]>>> =
                polygon.as_array().and_then(|rings| rings.iter().map(ring).collect());
            match rings.map(|mut rings| (!rings.is_empty()).then(|| (rings.remove(0), rings))) {
                Some(Some((outer, holes))) => footprints.push(Footprint { label: label.clone(), start, outer, holes }),
                _ => problems.push(format!("{label}: skipped: its coordinates cannot be read")),
            }
        }
    }
    project(&mut footprints);
    Ok((footprints, problems))
}

/// A ring without the last point, which repeats the first.
fn ring(ring: &Value) -> Option<Vec<[f64; 2]>> {
    let point = |point: &Value| Some([point.get(0)?.as_f64()?, point.get(1)?.as_f64()?]);
    let mut points: Vec<[f64; 2]> = ring.as_array()?.iter().map(point).collect::<Option<_>>()?;
    if 1 < points.len() && points.first() == points.last() {
        points.pop();
    }
    Some(points)
}

/// The metres to the east in a degree of longitude and to the north in a degree of latitude, at a latitude on the
/// ellipsoid WGS 84. Its two radii of curvature differ by up to 0.7 %.
pub(crate) fn metres_a_degree(latitude: f64) -> [f64; 2] {
    const EQUATOR: f64 = 6_378_137.0;
    const FLATTENING: f64 = 1.0 / 298.257_223_563;
    const ECCENTRICITY_SQUARED: f64 = FLATTENING * (2.0 - FLATTENING);
    let (sin, cos) = (libm::sin(latitude.to_radians()), libm::cos(latitude.to_radians()));
    let squared = 1.0 - ECCENTRICITY_SQUARED * sin * sin;
    let east = EQUATOR / squared.sqrt() * cos;
    let north = EQUATOR * (1.0 - ECCENTRICITY_SQUARED) / (squared * squared.sqrt());
    [east.to_radians(), north.to_radians()]
}

/// Converts longitude and latitude to metres east and south of the middle. At the size of a district the earth is
/// flat.
fn project(footprints: &mut [Footprint]) {
    let all = || footprints.iter().flat_map(|footprint| &footprint.outer);
    let (low, high) = all().fold(([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]), |(low, high), p| {
        ([low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])])
    });
    let middle = [(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0];
    let [east, north] = metres_a_degree(middle[1]);
    for footprint in footprints {
        for point in footprint.outer.iter_mut().chain(footprint.holes.iter_mut().flatten()) {
            *point = [(point[0] - middle[0]) * east, (middle[1] - point[1]) * north];
        }
    }
}

/// Made-up buildings, one with a courtyard and some in a row, a street, gardens and a square below them, and two features that cannot be built.
pub(crate) const SAMPLE: &str = r#"{ "type": "FeatureCollection", "features": [
    { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [
        [[10.0000, 50.0000], [10.0006, 50.0000], [10.0006, 50.0004], [10.0000, 50.0004], [10.0000, 50.0000]],
        [[10.0002, 50.00013], [10.0002, 50.00027], [10.0004, 50.00027], [10.0004, 50.00013], [10.0002, 50.00013]] ] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [
        [[10.0008, 50.0000], [10.0012, 50.0000], [10.0012, 50.0001], [10.0009, 50.0001], [10.0009, 50.0003],
         [10.0008, 50.0003], [10.0008, 50.0000]] ] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [
        [[10.0010, 50.00016], [10.0013, 50.00012], [10.00135, 50.0003], [10.00115, 50.00035], [10.0010, 50.0003],
         [10.0010, 50.00016]] ] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [
        [[10.00000, 50.00052], [10.00130, 50.00052], [10.00130, 50.00062], [10.00000, 50.00062], [10.00000, 50.00052]] ] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [
        [[10.00000, 49.99968], [10.00019, 49.99968], [10.00019, 49.99979], [10.00000, 49.99979], [10.00000, 49.99968]] ] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [
        [[10.00019, 49.99968], [10.00038, 49.99968], [10.00038, 49.99977], [10.00019, 49.99977], [10.00019, 49.99968]] ] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [
        [[10.00038, 49.99968], [10.00057, 49.99968], [10.00057, 49.99981], [10.00038, 49.99981], [10.00038, 49.99968]] ] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [
        [[10.00057, 49.99968], [10.00076, 49.99968], [10.00076, 49.99978], [10.00057, 49.99978], [10.00057, 49.99968]] ] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [
        [[10.00095, 49.99968], [10.00114, 49.99968], [10.00114, 49.99978], [10.00095, 49.99978], [10.00095, 49.99968]] ] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [
        [[10.00114, 49.99968], [10.00133, 49.99968], [10.00133, 49.99980], [10.00114, 49.99980], [10.00114, 49.99968]] ] } },
    { "type": "Feature", "properties": { "start": "Street" }, "geometry": { "type": "Polygon", "coordinates": [
        [[9.99990, 49.99957], [10.00140, 49.99957], [10.00140, 49.99965], [9.99990, 49.99965], [9.99990, 49.99957]] ] } },
    { "type": "Feature", "properties": { "start": "Garden" }, "geometry": { "type": "Polygon", "coordinates": [
        [[10.00060, 50.00000], [10.00080, 50.00000], [10.00080, 50.00040], [10.00060, 50.00040], [10.00060, 50.00000]] ] } },
    { "type": "Feature", "properties": { "start": "Garden" }, "geometry": { "type": "Polygon", "coordinates": [
        [[10.00076, 49.99968], [10.00095, 49.99968], [10.00095, 49.99981], [10.00076, 49.99981], [10.00076, 49.99968]] ] } },
    { "type": "Feature", "properties": { "start": "Garden" }, "geometry": { "type": "Polygon", "coordinates": [
        [[10.00000, 49.99982], [10.00130, 49.99982], [10.00130, 49.99997], [10.00000, 49.99997], [10.00000, 49.99982]] ] } },
    { "type": "Feature", "properties": { "start": "Square" }, "geometry": { "type": "Polygon", "coordinates": [
        [[9.99985, 49.99950], [10.00145, 49.99950], [10.00145, 50.00070], [9.99985, 50.00070], [9.99985, 49.99950]] ] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Point", "coordinates": [10.0, 50.0] } },
    { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [
        [[10.0, 50.0], [10.001, 50.0], [10.0, 50.0]] ] } }
] }"#;
