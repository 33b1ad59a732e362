//! The sheets that are the result of an operation.

use super::budget::Budget;
use super::cell::FacetWinding;
use super::lists::Lists;
use super::operation::{BooleanError, BooleanOp};
use super::progress::goes_on;
use super::ray::RayCaster;
use super::sheet::{SheetSide, Sheets};
use super::surface::{inside_surface, surface_winding};
use super::winding::Windings;
use crate::each::Each;

/// A sheet of the result.
#[derive(Clone, Copy)]
pub(super) struct ChosenSheet<'a> {
    pub(super) sheet: u32,
    /// True if the back of the sheet is the front of the result.
    pub(super) is_reversed: bool,
    /// The facets that the result has there, in order. The first one gives material and coordinates.
    pub(super) sources: &'a [u32],
}

/// The sheets of the result, in order.
#[derive(Default)]
pub(super) struct ChosenSheets {
    /// The number of each sheet, and true if its back is the front of the result.
    list: Vec<(u32, bool)>,
    sources: Lists<u32>,
}

impl ChosenSheets {
    pub(super) fn len(&self) -> u32 {
        self.sources.len()
    }

    pub(super) fn at(&self, number: u32) -> ChosenSheet<'_> {
        let (sheet, is_reversed) = self.list[number as usize];
        ChosenSheet { sheet, is_reversed, sources: self.sources.of(number) }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = ChosenSheet<'_>> {
        (0..self.len()).map(|number| self.at(number))
    }

    fn add(&mut self, sheet: u32, is_reversed: bool, sources: impl Iterator<Item = u32>) {
        self.list.push((sheet, is_reversed));
        self.sources.add(sources);
    }
}

/// The sheets between the inside and the outside of the result.
pub(super) fn choose(
    op: BooleanOp,
    sheets: &Sheets,
    rays: &RayCaster<'_>,
    windings: &Windings,
    budget: &mut Budget,
) -> Result<ChosenSheets, BooleanError> {
    let mut surface = |operand: u8| match op {
        BooleanOp::Unify => Ok(vec![false; sheets.len() as usize]),
        _ => inside_surface(sheets, rays, operand, budget),
    };
    let surfaces = [surface(0)?, surface(1)?];
    let mut chosen = ChosenSheets::default();
    for (number, sheet) in (0..).zip(sheets.iter()) {
        goes_on(sheet.sources.len())?;
        let inside = |operand: usize, side: SheetSide| {
            let is_in = |side: SheetSide| 0 < windings.at(number, side)[operand];
            let winding = surface_winding(sheets, rays, number, operand as u8);
            let is_between = is_in(SheetSide::Front) != is_in(SheetSide::Back);
            if winding == 0 || is_between {
                is_in(side) || surfaces[operand][number as usize]
            } else {
                is_in(side) || (0 < winding) == (side == SheetSide::Back)
            }
        };
        let [front, back] = SheetSide::BOTH.each(|side| [inside(0, side), inside(1, side)]);
        if op.keeps(front) != op.keeps(back) {
            // A solid that only touches the one from which it is subtracted has no part of the result.
            let operand = (op == BooleanOp::Subtract).then_some(u8::from(front[0] == back[0]));
            let counts = |facet: &u32| operand.is_none_or(|operand| rays.operands[*facet as usize] == operand);
            let sources = sheet.sources.iter().map(|source| source.facet).filter(counts);
            chosen.add(number, op.keeps(front), sources);
        }
    }
    Ok(chosen)
}

/// The sheets of the result if all facets lie in one plane: areas count, and not which way they face. Areas of the second
/// operand alone face as the first operand does.
pub(super) fn choose_in_plane(op: BooleanOp, sheets: &Sheets, rays: &RayCaster<'_>) -> ChosenSheets {
    let operand = |source: &FacetWinding| usize::from(rays.operands[source.facet as usize]);
    let first = rays.operands.iter().position(|operand| *operand == 0);
    let mut chosen = ChosenSheets::default();
    for (number, sheet) in (0..).zip(sheets.iter()) {
        let has = [0, 1].each(|which| sheet.sources.iter().any(|source| operand(source) == which));
        if !op.keeps(has) {
            continue;
        }
        let facet = &rays.facets[sheet.facet() as usize];
        let is_reversed = match first {
            Some(first) if op != BooleanOp::Unify && !has[0] => facet.normal.dot(rays.facets[first].normal) < 0.0,
            _ => sheet.sources[0].winding < 0,
        };
        chosen.add(number, is_reversed, sheet.sources.iter().map(|source| source.facet));
    }
    chosen
}
