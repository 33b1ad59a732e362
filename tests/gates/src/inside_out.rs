//! Closed parts whose outside is inside.

use crate::finding::Finding;
use crate::survey::Survey;

/// Volumes in cubic metres that are nearer to 0 are flat.
const FLAT: f64 = 1e-9;

/// The closed parts with a negative volume. Viewers draw their far sides.
pub fn inside_out(survey: &Survey) -> Vec<Finding> {
    let parts = survey.parts.iter().enumerate().filter(|(_, part)| part.closed && part.volume < -FLAT);
    parts.map(|(number, part)| Finding { parts: vec![number as u32], place: part.middle, side: None }).collect()
}
