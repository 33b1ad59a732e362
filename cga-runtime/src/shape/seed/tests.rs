use super::*;

#[test]
fn values_are_held_still() {
    let child = |value, tag| Seed::new(value).child(tag, 7).value();
    assert_ne!(child(1, Tag::Split), child(1, Tag::Comp));
    assert_ne!(child(1, Tag::Split), child(2, Tag::Split));
    assert_eq!(child(1, Tag::Split), GOLDEN_CHILD, "a change here changes every generated model");
    let mut seed = Seed::new(1);
    let drawn: Vec<f64> = (0..3).map(|_| seed.draw()).collect();
    assert_eq!(drawn, GOLDEN, "a change here changes every generated model");
}

const GOLDEN_CHILD: u64 = 1_659_810_704_615_153_772;
const GOLDEN: [f64; 3] = [0.5540560376705036, 0.1910159942178482, 0.2710719467463243];

/// The first number that a seed draws.
fn first(seed: u64) -> f64 {
    Seed::new(seed).draw()
}

/// The chi-square of the counts of numbers in equal bins, with its degrees of freedom.
fn chi_square(numbers: impl Iterator<Item = f64>, bins: usize) -> (f64, f64) {
    let mut counts = vec![0u32; bins];
    let mut total = 0.0;
    for number in numbers {
        counts[(number * bins as f64) as usize] += 1;
        total += 1.0;
    }
    let expected = total / bins as f64;
    let sum = counts.iter().map(|&count| (f64::from(count) - expected).powi(2) / expected).sum();
    (sum, bins as f64 - 1.0)
}

/// Fails beyond five standard deviations on either side: numbers that are too even are as wrong as uneven ones.
#[track_caller]
fn assert_even(what: &str, numbers: impl Iterator<Item = f64>) {
    let (sum, freedom) = chi_square(numbers, 256);
    let off = (sum - freedom) / (2.0 * freedom).sqrt();
    assert!(off.abs() < 5.0, "{what}: chi-square {sum:.0} of {freedom}");
}

/// Fails where the numbers of neighbours in a sequence depend on each other.
#[track_caller]
fn assert_independent(what: &str, numbers: &[f64]) {
    let pairs = numbers.windows(2).map(|pair| {
        let cell = (pair[0] * 16.0).floor() * 16.0 + (pair[1] * 16.0).floor();
        (cell + 0.5) / 256.0
    });
    assert_even(what, pairs);
    let mean = numbers.iter().sum::<f64>() / numbers.len() as f64;
    let variance: f64 = numbers.iter().map(|number| (number - mean).powi(2)).sum();
    let covariance: f64 = numbers.windows(2).map(|pair| (pair[0] - mean) * (pair[1] - mean)).sum();
    let off = covariance / variance * (numbers.len() as f64).sqrt();
    assert!(off.abs() < 5.0, "{what}: correlation {off:.1} standard deviations");
}

fn step(parent: u64, key: u64) -> u64 {
    Seed::new(parent).step(key).value()
}

fn part(step: u64, slot: u32, turn: u64) -> u64 {
    Seed::new(step).part(slot, turn).value()
}

/// All seeds of a tree of splits: `slots` slots in `turns` repetitions at each of `levels` levels.
fn tree(root: u64, levels: u32, slots: u32, turns: u64) -> Vec<u64> {
    let mut list = vec![root];
    for _ in 0..levels {
        let parts = |seed: u64| {
            let step = step(seed, key(Tag::Split, 0));
            (0..turns).flat_map(move |turn| (0..slots).map(move |slot| part(step, slot, turn)))
        };
        list = list.into_iter().flat_map(parts).collect();
    }
    list
}

#[test]
fn numbers_of_one_shape_are_even_and_independent() {
    for seed in [0, 1, 2, 42, u64::MAX] {
        let mut seed = Seed::new(seed);
        let numbers: Vec<f64> = (0..100_000).map(|_| seed.draw()).collect();
        assert_even("draws", numbers.iter().copied());
        assert_independent("draws", &numbers);
    }
}

