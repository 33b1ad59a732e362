//! The tileset: boxes, errors, addresses, sizes.

use std::collections::BTreeSet;
use std::path::Path;

use cga_city::build::{NoProgress, Options};
use cga_city::glb_bounds::glb_bounds;
use cga_city::rules::Rules;
use cga_geo::synthetic::Town;
use serde_json::Value;

use crate::glb::is_tile;
use crate::town::{build, city, files, options, rules};

type Matrix = [f64; 16];

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|at| (0..4).map(|inner| a[4 * inner + at % 4] * b[4 * (at / 4) + inner]).sum())
}

fn moved(m: &Matrix, [x, y, z]: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|row| m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row])
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let list: Vec<f64> =
        value.as_array().expect("a list").iter().map(|number| number.as_f64().expect("a number")).collect();
    list.try_into().expect("the length")
}

/// A tile with the matrix to the Earth.
struct Walk<'a> {
    folder: &'a Path,
    seen: BTreeSet<String>,
    deepest: usize,
}

impl Walk<'_> {
    /// Checks a tile and returns the corners of its box on the Earth.
    fn tile(&mut self, tile: &Value, file: &Path, outer: &Matrix, most_error: f64, depth: usize) -> Vec<[f64; 3]> {
        self.deepest = self.deepest.max(depth);
        let matrix = tile.get("transform").map_or(*outer, |own| product(outer, &numbers(own)));
        let error = tile["geometricError"].as_f64().expect("an error");
        assert!(error <= most_error, "{error} {most_error}");
        let [e, n, u, x, _, _, _, y, _, _, _, z]: [f64; 12] = numbers(&tile["boundingVolume"]["box"]);
        let inside = |point: [f64; 3]| {
            let local = inverse(&matrix, point);
            (local[0] - e).abs() <= x + 0.01 && (local[1] - n).abs() <= y + 0.01 && (local[2] - u).abs() <= z + 0.01
        };
        if let Some(uri) = tile["content"]["uri"].as_str() {
            let path = file.parent().expect("a folder").join(uri);
            if uri.ends_with(".json") {
                let set: Value = serde_json::from_slice(&std::fs::read(&path).expect("a set")).expect("JSON");
                let corners = self.tile(&set["root"], &path, &matrix, f64::INFINITY, depth);
                assert!(corners.into_iter().all(inside));
            } else {
                let bounds = glb_bounds(&std::fs::read(&path).expect("a tile")).expect("GLB");
                // From y up to z up.
                let corners = bounds.corners().map(|[x, y, z]| moved(&matrix, [x, -z, y]));
                assert!(corners.into_iter().all(inside));
                assert!(
                    self.seen.insert(
                        path.canonicalize()
                            .expect("a path")
                            .strip_prefix(self.folder)
                            .expect("below")
                            .to_string_lossy()
                            .into_owned()
                    )
                );
            }
        }
        for child in tile["children"].as_array().into_iter().flatten() {
            let corners = self.tile(child, file, &matrix, error, depth + 1);
            assert!(corners.into_iter().all(inside), "a child is outside of its parent");
        }
        let corner = |number: usize| {
            let sign = |axis: usize| if number >> axis & 1 == 0 { -1.0 } else { 1.0 };
            moved(&matrix, [e + sign(0) * x, n + sign(1) * y, u + sign(2) * z])
        };
        (0..8).map(corner).collect()
    }
}

/// The point before a rotation and a translation.
fn inverse(m: &Matrix, point: [f64; 3]) -> [f64; 3] {
    let offset = [0, 1, 2].map(|row| point[row] - m[12 + row]);
    [0, 1, 2].map(|axis| (0..3).map(|row| m[4 * axis + row] * offset[row]).sum())
}

const IDENTITY: Matrix = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

