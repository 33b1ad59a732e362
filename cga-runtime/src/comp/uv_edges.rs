//! The edges of faces in texture space.

use glam::DVec2;

use super::select::UvSide;
use crate::geometry::each::Each;
use crate::geometry::mesh::Mesh;
use crate::geometry::tol::{NEXT_EPSILON, TIE_EPSILON};

/// The texture coordinates of a mesh, for the selectors of edges (*setback operation*).
#[derive(Debug)]
pub(super) struct UvEdges {
    set: usize,
    /// The smallest and the largest coordinates; `None` if there are none.
    range: Option<[DVec2; 2]>,
    /// 1 for each face that is counter-clockwise in texture space, −1 for others.
    turns: Vec<f64>,
}

impl UvEdges {
    pub(super) fn of(mesh: &Mesh, set: usize) -> Self {
        let range = mesh.uv_range(set);
        let uvs = mesh.uv_set(set);
        let area = |ring: std::ops::Range<usize>| -> f64 {
            let first = uvs[ring.start];
            uvs[ring].windows(2).map(|pair| (pair[0] - first).perp_dot(pair[1] - first)).sum()
        };
        let turn = |area: f64| if area < 0.0 { -1.0 } else { 1.0 };
        let turns = if range.is_none() {
            Vec::new()
        } else {
            mesh.faces().map(|face| turn(face.loop_ranges().map(area).sum())).collect()
        };
        UvEdges { set, range, turns }
    }

    /// Returns true if a selector takes the edge between two corners of a face. Without coordinates, none is taken.
    ///
    /// The direction of an edge is the axis along which its outward normal in texture space is longest, u if both are
    /// equal. Edges without length there have no direction.
    pub(super) fn takes(&self, mesh: &Mesh, face: usize, ends: [u32; 2], side: UvSide) -> bool {
        let Some([low, high]) = self.range else { return false };
        let [a, b] = ends.each(|corner| mesh.uv_set(self.set)[corner as usize]);
        let is_at = |axis: usize, of: DVec2| {
            let far = low[axis].abs().max(high[axis].abs()).max(1.0);
            [a, b].iter().all(|uv| (uv[axis] - of[axis]).abs() <= far * NEXT_EPSILON)
        };
        let outwards = -(b - a).perp() * self.turns[face];
        let along_u = outwards.y.abs() <= outwards.x.abs() * (1.0 + TIE_EPSILON) && outwards.x != 0.0;
        let along_v = !along_u && outwards.y != 0.0;
        match side {
            UvSide::Left => along_u && outwards.x < 0.0,
            UvSide::Right => along_u && 0.0 < outwards.x,
            UvSide::Bottom => along_v && outwards.y < 0.0,
            UvSide::Top => along_v && 0.0 < outwards.y,
            UvSide::UMin => is_at(0, low),
            UvSide::UMax => is_at(0, high),
            UvSide::VMin => is_at(1, low),
            UvSide::VMax => is_at(1, high),
        }
    }
}
