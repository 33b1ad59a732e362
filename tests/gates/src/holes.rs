//! Background inside of a silhouette.

use crate::finding::Finding;
use crate::look::Look;
use crate::survey::Survey;

/// The pixels of background with surfaces all around: cracks, holes, open reveals. `open` has the rules of parts with gaps, such as
/// railings and leaves.
pub fn holes(survey: &Survey, looks: &[Look], open: &[&str]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for look in looks {
        let width = look.width;
        for y in 1..look.height - 1 {
            for x in 1..width - 1 {
                let pixel = y * width + x;
                if look.nearest(pixel).is_some() {
                    continue;
                }
                let around = [
                    pixel - width - 1,
                    pixel - width,
                    pixel - width + 1,
                    pixel - 1,
                    pixel + 1,
                    pixel + width - 1,
                    pixel + width,
                    pixel + width + 1,
                ];
                let Some(seen) = around.iter().map(|at| look.nearest(*at)).collect::<Option<Vec<u32>>>() else {
                    continue;
                };
                let mut parts: Vec<u32> = seen.iter().map(|seen| survey.triangles[*seen as usize].part).collect();
                parts.sort_unstable();
                parts.dedup();
                if parts.iter().any(|part| open.contains(&survey.parts[*part as usize].rule)) {
                    continue;
                }
                parts.truncate(2);
                findings.push(Finding { parts, place: look.place(pixel - 1) });
            }
        }
    }
    findings
}
