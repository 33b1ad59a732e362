//! The tree of a block of lots: pieces of the curve, their tiles, and the nodes of the tileset.

use std::io;
use std::ops::Range;

use cga_geo::frame::Frame;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::area::Area;
use crate::cell::Cell;
use crate::content::{Form, content};
use crate::glb_bounds::Bounds;
use crate::lots::{Lots, MOST_NEAR};
use crate::rules::LevelRules;
use crate::store::Store;
use crate::surroundings::{Distances, Surroundings};
use crate::tile_file::TileFile;
use crate::tileset::Node;

/// The lots of a block.
pub(crate) const BLOCK_LOTS: u64 = 65_536;

/// A piece of the curve: neighbouring lots, and the smallest cell around their centroids.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// The numbers of its lots.
    pub lots: Range<u64>,
    /// The cell.
    pub cell: Cell,
    /// For lots that are all in one smallest cell, the way to this piece by halves.
    half: String,
}

/// A block of lots whose tree has a file of its own.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Block {
    /// The name of the file.
    pub name: String,
    /// The smallest cell around its lots.
    pub cell: Cell,
    /// The box around its buildings in the frame of its cell: the lowest and the highest corner as east, north and up in metres.
    pub bounds: [[f64; 3]; 2],
    /// The error in metres if its file is not shown.
    pub error: f64,
}

/// The file of a block. Its folder is three folders below the city.
fn set(tree: &Node) -> Vec<u8> {
    fn lifted(node: &Node) -> Node {
        Node {
            content: node.content.as_ref().map(|name| format!("../../../{name}")),
            children: node.children.iter().map(lifted).collect(),
            ..node.clone()
        }
    }
    lifted(tree).inner_tileset()
}

/// A level of the tree.
#[derive(Debug)]
pub struct TreeLevel {
    /// The rules.
    pub rules: LevelRules,
    /// The most lots of a piece.
    pub lots: u64,
    /// The error in metres where a tile of this level is shown.
    pub error: f64,
    /// The distances up to which rules find other lots; `None` for rules that find no others.
    pub neighbours: Option<Distances>,
    /// True for tiles that share their images.
    pub shares_images: bool,
    /// False for tiles without normals.
    pub has_normals: bool,
    /// True for tiles whose triangles meet edge to edge.
    pub is_watertight: bool,
}

impl TreeLevel {
    /// The metres by which positions may move: a centimetre nearby, and a fiftieth of the error far away.
    pub fn accuracy(&self) -> f64 {
        (self.error / 50.0).max(0.01)
    }

    /// The form of its tiles with at most some bytes.
    pub fn form(&self, most_bytes: u64) -> Form {
        let TreeLevel { shares_images, has_normals, is_watertight, .. } = *self;
        Form { accuracy: self.accuracy(), most_bytes, shares_images, has_normals, is_watertight }
    }
}

/// A tile that is finished.
#[derive(Clone, Debug, PartialEq)]
pub struct TileEvent<'t> {
    /// Its name in the store.
    pub name: &'t str,
    /// The number of its level, 0 for the near one.
    pub level: usize,
    /// Its description.
    pub tile: &'t TileFile,
    /// True if it was finished before this run.
    pub was_finished: bool,
    /// The number of its lots.
    pub lots: u64,
}

/// The most lots of a block: its tree is in memory and becomes a file of its own.
pub fn block_lots(levels: &[TreeLevel]) -> u64 {
    BLOCK_LOTS.max(levels.last().map_or(0, |level| level.lots))
}

/// The maker of trees.
#[derive(Clone, Copy)]
pub struct Trees<'c> {
    /// All lots.
    pub lots: &'c Lots,
    /// The levels, from near to far.
    pub levels: &'c [TreeLevel],
    /// The store of the city.
    pub store: &'c dyn Store,
    /// The most bytes of a tile with several lots.
    pub most_bytes: u64,
    /// Hears of each tile, from several threads. An error ends the run.
    pub each: &'c (dyn Fn(&TileEvent<'_>) -> io::Result<()> + Sync),
}