#[test]
fn siblings_are_even_and_independent() {
    for root in [0, 1, 7, 1 << 40] {
        let slots: Vec<f64> = (0..100_000).map(|slot| first(part(step(root, key(Tag::Split, 0)), slot, 0))).collect();
        let turns: Vec<f64> = (0..100_000).map(|turn| first(part(step(root, key(Tag::Split, 0)), 1, turn))).collect();
        for (what, numbers) in [("slots", slots), ("turns", turns)] {
            assert_even(what, numbers.iter().copied());
            assert_independent(what, &numbers);
        }
    }
}

#[test]
fn initial_shapes_with_neighbouring_seeds_are_independent() {
    let numbers: Vec<f64> = (0..200_000).map(first).collect();
    assert_even("lots", numbers.iter().copied());
    assert_independent("lots", &numbers);
    let faces: Vec<f64> = (0..50_000)
        .flat_map(|lot| (0..4).map(move |face| first(part(step(lot, key(Tag::Comp, 0)), face, 0))))
        .collect();
    assert_even("faces", faces.iter().copied());
    assert_independent("faces", &faces);
}

#[test]
fn cousins_and_depths_are_even_and_independent() {
    for (levels, slots, turns) in [(4, 3, 6), (8, 2, 2), (17, 2, 1), (2, 10, 40)] {
        let numbers: Vec<f64> = tree(3, levels, slots, turns).into_iter().map(first).collect();
        assert_even("a tree", numbers.iter().copied());
        assert_independent("a tree", &numbers);
    }
    // A shape, its first part, the first part of that, …
    let mut seed = 5;
    let chain: Vec<f64> = (0..100_000)
        .map(|_| {
            seed = part(step(seed, key(Tag::Split, 0)), 0, 0);
            first(seed)
        })
        .collect();
    assert_even("a chain", chain.iter().copied());
    assert_independent("a chain", &chain);
}

#[test]
fn no_two_shapes_share_a_seed() {
    // Of n seeds in 64 bits n²/2⁶⁵ pairs collide by chance: none of these.
    let mut all = Vec::new();
    for root in 0..20 {
        for levels in 1..=4 {
            all.extend(tree(root, levels, 4, 4));
        }
        for tag in [Tag::Successor, Tag::Split, Tag::Comp, Tag::Push, Tag::Global, Tag::Candidate] {
            all.extend((1..200).map(|number| Seed::new(root).child(tag, number).value()));
        }
    }
    let count = all.len();
    all.sort_unstable();
    all.dedup();
    assert_eq!(all.len(), count);
}

#[test]
fn first_numbers_collide_as_often_as_random_ones() {
    // 2¹⁵ numbers in 2²⁴ places: 32 collisions are expected.
    for (levels, slots, turns) in [(3, 8, 4), (15, 2, 1), (5, 2, 4)] {
        let mut places: Vec<u64> =
            tree(11, levels, slots, turns).into_iter().map(|seed| (first(seed) * f64::from(1 << 24)) as u64).collect();
        let count = places.len();
        assert_eq!(count, 1 << 15);
        places.sort_unstable();
        places.dedup();
        assert!((8..=64).contains(&(count - places.len())), "{}", count - places.len());
    }
}

#[test]
fn a_seed_is_its_factor_times_the_first_seed_and_a_sum() {
    let below = |first: Seed, levels: u32| {
        let level = |seed: Seed, level| seed.step(key(Tag::Split, level)).part(level, 5).child(Tag::Push, 1);
        (0..levels).fold(first, level)
    };
    for levels in 0..5 {
        let sum = below(Seed::new(0), levels).value();
        for first in [1, 7, u64::MAX] {
            let seed = below(Seed::new(first), levels);
            assert_eq!(seed.value(), seed.factor().wrapping_mul(first).wrapping_add(sum));
            assert_eq!(below(Seed::set(first), levels).factor(), 0);
        }
    }
}
