//! Windows of houses that stand wall to wall, compared with a search of all pairs.
//!
//! `CGA_OUTLINES=outlines.geojson cargo test -p cga-tests --test language given_outlines -- --nocapture` reads other outlines: polygons of a
//! collection in longitude and latitude. It prints its figures.

use cga::glam::{DVec2, DVec3};
use cga::mesh::Bounds;
use cga::{Model, Scene, Settings, Shape, cga};
use cga_tests::metres_a_degree;
use serde_json::Value;

cga! {
    grammar Terrace = r#"
        attr height = 6
        Lot --> extrude(height) comp(f) { side : Facade | top : Roof. | bottom : NIL }
        Facade --> split(y) { ~3 : Floor }*
        Floor --> split(x) { ~2 : Tile }*
        Tile --> case touches(inter) : Wall. else : Window.
    "#;
}

fn models(lots: &[Shape]) -> Vec<Model> {
    let batches = Scene::new(&Terrace::default(), lots).generate(&Settings::default()).expect("models");
    batches.into_iter().map(|batch| batch.sink).collect()
}

/// A house of a row: its box.
fn house(row: usize, at: usize) -> Bounds {
    // Widths of 6, 7 and 8 m, and heights from 6 to 18 m.
    let width = |at: usize| 6.0 + (at * 5 % 3) as f64;
    let x: f64 = (0..at).map(width).sum();
    let height = 6.0 + ((at * 7 + row * 3) % 5) as f64 * 3.0;
    let low = DVec3::new(x, 0.0, row as f64 * 20.0);
    Bounds { low, high: low + DVec3::new(width(at), height, 10.0) }
}

/// The lot of a house.
fn lot(house: &Bounds) -> Shape {
    let size = house.high - house.low;
    Shape::rectangle(size.x, size.z).at(house.low.to_array()).attribute("height", size.y)
}

/// Returns true if a flat tile and a box have an area in common.
fn has_contact(tile: &Bounds, solid: &Bounds) -> bool {
    let common = tile.high.min(solid.high) - tile.low.max(solid.low);
    let sides = common.to_array().into_iter().filter(|extent| 1e-3 < *extent).count();
    -1e-6 <= common.min_element() && sides == 2
}

/// The tiles of a model: its box, and true for a window.
fn tiles(model: &Model) -> impl Iterator<Item = (Bounds, bool)> + '_ {
    let facade = model.leaves().filter(|leaf| ["Window", "Wall"].contains(&leaf.rule()));
    facade.map(|leaf| (leaf.bounds(), leaf.rule() == "Window"))
}

#[test]
fn party_walls_have_no_windows_up_to_the_roof_of_the_neighbour() {
    let houses: Vec<Bounds> = (0..3).flat_map(|row| (0..8).map(move |at| house(row, at))).collect();
    let lots: Vec<Shape> = houses.iter().map(lot).collect();
    let (mut windows, mut walls) = (0, 0);
    for (at, model) in models(&lots).iter().enumerate() {
        for (tile, is_window) in tiles(model) {
            let others = houses.iter().enumerate().filter(|(other, _)| *other != at);
            let is_hidden = others.into_iter().any(|(_, other)| has_contact(&tile, other));
            assert_eq!(is_window, !is_hidden, "{at}: {tile:?}");
            *(if is_window { &mut windows } else { &mut walls }) += 1;
        }
    }
    assert!(100 < walls && 500 < windows, "{walls} {windows}");
}

#[test]
fn without_a_house_its_neighbours_alone_get_windows() {
    let houses: Vec<Bounds> = (0..3).flat_map(|row| (0..8).map(move |at| house(row, at))).collect();
    let lots: Vec<Shape> = houses.iter().map(lot).collect();
    let before = models(&lots);
    let windows = |model: &Model| model.count("Window");
    for removed in [0, 3, 7, 12, 16, 23] {
        let affected = Scene::new(&Terrace::default(), &lots).affected_by(removed, &Settings::default());
        let mut rest = lots.clone();
        rest.remove(removed);
        let after = models(&rest);
        let after = |at: usize| &after[if at < removed { at } else { at - 1 }];
        let changed: Vec<usize> = (0..lots.len()).filter(|at| *at == removed || before[*at] != *after(*at)).collect();
        assert_eq!(affected, Ok(changed.clone()), "{removed}");
        assert!(1 < changed.len() && changed.len() <= 3);
        for at in changed.into_iter().filter(|at| *at != removed) {
            assert!(windows(&before[at]) < windows(after(at)), "{at} beside {removed}");
        }
    }
}

/// The answers of scenes for outlines of any form, and of a search of all pairs of tiles and outlines.
#[derive(Debug, Default)]
struct Found {
    tiles: usize,
    walls: usize,
    /// Tiles whose samples do not agree, or are near the border of an outline.
    unclear: usize,
    differences: usize,
}

/// A simple polygon in plan, and the height of its house.
struct Outline {
    corners: Vec<DVec2>,
    height: f64,
}

