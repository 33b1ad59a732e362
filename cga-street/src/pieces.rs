//! The pieces of a network: cells of streets and sidewalks, and areas of junctions, which may still overlap.

use super::cell::{Tile, TileCorner};
use super::chain::{ChainNode, Polyline};
use super::grid::Point;
use super::junction::{self, JunctionLayout};
use super::progress::{EDGE, spend};
use super::section::{CrossSection, Station};
use super::{Kind, Side, StreetError};
use cga_geometry::each::Each;
use cga_geometry::small_sort::SmallSort;

/// The run that a cell is a part of, by number in [`StreetPieces::runs`].
pub(super) type RunId = u32;

/// A stretch of a street, of a sidewalk beside it, or of a sidewalk around a corner: one chart.
#[derive(Clone, Debug)]
pub(super) struct Chart {
    pub(super) kind: Kind,
    /// The side of the chain that a sidewalk is on.
    pub(super) side: Option<Side>,
    /// The line, and whether the cells are in its direction.
    pub(super) line: Option<(u32, bool)>,
    /// The distances along at its start and end.
    pub(super) along: [f64; 2],
    pub(super) width: f64,
}

/// The kind of a piece.
#[derive(Clone, Debug)]
pub(super) enum Plot {
    /// A cell of a roadway. A cell that is not free belongs to a junction.
    Road { cell: Tile, run: RunId, chain: u32, segment: u32, free: bool },
    /// A part of the area of a junction. The node of a junction with a layout.
    Junction { node: Option<u32>, ring: Vec<Point> },
    /// A cell of a sidewalk.
    Walk { cell: Tile, run: RunId },
}

impl Plot {
    pub(super) fn ring(&self) -> Vec<Point> {
        match self {
            Plot::Road { cell, .. } | Plot::Walk { cell, .. } => cell.ring(),
            Plot::Junction { ring, .. } => ring.clone(),
        }
    }
}

/// All pieces and runs.
#[derive(Debug, Default)]
pub(super) struct StreetPieces {
    pub(super) list: Vec<Plot>,
    pub(super) runs: Vec<Chart>,
}

/// The extents of the junctions of a network: chains, nodes, and the results of earlier attempts.
pub(super) struct JunctionDraft {
    pub(super) chains: Vec<Polyline>,
    pub(super) nodes: Vec<ChainNode>,
    /// By node: 0 for rounded kerbs, 1 for sharp ones, 2 for arms that do not fit and overlap.
    pub(super) levels: Vec<u8>,
    /// By chain: the parts that belong to junctions, as distances from the start.
    pub(super) cuts: Vec<Vec<[f64; 2]>>,
    radius: f64,
}

/// The units of work of a segment of an arm in the layout of a junction.
const ARM: usize = 128;

/// The level of a node whose arms overlap.
const OVERLAID: u8 = 2;

/// A piece of roadway between two junctions belongs to them if it is shorter than this share of its width.
const LEAST_STREET: f64 = 0.5;

impl JunctionDraft {
    pub(super) fn new(chains: Vec<Polyline>, nodes: Vec<ChainNode>, radius: f64) -> Self {
        let level = |node: &ChainNode| if node.is_bend { OVERLAID } else { u8::from(radius == 0.0) };
        JunctionDraft {
            levels: nodes.iter().map(level).collect(),
            cuts: vec![Vec::new(); chains.len()],
            chains,
            nodes,
            radius,
        }
    }

    /// Reduces the room of a junction, if possible. Returns whether it was possible.
    pub(super) fn lower(&mut self, node: usize) -> bool {
        let had = self.levels[node] < OVERLAID;
        self.levels[node] += u8::from(had);
        had
    }

