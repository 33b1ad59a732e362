//! Sheets: the cells of all facets, where cells that coincide are one.
//!
//! Around an edge, the sheets that have it are in the order of their angles. So the space at the edge is divided into wedges,
//! each between a side of a sheet and a side of the next one.

use crate::each::Each;
use crate::small_sort::SmallSort;
use std::collections::HashMap;

use glam::DVec2;

use super::cell::{Cells, FacetWinding};
use super::edge_table::EdgeTable;
use super::facet::Facet;
use super::lists::{Lists, Polygons, Rings};
use super::operation::BooleanError;
use super::progress::{ask, goes_on, sort};
use crate::buckets::Buckets;
use crate::mesh::in_order;

/// The sine of the smallest angle between sheets at an edge that can be told from none.
const LEAST_ANGLE: f64 = 1e-13;

/// A polygon with holes that no edge divides, with its front where the normal of its first facet points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheet<'a> {
    /// The facets that have a cell there, in order. The first one has its normal.
    pub(super) sources: &'a [FacetWinding],
    pub(super) rings: Rings<'a, u32>,
}

impl Sheet<'_> {
    /// The facet whose plane the sheet has.
    pub(super) fn facet(&self) -> u32 {
        self.sources[0].facet
    }
}

/// A side of a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SheetSide {
    Front,
    Back,
}

impl SheetSide {
    pub(super) const BOTH: [SheetSide; 2] = [SheetSide::Front, SheetSide::Back];

    pub(super) fn other(self) -> Self {
        match self {
            SheetSide::Front => SheetSide::Back,
            SheetSide::Back => SheetSide::Front,
        }
    }
}

/// A sheet at an edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeUse {
    pub(super) sheet: u32,
    /// True if the sheet is on the left of the edge as seen from the sheet's front.
    pub(super) is_left: bool,
}

impl EdgeUse {
    /// The side of the sheet that looks counter-clockwise around the edge.
    pub(super) fn ahead(self) -> SheetSide {
        if self.is_left { SheetSide::Front } else { SheetSide::Back }
    }

    /// The side that looks clockwise.
    pub(super) fn behind(self) -> SheetSide {
        self.ahead().other()
    }
}

/// The sheets of an arrangement.
pub(super) struct Sheets {
    /// The polygons of all cells, and the cell of each sheet.
    rings: Polygons<u32>,
    cells: Vec<u32>,
    sources: Lists<FacetWinding>,
    /// The edges that sheets have, in increasing order, each with the end of its uses.
    fans: Vec<(u32, u32)>,
    /// The uses of edges, counter-clockwise around each edge.
    uses: Vec<EdgeUse>,
}

impl Sheets {
    pub(super) fn len(&self) -> u32 {
        self.sources.len()
    }

