//! `cleanupGeometry`: merges parts that are nearly the same.

use super::reshaped::put_reshaped;
use crate::geometry::cleanup::{Parts, cleanup};
use crate::run::env::Env;
use crate::shape::{Geometry, Shape};

/// The parts that `cleanupGeometry` cleans up. All of them merge vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CleanupComponents {
    /// Vertices between collinear edges.
    Vertices,
    /// Edges between coplanar faces.
    Edges,
    /// Doubled and small faces.
    Faces,
    /// All of these.
    All,
}

/// `cleanupGeometry(components, tolerance)` (*cleanupGeometry operation*). With the tolerance 0 only parts go that change nothing
/// except for rounding. With the tolerance `t` vertices within `t` metres are one, edges and normals within `10 t` degrees are
/// collinear and coplanar if nothing moves by more than `t` metres, and faces of up to `t` square metres go. Values outside 0 to 1
/// count as the nearest of them.
///
/// A vertex becomes the first one near it, except where that would turn a face over. Edges stay if they have tags, if their faces
/// differ in tags, group or material, if the texture is not continuous across them, or if more than two faces have them. Vertices
/// with tags stay, and so do those between edges with different tags. First edges stay.
///
/// A closed mesh stays closed: a face that closes it stays however small it is, and of two opposite faces inside a solid both go.
/// Otherwise one of doubled or opposite faces stays. The scope is fitted to the geometry. If nothing is left, the shape has no
/// geometry.
pub fn cleanup_geometry(env: &mut Env, shape: &mut Shape, components: CleanupComponents, tolerance: f64) {
    let tolerance = env.finite(tolerance, "the tolerance of `cleanupGeometry`").clamp(0.0, 1.0);
    let parts = |one: CleanupComponents| components == one || components == CleanupComponents::All;
    let parts = Parts {
        vertices: parts(CleanupComponents::Vertices),
        edges: parts(CleanupComponents::Edges),
        faces: parts(CleanupComponents::Faces),
    };
    if is_clean(shape, tolerance) {
        return;
    }
    let mesh = shape.to_mesh();
    if env.count_vertices(&mesh).is_continue()
        && let Some(made) = cleanup(&mesh, parts, tolerance)
    {
        put_reshaped(shape, made);
    }
}

/// Returns true for boxes and rectangles that are larger than the tolerance, and for geometry without faces.
fn is_clean(shape: &Shape, tolerance: f64) -> bool {
    let size = shape.scope.size.abs();
    let is_large = |lengths: &[f64]| lengths.iter().all(|&length| tolerance < length);
    match shape.geometry {
        Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => true,
        Geometry::Box(_) => is_large(&size.to_array()),
        Geometry::Rect(axis, _) => {
            let sides: Vec<f64> = (0..3).filter(|&other| other != axis.index()).map(|other| size[other]).collect();
            is_large(&sides) && tolerance < sides[0] * sides[1]
        }
        Geometry::Mesh(_) => false,
    }
}
