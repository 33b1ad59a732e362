//! Merges points at the same position, bit for bit; -0 equals 0.
//!
//! Uses a hash table with a fixed hash function. An attacker could choose points with equal hashes, so if look-ups take
//! much longer than expected, sorting is used instead, with the same result.

use crate::each::Each;
use crate::small_sort::SmallSort;
use glam::DVec3;

/// For each point the first point at the same position.
pub(crate) fn weld(points: &[DVec3]) -> Vec<u32> {
    by_hash(points).unwrap_or_else(|| by_order(points))
}

fn bits(p: DVec3) -> [u64; 3] {
    (p + 0.0).to_array().each(f64::to_bits)
}

/// `None` if too many points have similar hashes.
fn by_hash(points: &[DVec3]) -> Option<Vec<u32>> {
    /// The limit on steps per slot of the table. Usually there is less than one.
    const MOST_STEPS: usize = 8;
    let size = (points.len().max(4) * 2).next_power_of_two();
    let mut table = vec![u32::MAX; size];
    let mut same = Vec::with_capacity(points.len());
    let mut steps_left = MOST_STEPS * size;
    for (i, &p) in points.iter().enumerate() {
        let key = bits(p);
        let mut hash = key.iter().fold(0u64, |h, &k| (h ^ k).wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(29));
        hash ^= hash >> 32;
        let mut at = hash as usize & (size - 1);
        let first = loop {
            match table[at] {
                u32::MAX => {
                    table[at] = i as u32;
                    break i as u32;
                }
                other if bits(points[other as usize]) == key => break other,
                _ => at = (at + 1) & (size - 1),
            }
            steps_left = steps_left.checked_sub(1)?;
        };
        same.push(first);
    }
    Some(same)
}

fn by_order(points: &[DVec3]) -> Vec<u32> {
    let key = |point: u32| bits(points[point as usize]);
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.small_sort_by_key(|&point| (key(point), point));
    let mut same = vec![0; points.len()];
    for place in order.chunk_by(|&a, &b| key(a) == key(b)) {
        place.iter().for_each(|&point| same[point as usize] = place[0]);
    }
    same
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways_find_the_first_at_each_place() {
        let mut points: Vec<DVec3> =
            (0..1000).map(|i| DVec3::new(f64::from(i % 7), f64::from(i % 5) * -0.5, 1.0)).collect();
        points.push(DVec3::new(-0.0, 0.0, 1.0));
        let first = |p: &DVec3| points.iter().position(|other| other == p).unwrap() as u32;
        let expected: Vec<u32> = points.iter().map(first).collect();
        assert_eq!(by_order(&points), expected);
        assert_eq!(by_hash(&points), Some(expected));
    }

    #[test]
    fn points_made_to_crowd_are_sorted() {
        // The last coordinate cancels the hash of the others.
        const FACTOR: u64 = 0x9E37_79B9_7F4A_7C15;
        let inverse = (0..6).fold(1u64, |x, _| x.wrapping_mul(2u64.wrapping_sub(FACTOR.wrapping_mul(x))));
        let crowd = |i: u32| {
            let (x, y) = (f64::from(i) + 0.5, f64::from(i % 97) + 0.25);
            let hash = [x, y].iter().fold(0u64, |h, k| (h ^ k.to_bits()).wrapping_mul(FACTOR).rotate_left(29));
            DVec3::new(x, y, f64::from_bits(0x1234_5678_0000_0000u64.rotate_right(29).wrapping_mul(inverse) ^ hash))
        };
        let points: Vec<DVec3> = (0..20_000).map(crowd).filter(|p| p.is_finite()).collect();
        assert_eq!(by_hash(&points), None);
        assert!(weld(&points).into_iter().eq(0..points.len() as u32));
    }
}
