//! Surfaces in one place.

use crate::finding::Finding;
use crate::look::Look;
use crate::survey::Survey;

/// The pixels with two surfaces of different materials in one place: a depth buffer shows one or the other by chance.
pub fn fights(survey: &Survey, looks: &[Look]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for look in looks {
        findings.extend(look.doubled.iter().map(|(pixel, pair)| {
            let mut parts: Vec<u32> = pair.iter().map(|seen| survey.triangles[*seen as usize].part).collect();
            parts.dedup();
            Finding { parts, place: look.place(*pixel), side: Some(look.side) }
        }));
    }
    findings
}