impl Trees<'_> {
    /// Makes the tiles of a block, a piece of [`cut`](Trees::cut) with at most [`block_lots`], and the file of its tree.
    /// `None` if no building of it has a face.
    ///
    /// The result depends on the lots of the block alone, and on the lots around it if its rules ask about neighbours. So blocks can be made in any
    /// order, by several programs on several machines.
    ///
    /// # Errors
    /// Errors of the store, and an error of [`each`](Trees::each).
    pub fn block(&self, piece: Piece) -> io::Result<Option<Block>> {
        let cell = piece.cell;
        // Lots that are all in one smallest cell may be several blocks.
        let name = format!("sets/{cell}{}.json", piece.half);
        let nodes = self.nodes(piece, self.levels.len() - 1)?;
        if nodes.is_empty() {
            return Ok(None);
        }
        let tree = Node::around(Frame::at(cell.middle()), nodes);
        self.store.write(&name, set(&tree))?;
        Ok(Some(Block { name, cell, bounds: [tree.bounds.low, tree.bounds.high], error: tree.error }))
    }

    /// Makes all blocks, one after another, and calls a function after each: `None` for a block without a face.
    ///
    /// # Errors
    /// As [`block`](Trees::block), and an error of the function.
    pub fn blocks(&self, after: impl FnMut(Option<&Block>) -> io::Result<()>) -> io::Result<Vec<Block>> {
        self.blocks_of(0..self.lots.len(), after)
    }

    /// Makes the blocks of some neighbouring lots: all blocks with one of them have no other lots. Rules also find the lots around them.
    ///
    /// # Errors
    /// As [`blocks`](Trees::blocks).
    pub fn blocks_of(
        &self,
        lots: Range<u64>,
        mut after: impl FnMut(Option<&Block>) -> io::Result<()>,
    ) -> io::Result<Vec<Block>> {
        let Some(all) = self.piece(lots)? else { return Ok(Vec::new()) };
        let mut blocks = Vec::new();
        for piece in self.cut(all, block_lots(self.levels))? {
            let block = self.block(piece)?;
            after(block.as_ref())?;
            blocks.extend(block);
        }
        Ok(blocks)
    }

    /// The piece of a range of lots, if it has some.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn piece(&self, lots: Range<u64>) -> io::Result<Option<Piece>> {
        if lots.is_empty() {
            return Ok(None);
        }
        let cell = Cell::around(self.lots.key(lots.start)?, self.lots.key(lots.end - 1)?);
        Ok(Some(Piece { lots, cell, half: String::new() }))
    }

    /// The largest pieces with at most a number of lots, and in cells small enough for one plane.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn cut(&self, piece: Piece, most: u64) -> io::Result<Vec<Piece>> {
        if piece.lots.end - piece.lots.start <= most.max(1) && Cell::WIDEST_TILE <= piece.cell.zoom {
            return Ok(vec![piece]);
        }
        let mut pieces = Vec::new();
        for part in self.divided(&piece)? {
            pieces.extend(self.cut(part, most)?);
        }
        Ok(pieces)
    }

    /// The parts of a piece with several lots: its quarters, or halves of its lots if they are all at one place.
    fn divided(&self, piece: &Piece) -> io::Result<Vec<Piece>> {
        let Range { start, end } = piece.lots;
        let Some(quarters) = piece.cell.quarters() else {
            let middle = start + (end - start) / 2;
            let half = |lots, name: &str| Piece { lots, cell: piece.cell, half: format!("{}{name}", piece.half) };
            return Ok(vec![half(start..middle, "a"), half(middle..end, "b")]);
        };
        let mut parts = Vec::new();
        let mut from = start;
        for quarter in quarters {
            let to = self.lots.before(quarter.keys().end, from..end)?;
            parts.extend(self.piece(from..to)?);
            from = to;
        }
        Ok(parts)
    }

    /// The nodes of a piece at a level and the nearer ones.
    ///
    /// # Errors
    /// Errors of the file system, and an error of [`each`](Trees::each).
    pub fn nodes(&self, piece: Piece, level: usize) -> io::Result<Vec<Node>> {
        let pieces = self.cut(piece, self.levels[level].lots)?;
        let nodes: Vec<Vec<Node>> =
            pieces.into_par_iter().map(|piece| self.node(piece, level)).collect::<io::Result<_>>()?;
        Ok(nodes.into_iter().flatten().collect())
    }

    /// The node of a piece, or the nodes of its parts if it has too many bytes.
    fn node(&self, piece: Piece, level: usize) -> io::Result<Vec<Node>> {
        let (tile, name, frame) = self.tile(&piece, level)?;
        if tile.is_divided {
            let parts = self.divided(&piece)?;
            let nodes: Vec<Vec<Node>> =
                parts.into_par_iter().map(|part| self.node(part, level)).collect::<io::Result<_>>()?;
            return Ok(nodes.into_iter().flatten().collect());
        }
        let children = if level == 0 { Vec::new() } else { self.nodes(piece, level - 1)? };
        let bounds = tile.bounds.map_or(Bounds::EMPTY, |[low, high]| Bounds { low, high });
        let content = (0 < tile.bytes).then_some(name);
        let mut node = Node { frame, bounds, error: self.levels[level].error, content, children };
        node.grow();
        // Lots without faces have no node.
        Ok(if node.bounds.is_empty() { Vec::new() } else { vec![node] })
    }

    /// The tile of a piece: from the disk if it is finished, otherwise made now.
    fn tile(&self, piece: &Piece, level: usize) -> io::Result<(TileFile, String, Frame)> {
        let Piece { lots, cell, half } = piece;
        let name = format!("tiles/{level}/{cell}{half}.glb");
        let frame = Frame::at(cell.middle());
        let around = self.surroundings(piece, level)?;
        let digest = self.digest(piece, level, around.as_ref())?;
        let finished = TileFile::finished(self.store, &name, &digest);
        let was_finished = finished.is_some();
        let tile = match finished {
            Some(tile) => tile,
            None => {
                let footprints = self.lots.footprints(lots.clone())?;
                let own = &self.levels[level];
                let made = content(&footprints, around.as_ref(), &frame, &own.rules, own.form(self.most_bytes));
                TileFile::write(self.store, &name, digest, made)?
            }
        };
        (self.each)(&TileEvent { name: &name, level, tile: &tile, was_finished, lots: lots.end - lots.start })?;
        Ok((tile, name, frame))
    }

    /// The lots around the lots of a piece whose rules can ask about them. `None` if no rules ask.
    fn surroundings(&self, piece: &Piece, level: usize) -> io::Result<Option<Surroundings>> {
        let TreeLevel { rules, neighbours, .. } = &self.levels[level];
        let Some(distances) = neighbours.filter(|_| rules.can_ask()) else { return Ok(None) };
        let own = self.lots.footprints(piece.lots.clone())?;
        let asking = own.iter().filter(|footprint| rules.asks(footprint)).map(Area::of);
        let Some(area) = asking.reduce(Area::join) else { return Ok(None) };
        let near = self.lots.near(&area.around(distances.largest()), piece.lots.clone())?;
        let (digests, lots) = match near {
            Some(near) => {
                let (digests, lots) = near.into_iter().unzip();
                (digests, Ok(lots))
            }
            None => {
                let metres = distances.largest();
                let why = format!(
                    "more than {MOST_NEAR} lots are within {metres} m of its tile; its rules find lots of this tile alone"
                );
                (Vec::new(), Err(why))
            }
        };
        Ok(Some(Surroundings { distances, lots, digests }))
    }

    /// The digest of all that a tile depends on.
    fn digest(&self, piece: &Piece, level: usize, around: Option<&Surroundings>) -> io::Result<String> {
        let mut digest = blake3::Hasher::new();
        digest.update(concat!("cga-city ", env!("CARGO_PKG_VERSION"), " 3").as_bytes());
        let own = &self.levels[level];
        let Form { accuracy, most_bytes, shares_images, has_normals, is_watertight } = own.form(self.most_bytes);
        digest.update(&own.rules.digest).update(&most_bytes.to_le_bytes()).update(&accuracy.to_le_bytes());
        digest.update(&[shares_images, has_normals, is_watertight].map(u8::from));
        digest.update(piece.cell.to_string().as_bytes());
        for entry in self.lots.entries(piece.lots.clone())? {
            digest.update(&entry.digest);
        }
        if let Some(around) = around {
            around.add_to(&mut digest);
        }
        Ok(digest.finalize().to_hex().to_string())
    }
}

