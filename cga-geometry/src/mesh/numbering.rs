//! The numbers of points: unused points are dropped, and the others numbered again.

use glam::DVec3;

use super::Mesh;
use crate::origin::PointOrigin;
use crate::work;

/// The corners that are numbered between two counts of work.
const PART: usize = 1 << 14;

/// The points that corners use, in their old order. Renumbers the corners; -0 becomes 0.
pub(crate) fn keep_used(points: &[DVec3], corners: &mut [u32]) -> Vec<DVec3> {
    let mut new = vec![u32::MAX; points.len()];
    for &c in corners.iter() {
        new[c as usize] = 0;
    }
    let mut kept = Vec::with_capacity(points.len());
    for (slot, &p) in new.iter_mut().zip(points) {
        if *slot == 0 {
            *slot = kept.len() as u32;
            kept.push(p + 0.0);
        }
    }
    for c in corners {
        *c = new[*c as usize];
    }
    kept
}

impl Mesh {
    /// Drops unused points, and numbers the others in the order of their first use; -0 becomes 0. Returns their numbers before.
    /// For meshes without traces and tags of edges and vertices. If the work is to end, the mesh and the numbers have no meaning.
    pub(crate) fn number_by_use(&mut self) -> Vec<u32> {
        let (mut new, mut before) = (vec![u32::MAX; self.points.len()], Vec::with_capacity(self.points.len()));
        for part in self.corners.chunks_mut(PART) {
            if !work::spend(part.len()) {
                break;
            }
            for corner in part {
                let number = &mut new[*corner as usize];
                if *number == u32::MAX {
                    *number = before.len() as u32;
                    before.push(*corner);
                }
                *corner = *number;
            }
        }
        self.points = before.iter().map(|point| self.points[*point as usize] + 0.0).collect();
        before
    }

    /// Drops unused points; -0 becomes 0. Returns the numbers of the others before. For meshes without traces and tags of edges and
    /// vertices.
    pub(crate) fn number_used(&mut self) -> Vec<u32> {
        let mut is_used = vec![false; self.points.len()];
        self.corners.iter().for_each(|corner| is_used[*corner as usize] = true);
        self.points = keep_used(&self.points, &mut self.corners);
        (0..).zip(is_used).filter(|(_, is_used)| *is_used).map(|(point, _)| point).collect()
    }

    /// Renumbers the tags of edges and vertices. `before` are the corners with the old numbers of points. Tags without an
    /// edge or a vertex are dropped.
    pub(super) fn renumber_tags(&mut self, before: &[u32]) {
        if self.subcomponent_tags.is_empty() {
            return;
        }
        let mut old = vec![0; self.points.len()];
        self.corners.iter().zip(before).for_each(|(new, before)| old[*new as usize] = *before);
        let origin = |point: u32| PointOrigin::Old(old[point as usize]);
        let tags = self.subcomponent_tags.carried(&mut self.face_edges(), self.points.len(), &origin);
        self.subcomponent_tags = tags;
    }
}
