//! The root of a city: `tileset.json`, and in a large city files of areas between it and the blocks.

use std::io;

use cga_geo::frame::Frame;

use crate::cell::Cell;
use crate::glb_bounds::Bounds;
use crate::store::Store;
use crate::tileset::Node;
use crate::tree::Block;

/// The most children of the root and of an area.
const MOST_CHILDREN: usize = 256;

/// Writes `tileset.json` with the blocks of a city along the curve, in a cell around them. With more than 256 blocks, its children are
/// areas, each with a file of its own: so no file grows with the city, and a viewer reads the ones that it shows. `added` gets the names of
/// the files of areas.
///
/// # Errors
/// Errors of the store.
pub fn write_root(store: &dyn Store, cell: Cell, blocks: Vec<Block>, added: &mut dyn FnMut(&str)) -> io::Result<()> {
    write_root_of(store, cell, blocks, MOST_CHILDREN, added)
}

fn write_root_of(
    store: &dyn Store,
    cell: Cell,
    blocks: Vec<Block>,
    most: usize,
    added: &mut dyn FnMut(&str),
) -> io::Result<()> {
    let children = if blocks.len() <= most { blocks } else { Areas { store, most, added }.divided(&blocks, "")? };
    store.write("tileset.json", around(cell, children, "").tileset())
}

/// A node around blocks or areas, whose files are at addresses after a prefix.
fn around(cell: Cell, blocks: Vec<Block>, prefix: &str) -> Node {
    let node = |Block { name, cell, bounds: [low, high], error }| Node {
        frame: Frame::at(cell.middle()),
        bounds: Bounds { low, high },
        error,
        content: Some(format!("{prefix}{name}")),
        children: Vec::new(),
    };
    Node::around(Frame::at(cell.middle()), blocks.into_iter().map(node).collect())
}

/// Writes areas.
struct Areas<'a> {
    store: &'a dyn Store,
    most: usize,
    added: &'a mut dyn FnMut(&str),
}

impl Areas<'_> {
    /// The parts of several blocks in the quarters of the cell around them. Blocks that are all in one smallest cell become two halves.
    fn divided(&mut self, blocks: &[Block], half: &str) -> io::Result<Vec<Block>> {
        let mut parts = Vec::new();
        match cell_around(blocks).quarters() {
            Some(quarters) => {
                for quarter in quarters {
                    let [from, to] = [quarter.keys().start, quarter.keys().end]
                        .map(|key| blocks.partition_point(|block| block.cell.keys().start < key));
                    parts.extend(self.part(&blocks[from..to], half)?);
                }
            }
            None => {
                let (first, second) = blocks.split_at(blocks.len() / 2);
                parts.extend(self.part(first, &format!("{half}a"))?);
                parts.extend(self.part(second, &format!("{half}b"))?);
            }
        }
        Ok(parts)
    }

    /// A part of a division: an area if it has several blocks.
    fn part(&mut self, blocks: &[Block], half: &str) -> io::Result<Option<Block>> {
        if blocks.len() < 2 {
            return Ok(blocks.first().cloned());
        }
        let children = if blocks.len() <= self.most { blocks.to_vec() } else { self.divided(blocks, half)? };
        let cell = cell_around(blocks);
        let name = format!("areas/{cell}{half}.json");
        // The folder of an area is three folders below the city.
        let node = around(cell, children, "../../../");
        self.store.write(&name, node.inner_tileset())?;
        (self.added)(&name);
        Ok(Some(Block { name, cell, bounds: [node.bounds.low, node.bounds.high], error: node.error }))
    }
}

/// The smallest cell around blocks.
fn cell_around(blocks: &[Block]) -> Cell {
    let ends = blocks.first().zip(blocks.last());
    ends.map_or(Cell::WORLD, |(first, last)| Cell::around(first.cell.keys().start, last.cell.keys().end - 1))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use serde_json::Value;

    use super::*;
    use crate::cell::key;
    use crate::leftovers::is_made;
    use crate::store::Folder;

    fn blocks(places: impl Iterator<Item = [f64; 2]>) -> Vec<Block> {
        let bounds = [[-9.0, -9.0, 0.0], [9.0, 9.0, 30.0]];
        let block = |(number, place)| {
            let cell = Cell::around(key(place), key(place));
            Block { name: format!("sets/{cell}-{number}.json"), cell, bounds, error: 100.0 }
        };
        let mut blocks: Vec<Block> = places.enumerate().map(block).collect();
        blocks.sort_by_key(|block| block.cell.keys().start);
        blocks
    }

    /// The names of all blocks below a file, and the largest number of children of a node.
    fn read(folder: &Path, name: &str, found: &mut Vec<String>) -> usize {
        let text = std::fs::read(folder.join(name)).expect("a file");
        let set: Value = serde_json::from_slice(&text).expect("JSON");
        assert_eq!(set["root"].get("transform").is_some(), name == "tileset.json");
        let children = set["root"]["children"].as_array().expect("children");
        let mut most = children.len();
        for child in children {
            let name = child["content"]["uri"].as_str().expect("a file").trim_start_matches("../");
            assert!(child["geometricError"].as_f64() <= set["root"]["geometricError"].as_f64());
            match name.starts_with("areas/") {
                true => most = most.max(read(folder, name, found)),
                false => found.push(name.to_owned()),
            }
        }
        most
    }

    #[test]
    fn no_file_of_a_large_city_has_many_children() {
        let folder = tempfile::tempdir().expect("a folder");
        let store = Folder(folder.path().to_owned());
        // A country with a capital, and blocks at one place.
        let country = (0..900).map(|at| [6.0 + f64::from(at % 30) * 0.3, 47.0 + f64::from(at / 30) * 0.25]);
        let capital = (0..300).map(|at| [13.4 + f64::from(at % 20) * 0.001, 52.5 + f64::from(at / 20) * 0.001]);
        let all = blocks(country.chain(capital).chain(std::iter::repeat_n([9.0, 48.0], 40)));
        let mut added = BTreeSet::new();
        let cell = cell_around(&all);
        write_root_of(&store, cell, all.clone(), 16, &mut |name| {
            assert!(added.insert(name.to_owned()), "{name} is written twice");
        })
        .expect("room");
        assert!(added.iter().all(|name| is_made(name)) && 60 < added.len());
        let mut found = Vec::new();
        assert!(read(folder.path(), "tileset.json", &mut found) <= 16);
        assert_eq!(found, all.iter().map(|block| block.name.clone()).collect::<Vec<_>>());
    }

    #[test]
    fn a_city_of_few_blocks_has_no_areas() {
        let folder = tempfile::tempdir().expect("a folder");
        let store = Folder(folder.path().to_owned());
        let all = blocks((0..256).map(|at| [9.0 + f64::from(at) * 0.1, 48.0]));
        write_root(&store, cell_around(&all), all, &mut |name| panic!("{name}")).expect("room");
        let mut found = Vec::new();
        assert_eq!(read(folder.path(), "tileset.json", &mut found), 256);
    }
}