#[cfg(test)]
mod tests {
    use cga::RuleFile;
    use cga_geo::footprint::Footprint;

    use super::*;
    use crate::leftovers::is_made;
    use crate::level::Level;
    use crate::lots::Sorter;
    use crate::rules::Rules;
    use crate::store::Folder;

    #[test]
    fn blocks_of_one_smallest_cell_have_names_of_their_own() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut sorter = Sorter::new(folder.path());
        for id in 0..8 {
            let footprint = Footprint {
                id: id.to_string(),
                seed: id,
                grammar: None,
                start: None,
                values: Vec::new(),
                rings: vec![vec![[9.0, 48.0], [9.0001, 48.0], [9.0001, 48.0001], [9.0, 48.0001]]],
                base: 0.0,
            };
            sorter.add(&footprint).expect("room");
        }
        let lots = sorter.finish().expect("room");
        let file = RuleFile::from_text("@StartRule Lot --> extrude(9) X.").expect("good rules");
        let rules = Rules::new(vec![file]).expect("rules").at(&Level::default()).expect("rules");
        let store = Folder(folder.path().join("city"));
        let levels = [TreeLevel {
            rules,
            lots: 2,
            error: 0.0,
            neighbours: None,
            shares_images: true,
            has_normals: true,
            is_watertight: false,
        }];
        let trees = Trees { lots: &lots, levels: &levels, store: &store, most_bytes: u64::MAX, each: &|_| Ok(()) };
        let all = trees.piece(0..8).expect("lots").expect("lots");
        let pieces = trees.cut(all, 4).expect("pieces");
        let blocks: Vec<Block> =
            pieces.into_iter().map(|piece| trees.block(piece).expect("room").expect("faces")).collect();
        assert_eq!(blocks.len(), 2);
        assert_ne!(blocks[0].name, blocks[1].name);
        for block in &blocks {
            assert!(is_made(&block.name), "{}", block.name);
            let set = store.read(&block.name).expect("a file").expect("a file");
            let set = String::from_utf8(set).expect("a text");
            assert_eq!(set.matches(".glb").count(), 2, "{set}");
        }
    }
}
