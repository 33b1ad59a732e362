//! Surfaces whose backs are seen.

use crate::finding::Finding;
use crate::look::Look;
use crate::survey::Survey;

/// The pixels that show the back of a surface. A viewer that draws fronts alone shows a hole there. Clear parts are looked at and
/// through.
pub fn back_faces(survey: &Survey, looks: &[Look]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for look in looks {
        for pixel in 0..look.pixels() {
            let seen = [look.nearest(pixel), look.opaque(pixel)].into_iter().flatten();
            let back = seen.map(|seen| &survey.triangles[seen as usize]).find(|triangle| look.is_back(triangle));
            findings.extend(back.map(|triangle| Finding {
                parts: vec![triangle.part],
                place: look.place(pixel),
                side: Some(look.side),
            }));
        }
    }
    findings
}