    /// The pieces of the current plan. Junctions that do not fit are reduced until they do. An error if the layout is to end.
    pub(super) fn pieces(&mut self) -> Result<StreetPieces, StreetError> {
        let mut layouts: Vec<Option<JunctionLayout>> = (0..self.nodes.len()).map(|_| None).collect();
        let mut waiting: Vec<usize> = (0..self.nodes.len()).collect();
        let mut ends: Vec<[Station; 2]> = Vec::new();
        while !waiting.is_empty() {
            for node in waiting.drain(..) {
                layouts[node] = None;
                while self.levels[node] < OVERLAID && 1 < self.nodes[node].arms.len() {
                    let arms = self.nodes[node].arms.iter();
                    spend(ARM * arms.map(|&(chain, _)| 1 + self.chains[chain as usize].len()).sum::<usize>())?;
                    let radius = if self.levels[node] == 0 { self.radius } else { 0.0 };
                    layouts[node] = junction::layout(&self.nodes[node], &self.chains, radius);
                    if layouts[node].is_some() {
                        break;
                    }
                    self.levels[node] += 1;
                }
            }
            ends = self.chains.iter().map(|chain| [Station::Vertex(0), Station::Vertex(chain.len())]).collect();
            for &(chain, end, station) in layouts.iter().flatten().flat_map(|layout| &layout.stations) {
                ends[chain as usize][end] = station;
            }
            spend(EDGE * self.chains.len())?;
            for (chain, stations) in self.chains.iter().zip(&ends) {
                if chain.along(stations[1]) < chain.along(stations[0]) {
                    for node in chain.ends.into_iter().flatten().map(|node| node as usize) {
                        if self.levels[node] < OVERLAID {
                            self.levels[node] += 1;
                            waiting.push(node);
                        }
                    }
                }
            }
            waiting.small_sort();
            waiting.dedup();
        }
        let mut pieces = StreetPieces::default();
        for (number, ends) in ends.iter().enumerate() {
            spend(8 * EDGE * (self.chains[number].len() + self.cuts[number].len()))?;
            self.add_chain(number, *ends, &mut pieces);
        }
        for (number, layout) in layouts.into_iter().enumerate() {
            let node = layout.is_some().then_some(number as u32);
            let fans = || junction::fans(&self.nodes[number], &self.chains);
            let Some(layout) = layout.or_else(|| (self.levels[number] == OVERLAID).then(fans)) else { continue };
            pieces.list.extend(layout.roadway.into_iter().map(|ring| Plot::Junction { node, ring }));
            for corner in layout.corners {
                let run = pieces.runs.len() as RunId;
                pieces.list.extend(corner.cells.into_iter().map(|cell| Plot::Walk { cell, run }));
                let (along, width) = ([0.0, corner.length], corner.width);
                pieces.runs.push(Chart { kind: Kind::Sidewalk, side: None, line: None, along, width });
            }
        }
        Ok(pieces)
    }

    /// The parts of a chain that belong to junctions, between stations, sorted and disjoint.
    fn swallowed(&self, number: usize, ends: [Station; 2]) -> Vec<[Station; 2]> {
        let chain = &self.chains[number];
        let [start, end] = ends.each(|station| chain.along(station));
        let mut parts: Vec<[Station; 2]> = Vec::new();
        for &[low, high] in &self.cuts[number] {
            let low = if low <= start { ends[0] } else { chain.station_before(low) };
            let high = if end <= high { ends[1] } else { chain.station_after(high) };
            let low = if chain.along(low) < start { ends[0] } else { low };
            let high = if end < chain.along(high) { ends[1] } else { high };
            if chain.along(low) < chain.along(high) {
                parts.push([low, high]);
            }
        }
        parts.small_sort_by(|a, b| chain.along(a[0]).total_cmp(&chain.along(b[0])));
        let least = LEAST_STREET * 2.0 * chain.widths.half;
        let is_short = |from: Station, to: Station| chain.along(to) - chain.along(from) < least;
        let [from_node, to_node] = chain.ends.each(|end| end.is_some() && !chain.closed);
        let mut merged: Vec<[Station; 2]> = Vec::new();
        for part in parts {
            match merged.last_mut() {
                Some(last) if is_short(last[1], part[0]) => {
                    if chain.along(last[1]) < chain.along(part[1]) {
                        last[1] = part[1];
                    }
                }
                None if from_node && is_short(ends[0], part[0]) => merged.push([ends[0], part[1]]),
                _ => merged.push(part),
            }
        }
        match merged.last_mut() {
            Some(last) if to_node && is_short(last[1], ends[1]) => last[1] = ends[1],
            None if from_node && to_node && is_short(ends[0], ends[1]) => merged.push(ends),
            _ => {}
        }
        merged
    }