impl Outline {
    /// The distance to the border, negative inside.
    fn distance(&self, point: DVec2) -> f64 {
        let (mut nearest, mut is_inside) = (f64::INFINITY, false);
        for (at, &a) in self.corners.iter().enumerate() {
            let b = self.corners[(at + 1) % self.corners.len()];
            let along = ((point - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            nearest = nearest.min(point.distance(a + (b - a) * along));
            if (a.y <= point.y) != (b.y <= point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y) {
                is_inside = !is_inside;
            }
        }
        if is_inside { -nearest } else { nearest }
    }
}

/// Compares the tiles of all houses with samples of them. A tile is hidden if a stretch of it is inside or on the border of another outline,
/// below its roof.
fn compare(outlines: &[Outline]) -> Found {
    let lot = |outline: &Outline| {
        let corners: Vec<[f64; 2]> = outline.corners.iter().map(|corner| corner.to_array()).collect();
        Shape::footprint(&corners, &[]).expect("an outline").attribute("height", outline.height)
    };
    let lots: Vec<Shape> = outlines.iter().map(lot).collect();
    let mut found = Found::default();
    for (at, model) in models(&lots).iter().enumerate() {
        for leaf in model.leaves().filter(|leaf| ["Window", "Wall"].contains(&leaf.rule())) {
            let scope = leaf.scope();
            let end = scope.origin + scope.axes.x_axis * scope.size.x;
            let (mut is_hidden, mut is_clear) = (false, true);
            for (_, other) in outlines.iter().enumerate().filter(|(other, _)| *other != at) {
                // The tile begins below the roof by more than the tolerance.
                if other.height <= scope.origin.y + 0.01 {
                    is_clear &= other.height <= scope.origin.y - 0.01 || scope.origin.y + 1e-6 <= other.height + 0.01;
                    continue;
                }
                let sample = |step: i32| {
                    let point = scope.origin.lerp(end, (f64::from(step) + 0.5) / 40.0);
                    other.distance(DVec2::new(point.x, point.z))
                };
                let samples: Vec<f64> = (0..40).map(sample).collect();
                // A common stretch of two samples is wider than the tolerance; a gap between 0.1 and 10 mm is not decided here.
                let near = samples.windows(2).filter(|pair| pair.iter().all(|gap| *gap <= 1e-4)).count();
                let unsure = samples.windows(2).filter(|pair| pair.iter().all(|gap| *gap <= 1e-2)).count();
                is_hidden |= 1 < near;
                is_clear &= 1 < near || unsure == 0 && samples.iter().all(|gap| 1e-2 < *gap);
            }
            found.tiles += 1;
            found.walls += usize::from(leaf.rule() == "Wall");
            found.unclear += usize::from(!is_clear && !is_hidden);
            found.differences += usize::from((is_clear || is_hidden) && is_hidden != (leaf.rule() == "Wall"));
        }
    }
    found
}

/// Made-up blocks: houses of all forms around corners, turned, with party walls that are equal up to rounding.
fn block(degrees: f64) -> Vec<Outline> {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    let turned = |[x, z]: [f64; 2]| DVec2::new(500.0 + x * cos + z * sin, 300.0 - x * sin + z * cos);
    let forms: [&[[f64; 2]]; 7] = [
        &[[0.0, 0.0], [12.0, 0.0], [12.0, 6.0], [7.0, 6.0], [7.0, 11.0], [0.0, 11.0]],
        &[[12.0, 0.0], [19.0, 0.0], [20.0, 9.0], [13.0, 9.0], [12.0, 6.0]],
        &[[19.0, 0.0], [31.0, 0.0], [31.0, 12.0], [24.0, 12.0], [24.0, 8.5], [20.0, 9.0]],
        &[[31.0, 12.0], [31.0, 20.0], [22.0, 21.0], [24.0, 12.0]],
        &[[31.0, 20.0], [31.0, 30.0], [16.0, 30.0], [16.0, 22.0], [22.0, 21.0]],
        &[[16.0, 30.0], [0.0, 30.0], [0.0, 19.0], [9.0, 19.0], [9.0, 22.0], [16.0, 22.0]],
        &[[0.0, 19.0], [0.0, 11.0], [7.0, 11.0], [7.0, 19.0]],
    ];
    let corners = |form: &[[f64; 2]]| form.iter().rev().map(|corner| turned(*corner)).collect();
    let heights = [9.0, 15.0, 12.5, 6.0, 18.0, 10.0, 15.0];
    forms.iter().zip(heights).map(|(form, height)| Outline { corners: corners(form), height }).collect()
}

#[test]
fn tiles_of_made_up_blocks_equal_a_search_of_all_pairs() {
    for degrees in [0.0, 12.5, 45.0, 77.0, 200.3] {
        let found = compare(&block(degrees));
        assert!(found.differences == 0 && 60 < found.walls && 200 < found.tiles, "{degrees}: {found:?}");
        assert!(found.unclear * 10 < found.tiles, "{degrees}: {found:?}");
    }
}

#[test]
fn tiles_of_given_outlines_equal_a_search_of_all_pairs() {
    let Some(path) = std::env::var_os("CGA_OUTLINES") else { return };
    let text = std::fs::read_to_string(path).expect("a file of outlines");
    let all: Value = serde_json::from_str(&text).expect("a collection of polygons");
    let ring = |feature: &Value| -> Vec<DVec2> {
        let corners = feature["geometry"]["coordinates"][0].as_array().expect("a polygon");
        let corner = |corner: &Value| DVec2::new(corner[0].as_f64().expect("x"), corner[1].as_f64().expect("y"));
        corners.iter().skip(1).map(corner).collect()
    };
    let rings: Vec<Vec<DVec2>> = all["features"].as_array().expect("features").iter().map(ring).collect();
    let origin = rings[0][0];
    let scale = DVec2::from_array(metres_a_degree(origin.y)) * DVec2::new(1.0, -1.0);
    let outline = |(at, ring): (usize, &Vec<DVec2>)| {
        let corners = ring.iter().map(|corner| (*corner - origin) * scale).collect();
        Outline { corners, height: 9.0 + (at * 7 % 5) as f64 * 3.0 }
    };
    let outlines: Vec<Outline> = rings.iter().enumerate().map(outline).collect();
    let found = compare(&outlines);
    println!("{} outlines: {found:?}", outlines.len());
    assert_eq!(found.differences, 0);
}
