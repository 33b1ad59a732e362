//! Background inside of a silhouette.

use crate::finding::Finding;
use crate::look::Look;
use crate::survey::Survey;

/// Surfaces around a hole are at similar distances from the viewer: within so many pixels.
const NEAR: f64 = 8.0;

/// The pixels of background with near surfaces all around: cracks, holes, open reveals. `open` has the rules of parts with gaps, such
/// as railings and leaves.
pub fn holes(survey: &Survey, looks: &[Look], open: &[&str]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for look in looks {
        for pixel in (0..look.pixels()).filter(|pixel| look.nearest(*pixel).is_none()) {
            let Some(around) = look.around(pixel) else { continue };
            let Some(seen) = around.map(|at| look.nearest(at)).into_iter().collect::<Option<Vec<u32>>>() else { continue };
            let depths = around.map(|at| look.depth(at));
            let spread = depths.iter().copied().fold(f64::NEG_INFINITY, f64::max) - depths.iter().copied().fold(f64::INFINITY, f64::min);
            if NEAR * look.pixel() < spread {
                continue;
            }
            let mut parts: Vec<u32> = seen.iter().map(|seen| survey.triangles[*seen as usize].part).collect();
            parts.sort_unstable();
            parts.dedup();
            if parts.iter().any(|part| open.contains(&survey.parts[*part as usize].rule)) {
                continue;
            }
            parts.truncate(2);
            findings.push(Finding { parts, place: look.place(around[0]), side: Some(look.side) });
        }
    }
    findings
}
