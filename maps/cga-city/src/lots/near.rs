//! Footprints near an area: the lots around a tile.

use std::io;
use std::ops::Range;

use cga_geo::footprint::Footprint;

use super::Lots;
use crate::area::{Area, CLASSES};

/// The most lots around a tile.
pub(crate) const MOST_NEAR: usize = 1 << 15;

/// The most entries of the index that are read for an area.
const MOST_READ: u64 = 1 << 18;

/// Large footprints, which may touch an area from far away: keys and numbers in ascending order, for each class after the first. Almost all
/// buildings are in the first class, so these lists are short.
#[derive(Debug, Default)]
pub(super) struct Large {
    of_class: [Vec<(u64, u64)>; CLASSES.len() - 1],
}

impl Large {
    /// Adds a footprint. Keys and numbers do not fall.
    pub(super) fn add(&mut self, class: u8, key: u64, number: u64) {
        let Some(at) = CLASSES.iter().position(|known| *known == class).and_then(|at| at.checked_sub(1)) else {
            return;
        };
        self.of_class[at].push((key, number));
    }
}

/// A footprint with its digest.
pub(crate) type Near = ([u8; 32], Footprint);

impl Lots {
    /// The footprints whose boxes touch an area, without the numbers in a range, by id, then by digest. `None` if there are more than
    /// [`MOST_NEAR`]. The result depends on the footprints alone.
    ///
    /// # Errors
    /// Errors of the file system.
    pub(crate) fn near(&self, area: &Area, without: Range<u64>) -> io::Result<Option<Vec<Near>>> {
        let Some(mut numbers) = self.near_small(area)? else { return Ok(None) };
        for (large, class) in self.large.of_class.iter().zip(&CLASSES[1..]) {
            let wide = area.of_class(*class);
            for Range { start, end } in wide.keys() {
                let [from, to] = [start, end].map(|key| large.partition_point(|(known, _)| *known < key));
                let inside = large[from..to].iter().filter(|(key, _)| wide.has(*key));
                numbers.extend(inside.map(|(_, number)| *number));
                if MOST_READ < numbers.len() as u64 {
                    return Ok(None);
                }
            }
        }
        numbers.retain(|number| !without.contains(number));
        numbers.sort_unstable();
        numbers.dedup();
        let mut found = Vec::new();
        for run in numbers.chunk_by(|a, b| a + 1 == *b) {
            let Some(last) = run.last() else { continue };
            let near = self.with_digests(run[0]..last + 1)?;
            found.extend(near.into_iter().filter(|(_, footprint)| area.touches(&Area::of(footprint))));
            if MOST_NEAR < found.len() {
                return Ok(None);
            }
        }
        found.sort_by(|(a_digest, a), (b_digest, b)| a.id.cmp(&b.id).then(a_digest.cmp(b_digest)));
        Ok(Some(found))
    }

    /// The numbers of footprints of all classes that touch an area if they are in the first class. `None` if they are too many.
    fn near_small(&self, area: &Area) -> io::Result<Option<Vec<u64>>> {
        let (wide, mut numbers, mut read) = (area.of_class(CLASSES[0]), Vec::new(), 0);
        for Range { start, end } in wide.keys() {
            let from = self.before(start, 0..self.len())?;
            let to = self.before(end, from..self.len())?;
            read += to - from;
            if MOST_READ < read {
                return Ok(None);
            }
            let entries = self.entries(from..to)?;
            numbers.extend((from..to).zip(entries).filter(|(_, entry)| wide.has(entry.key)).map(|(number, _)| number));
        }
        Ok(Some(numbers))
    }
}

#[cfg(test)]
mod tests {
    use cga_geo::frame::metres_a_degree;
    use cga_geo::outline::Corner;

    use super::*;
    use crate::lots::Sorter;

    fn rectangle(id: usize, [longitude, latitude]: Corner, metres: [f64; 2]) -> Footprint {
        let degree = metres_a_degree(latitude);
        let [east, north] = [0, 1].map(|axis| metres[axis] / degree[axis]);
        let ring = [[0.0, 0.0], [east, 0.0], [east, north], [0.0, north]];
        let rings = vec![ring.map(|[x, y]| [longitude + x, latitude + y]).to_vec()];
        let (id, seed) = (format!("{id:04}"), id as u64);
        Footprint { id, seed, grammar: None, start: None, values: Vec::new(), rings, base: 0.0 }
    }

    #[test]
    fn near_footprints_are_found_as_a_search_of_all_finds_them() {
        let mut random = 7u64;
        let mut number = || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 11) as f64 / (1u64 << 53) as f64
        };
        // On both sides of the meridian of 180 degrees; each ninth one is large.
        let mut list = Vec::new();
        for id in 0..600 {
            let longitude = 179.99 + 0.02 * number();
            let place = [longitude - if longitude < 180.0 { 0.0 } else { 360.0 }, 51.0 + 0.01 * number()];
            let size = if id % 9 == 0 { 4000.0 * number() } else { 5.0 + 30.0 * number() };
            list.push(rectangle(id, place, [size, 3.0 + size * number()]));
        }
        let folder = tempfile::tempdir().expect("a folder");
        let mut sorter = Sorter::new(folder.path());
        list.iter().for_each(|footprint| sorter.add(footprint).expect("room"));
        let lots = sorter.finish().expect("room");
        assert!(lots.large.of_class.iter().flatten().count() > 30);
        for (own, metres) in list.iter().zip([0.5, 20.0, 300.0].into_iter().cycle()) {
            let area = Area::of(own).around(metres);
            let found = lots.near(&area, 0..100).expect("lots").expect("not too many");
            let first = lots.footprints(0..100).expect("lots");
            let expected: Vec<&Footprint> = list
                .iter()
                .filter(|footprint| area.touches(&Area::of(footprint)) && !first.contains(footprint))
                .collect();
            assert_eq!(found.iter().map(|(_, footprint)| footprint).collect::<Vec<_>>(), expected);
        }
    }

    #[test]
    fn too_many_neighbours_are_none() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut sorter = Sorter::new(folder.path());
        for id in 0..MOST_NEAR + 2 {
            sorter.add(&rectangle(id, [9.0, 48.0], [10.0, 10.0])).expect("room");
        }
        let lots = sorter.finish().expect("room");
        let area = Area::of(&rectangle(0, [9.0, 48.0], [10.0, 10.0])).around(1.0);
        assert_eq!(lots.near(&area, 0..1).expect("lots"), None);
        assert_eq!(lots.near(&area, 0..2).expect("lots").map(|near| near.len()), Some(MOST_NEAR));
    }
}
