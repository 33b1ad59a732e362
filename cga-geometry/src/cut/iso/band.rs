//! The mesh of one band during a cut.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::crossings::Crossings;
use crate::cut::points::{NONE, PieceCorner};
use crate::mesh::{FaceTag, Mesh};
use crate::origin::PointOrigin;
use crate::small_sort::SmallSort;

/// A band. Until it is finished, its corners are numbers of points of the source, followed by numbers of crossings.
pub(super) struct LineBand {
    pub(super) mesh: Mesh,
    /// The number of faces that were not cut.
    whole: usize,
}

impl LineBand {
    /// An empty band with capacity for an equal share of the source.
    pub(super) fn new(source: &Mesh, bands: usize) -> Self {
        let room = source.corners.len() / bands;
        let mut mesh = source.alike(room);
        mesh.corners.reserve(room);
        mesh.loop_ends.reserve(source.loop_ends.len() / bands);
        LineBand { mesh, whole: 0 }
    }

    /// Adds a face without cutting it.
    pub(super) fn keep(&mut self, source: &Mesh, face: usize, tag: FaceTag) {
        self.whole += 1;
        let loops = source.face_loops(face);
        self.mesh.corners.extend_from_slice(&source.corners[source.corners_of(&loops)]);
        self.mesh.end_copy(source, loops, tag);
    }

    /// Adds corners with their values.
    pub(super) fn corners(&mut self, source: &Mesh, crossings: &Crossings, nodes: &[PieceCorner]) {
        let coordinate = crossings.coordinate;
        for node in nodes {
            self.mesh.corners.push(node.place.number);
            let [from, to] = [node.from as usize, node.to as usize];
            if node.is_corner() {
                self.mesh.add_values(source, from..from + 1);
                continue;
            }
            let share = crossings.share(node.place);
            let cut = source.uv_set(coordinate.set);
            self.mesh.uvs.push(&source.uvs, |list| {
                let mut uv = between(list[from], list[to], share);
                // Also in copies of the set that is cut.
                if [from, to].iter().all(|&end| list[end][coordinate.axis] == cut[end][coordinate.axis]) {
                    uv[coordinate.axis] = crossings.lines[node.class().plane() as usize];
                }
                uv
            });
            if !source.normals.is_empty() {
                let normal = source.normals[from];
                self.mesh.normals.push(normal.lerp(source.normals[to], share).normalize_or(normal));
            }
        }
    }

    /// The finished mesh. The source itself if the band contains all of it, `None` if the band is empty. `points` become the
    /// origins of its points, for a source with a trace.
    pub(super) fn finish(
        mut self,
        source: &Arc<Mesh>,
        numbers: &mut BandNumbers<'_>,
        points: &mut Vec<PointOrigin>,
    ) -> Option<Arc<Mesh>> {
        let faces = self.mesh.face_count();
        if faces == 0 {
            return None;
        }
        if self.whole == source.face_count() && faces == self.whole {
            return Some(source.clone());
        }
        self.mesh.points = numbers.renumber(&mut self.mesh.corners);
        if !source.trace.is_empty() {
            *points = numbers.used.iter().map(|point| numbers.crossings.origin(*point)).collect();
        }
        self.mesh.divide_tags(source, |point| numbers.crossings.origin(numbers.used[point as usize]));
        self.mesh.give_back_room();
        Some(Arc::new(self.mesh.checked()))
    }
}

/// Interpolated coordinates, clamped to the range of the two ends.
fn between(a: DVec2, b: DVec2, share: f64) -> DVec2 {
    let uv = a.lerp(b, share);
    uv.clamp(a.min(b), a.max(b))
}

/// Renumbers the points of each band: points of the source in their order, then crossings.
pub(super) struct BandNumbers<'c> {
    source: &'c Mesh,
    crossings: &'c Crossings,
    new: Vec<u32>,
    used: Vec<u32>,
}

impl<'c> BandNumbers<'c> {
    pub(super) fn new(source: &'c Mesh, crossings: &'c Crossings) -> Self {
        let new = vec![NONE; source.points.len() + crossings.points.len()];
        BandNumbers { source, crossings, new, used: Vec::new() }
    }

    fn renumber(&mut self, corners: &mut [u32]) -> Vec<DVec3> {
        /// A band with more than this share of all points scans all points, which is faster than sorting its own.
        const MANY: usize = 16;
        self.used.clear();
        for &corner in corners.iter() {
            let new = &mut self.new[corner as usize];
            if *new == NONE {
                *new = 0;
                self.used.push(corner);
            }
        }
        if self.used.len() < self.new.len() / MANY {
            self.used.small_sort();
        } else {
            self.used.clear();
            self.used.extend((0..self.new.len() as u32).filter(|&point| self.new[point as usize] != NONE));
        }
        for (number, &point) in self.used.iter().enumerate() {
            self.new[point as usize] = number as u32;
        }
        corners.iter_mut().for_each(|corner| *corner = self.new[*corner as usize]);
        self.used.iter().for_each(|&point| self.new[point as usize] = NONE);
        self.used.iter().map(|&point| self.crossings.position(self.source, point)).collect()
    }
}
