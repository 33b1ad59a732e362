//! Sheets: the cells of all facets, where cells that coincide are one.
//!
//! Around an edge, the sheets that have it are in the order of their angles. So the space at the edge is divided into wedges,
//! each between a side of a sheet and a side of the next one.

use crate::each::Each;
use crate::small_sort::SmallSort;
use std::collections::HashMap;

use glam::DVec2;

use super::cell::{Cell, Winding};
use super::edge_table::EdgeTable;
use super::facet::Facet;
use super::operation::BooleanError;
use super::progress::{ask, goes_on};

/// The sine of the smallest angle between sheets at an edge that can be told from none.
const LEAST_ANGLE: f64 = 1e-13;

/// A facet that has a cell at the place of a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct SheetSource {
    pub(super) facet: u32,
    /// The number of times that the facet's outline winds around the sheet, seen from the sheet's front.
    pub(super) winding: i32,
}

/// The windings of several facets, in the order of the facets.
impl Winding for Vec<SheetSource> {
    fn across(&self, count: &Self, to_right: bool) -> Self {
        let mut sum = self.clone();
        for step in count {
            let change = if to_right { -step.winding } else { step.winding };
            match sum.binary_search_by_key(&step.facet, |known| known.facet) {
                Ok(at) => {
                    sum[at].winding += change;
                    if sum[at].winding == 0 {
                        sum.remove(at);
                    }
                }
                Err(at) => sum.insert(at, SheetSource { facet: step.facet, winding: change }),
            }
        }
        sum
    }

    fn is_outside(&self) -> bool {
        self.is_empty()
    }

    fn len(&self) -> usize {
        1 + self.as_slice().len()
    }
}

/// A polygon with holes that no edge divides, with its front where the normal of its first facet points.
#[derive(Debug)]
pub(super) struct Sheet {
    /// The facets, in order. The first one has its normal.
    pub(super) sources: Vec<SheetSource>,
    pub(super) rings: Vec<Vec<u32>>,
    /// Edges inside of it.
    inner: Vec<u32>,
}

impl Sheet {
    /// The facet whose plane the sheet has.
    pub(super) fn facet(&self) -> u32 {
        self.sources[0].facet
    }

    /// The edges of all rings, as pairs of points.
    pub(super) fn rim(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.rings.iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| [*a, *b]))
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
    pub(super) list: Vec<Sheet>,
    /// The edges that sheets have, in increasing order, each with the end of its uses.
    fans: Vec<(u32, u32)>,
    /// The uses of edges, counter-clockwise around each edge.
    uses: Vec<EdgeUse>,
}

impl Sheets {
    /// Unites the cells that coincide. The first facet of each gives its front.
    pub(super) fn of(
        edges: &EdgeTable,
        facets: &[Facet],
        cells: Vec<Cell<Vec<SheetSource>>>,
    ) -> Result<Self, BooleanError> {
        let mut list: Vec<Sheet> = Vec::new();
        let mut known: HashMap<Vec<[u32; 2]>, u32> = HashMap::new();
        for Cell { winding, rings, inner } in cells {
            let new = Sheet { sources: winding, rings, inner };
            goes_on(new.rim().count())?;
            let mut outline: Vec<[u32; 2]> = new.rim().map(|[a, b]| [a.min(b), a.max(b)]).collect();
            outline.small_sort();
            let number = *known.entry(outline).or_insert(list.len() as u32);
            match list.get_mut(number as usize) {
                None => list.push(new),
                Some(sheet) => {
                    let [own, front] = [new.facet(), sheet.facet()].each(|facet| facets[facet as usize].normal);
                    let sign = if 0.0 < own.dot(front) { 1 } else { -1 };
                    let turned = |one: SheetSource| SheetSource { winding: sign * one.winding, ..one };
                    sheet.sources.extend(new.sources.into_iter().map(turned));
                    sheet.sources.small_sort();
                    sheet.inner.extend(new.inner);
                }
            }
        }
        let mut all: Vec<(u32, EdgeUse)> = Vec::new();
        for (number, sheet) in (0..).zip(&list) {
            goes_on(sheet.rim().count())?;
            for ends in sheet.rim() {
                let edge = edges.find(ends).ok_or(BooleanError::Tangled)?;
                all.push((edge, EdgeUse { sheet: number, is_left: ends[0] < ends[1] }));
            }
            let both = |edge: u32| [true, false].each(|is_left| (edge, EdgeUse { sheet: number, is_left }));
            let mut inner = sheet.inner.clone();
            inner.small_sort();
            inner.dedup();
            all.extend(inner.into_iter().flat_map(both));
        }
        ask()?;
        all.sort_by_key(|(edge, _)| *edge);
        ask()?;
        let mut sheets = Sheets { list, fans: Vec::new(), uses: Vec::with_capacity(all.len()) };
        for group in all.chunk_by(|a, b| a.0 == b.0) {
            goes_on(group.len())?;
            sheets.add_fan(edges, facets, group)?;
        }
        Ok(sheets)
    }

    /// Sorts the uses of an edge by angle.
    fn add_fan(&mut self, edges: &EdgeTable, facets: &[Facet], group: &[(u32, EdgeUse)]) -> Result<(), BooleanError> {
        let along = edges.list[group[0].0 as usize].direction;
        let across = along.any_orthonormal_vector();
        let up = along.cross(across);
        let direction = |entry: &(u32, EdgeUse)| {
            let normal = facets[self.list[entry.1.sheet as usize].facet() as usize].normal;
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
