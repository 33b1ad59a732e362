//! Errors of mesh construction.

use std::fmt;

/// An error in points or faces.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshError {
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// The number of the point, in the given order.
        point: usize,
    },
    /// The index of a corner's point is out of range.
    OutOfRange {
        /// The number of the face.
        face: usize,
        /// The index.
        index: u32,
    },
    /// A loop has fewer than three corners.
    ShortLoop {
        /// The number of the face.
        face: usize,
        /// The number of the loop, 0 for the outline.
        ring: usize,
    },
    /// The number of texture coordinates or normals of a face differs from the number of its corners.
    CornerCount {
        /// The number of the face.
        face: usize,
    },
    /// The number of a texture set is out of range: sets have the numbers 0 to 9.
    UvSet {
        /// The number of the set.
        set: usize,
    },
    /// A face uses a group or material that does not exist.
    Tag {
        /// The number of the face.
        face: usize,
    },
    /// The outline has no area.
    ZeroArea,
    /// Two edges of a polygon cross, overlap, or touch where they should not.
    SelfCrossing {
        /// The first edge: its loop (0 for the outline) and the number of its first point in that loop.
        first: (usize, usize),
        /// The other edge.
        second: (usize, usize),
    },
    /// A hole is outside the outline, or inside another hole.
    HolePlace {
        /// The number of the hole, from 0.
        hole: usize,
        /// The hole around it; `None` if the hole is outside the outline.
        within: Option<usize>,
    },
    /// There are more points, corners or faces than 32-bit indices can count.
    TooLarge,
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |ring: usize| if ring == 0 { "the outline".to_string() } else { format!("hole {}", ring - 1) };
        match self {
            MeshError::NotFinite { point } => write!(f, "point {point} has a coordinate that is not finite"),
            MeshError::OutOfRange { face, index } => write!(f, "face {face} uses point {index}, which does not exist"),
            MeshError::ShortLoop { face, ring } => {
                write!(f, "{} of face {face} has fewer than three corners", name(*ring))
            }
            MeshError::CornerCount { face } => {
                write!(f, "face {face} has texture coordinates or normals for another number of corners")
            }
            MeshError::Tag { face } => write!(f, "face {face} uses a group or material that does not exist"),
            MeshError::ZeroArea => write!(f, "the polygon has no area"),
            MeshError::SelfCrossing { first, second } => {
                write!(f, "edge {} of {} meets edge {} of {}", first.1, name(first.0), second.1, name(second.0))
            }
            MeshError::HolePlace { hole, within: None } => write!(f, "hole {hole} is outside the outline"),
            MeshError::HolePlace { hole, within: Some(other) } => write!(f, "hole {hole} is inside hole {other}"),
            MeshError::UvSet { set } => write!(f, "texture set {set} does not exist; use 0 to 9"),
            MeshError::TooLarge => write!(f, "more points or corners than 32-bit indices can count"),
        }
    }
}

impl std::error::Error for MeshError {}

/// The error of an operation whose result would have more corners than the limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyCorners {
    /// The limit.
    pub most: usize,
}

impl fmt::Display for TooManyCorners {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the mesh would have more than {} corners", self.most)
    }
}

impl std::error::Error for TooManyCorners {}
