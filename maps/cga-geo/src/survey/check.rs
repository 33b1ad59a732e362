//! Checks of an outline, and its rings in degrees.

use super::crossing::crossing;
use crate::crs::Crs;
use crate::frame::metres_a_degree;
use crate::outline::{Corner, Outline, contains, twice_area};

/// The largest extent of a footprint in metres. A corner further away is a mistake of its file.
const MOST_METRES: f64 = 20_000.0;

/// The least extent of a footprint in metres. Smaller ones are degrees that are read as metres.
const LEAST_METRES: f64 = 0.01;

/// The most degrees of longitude from the middle of a zone of UTM. Whole countries are mapped in one zone, so this is more than the three
/// degrees of a zone.
const MOST_FROM_ZONE: f64 = 20.0;

/// The latitude where the square map of tiles ends.
const MOST_LATITUDE: f64 = 85.0;

/// An outline that can be a footprint.
pub(super) struct Checked {
    /// The rings in degrees, as [`Footprint::rings`](crate::footprint::Footprint::rings).
    pub(super) rings: Vec<Vec<Corner>>,
    /// The outer ring in the coordinates of the file.
    pub(super) place: Vec<Corner>,
    /// The number of holes without an area.
    pub(super) holes_lost: usize,
    /// The number of holes that are outside of the outline or inside of other holes.
    pub(super) holes_misplaced: usize,
    /// A sign that the coordinate system is a wrong one.
    pub(super) note: Option<String>,
}

/// # Errors
/// The reason why the outline cannot be a footprint.
pub(super) fn check(outline: &Outline, crs: &Crs) -> Result<Checked, String> {
    let mut own = Vec::new();
    for (number, ring) in outline.rings.iter().enumerate() {
        match (ring_of(ring)?, number) {
            (Some(ring), _) => own.push(ring),
            (None, 0) => return Err("its outline has no area".to_owned()),
            (None, _) => {}
        }
    }
    let Some(first) = own.first().map(|ring| ring[0]) else { return Err("it has an empty polygon".to_owned()) };
    let reference = crs.degrees(first)?[0];
    let rings = own.iter().enumerate().map(|(number, ring)| Ok(wound(degrees(ring, crs, reference)?, number == 0)));
    let mut rings = rings.collect::<Result<Vec<_>, String>>()?;
    let metres = extent(&rings[0])?;
    if let Some([longitude, latitude]) = crossing(&rings) {
        return Err(format!("its edges cross near longitude {longitude:.6}, latitude {latitude:.6}"));
    }
    let holes_lost = outline.rings.len() - own.len();
    let holes_misplaced = remove_misplaced_holes(&mut rings);
    let note = doubt(metres, rings[0][0][0], crs);
    Ok(Checked { rings, place: own.swap_remove(0), holes_lost, holes_misplaced, note })
}

/// Removes holes that are outside of the outline or inside of other holes, and returns their number. Edges do not cross, but rings may touch at
/// corners; such a corner may count as inside or outside.
fn remove_misplaced_holes(rings: &mut Vec<Vec<Corner>>) -> usize {
    let is_misplaced = |hole: usize| {
        let is_in = |ring: &[Corner]| rings[hole].iter().filter(|corner| contains(ring, **corner)).count();
        let area = |ring: usize| twice_area(&rings[ring]).abs();
        let is_around = |other: &usize| area(hole) < area(*other) && 2 * is_in(&rings[*other]) > rings[hole].len();
        is_in(&rings[0]) == 0
            || area(0) < area(hole)
            || (1..rings.len()).filter(|ring| *ring != hole).any(|ring| is_around(&ring))
    };
    let misplaced: Vec<bool> = (0..rings.len()).map(|ring| ring != 0 && is_misplaced(ring)).collect();
    let mut misplaced_ring = misplaced.iter();
    rings.retain(|_| misplaced_ring.next() != Some(&true));
    misplaced.into_iter().filter(|is_misplaced| *is_misplaced).count()
}

/// A sentence if the coordinate system is probably a wrong one, by the extent of an outline in metres and its longitude.
fn doubt(metres: f64, longitude: f64, crs: &Crs) -> Option<String> {
    let hint = format!("is {crs} its coordinate system? `--crs` names another one");
    if metres < LEAST_METRES {
        return Some(format!("it is smaller than 1 cm; {hint}"));
    }
    let turn = longitude - crs.zone_middle()?;
    let away = (turn - 360.0 * (turn / 360.0).round()).abs();
    (MOST_FROM_ZONE < away).then(|| format!("it is {away:.0} degrees of longitude from the middle of its zone; {hint}"))
}

/// The corners of a ring, each once; `None` without an area.
fn ring_of(ring: &[Corner]) -> Result<Option<Vec<Corner>>, String> {
    if let Some([x, y]) = ring.iter().find(|corner| !(corner[0].is_finite() && corner[1].is_finite())) {
        return Err(format!("a corner is ({x}, {y})"));
    }
    let mut ring = ring.to_vec();
    ring.dedup();
    while 1 < ring.len() && ring.first() == ring.last() {
        ring.pop();
    }
    Ok(Some(ring).filter(|ring| 3 <= ring.len() && twice_area(ring) != 0.0))
}

/// The ring with its first corner first: counter-clockwise for an outline, clockwise for a hole.
fn wound(mut ring: Vec<Corner>, is_outer: bool) -> Vec<Corner> {
    if (0.0 < twice_area(&ring)) != is_outer {
        ring[1..].reverse();
    }
    ring
}

/// The corners in degrees. Corners on the other side of the meridian of 180 degrees from a reference longitude go on beyond it.
fn degrees(ring: &[Corner], crs: &Crs, reference: f64) -> Result<Vec<Corner>, String> {
    let corner = |corner: &Corner| -> Result<Corner, String> {
        let [longitude, latitude] = crs.degrees(*corner)?;
        Ok([longitude - 360.0 * ((longitude - reference) / 360.0).round(), latitude])
    };
    ring.iter().map(corner).collect()
}

/// The extent of an outline in degrees, in metres.
///
/// # Errors
/// The outline is too large, or too far in the north or in the south.
fn extent(ring: &[Corner]) -> Result<f64, String> {
    let range = |axis: usize| {
        let values = ring.iter().map(|corner| corner[axis]);
        (values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max))
    };
    let ((west, east), (south, north)) = (range(0), range(1));
    if MOST_LATITUDE < south.abs().max(north.abs()) {
        return Err(format!(
            "it is at latitude {}; tiles end at {MOST_LATITUDE} degrees",
            if south < 0.0 { south } else { north }
        ));
    }
    let [a_degree_east, a_degree_north] = metres_a_degree((south + north) / 2.0);
    let metres = ((east - west) * a_degree_east).max((north - south) * a_degree_north);
    if metres <= MOST_METRES {
        return Ok(metres);
    }
    Err(format!("it is {:.0} km long; at most {} km are used", metres / 1e3, MOST_METRES / 1e3))
}
