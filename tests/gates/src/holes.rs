//! Background inside of a silhouette.

use crate::finding::Finding;
use crate::look::Look;
use crate::survey::Survey;

/// Surfaces around a hole are at similar distances from the viewer: within so many pixels.
const NEAR: f64 = 8.0;

/// The pixels of background that surfaces enclose, all around or in a slit of a flat surface: cracks, holes, open reveals. `open` has
/// the rules of parts with gaps, such as railings and leaves.
pub fn holes(survey: &Survey, looks: &[Look], open: &[&str]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for look in looks {
        let outside = look.outside();
        for pixel in (0..look.pixels()).filter(|pixel| look.nearest(*pixel).is_none() && !outside[*pixel]) {
            let Some(around) = look.around(pixel) else { continue };
            let seen: Vec<_> = around.iter().filter_map(|at| Some((look.nearest(*at)?, look.depth(*at)))).collect();
            let Some(beside) = around.into_iter().find(|at| look.nearest(*at).is_some()) else { continue };
            let depths = || seen.iter().map(|(_, depth)| *depth);
            let spread = depths().fold(f64::NEG_INFINITY, f64::max) - depths().fold(f64::INFINITY, f64::min);
            let is_hole = match seen.len() {
                8 => spread < NEAR * look.pixel(),
                6 => [[0, 1], [3, 6]].iter().any(|sides| is_flat(survey, look, sides.map(|side| around[side]))),
                _ => false,
            };
            if !is_hole {
                continue;
            }
            let mut parts: Vec<u32> = seen.iter().map(|(seen, _)| survey.triangles[*seen as usize].part).collect();
            parts.sort_unstable();
            parts.dedup();
            if parts.iter().any(|part| open.contains(&survey.parts[*part as usize].rule.as_str())) {
                continue;
            }
            parts.truncate(2);
            findings.push(Finding { parts, place: look.place(beside), side: Some(look.side) });
        }
    }
    findings
}

/// Returns true if two pixels show one plane.
fn is_flat(survey: &Survey, look: &Look, pixels: [usize; 2]) -> bool {
    let [Some(a), Some(b)] = pixels.map(|pixel| Some(survey.triangles[look.nearest(pixel)? as usize])) else {
        return false;
    };
    let distance = (look.place(pixels[1]) - look.place(pixels[0])).dot(a.normal);
    0.999 < a.normal.dot(b.normal) && distance.abs() < 0.2 * look.pixel()
}