    fn add_chain(&self, number: usize, ends: [Station; 2], pieces: &mut StreetPieces) {
        let chain = &self.chains[number];
        let [start, end] = ends.each(|station| chain.along(station));
        if end <= start {
            return;
        }
        let swallowed = self.swallowed(number, ends);
        let mut stations: Vec<Station> = vec![ends[0], ends[1]];
        stations.extend((0..=chain.len()).map(Station::Vertex));
        stations.extend(swallowed.iter().flatten());
        stations.retain(|&station| start <= chain.along(station) && chain.along(station) <= end);
        stations.small_sort_by(|&a, &b| chain.along(a).total_cmp(&chain.along(b)));
        stations.dedup_by(|a, b| chain.along(*a) == chain.along(*b));
        let sections: Vec<CrossSection> = stations.iter().map(|&station| chain.section(station)).collect();
        let mut before: Option<(bool, (u32, bool))> = None;
        let mut runs = [0; 3];
        for at in 0..stations.len() - 1 {
            let (from, to) = (sections[at], sections[at + 1]);
            let middle = (from.along + to.along) / 2.0;
            let segment = match (stations[at], stations[at + 1]) {
                (Station::Within(segment, _), _) | (_, Station::Within(segment, _)) => segment,
                (Station::Vertex(at), Station::Vertex(_)) => at,
            };
            // The parts are sorted and disjoint, so it can only be in the last one that begins before it.
            let begun = swallowed.partition_point(|part| chain.along(part[0]) < middle);
            let free = begun.checked_sub(1).is_none_or(|last| chain.along(swallowed[last][1]) <= middle);
            let home = (free, chain.lines[segment]);
            if before.replace(home) != Some(home) {
                for (run, kind, side, width) in [
                    (0, Kind::Street, None, 2.0 * chain.widths.half),
                    (1, Kind::Sidewalk, Some(Side::Left), chain.widths.left),
                    (2, Kind::Sidewalk, Some(Side::Right), chain.widths.right),
                ] {
                    runs[run] = pieces.runs.len() as RunId;
                    pieces.runs.push(Chart { kind, side, line: Some(home.1), along: [from.along; 2], width });
                }
            }
            for run in runs {
                pieces.runs[run as usize].along[1] = to.along;
            }
            let corner = |section: &CrossSection, border: usize, across: f64| {
                TileCorner::new(section.borders[border], section.along, across, section.height)
            };
            let width = 2.0 * chain.widths.half;
            let road = [corner(&from, 2, 0.0), corner(&to, 2, 0.0), corner(&to, 1, width), corner(&from, 1, width)];
            if let Some(cell) = Tile::new(&road) {
                let (chain, segment) = (number as u32, segment as u32);
                pieces.list.push(Plot::Road { cell, run: runs[0], chain, segment, free });
            }
            // The borders at the kerb and outside, and the sections at the start and the end as seen from the kerb.
            let (start, end) = ((stations[at], &from), (stations[at + 1], &to));
            for (run, width, kerb, outside, [(near, a), (far, b)]) in
                [(runs[1], chain.widths.left, 1, 0, [start, end]), (runs[2], chain.widths.right, 2, 3, [end, start])]
            {
                let distance = chain.widths.borders()[outside];
                let outer = |station: Station, section: &CrossSection| {
                    let mut corner = corner(section, outside, width);
                    // If the outer border has no length in a bend, the border overlaps the border of the next cell.
                    if let Station::Vertex(at) = station
                        && chain.is_folded(segment, distance)
                        && 0.0 < distance * chain.bend(at)
                    {
                        corner.point = Point::near(chain.place(at) + chain.direction(segment).perp() * distance);
                    }
                    corner
                };
                if 0.0 < width {
                    let cell = Tile::new(&[corner(a, kerb, 0.0), corner(b, kerb, 0.0), outer(far, b), outer(near, a)]);
                    pieces.list.extend(cell.map(|cell| Plot::Walk { cell, run }));
                }
            }
        }
    }
}
