//! Why a mesh could not be made.

use std::fmt;

/// What is wrong with points and faces handed in.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshError {
    /// A coordinate is not a number or infinite.
    NotFinite {
        /// Which point, in the order handed in.
        point: usize,
    },
    /// A corner names a point that does not exist.
    OutOfRange {
        /// Which face.
        face: usize,
        /// The index it uses.
        index: u32,
    },
    /// A loop has fewer than three corners.
    ShortLoop {
        /// Which face.
        face: usize,
        /// Which of its loops, 0 for the outline.
        ring: usize,
    },
    /// A face got texture coordinates or normals for another number of corners than it has.
    CornerCount {
        /// Which face.
        face: usize,
    },
    /// There is no such set of texture coordinates: they go from 0 to 9.
    UvSet {
        /// The number given.
        set: usize,
    },
    /// A face names a group or material that does not exist.
    Tag {
        /// Which face.
        face: usize,
    },
    /// The outline encloses nothing.
    ZeroArea,
    /// Two edges of a polygon cross, overlap, or touch where they should not.
    SelfCrossing {
        /// The first edge: loop (0 for the outline) and number of its first point within that loop.
        first: (usize, usize),
        /// The other edge.
        second: (usize, usize),
    },
    /// A hole that lies outside of the outline, or inside of another hole.
    HolePlace {
        /// Which hole, from 0.
        hole: usize,
        /// The hole it lies in; `None` when it is outside of the outline.
        within: Option<usize>,
    },
    /// More points, corners or faces than indices of 32 bits can count.
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
                write!(f, "face {face} has another number of corners than of texture coordinates or normals")
            }
            MeshError::Tag { face } => write!(f, "face {face} names a group or material that does not exist"),
            MeshError::ZeroArea => write!(f, "the polygon has no area"),
            MeshError::SelfCrossing { first, second } => {
                write!(f, "edge {} of {} meets edge {} of {}", first.1, name(first.0), second.1, name(second.0))
            }
            MeshError::HolePlace { hole, within: None } => write!(f, "hole {hole} lies outside of the outline"),
            MeshError::HolePlace { hole, within: Some(other) } => write!(f, "hole {hole} lies inside of hole {other}"),
            MeshError::UvSet { set } => write!(f, "there is no texture set {set}: they go from 0 to 9"),
            MeshError::TooLarge => write!(f, "more points or corners than 32-bit indices can count"),
        }
    }
}

impl std::error::Error for MeshError {}

/// An operation would make a mesh with more corners than it may.
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
