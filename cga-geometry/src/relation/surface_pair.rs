//! The relation of a mesh to a closed one.
//!
//! The faces of the geometry are divided where they meet the occluder. A part that is farther from its surface than the tolerance decides:
//! it is inside, or outside. If the geometry is closed, faces of the occluder are divided by it likewise, and the spaces beside common faces
//! are compared. So each answer has a witness, except `inside`, which holds if no part is outside.

use glam::DVec3;

use super::Relation;
use super::budget::Budget;
use super::convex_polygon::ConvexPolygon;
use super::plane_cut::middle;
use super::subdivision::subdivide;
use super::surface::{Place, Surface};
use crate::bounds::Bounds;

/// The places of a part that are compared if its middle is on the surface, as shares of the way to each corner.
const SHARES: [f64; 2] = [0.5, 0.98];

/// The distance from a common face at which spaces are compared, in tolerances.
const BESIDE: f64 = 4.0;

/// The relation of a geometry to a closed occluder, at least the `wanted` answers.
pub(super) fn relate(geometry: &Surface, occluder: &Surface, tolerance: f64, wanted: Relation) -> Relation {
    let Bounds { low, high } = geometry.bounds;
    let is_beyond =
        low.cmplt(occluder.bounds.low - tolerance).any() || high.cmpgt(occluder.bounds.high + tolerance).any();
    let known = Known { wanted, is_outside: is_beyond, overlaps: false, contact: false };
    let mut pair = Pair { geometry, occluder, tolerance, known, budget: Budget::new() };
    pair.compare_faces_of_geometry();
    if geometry.is_closed {
        pair.compare_faces_of_occluder();
    }
    let Known { is_outside, overlaps, contact, .. } = pair.known;
    Relation::of(!is_outside && !pair.budget.is_spent(), overlaps, contact)
}

/// The findings about a pair so far.
struct Known {
    wanted: Relation,
    is_outside: bool,
    overlaps: bool,
    contact: bool,
}

impl Known {
    fn is_contact_open(&self) -> bool {
        self.wanted.touches && !self.overlaps && !self.contact
    }

    /// Returns true if all wanted answers are known. A geometry that is inside touches, too.
    fn is_done(&self) -> bool {
        let is_contact_open = self.is_contact_open();
        let is_inside_open = (self.wanted.inside || is_contact_open) && !self.is_outside;
        let is_overlap_open = self.wanted.overlaps && !self.overlaps;
        !is_contact_open && !is_inside_open && !is_overlap_open
    }
}

struct Pair<'s> {
    geometry: &'s Surface,
    occluder: &'s Surface,
    tolerance: f64,
    known: Known,
    budget: Budget,
}

impl Pair<'_> {
    fn compare_faces_of_geometry(&mut self) {
        let (geometry, occluder, tolerance) = (self.geometry, self.occluder, self.tolerance);
        for piece in pieces_near(geometry, &occluder.bounds, tolerance) {
            if self.known.is_done() || self.budget.is_spent() {
                return;
            }
            let polygon = geometry.polygon(piece);
            let near = pieces_near(occluder, geometry.bounds_of(piece), tolerance);
            let budget = &self.budget;
            if self.known.is_contact_open() {
                let is_common = |piece: &u32| {
                    let face = occluder.polygon(*piece);
                    budget.spend(polygon.corners.len() + face.corners.len())
                        && face.common_area(&polygon, tolerance).is_some()
                };
                self.known.contact = near.iter().any(is_common);
            }
            if self.known.is_done() {
                return;
            }
            let known = &mut self.known;
            let visit = |part: &[DVec3]| {
                let place = witness(part, |point| occluder.place(point, polygon.normal, tolerance, budget));
                known.is_outside |= place == Place::Outside;
                known.overlaps |= place == Place::Inside;
                if place == Place::On && geometry.is_closed {
                    for beside in sides(middle(part), polygon.normal, tolerance) {
                        if geometry.winds_around(beside, budget) {
                            let place = occluder.place(beside, DVec3::ZERO, tolerance, budget);
                            known.is_outside |= place == Place::Outside;
                            known.overlaps |= place == Place::Inside;
                        }
                    }
                }
                !known.is_done()
            };
            if !subdivide(&polygon, occluder, near, tolerance, budget, visit) {
                return;
            }
        }
    }

    /// Compares the faces of the occluder with a closed geometry around them.
    fn compare_faces_of_occluder(&mut self) {
        let (geometry, occluder, tolerance) = (self.geometry, self.occluder, self.tolerance);
        for piece in pieces_near(occluder, &geometry.bounds, tolerance) {
            if self.known.is_done() || self.budget.is_spent() {
                return;
            }
            let polygon: ConvexPolygon<'_> = occluder.polygon(piece);
            let near = pieces_near(geometry, occluder.bounds_of(piece), tolerance);
            let (known, budget) = (&mut self.known, &self.budget);
            let visit = |part: &[DVec3]| {
                if witness(part, |point| geometry.place(point, polygon.normal, tolerance, budget)) == Place::Inside {
                    known.overlaps = true;
                    // A wall between two parts of the occluder has no outside.
                    known.is_outside |= sides(middle(part), polygon.normal, tolerance).into_iter().any(|beside| {
                        geometry.winds_around(beside, budget)
                            && occluder.place(beside, DVec3::ZERO, tolerance, budget) == Place::Outside
                    });
                }
                !known.is_done()
            };
            if !subdivide(&polygon, geometry, near, tolerance, budget, visit) {
                return;
            }
        }
    }
}

fn pieces_near(surface: &Surface, bounds: &Bounds, distance: f64) -> Vec<u32> {
    let mut pieces = Vec::new();
    surface.near(bounds, distance, |piece| {
        pieces.push(piece);
        true
    });
    pieces
}

/// The points on both sides of a face.
fn sides(point: DVec3, normal: DVec3, tolerance: f64) -> [DVec3; 2] {
    let step = normal * (BESIDE * tolerance);
    [point + step, point - step]
}

/// The first place of a part that is not on the surface.
fn witness(part: &[DVec3], place: impl Fn(DVec3) -> Place) -> Place {
    let middle = middle(part);
    let corners = part.iter().flat_map(|corner| SHARES.map(|share| middle + (*corner - middle) * share));
    std::iter::once(middle).chain(corners).map(place).find(|place| *place != Place::On).unwrap_or(Place::On)
}
