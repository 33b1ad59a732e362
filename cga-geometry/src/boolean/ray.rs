//! Rays, to find the number of shells around a place.

use glam::{DVec2, DVec3};

use super::budget::Budget;
use super::facet::Facet;
use super::lists::Rings;
use super::operation::BooleanError;
use super::point_set::PointSet;
use super::sheet::Sheet;
use super::shell::ShellKind;
use crate::bounds_tree::{BoundsTree, meets_ray};
use crate::each::Each;
use crate::triangulate::Triangulator;

/// A ray that passes the rim of a facet at less than this many epsilons is not used.
const CLEARANCE: f64 = 16.0;

/// The sine of the smallest angle between a ray and a facet that it may cross.
const GRAZING: f64 = 1e-3;

/// The number of rays that are tried from one place.
const MOST_RAYS: u32 = 48;

/// The shells of the two operands around a place: for each, the number of closed shells that wind around it.
pub(super) type Around = [i32; 2];

/// Casts rays against closed shells.
pub(super) struct RayCaster<'a> {
    pub(super) points: &'a PointSet,
    pub(super) facets: &'a [Facet<'a>],
    pub(super) tree: &'a BoundsTree,
    pub(super) kinds: &'a [ShellKind],
    /// The operand of each facet.
    pub(super) operands: &'a [u8],
}

impl RayCaster<'_> {
    /// The shells around the front of a sheet. Facets that `counts` refuses are not there.
    pub(super) fn around_front(
        &self,
        sheet: Sheet<'_>,
        counts: impl Fn(u32) -> bool + Copy,
        budget: &mut Budget,
    ) -> Result<Around, BooleanError> {
        let facet = &self.facets[sheet.facet() as usize];
        let triangle = self.largest_triangle(sheet, facet).ok_or(BooleanError::Tangled)?;
        let is_source = |facet: u32| sheet.sources.iter().any(|source| source.facet == facet);
        for turn in 0..MOST_RAYS {
            let mut direction = spread_direction(turn);
            let rise = direction.dot(facet.normal);
            if rise.abs() < 0.1 {
                continue;
            }
            direction *= rise.signum();
            // Another solid may touch the sheet in one point.
            let place = place_in(triangle, turn);
            if let Some(found) = self.cast(place, direction, |facet| counts(facet) && !is_source(facet), budget)? {
                return Ok(found);
            }
        }
        Err(BooleanError::Tangled)
    }

    /// The shells that wind around the start of a ray. `None` if the ray passes a rim closely.
    fn cast(
        &self,
        from: DVec3,
        direction: DVec3,
        counts: impl Fn(u32) -> bool,
        budget: &mut Budget,
    ) -> Result<Option<Around>, BooleanError> {
        let inverse = direction.recip();
        let mut around = [0; 2];
        let mut is_clear = true;
        let mut work = Ok(());
        self.tree.visit(
            |bounds| meets_ray(bounds, from, inverse),
            |number| {
                let facet = &self.facets[number as usize];
                if self.kinds[number as usize] == ShellKind::Open || !counts(number) {
                    return true;
                }
                work = budget.spend(1 + facet.rings.corners.len());
                if work.is_err() {
                    return false;
                }
                match self.cross(facet, from, direction) {
                    Crossing::Unclear => is_clear = false,
                    Crossing::Winding(winding) => {
                        let sign = if self.kinds[number as usize] == ShellKind::Inverted { -1 } else { 1 };
                        around[usize::from(self.operands[number as usize])] += sign * winding;
                    }
                }
                is_clear
            },
        );
        work?;
        Ok(is_clear.then_some(around))
    }

    fn cross(&self, facet: &Facet<'_>, from: DVec3, direction: DVec3) -> Crossing {
        let height = facet.height(from);
        let fall = direction.dot(facet.normal);
        let near = CLEARANCE * self.points.epsilon;
        if fall.abs() < GRAZING {
            // The ray may still pass beside the facet.
            let is_beside = !meets_ray(&facet.bounds, from, direction.recip());
            return if is_beside { Crossing::Winding(0) } else { Crossing::Unclear };
        }
        let distance = -height / fall;
        let place = facet.flat(from + direction * distance);
        if distance < -near {
            return Crossing::Winding(0);
        }
        if facet.distance_from_rim(self.points, place) <= near {
            return Crossing::Unclear;
        }
        match facet.winding(self.points, place).0 {
            0 => Crossing::Winding(0),
            _ if distance <= near => Crossing::Unclear,
            winding => Crossing::Winding(if 0.0 < fall { winding } else { -winding }),
        }
    }

    /// The corners of a sheet's largest triangle.
    pub(super) fn largest_triangle(&self, sheet: Sheet<'_>, facet: &Facet<'_>) -> Option<[DVec3; 3]> {
        let Rings { corners, ends } = sheet.rings;
        let at = |corner: u32| self.points.at[corners[corner as usize] as usize];
        let flat: Vec<DVec2> = (0..corners.len() as u32).map(|corner| facet.flat(at(corner))).collect();
        let mut triangles = Vec::new();
        Triangulator::new().polygon(&flat, ends, &mut triangles);
        let area = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.each(|corner| flat[corner as usize]);
            (b - a).perp_dot(c - a)
        };
        let largest = triangles.iter().max_by(|a, b| area(a).total_cmp(&area(b)))?;
        Some(largest.each(at))
    }
}

enum Crossing {
    /// The change of the winding number.
    Winding(i32),
    Unclear,
}

/// Places well inside a triangle, each turn another one.
pub(super) fn place_in([a, b, c]: [DVec3; 3], turn: u32) -> DVec3 {
    let share = |step: f64| 0.5 + (f64::from(turn) * step).fract();
    let [x, y, z] = [share(0.0), share(0.754_877_666_246_692_8), share(0.569_840_290_998_053_3)];
    (a * x + b * y + c * z) / (x + y + z)
}

/// Directions all over the sphere, none of them along an axis or a diagonal.
fn spread_direction(turn: u32) -> DVec3 {
    // Additive recurrences with irrational steps.
    let share = |step: f64| (0.5 + f64::from(turn) * step).fract();
    let (x, y, z) = (share(0.819_172_513_396_164_5), share(0.671_043_606_703_789_3), share(0.549_700_477_901_970_3));
    let direction = DVec3::new(2.0 * x - 0.917, 2.0 * y - 1.083, 2.0 * z - 0.961);
    direction.normalize_or(DVec3::new(0.36, 0.48, 0.8))
}
