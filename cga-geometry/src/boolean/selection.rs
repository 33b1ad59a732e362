//! The sheets that are the result of an operation.

use super::budget::Budget;
use super::operation::{BooleanError, BooleanOp};
use super::progress::goes_on;
use super::ray::RayCaster;
use super::sheet::{Sheet, SheetSide, SheetSource, Sheets};
use super::surface::{inside_surface, surface_winding};
use super::winding::Windings;
use crate::each::Each;
use crate::small_sort::SmallSort;

/// A sheet of the result.
pub(super) struct ChosenSheet {
    pub(super) sheet: u32,
    /// True if the back of the sheet is the front of the result.
    pub(super) is_reversed: bool,
    /// The facets that the result has there, in order. The first one gives material and coordinates.
    pub(super) sources: Vec<u32>,
}

/// The sheets between the inside and the outside of the result.
pub(super) fn choose(
    op: BooleanOp,
    sheets: &Sheets,
    rays: &RayCaster<'_>,
    windings: &Windings,
    budget: &mut Budget,
) -> Result<Vec<ChosenSheet>, BooleanError> {
    let mut surface = |operand: u8| match op {
        BooleanOp::Unify => Ok(vec![false; sheets.list.len()]),
        _ => inside_surface(sheets, rays, operand, budget),
    };
    let surfaces = [surface(0)?, surface(1)?];
    let mut chosen = Vec::new();
    for (number, sheet) in (0..).zip(&sheets.list) {
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
            let is_reversed = op.keeps(front);
            let sources = sources(op, sheet, rays, front[0] != back[0]);
            chosen.push(ChosenSheet { sheet: number, is_reversed, sources });
        }
    }
    Ok(chosen)
}

/// The facets that the result has at a sheet. A solid that only touches the one from which it is subtracted has none.
fn sources(op: BooleanOp, sheet: &Sheet, rays: &RayCaster<'_>, is_rim_of_first: bool) -> Vec<u32> {
    let counts = |source: &&SheetSource| {
        op != BooleanOp::Subtract || is_rim_of_first == (rays.operands[source.facet as usize] == 0)
    };
    let mut found: Vec<u32> = sheet.sources.iter().filter(counts).map(|source| source.facet).collect();
    found.small_sort();
    found
}

/// The sheets of the result if all facets lie in one plane: areas count, and not which way they face. Areas of the second
/// operand alone face as the first operand does.
pub(super) fn choose_in_plane(op: BooleanOp, sheets: &Sheets, rays: &RayCaster<'_>) -> Vec<ChosenSheet> {
    let operand = |source: &SheetSource| usize::from(rays.operands[source.facet as usize]);
    let first = rays.operands.iter().position(|operand| *operand == 0);
    let mut chosen = Vec::new();
    for (number, sheet) in (0..).zip(&sheets.list) {
        let has = [0, 1].each(|which| sheet.sources.iter().any(|source| operand(source) == which));
        if !op.keeps(has) {
            continue;
        }
        let facet = &rays.facets[sheet.facet() as usize];
        let is_reversed = match first {
            Some(first) if op != BooleanOp::Unify && !has[0] => facet.normal.dot(rays.facets[first].normal) < 0.0,
            _ => sheet.sources[0].winding < 0,
        };
        let sources = sheet.sources.iter().map(|source| source.facet).collect();
        chosen.push(ChosenSheet { sheet: number, is_reversed, sources });
    }
    chosen
}
