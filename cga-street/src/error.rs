//! Errors of street networks.

use std::fmt;

/// An error in centre lines or settings.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum StreetError {
    /// A coordinate is NaN, infinite or beyond 100,000 km.
    Point {
        /// The number of the line, from 0.
        line: usize,
        /// The number of the point in the line, from 0.
        point: usize,
    },
    /// A roadway is narrower than 1 cm or wider than 10 km.
    Roadway {
        /// The number of the line, from 0.
        line: usize,
        /// The width in metres.
        width: f64,
    },
    /// The width of a sidewalk is negative, not finite or more than 10 km.
    Sidewalk {
        /// The number of the line, from 0.
        line: usize,
        /// The width in metres.
        width: f64,
    },
    /// A setting is negative, not finite or too large.
    Option {
        /// The name of the field.
        name: &'static str,
        /// The value.
        value: f64,
    },
    /// The borders of streets have too many edges.
    TooLarge {
        /// The most edges.
        most: usize,
    },
    /// The borders of streets cross too often, or very many lie over each other.
    TooDense {
        /// The most crossings.
        most: usize,
    },
    /// Too many streets meet at one point.
    TooManyArms {
        /// The point as (x, z) in metres.
        point: [f64; 2],
        /// The most streets.
        most: usize,
    },
    /// The watch ended the layout.
    Stopped,
}

impl fmt::Display for StreetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StreetError::Point { line, point } => {
                write!(f, "point {point} of line {line} is NaN, infinite or beyond 1e8 m; give metres, not degrees")
            }
            StreetError::Roadway { line, width } => {
                write!(f, "line {line} has a roadway of {width} m; give a width from 0.01 to 10,000")
            }
            StreetError::Sidewalk { line, width } => {
                write!(f, "line {line} has a sidewalk of {width} m; give a width from 0 to 10,000, 0 for none")
            }
            StreetError::Option { name, value } => {
                let most = if *name == "arc_above" { 180 } else { 100 };
                write!(f, "the option `{name}` is {value}; give a number from 0 to {most}")
            }
            StreetError::TooLarge { most } => {
                write!(f, "the borders of the streets have more than {most} edges; divide the network")
            }
            StreetError::TooDense { most } => {
                write!(f, "too many streets cross or lie over each other: at most {most} crossings; divide the network")
            }
            StreetError::TooManyArms { point: [x, z], most } => {
                write!(f, "more than {most} streets meet at ({x}, {z}); remove lines there")
            }
            StreetError::Stopped => write!(f, "the watch ended the layout of the streets; give it more time"),
        }
    }
}

impl std::error::Error for StreetError {}
