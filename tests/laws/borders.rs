//! Pieces of one split, and neighbours inside and outside of a repeat, share their corners.

use std::collections::BTreeMap;

use cga::glam::{DVec3, dvec3};
use cga::sink::buffers::Buffers;
use cga::{Model, Repeats, Settings, Shape, cga};

use crate::random::Random;

cga! {
    grammar Walls;
    attr bay = 2.5
    attr floor_h = 3.0
    attr sill = 0.9
    Lot    --> extrude(12.3) comp(f) { side : Facade | all : NIL }
    Facade --> split(y) { 4 : Ground | { ~floor_h : Floor }* }
    Ground --> split(x) { { ~bay : Wall. }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~bay : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { sill : Wall. | ~1.5 : Window | ~0.8 : Wall. }
    Window --> split(x) { 0.1 : Frame. | ~1 : Glass. | 0.1 : Frame. }
}

/// Corners of leaves that are at one place of a façade.
#[derive(Default)]
struct Tally {
    /// Places with several corners.
    places: usize,
    /// Those whose corners differ in f64, and the largest distance.
    apart: usize,
    distance: f64,
    /// Those whose corners differ in the buffers, and the largest distance. Near 0 the buffers have the rounding of f64.
    cracks: usize,
    gap: f64,
}

impl Tally {
    fn add(&mut self, walls: &Walls, shape: &Shape, repeats: Repeats) {
        let settings = Settings { repeats, ..Settings::default() };
        let (mut model, mut buffers) = (Model::new(), Buffers::new());
        assert!(walls.run(shape, &settings, &mut model).is_ok());
        assert!(walls.run(shape, &settings, &mut buffers).is_ok());
        let corners = model.leaves().flat_map(|leaf| {
            let (mesh, placement) = leaf.mesh();
            mesh.points().iter().map(|point| placement.transform_point3(*point)).collect::<Vec<_>>()
        });
        // Each leaf is a rectangle, in the buffers as well.
        let corners: Vec<DVec3> = corners.collect();
        assert_eq!(corners.len(), buffers.vertices().len());
        let mut places: BTreeMap<[i64; 3], Vec<(DVec3, DVec3)>> = BTreeMap::new();
        for (at, &[x, y, z, ..]) in buffers.vertices().iter().enumerate() {
            let written = dvec3(x.into(), y.into(), z.into());
            // The buffers begin a rectangle at another corner.
            let leaf = &corners[at / 4 * 4..][..4];
            let near = |a: &&DVec3, b: &&DVec3| a.distance(written).total_cmp(&b.distance(written));
            let corner = *leaf.iter().min_by(near).expect("four corners");
            assert!(corner.distance(written) <= 1e-7 * (1.0 + corner.length()));
            let place = corner.to_array().map(|x| (x * 1e6).round() as i64);
            places.entry(place).or_default().push((corner, written));
        }
        for corners in places.into_values().filter(|corners| 1 < corners.len()) {
            let far = |of: fn(&(DVec3, DVec3)) -> DVec3| {
                corners.iter().map(|it| of(it).distance(of(&corners[0]))).fold(0.0, f64::max)
            };
            let (distance, gap) = (far(|it| it.0), far(|it| it.1));
            self.places += 1;
            self.apart += usize::from(0.0 < distance);
            self.distance = self.distance.max(distance);
            self.cracks += usize::from(0.0 < gap);
            self.gap = self.gap.max(gap);
        }
    }
}

/// Random lots at a distance from the origin, turned or along the axes.
fn lots(random: &mut Random, far: f64, is_turned: bool, grain: f64) -> (Walls, Shape) {
    let mut length = |least: usize, most: usize| ((least + random.below(most - least)) as f64 * grain).max(grain);
    let steps = |metres: f64| (metres / grain) as usize;
    let [a, b] = [length(steps(4.0), steps(30.0)), length(steps(4.0), steps(30.0))];
    let bay = length(steps(2.0), steps(4.0));
    let walls = Walls { bay, floor_h: length(steps(2.5), steps(4.0)), sill: length(steps(0.3), steps(1.2)) };
    let angle = if is_turned { random.below(6283) as f64 / 1000.0 } else { 0.0 };
    let (cos, sin) = (libm::cos(angle), libm::sin(angle));
    let at = [0; 2].map(|_| (far * (random.below(2000) as f64 / 1000.0 - 1.0) / grain).round() * grain);
    let outline = [[0.0, 0.0], [a, 0.0], [a, b], [0.0, b]].map(|[x, z]| [x * cos - z * sin, x * sin + z * cos]);
    (walls, Shape::footprint(&outline, &[]).expect("an outline").at([at[0], 0.0, at[1]]))
}

/// Corners at one place differ by rounding in f64: each is the sum of its own piece. They are equal in f32, but near 0, where
/// f32 has room for the rounding: nothing that could be seen.
#[test]
fn neighbours_share_the_corners_of_their_border() {
    let lots_each = if cfg!(debug_assertions) { 4 } else { 100 };
    for far in [0.0, 1000.0, 100_000.0] {
        // Two roundings of the largest coordinate.
        let rounding = 2.0 * f64::EPSILON * (2.0 * far + 45.0);
        for (is_turned, grain) in [(false, 0.01), (true, 0.01), (false, 1.0 / 64.0), (true, 1.0 / 64.0)] {
            for repeats in [Repeats::Kept, Repeats::Direct] {
                let (mut random, mut sum) = (Random(7), Tally::default());
                for _ in 0..lots_each {
                    let (walls, shape) = lots(&mut random, far, is_turned, grain);
                    sum.add(&walls, &shape, repeats);
                }
                let Tally { places, apart, distance, cracks, gap } = sum;
                println!(
                    "up to {far} m away, turned: {is_turned}, {repeats:?}: {places} places, {apart} apart by up to \
                     {distance:.1e} in f64, {cracks} by up to {gap:.1e} in f32"
                );
                assert!(300 * lots_each < places);
                assert!(
                    distance <= rounding && gap <= rounding,
                    "{distance} and {gap} m apart; rounding is {rounding}"
                );
            }
        }
    }
}