fn walk(out: &Path) -> (BTreeSet<String>, usize) {
    let folder = out.canonicalize().expect("a folder");
    let path = folder.join("tileset.json");
    let set: Value = serde_json::from_slice(&std::fs::read(&path).expect("a tileset")).expect("JSON");
    assert_eq!(set["asset"]["version"], "1.1");
    assert_eq!(set["root"]["refine"], "REPLACE");
    let mut walk = Walk { folder: &folder, seen: BTreeSet::new(), deepest: 0 };
    let error = set["geometricError"].as_f64().expect("an error");
    walk.tile(&set["root"], &path, &IDENTITY, error, 0);
    (walk.seen, walk.deepest)
}

#[test]
fn the_tileset_has_each_tile_once_inside_of_its_boxes() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.fgb"), folder.path().join("out"));
    Town::new(2000).write(&lots).expect("room");
    city(&lots, &out);
    let (seen, deepest) = walk(&out);
    let tiles: BTreeSet<String> = files(&out).into_keys().filter(|name| name.ends_with(".glb")).collect();
    assert_eq!(seen, tiles);
    assert!(3 <= deepest);
    assert!(
        tiles.iter().filter(|name| is_tile(name, 1)).count() * 4 < tiles.iter().filter(|name| is_tile(name, 0)).count()
    );
}

#[test]
fn tiles_have_at_most_their_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.fgb"), folder.path().join("out"));
    Town::new(400).write(&lots).expect("room");
    let most_bytes = 20_000;
    let options = Options { most_bytes, lots_per_tile: 64, ..options() };
    let summary = build(&lots, &out, &rules(), options, &NoProgress).expect("a city");
    let rows: u64 = Town::new(400).iter().map(|row| row.polygons.len() as u64).sum();
    assert!(summary.levels.iter().all(|level| level.buildings == rows), "{summary:?}");
    let (seen, _) = walk(&out);
    for (name, bytes) in files(&out).iter().filter(|(name, _)| name.ends_with(".glb")) {
        assert!(bytes.len() as u64 <= most_bytes && seen.contains(name), "{name}: {} bytes", bytes.len());
    }
}

#[test]
fn lots_at_one_place_are_divided_by_number() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("one.geojson"), folder.path().join("out"));
    let feature = |id: u32| {
        format!(
            "{{\"type\":\"Feature\",\"properties\":{{\"id\":{id}}},\"geometry\":{{\"type\":\"Polygon\",\"coordinates\":\
             [[[10,50],[10.0001,50],[10.0001,50.0001],[10,50.0001],[10,50]]]}}}}"
        )
    };
    let features: Vec<String> = (0..100).map(feature).collect();
    std::fs::write(&lots, format!("{{\"type\":\"FeatureCollection\",\"features\":[{}]}}", features.join(",")))
        .expect("room");
    let summary = city(&lots, &out);
    assert_eq!(summary.levels[0].buildings, 100);
    assert!(
        7 <= summary.levels[0].tiles && walk(&out).0.len() as u64 == summary.levels[0].tiles + summary.levels[1].tiles
    );
}

#[test]
fn a_city_on_both_sides_of_the_meridian_of_180_degrees_is_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.fgb"), folder.path().join("out"));
    Town { middle: [180.0, -17.0], ..Town::new(200) }.write(&lots).expect("room");
    let summary = city(&lots, &out);
    assert_eq!(summary.lost, 0);
    assert_eq!(walk(&out).0.len() as u64, summary.levels.iter().map(|level| level.tiles).sum::<u64>());
}

/// The only cell of the map around lots on both sides of its middle is the whole world.
#[test]
fn lots_are_near_the_middle_of_their_tile_wherever_they_are() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.fgb"), folder.path().join("out"));
    for middle in [[0.0, 51.48], [180.0, -17.0], [36.9, 0.0]] {
        Town { middle, ..Town::new(200) }.write(&lots).expect("room");
        assert_eq!(city(&lots, &out).lost, 0);
        let mut count = 0;
        for (name, bytes) in files(&out).iter().filter(|(name, _)| name.starts_with("tiles") && name.ends_with("json"))
        {
            let tile: Value = serde_json::from_slice(bytes).expect("JSON");
            let corners = tile["bounds"].as_array().into_iter().flatten();
            for number in corners.flat_map(|corner| corner.as_array().expect("a corner")) {
                let metres = number.as_f64().expect("a number");
                assert!(metres.abs() < 15_000.0, "{name} around {middle:?}: {metres} m");
                count += 1;
            }
        }
        assert!(0 < count, "the tiles have boxes");
    }
}

