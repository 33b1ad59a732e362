//! The parts of an operand inside the open surface of the other one.
//!
//! An open surface counts as the outline of a solid below its front, as long as its border does not meet the other operand.
//! The surface divides the other operand into regions. A region is inside if all edges at which it meets the surface agree, and outside otherwise. A region that does not meet the surface is inside
//! if the surface hides more than half of the view from there.

use std::collections::BTreeMap;

use glam::DVec3;

use super::budget::Budget;
use super::lists::Rings;
use super::operation::BooleanError;
use super::point_set::PointSet;
use super::ray::{RayCaster, place_in};
use super::sheet::{EdgeUse, Sheet, SheetSide, Sheets};
use super::shell::ShellKind;
use crate::disjoint::DisjointSets;
use crate::each::Each;
use crate::triangulate::Triangulator;

/// The cost of the solid angle of a triangle, in comparisons.
const ANGLE_COST: usize = 4;

/// For each sheet whether it is inside the open surface of an operand. Sheets of that operand are not.
pub(super) fn inside_surface(
    sheets: &Sheets,
    rays: &RayCaster<'_>,
    operand: u8,
    budget: &mut Budget,
) -> Result<Vec<bool>, BooleanError> {
    let count = sheets.len() as usize;
    let surface: Vec<i32> = (0..count as u32).map(|sheet| surface_winding(sheets, rays, sheet, operand)).collect();
    let is_other =
        |sheet: Sheet<'_>| sheet.sources.iter().all(|source| rays.operands[source.facet as usize] != operand);
    let others: Vec<bool> = sheets.iter().map(is_other).collect();
    if surface.iter().all(|winding| *winding == 0) || !others.contains(&true) {
        return Ok(vec![false; count]);
    }
    let mut regions = DisjointSets::new(count);
    for (_, uses) in sheets.fans() {
        if uses.iter().any(|used| surface[used.sheet as usize] != 0) {
            continue;
        }
        let mut here = uses.iter().map(|used| used.sheet).filter(|sheet| others[*sheet as usize]);
        if let Some(first) = here.next() {
            here.for_each(|sheet| regions.unite(first, sheet));
        }
    }
    regions.flatten();
    // The votes of a region's edges: outside, inside.
    let mut votes: BTreeMap<u32, [bool; 2]> = BTreeMap::new();
    for (_, uses) in sheets.fans() {
        for (place, used) in uses.iter().enumerate().filter(|(_, used)| others[used.sheet as usize]) {
            if let Some(found) = votes_at(uses, place, &surface) {
                let region = votes.entry(regions.find(used.sheet)).or_default();
                *region = [region[0] || found[0], region[1] || found[1]];
            }
        }
    }
    let mut triangles: Option<SurfaceTriangles> = None;
    let mut inside = vec![false; count];
    for sheet in (0..count as u32).filter(|sheet| others[*sheet as usize]) {
        // The first sheet of a region decides for all.
        let region = regions.find(sheet);
        inside[sheet as usize] = match votes.get(&region) {
            Some(votes) => *votes == [false, true],
            None if region != sheet => inside[region as usize],
            None => {
                let triangles = triangles.get_or_insert_with(|| SurfaceTriangles::of(sheets, rays, &surface));
                triangles.hide(sheets, rays, sheet, budget)?
            }
        };
    }
    Ok(inside)
}

/// The winding of an operand's open surface at a sheet.
pub(super) fn surface_winding(sheets: &Sheets, rays: &RayCaster<'_>, sheet: u32, operand: u8) -> i32 {
    let is_open =
        |facet: u32| rays.kinds[facet as usize] == ShellKind::Open && rays.operands[facet as usize] == operand;
    sheets.at(sheet).sources.iter().filter(|source| is_open(source.facet)).map(|source| source.winding).sum()
}

/// The votes of one use of an edge: whether a surface around it has the use outside, and inside. `None` without a surface.
fn votes_at(uses: &[EdgeUse], place: usize, surface: &[i32]) -> Option<[bool; 2]> {
    let is_surface = |used: &&EdgeUse| surface[used.sheet as usize] != 0;
    let (before, after) = (&uses[..place], &uses[place + 1..]);
    let next = after.iter().chain(before).find(is_surface)?;
    let last = before.iter().rev().chain(after.iter().rev()).find(is_surface)?;
    let is_inside = |used: &EdgeUse, side: SheetSide| (0 < surface[used.sheet as usize]) == (side == SheetSide::Back);
    let found = [is_inside(next, next.behind()), is_inside(last, last.ahead())];
    Some([found.contains(&false), found.contains(&true)])
}

/// The triangles of an open surface, each with the winding of the surface there.
struct SurfaceTriangles(Vec<(i32, [u32; 3])>);

impl SurfaceTriangles {
    fn of(sheets: &Sheets, rays: &RayCaster<'_>, surface: &[i32]) -> Self {
        let (mut triangulator, mut found) = (Triangulator::new(), Vec::new());
        let mut triangles = Vec::new();
        for (sheet, winding) in sheets.iter().zip(surface).filter(|(_, winding)| **winding != 0) {
            let facet = &rays.facets[sheet.facet() as usize];
            let Rings { corners, ends } = sheet.rings;
            let flat: Vec<_> = corners.iter().map(|point| facet.flat(rays.points.at[*point as usize])).collect();
            triangles.clear();
            triangulator.polygon(&flat, ends, &mut triangles);
            found.extend(triangles.iter().map(|triangle| (*winding, triangle.each(|corner| corners[corner as usize]))));
        }
        SurfaceTriangles(found)
    }

    /// Returns true if the surface fills more than half of the view from a sheet, seen from its back.
    fn hide(
        &self,
        sheets: &Sheets,
        rays: &RayCaster<'_>,
        sheet: u32,
        budget: &mut Budget,
    ) -> Result<bool, BooleanError> {
        let sheet = sheets.at(sheet);
        let Some(triangle) = rays.largest_triangle(sheet, &rays.facets[sheet.facet() as usize]) else {
            return Ok(false);
        };
        budget.spend(ANGLE_COST * self.0.len())?;
        let eye = place_in(triangle, 0);
        let angle =
            |(winding, corners): &(i32, [u32; 3])| f64::from(*winding) * solid_angle(rays.points, eye, *corners);
        Ok(2.0 * std::f64::consts::PI < self.0.iter().map(angle).sum())
    }
}

/// The solid angle of a triangle as seen from a place, positive from behind.
fn solid_angle(points: &PointSet, eye: DVec3, triangle: [u32; 3]) -> f64 {
    let [a, b, c] = triangle.each(|point| points.at[point as usize] - eye);
    let [x, y, z] = [a.length(), b.length(), c.length()];
    let triple = a.dot(b.cross(c));
    let sum = x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y;
    2.0 * libm::atan2(triple, sum)
}
