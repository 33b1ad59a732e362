//! Laws of scenes: equal bytes on any number of threads, for any order of the lots, and for a scene cut into parts with a margin.

#[cfg(not(feature = "compiled"))]
use cga::Grammar as _;
use cga::{Model, Scene, Settings, Shape, cga};

use crate::rules;

cga! {
    pub(crate) grammar District = r#"
        attr floors = rint(rand(1, 6))
        Lot --> extrude(3 * floors) label("mass") Mass
        Mass --> comp(f) { side : Facade | top : Roof }
        Facade --> split(y) { ~3 : Floor }*
        Floor --> split(x) { ~2.5 : Tile }*
        Tile -->
            case inside(inter) : NIL
            case touches(all) : Wall.
            case minimumDistance(inter, "mass") < 3 : color(0.5, 0.4, 0.3) Small.
            case split.index % 3 == 0 && contextCount(inter, "mass") > 3 : Crowded.
            case p(0.3) : report("terraces", contextCount(all, "top")) print(getTreeKey) Window.
            else : Door.
        Roof --> case contextCompare(inter, "mass", world.highest) == 0 : label("top") Garden.
            case minimumDistance(all, "top") < 4 : Terrace. else : roofGable(30) Tiles.
    "#;
}

/// The distance up to which lots of the parts are neighbours, for both kinds of queries.
const NEAR: f64 = 4.0;

/// Lots of a block: some with party walls, some with gaps, some turned.
pub(crate) fn lots() -> Vec<Shape> {
    let lot = |at: usize| {
        let (row, column) = (at / 7, at % 7);
        let [x, z] = [column as f64 * 9.5, row as f64 * 12.0];
        let lot = if at % 5 == 3 {
            let outline = [[x + 1.0, z + 9.0], [x + 8.0, z + 10.0], [x + 9.0, z + 2.0], [x, z + 1.0]];
            Shape::footprint(&outline, &[]).expect("a lot")
        } else {
            Shape::rectangle(if at.is_multiple_of(3) { 8.0 } else { 9.5 }, 12.0).at([x, 0.0, z])
        };
        lot.seed(at as u64 * 31)
    };
    (0..35).map(lot).collect()
}

/// A grammar, with distances of a finite neighbourhood if `is_near`.
fn scene<'s>(district: &'s District, lots: &'s [Shape], is_near: bool) -> Scene<'s> {
    let scene = Scene::new(district, lots);
    if is_near { scene.occlusion_distance(NEAR).context_distance(NEAR) } else { scene }
}

/// The file and the prints of each model.
fn bytes(scene: &Scene<'_>) -> Vec<(Vec<u8>, Vec<String>)> {
    let batches = scene.generate(&Settings::default()).expect("models");
    let made = |model: Model| (model.to_glb().expect("a file"), crate::lines(&model));
    batches.into_iter().map(|batch| made(crate::clean(batch.sink))).collect()
}

#[test]
fn every_order_of_the_lots_gives_equal_bytes() {
    let (district, lots) = (District::default(), lots());
    for is_near in [false, true] {
        let expected = bytes(&scene(&district, &lots, is_near));
        // 35 has the factors 5 and 7, so each multiple of these steps is an order of all lots.
        for step in [1, 2, 3, 13, 34] {
            let order: Vec<usize> = (0..lots.len()).map(|at| (at * step + 11) % lots.len()).collect();
            let other: Vec<Shape> = order.iter().map(|at| lots[*at].clone()).collect();
            let found = bytes(&scene(&district, &other, is_near));
            assert!(order.iter().zip(&found).all(|(at, found)| *found == expected[*at]), "{order:?}");
        }
    }
}

#[test]
#[cfg(feature = "rayon")]
fn one_two_and_eight_threads_give_equal_bytes() {
    let (district, lots) = (District::default(), lots());
    let scene = scene(&district, &lots, false);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| bytes(&scene))
    };
    let expected = on(1);
    assert!(expected.iter().any(|(_, prints)| !prints.is_empty()));
    assert!([2, 8].into_iter().all(|threads| on(threads) == expected));
}

#[test]
fn parts_with_a_margin_of_the_distance_give_the_bytes_of_the_whole() {
    let (district, lots) = (District::default(), lots());
    let expected = bytes(&scene(&district, &lots, true));
    // The box of a lot in plan.
    rules! { grammar Flat = "Lot --> X."; }
    let plan = |lot: &Shape| {
        let bounds = Flat::default().generate(lot).expect("a model").bounds();
        [[bounds.low.x, bounds.low.z], [bounds.high.x, bounds.high.z]]
    };
    let boxes: Vec<[[f64; 2]; 2]> = lots.iter().map(plan).collect();
    let distance = |a: &[[f64; 2]; 2], b: &[[f64; 2]; 2]| {
        let gap = |axis: usize| (b[0][axis] - a[1][axis]).max(a[0][axis] - b[1][axis]).max(0.0);
        gap(0).hypot(gap(1))
    };
    for cut in [[10.0, 12.0], [33.0, 30.0], [9.5, 24.0]] {
        let quarter = |at: &[[f64; 2]; 2]| [0, 1].map(|axis| cut[axis] <= at[0][axis]);
        for part in [[false, false], [false, true], [true, false], [true, true]] {
            let is_own: Vec<bool> = boxes.iter().map(|own| quarter(own) == part).collect();
            let near =
                |at: &usize| (0..lots.len()).any(|other| is_own[other] && distance(&boxes[*at], &boxes[other]) <= NEAR);
            let kept: Vec<usize> = (0..lots.len()).filter(near).collect();
            let some: Vec<Shape> = kept.iter().map(|at| lots[*at].clone()).collect();
            let found = bytes(&scene(&district, &some, true));
            for (at, found) in kept.iter().zip(&found).filter(|(at, _)| is_own[**at]) {
                assert!(*found == expected[*at], "lot {at}, cut at {cut:?}");
            }
            assert!(is_own.contains(&true) && kept.len() < lots.len(), "{part:?}");
        }
    }
}
