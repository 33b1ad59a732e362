//! The number of closed shells around each side of each sheet.
//!
//! Sides of sheets that look into the same wedge of an edge are in the same space. From one side of a sheet to the other, the
//! numbers change by the windings of its facets. So one ray decides for all sheets that are connected, and the numbers of
//! all wedges must agree.

use super::budget::Budget;
use super::operation::BooleanError;
use super::progress::goes_on;
use super::ray::{Around, RayCaster};
use super::sheet::{SheetSide, Sheets};
use super::shell::ShellKind;
use crate::buckets::Buckets;
use crate::disjoint::DisjointSets;
use crate::each::Each;

/// The closed shells of each operand around both sides of each sheet.
pub(super) struct Windings(Vec<[Around; 2]>);

impl Windings {
    pub(super) fn at(&self, sheet: u32, side: SheetSide) -> Around {
        self.0[sheet as usize][side as usize]
    }

    pub(super) fn of(sheets: &Sheets, rays: &RayCaster<'_>, budget: &mut Budget) -> Result<Self, BooleanError> {
        let count = sheets.len() as usize;
        let node = |sheet: u32, side: SheetSide| 2 * sheet + side as u32;
        let mut spaces = DisjointSets::new(2 * count);
        for (_, uses) in sheets.fans() {
            goes_on(uses.len())?;
            for (here, next) in uses.iter().zip(uses.iter().cycle().skip(1)) {
                spaces.unite(node(here.sheet, here.ahead()), node(next.sheet, next.behind()));
            }
        }
        spaces.flatten();
        let space = |sheet: u32, side: SheetSide| spaces.find(node(sheet, side));
        // The sides at each space.
        let at_space = Buckets::by(2 * count, (0..2 * count as u32).map(|node| spaces.find(node)));
        goes_on(count)?;
        let mut is_seen = [vec![false; count], vec![false; 2 * count]];
        let mut known: Vec<Option<Around>> = vec![None; 2 * count];
        for first in 0..count as u32 {
            if known[space(first, SheetSide::Front) as usize].is_some() {
                continue;
            }
            let connected = connected_sheets(first, &at_space, &space, &mut is_seen)?;
            // The first of the widest sheets.
            let mut widest: Option<(f64, u32)> = None;
            for &sheet in &connected {
                goes_on(outline(sheets, sheet).len())?;
                let size = extent(sheets, rays, sheet);
                let is_wider = |(most, first): (f64, u32)| most.total_cmp(&size).then(sheet.cmp(&first)).is_lt();
                if widest.is_none_or(is_wider) {
                    widest = Some((size, sheet));
                }
            }
            let Some((_, widest)) = widest else { continue };
            let around = rays.around_front(sheets.at(widest), |_| true, budget)?;
            let start = space(widest, SheetSide::Front);
            known[start as usize] = Some(around);
            let mut open = vec![start];
            while let Some(here) = open.pop() {
                for sheet in at_space.of(here as usize).iter().map(|node| node / 2) {
                    goes_on(1)?;
                    let step = step_back(sheets, rays, sheet);
                    for side in SheetSide::BOTH.into_iter().filter(|side| space(sheet, *side) == here) {
                        let sign = if side == SheetSide::Front { 1 } else { -1 };
                        let [a, b] = known[here as usize].unwrap_or_default();
                        let value = [a + sign * step[0], b + sign * step[1]];
                        let beyond = space(sheet, side.other());
                        match &mut known[beyond as usize] {
                            Some(other) if *other != value => return Err(BooleanError::Tangled),
                            Some(_) => {}
                            unknown => {
                                *unknown = Some(value);
                                open.push(beyond);
                            }
                        }
                    }
                }
            }
        }
        let value = |sheet, side| known[space(sheet, side) as usize].unwrap_or_default();
        Ok(Windings((0..count as u32).map(|sheet| SheetSide::BOTH.each(|side| value(sheet, side))).collect()))
    }
}

/// The sheets that are connected with one, by common spaces. `is_seen` are the sheets and the spaces of all calls before.
fn connected_sheets(
    first: u32,
    at_space: &Buckets,
    space: &impl Fn(u32, SheetSide) -> u32,
    [is_seen, is_done]: &mut [Vec<bool>; 2],
) -> Result<Vec<u32>, BooleanError> {
    let mut found = vec![first];
    is_seen[first as usize] = true;
    let mut next = 0;
    while let Some(&sheet) = found.get(next) {
        goes_on(1)?;
        next += 1;
        for side in SheetSide::BOTH {
            let here = space(sheet, side) as usize;
            if !std::mem::replace(&mut is_done[here], true) {
                let sheets = at_space.of(here).iter().map(|node| node / 2);
                found.extend(sheets.filter(|sheet| !std::mem::replace(&mut is_seen[*sheet as usize], true)));
            }
        }
    }
    Ok(found)
}

/// The change of the numbers from the front to the back of a sheet.
fn step_back(sheets: &Sheets, rays: &RayCaster<'_>, sheet: u32) -> Around {
    let mut step = [0; 2];
    for source in sheets.at(sheet).sources {
        let sign = match rays.kinds[source.facet as usize] {
            ShellKind::Closed => 1,
            ShellKind::Inverted => -1,
            ShellKind::Open => 0,
        };
        step[usize::from(rays.operands[source.facet as usize])] += sign * source.winding;
    }
    step
}

fn outline(sheets: &Sheets, sheet: u32) -> &[u32] {
    sheets.at(sheet).rings.iter().next().unwrap_or_default()
}

/// A measure of the size of a sheet: the length of its outline's box.
fn extent(sheets: &Sheets, rays: &RayCaster<'_>, sheet: u32) -> f64 {
    let places = outline(sheets, sheet).iter().map(|point| rays.points.at[*point as usize]);
    let bounds = crate::mesh::Bounds::of(places);
    bounds.size().length_squared()
}
