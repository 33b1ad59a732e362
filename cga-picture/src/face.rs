//! The faces that a scene takes.

use glam::{DVec2, DVec3};

use crate::paint::PaintId;

/// A flat face, as triangles.
///
/// The lists for corners are as long as `corners`. A triangle with the index of a missing corner is not drawn.
#[derive(Clone, Copy, Debug)]
pub struct Face<'a> {
    /// The points of the corners, in the world.
    pub corners: &'a [DVec3],
    /// The triangles, as indices of corners. Their winding does not matter.
    pub triangles: &'a [[u32; 3]],
    /// The unit normal of the front. Both sides are visible.
    pub normal: DVec3,
    /// The paint.
    pub paint: PaintId,
    /// A number of the caller's choice. [`Lines::Leaves`](crate::Lines::Leaves) draws the borders between faces with different
    /// numbers, and [`Renderer::leaves`](crate::Renderer::leaves) finds the number at each pixel.
    pub leaf: u32,
    /// True if the face may be a facet of a round surface. If a scene has such faces, light is smoothed over neighbouring
    /// faces with similar normals.
    pub round: bool,
    /// The unit normals of the corners, for smooth shading.
    pub normals: Option<&'a [DVec3]>,
    /// The places of the corners in the paint's colour image. The image fills the square from (0, 0), at its lower left, to
    /// (1, 1), and repeats.
    pub color_uvs: Option<&'a [DVec2]>,
    /// The places of the corners in the paint's opacity image.
    pub opacity_uvs: Option<&'a [DVec2]>,
    /// The places of the corners in the paint's normal map.
    pub normal_uvs: Option<&'a [DVec2]>,
}

impl<'a> Face<'a> {
    /// A face with the leaf 0, without normals of its corners and without texture coordinates.
    pub fn new(corners: &'a [DVec3], triangles: &'a [[u32; 3]], normal: DVec3, paint: PaintId) -> Self {
        Face {
            corners,
            triangles,
            normal,
            paint,
            leaf: 0,
            round: false,
            normals: None,
            color_uvs: None,
            opacity_uvs: None,
            normal_uvs: None,
        }
    }
}