    pub(super) fn at(&self, number: u32) -> Sheet<'_> {
        Sheet { sources: self.sources.of(number), rings: self.rings.of(self.cells[number as usize]) }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = Sheet<'_>> {
        (0..self.len()).map(|number| self.at(number))
    }

    /// Unites the cells that coincide. The first facet of each gives its front.
    pub(super) fn of(edges: &EdgeTable, facets: &[Facet<'_>], cells: Cells) -> Result<Self, BooleanError> {
        let mut order: Vec<[u32; 2]> = (0..cells.len()).map(|cell| [cells.windings.of(cell)[0].facet, cell]).collect();
        sort(&mut order)?;
        let mut outlines = Lists::default();
        let mut outline: Vec<[u32; 2]> = Vec::new();
        for &[_, cell] in &order {
            outline.clear();
            outline.extend(cells.rings.of(cell).edges().map(in_order));
            goes_on(outline.len())?;
            outline.small_sort();
            outlines.add(outline.iter().copied());
        }
        let mut known: HashMap<&[[u32; 2]], u32> = HashMap::with_capacity(order.len());
        let mut sheet_of = Vec::with_capacity(order.len());
        let mut firsts: Vec<u32> = Vec::new();
        for (&[_, cell], outline) in order.iter().zip(outlines.iter()) {
            goes_on(outline.len())?;
            let number = *known.entry(outline).or_insert(firsts.len() as u32);
            if number as usize == firsts.len() {
                firsts.push(cell);
            }
            sheet_of.push(number);
        }
        drop(known);
        let cells_of = Buckets::by(firsts.len(), sheet_of.iter().copied());
        let mut sources = Lists::default();
        let mut all: Vec<(u32, EdgeUse)> = Vec::new();
        let (mut here, mut inner): (Vec<FacetWinding>, Vec<u32>) = (Vec::new(), Vec::new());
        for (sheet, first) in (0..).zip(&firsts) {
            here.clear();
            inner.clear();
            let normal = |cell: u32| facets[cells.windings.of(cell)[0].facet as usize].normal;
            for cell in cells_of.of(sheet as usize).iter().map(|place| order[*place as usize][1]) {
                let sign = if cell == *first || 0.0 < normal(cell).dot(normal(*first)) { 1 } else { -1 };
                let turned = |one: &FacetWinding| FacetWinding { winding: sign * one.winding, ..*one };
                here.extend(cells.windings.of(cell).iter().map(turned));
                inner.extend(cells.inner.of(cell));
            }
            here.small_sort();
            sources.add(here.iter().copied());
            inner.small_sort();
            inner.dedup();
            let rim = cells.rings.of(*first);
            goes_on(rim.corners.len() + inner.len())?;
            for ends in rim.edges() {
                let edge = edges.find(ends).ok_or(BooleanError::Tangled)?;
                all.push((edge, EdgeUse { sheet, is_left: ends[0] < ends[1] }));
            }
            let both = |edge: &u32| [true, false].each(|is_left| (*edge, EdgeUse { sheet, is_left }));
            all.extend(inner.iter().flat_map(both));
        }
        ask()?;
        all.small_sort_by_key(|(edge, _)| *edge);
        ask()?;
        let (fans, uses) = (Vec::new(), Vec::with_capacity(all.len()));
        let mut sheets = Sheets { rings: cells.rings, cells: firsts, sources, fans, uses };
        for group in all.chunk_by(|a, b| a.0 == b.0) {
            goes_on(group.len())?;
            sheets.add_fan(edges, facets, group)?;
        }
        Ok(sheets)
    }

    /// Sorts the uses of an edge by angle.
    fn add_fan(
        &mut self,
        edges: &EdgeTable,
        facets: &[Facet<'_>],
        group: &[(u32, EdgeUse)],
    ) -> Result<(), BooleanError> {
        let along = edges.list[group[0].0 as usize].direction;
        let across = along.any_orthonormal_vector();
        let up = along.cross(across);
        let direction = |entry: &(u32, EdgeUse)| {
            let normal = facets[self.at(entry.1.sheet).facet() as usize].normal;
            let into = normal.cross(along) * if entry.1.is_left { 1.0 } else { -1.0 };
            (DVec2::new(into.dot(across), into.dot(up)), entry.1)
        };
        let mut fan: Vec<(DVec2, EdgeUse)> = group.iter().map(direction).collect();
        let is_low = |at: DVec2| at.y < 0.0 || (at.y == 0.0 && at.x < 0.0);
        fan.small_sort_by(|(a, _), (b, _)| {
            is_low(*a).cmp(&is_low(*b)).then_with(|| 0.0f64.total_cmp(&(a.perp_dot(*b) + 0.0)))
        });
        let next = fan.iter().cycle().skip(1);
        let meet = |(a, b): (&(DVec2, EdgeUse), &(DVec2, EdgeUse))| {
            a.0.perp_dot(b.0).abs() <= LEAST_ANGLE && 0.0 < a.0.dot(b.0)
        };
        if 1 < fan.len() && fan.iter().zip(next).any(meet) {
            return Err(BooleanError::Tangled);
        }
        self.uses.extend(fan.iter().map(|entry| entry.1));
        self.fans.push((group[0].0, self.uses.len() as u32));
        Ok(())
    }

    /// All edges of sheets, each with its uses.
    pub(super) fn fans(&self) -> impl Iterator<Item = (u32, &[EdgeUse])> {
        let starts = std::iter::once(0).chain(self.fans.iter().map(|fan| fan.1));
        starts.zip(&self.fans).map(|(start, (edge, end))| (*edge, &self.uses[start as usize..*end as usize]))
    }
}