#[test]
fn far_tiles_without_normals_are_small_and_have_all_buildings() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, lit, plain) = (folder.path().join("town.fgb"), folder.path().join("lit"), folder.path().join("plain"));
    Town::new(400).write(&lots).expect("room");
    let make = |out: &Path, plain_far: bool| {
        let options = Options { plain_far, lots_per_tile: 256, ..options() };
        build(&lots, out, &rules(), options, &NoProgress).expect("a city")
    };
    let (first, second) = (make(&lit, false), make(&plain, true));
    assert_eq!(first.levels[0], second.levels[0]);
    let each = |summary: &cga_city::build::Summary| summary.levels[1].bytes / summary.levels[1].buildings;
    assert!(each(&second) <= 330 && 3 * each(&second) < 2 * each(&first), "{} {}", each(&first), each(&second));
    for (name, bytes) in files(&plain).iter().filter(|(name, _)| name.ends_with(".glb")) {
        let text = cga_city::glb_bounds::json(bytes).expect("GLB").to_string();
        assert_eq!(text.contains("NORMAL"), is_tile(name, 0), "{name}");
    }
    let names = |out: &Path| {
        let far = files(out).into_iter().filter(|(name, _)| is_tile(name, 1));
        let buildings = far.flat_map(|(_, bytes)| crate::glb::Glb::new(&bytes).buildings());
        buildings.map(|building| (building.name, building.y.map(f32::round))).collect::<Vec<_>>()
    };
    assert_eq!(names(&plain).len() as u64, second.levels[1].buildings);
    let sorted = |out: &Path| {
        let mut list = names(out);
        list.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
        list
    };
    assert_eq!(sorted(&plain), sorted(&lit));
}

#[test]
fn near_tiles_are_watertight_and_far_ones_are_not() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out, rules) =
        (folder.path().join("one.fgb"), folder.path().join("out"), folder.path().join("walls.cga"));
    Town::new(1).write(&lots).expect("room");
    // A storey with wide bays below one with narrow ones, nearby and far away.
    let walls = "@StartRule Lot --> extrude(6) comp(f) { side : Wall | all : Roof. }
        Wall --> split(y) { '0.5 : Bays(2) | ~1 : Bays(3) }
        Bays(n) --> split(x) { { '1 / n : Bay. }* }
        @StartRule Far --> Lot";
    std::fs::write(&rules, walls).expect("room");
    let rules = Rules::open(&[&rules]).expect("good rules");
    let options = Options { levels: vec!["Far".parse().expect("a rule")], watertight_near: true, ..options() };
    let summary = build(&lots, &out, &rules, options, &NoProgress).expect("a city");
    assert_eq!(summary.lost, 0, "{summary:?}");
    let corners = |level| -> u64 {
        let files = files(&out).into_iter().filter(|(name, _)| is_tile(name, level));
        files.map(|(_, bytes)| triangle_corners(&bytes)).sum()
    };
    // On each side, two corners of the bays above are in edges below, and one the other way round: three triangles more.
    let [near, far] = [corners(0), corners(1)];
    let sides = (near - far) / 9;
    assert_eq!((near - far) % 9, 0, "{near} {far}");
    assert!(4 <= sides, "{near} {far}");
}

/// The number of the corners of all triangles of a file.
fn triangle_corners(bytes: &[u8]) -> u64 {
    let json = cga_city::glb_bounds::json(bytes).expect("GLB");
    let primitives = json["meshes"].as_array().expect("meshes").iter().flat_map(|mesh| {
        mesh["primitives"].as_array().expect("primitives").iter().map(|primitive| primitive["indices"].as_u64())
    });
    primitives
        .map(|index| {
            let accessor = &json["accessors"][index.expect("an index") as usize];
            accessor["count"].as_u64().expect("a count")
        })
        .sum()
}
