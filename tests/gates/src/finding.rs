//! The findings of the gates.

use std::collections::BTreeMap;

use cga::glam::DVec3;

use crate::survey::Survey;

/// An error at one place of a model.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The numbers of the parts that are involved: one, or two.
    pub parts: Vec<u32>,
    /// The place in the world, in metres.
    pub place: DVec3,
    /// The azimuth and the elevation from which it is seen, in degrees.
    pub side: Option<[f64; 2]>,
}

/// A text for a list of findings: a line for each pair of rules, with the number, the first place and the trail of each part. Empty
/// without findings.
pub fn report(survey: &Survey, findings: &[Finding]) -> String {
    let mut groups: BTreeMap<Vec<String>, (usize, &Finding)> = BTreeMap::new();
    for finding in findings {
        let trails: Vec<String> = finding.parts.iter().map(|&part| survey.parts[part as usize].trail.clone()).collect();
        groups.entry(trails).or_insert((0, finding)).0 += 1;
    }
    let mut groups: Vec<_> = groups.into_iter().collect();
    groups.sort_by(|a, b| b.1.0.cmp(&a.1.0).then_with(|| a.0.cmp(&b.0)));
    let line = |(trails, (count, first)): (Vec<String>, (usize, &Finding))| {
        let DVec3 { x, y, z } = first.place;
        let side = first.side.map_or(String::new(), |[azimuth, elevation]| format!(" from {azimuth}°, {elevation}°"));
        format!("{count} x, first at ({x:.2}, {y:.2}, {z:.2}){side}: {}\n", trails.join("  beside  "))
    };
    groups.into_iter().map(line).collect()
}
