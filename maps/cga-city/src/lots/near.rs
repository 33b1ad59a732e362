//! Footprints near an area: the lots around a tile.

use std::io;
use std::ops::Range;

use cga_geo::footprint::Footprint;

use super::Lots;
use crate::area::{Area, CLASSES, Part};
use crate::cell::Cell;

/// The most lots around a tile.
pub(crate) const MOST_NEAR: usize = 1 << 15;

/// The most footprints with their middles near an area, whose boxes are compared with it.
const MOST_COMPARED: usize = 1 << 18;

/// The entries of the index that are compared one by one; more are divided by cells.
const ENTRIES: u64 = 1 << 12;

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
    /// [`MOST_NEAR`], or too many beside them. The result depends on the footprints near the area alone; see [`Area::of_class`].
    ///
    /// # Errors
    /// Errors of the file system.
    pub(crate) fn near(&self, area: &Area, without: Range<u64>) -> io::Result<Option<Vec<Near>>> {
        let Some(mut numbers) = self.near_small(area, &without)? else { return Ok(None) };
        for (large, class) in self.large.of_class.iter().zip(&CLASSES[1..]) {
            let wide = area.of_class(*class);
            for Range { start, end } in wide.cover().into_iter().map(Cell::keys) {
                let [from, to] = [start, end].map(|key| large.partition_point(|(known, _)| *known < key));
                let others = large[from..to].iter().filter(|(_, number)| !without.contains(number));
                numbers.extend(others.filter(|(key, _)| wide.has(*key)).map(|(_, number)| *number));
                if MOST_COMPARED < numbers.len() {
                    return Ok(None);
                }
            }
        }
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
    ///
    /// Lots beside the area are left out by cells, so a crowded place there costs little.
    fn near_small(&self, area: &Area, without: &Range<u64>) -> io::Result<Option<Vec<u64>>> {
        let (wide, mut numbers) = (area.of_class(CLASSES[0]), Vec::new());
        let within = |cell: Cell, all: Range<u64>| -> io::Result<(Cell, Range<u64>)> {
            let Range { start, end } = cell.keys();
            let from = self.before(start, all.clone())?;
            Ok((cell, from..self.before(end, from..all.end)?))
        };
        let mut open =
            wide.cover().into_iter().map(|cell| within(cell, 0..self.len())).collect::<io::Result<Vec<_>>>()?;
        while let Some((cell, lots)) = open.pop() {
            let part = if lots.is_empty() { Part::Nothing } else { wide.part_of(cell) };
            let is_short = lots.end - lots.start <= ENTRIES;
            match (part, cell.quarters()) {
                (Part::Nothing, _) => {}
                (Part::Some, Some(quarters)) if !is_short => {
                    for quarter in quarters {
                        open.push(within(quarter, lots.clone())?);
                    }
                }
                (Part::Some, _) => {
                    let entries = lots.clone().zip(self.entries(lots)?);
                    let inside = entries.filter(|(number, entry)| wide.has(entry.key) && !without.contains(number));
                    numbers.extend(inside.map(|(number, _)| number));
                }
                (Part::All, _) => {
                    let (before, after) =
                        (lots.start..lots.end.min(without.start), lots.start.max(without.end)..lots.end);
                    [before, after].into_iter().for_each(|part| numbers.extend(part.take(MOST_COMPARED + 1)));
                }
            }
            if MOST_COMPARED < numbers.len() {
                return Ok(None);
            }
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
    fn a_crowd_is_divided_by_cells() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut sorter = Sorter::new(folder.path());
        let place = |at: usize| [9.0 + (at * 37 % 211) as f64 * 2e-5, 48.0 + (at * 53 % 199) as f64 * 2e-5];
        let list: Vec<Footprint> =
            (0..5 * ENTRIES as usize).map(|at| rectangle(at, place(at), [2.0, 3.0 + (at % 7) as f64 * 60.0])).collect();
        list.iter().for_each(|footprint| sorter.add(footprint).expect("room"));
        let lots = sorter.finish().expect("room");
        for (at, metres) in [(0, 0.1), (9000, 3.0), (20_000, 90.0), (5, 10.0)] {
            let area = Area::of(&list[at]).around(metres);
            let own = lots.footprints(3000..3500).expect("lots");
            let found = lots.near(&area, 3000..3500).expect("lots").expect("not too many");
            let mut expected: Vec<&Footprint> =
                list.iter().filter(|lot| area.touches(&Area::of(lot)) && !own.contains(lot)).collect();
            expected.sort_by(|a, b| a.id.cmp(&b.id));
            let mut found: Vec<&Footprint> = found.iter().map(|(_, footprint)| footprint).collect();
            found.sort_by(|a, b| a.id.cmp(&b.id));
            assert_eq!(found, expected);
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
