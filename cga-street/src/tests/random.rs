//! Random networks.

use super::laws::check;
use super::*;

struct Random(u64);

impl Random {
    fn below(&mut self, most: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % most
    }

    fn number(&mut self, most: f64) -> f64 {
        self.below(1 << 30) as f64 / f64::from(1 << 30) * most
    }
}

/// Lines with small integer coordinates, so that many meet, or with arbitrary ones.
fn lines(random: &mut Random) -> Vec<Centerline> {
    let (count, on_grid, extent) = (1 + random.below(8), random.below(2) == 0, [60.0, 150.0][random.below(2) as usize]);
    let is_flat = random.below(4) != 0;
    let line = |random: &mut Random| {
        let count_of_points = 2 + random.below(4);
        let coordinate = |random: &mut Random| {
            if on_grid { 10.0 * random.below((extent / 10.0) as u64) as f64 } else { random.number(extent) }
        };
        let mut point = || {
            let height = if is_flat { 0.0 } else { coordinate(random) / 10.0 };
            [coordinate(random), height, coordinate(random)]
        };
        let line = Centerline::with_heights(&(0..count_of_points).map(|_| point()).collect::<Vec<_>>());
        match random.below(3) {
            0 => line.roadway(3.0 + random.below(10) as f64).sidewalks(random.below(4) as f64, random.below(4) as f64),
            _ => line,
        }
    };
    (0..count).map(|_| line(random)).collect()
}

#[test]
fn random_networks_are_divided_without_overlaps_and_gaps() {
    let seeds = std::env::var("CGA_STREETS").ok().and_then(|count| count.parse().ok()).unwrap_or(30);
    for seed in 0..seeds {
        let lines = lines(&mut Random(seed * 7919 + 1));
        let network = Network::new(&lines, &NetworkOptions::default()).unwrap();
        check(&network, &format!("seed {seed}"));
    }
}
