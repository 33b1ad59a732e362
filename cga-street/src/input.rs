//! Centre lines and the settings of a network.

use super::StreetError;

/// A centre line with the widths of its street.
///
/// Lines are joined wherever they meet: at common ends, at vertices and along segments. Left and right are relative to
/// the direction of the line.
#[derive(Clone, Debug, PartialEq)]
pub struct Centerline {
    pub(super) points: Vec<[f64; 3]>,
    pub(super) roadway: f64,
    pub(super) sidewalks: [f64; 2],
}

impl Centerline {
    /// A line on the ground: points as (x, z) in metres, as arrays, pairs or [`DVec2`](glam::DVec2). The roadway is 8 m
    /// wide, the sidewalks 2 m each.
    pub fn new<P: Copy + Into<[f64; 2]>>(points: &[P]) -> Self {
        let on_ground = |&point: &P| {
            let [x, z] = point.into();
            [x, 0.0, z]
        };
        Centerline::with_heights(&points.iter().map(on_ground).collect::<Vec<_>>())
    }

    /// A line in space: points as (x, y, z) in metres, y up. The widths are as in [`Centerline::new`].
    pub fn with_heights<P: Copy + Into<[f64; 3]>>(points: &[P]) -> Self {
        Centerline { points: points.iter().map(|&point| point.into()).collect(), roadway: 8.0, sidewalks: [2.0; 2] }
    }

    /// The same line with a roadway of another width in metres.
    #[must_use]
    pub fn roadway(self, width: f64) -> Self {
        Centerline { roadway: width, ..self }
    }

    /// The same line with sidewalks of other widths in metres, 0 for none.
    #[must_use]
    pub fn sidewalks(self, left: f64, right: f64) -> Self {
        Centerline { sidewalks: [left, right], ..self }
    }
}

/// The settings of a network.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct NetworkOptions {
    /// Ends of lines within this distance of another line, in metres, are moved onto it. Edges shorter than this are
    /// contracted. 0.5 by default.
    pub snap: f64,
    /// The radius in metres of the kerb at the corners of junctions, 4 by default. It is reduced if there is too little
    /// room.
    pub corner_radius: f64,
    /// Bends of centre lines by more than this angle in degrees become arcs if there is room, 30 by default. Other
    /// bends get a mitre.
    pub arc_above: f64,
}

impl Default for NetworkOptions {
    fn default() -> Self {
        NetworkOptions { snap: 0.5, corner_radius: 4.0, arc_above: 30.0 }
    }
}

/// The largest coordinate in metres. Beyond the length of the equator grid points would not be exact as f64.
const MOST_COORDINATE: f64 = 1e8;

/// The largest width in metres.
const MOST_WIDTH: f64 = 1e4;

/// The largest snapping distance and radius of a corner in metres.
const MOST_SNAP: f64 = 100.0;

/// The smallest width of a roadway in metres.
const LEAST_ROADWAY: f64 = 0.01;

/// Checks that lines and settings are usable.
pub(super) fn check(lines: &[Centerline], options: &NetworkOptions) -> Result<(), StreetError> {
    for (name, value, most) in [
        ("snap", options.snap, MOST_SNAP),
        ("corner_radius", options.corner_radius, MOST_SNAP),
        ("arc_above", options.arc_above, 180.0),
    ] {
        if !(0.0..=most).contains(&value) {
            return Err(StreetError::Option { name, value });
        }
    }
    for (number, line) in lines.iter().enumerate() {
        let far = |point: &[f64; 3]| !point.iter().all(|value| value.abs() <= MOST_COORDINATE);
        if let Some(point) = line.points.iter().position(far) {
            return Err(StreetError::Point { line: number, point });
        }
        if !(LEAST_ROADWAY..=MOST_WIDTH).contains(&line.roadway) {
            return Err(StreetError::Roadway { line: number, width: line.roadway });
        }
        if let Some(&width) = line.sidewalks.iter().find(|width| !(0.0..=MOST_WIDTH).contains(*width)) {
            return Err(StreetError::Sidewalk { line: number, width });
        }
    }
    Ok(())
}
