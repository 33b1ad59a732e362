//! The mesh of one slab during a cut.

use std::ops::Range;
use std::sync::Arc;

use super::points::{CutPoints, Location, NONE, PieceCorner};
use crate::mesh::{FaceTag, Mesh, keep_used};
use crate::origin::PointOrigin;

/// The mesh of a slab, and the number of its faces that were not cut.
pub(crate) struct Slab {
    pub(crate) mesh: Mesh,
    pub(crate) whole: usize,
    /// True if a piece was dropped because it has no extent. Then some points may be unused.
    pub(crate) dropped: bool,
    /// The face that must come first.
    pub(crate) lead: Option<usize>,
}

impl Slab {
    /// An empty part with capacity for points, corners and loops.
    pub(crate) fn new(source: &Mesh, points: usize, corners: usize, loops: usize) -> Self {
        let mut mesh = source.alike(corners);
        mesh.points.reserve(points);
        mesh.corners.reserve(corners);
        mesh.loop_ends.reserve(loops);
        if !source.normals.is_empty() {
            mesh.normals.reserve(corners);
        }
        Slab { mesh, whole: 0, dropped: false, lead: None }
    }

    /// Adds a triangle of the source. `numbers` are the numbers of its corners in this part.
    #[inline]
    pub(crate) fn keep_triangle(&mut self, source: &Mesh, tag: FaceTag, corners: Range<usize>, numbers: [u32; 3]) {
        self.whole += 1;
        self.piece(tag, numbers);
        self.mesh.add_values(source, corners);
    }

    /// The number of a point in this slab. A point on a plane gets its number at the first request.
    #[inline]
    pub(crate) fn number(&mut self, points: &mut CutPoints, place: Location, slab: u32) -> u32 {
        if !place.class.is_on_plane() {
            return place.number;
        }
        let plane = place.class.plane();
        let numbers = &mut points.levels[plane as usize].numbers[place.number as usize];
        let number = &mut numbers[usize::from(slab != plane)];
        if *number != NONE {
            return *number;
        }
        let new = self.mesh.points.len() as u32;
        *number = new;
        self.mesh.add_point(points.lift(plane, place.number))
    }

    /// Adds corners of a piece with their values.
    #[inline(always)]
    pub(crate) fn corners(&mut self, points: &mut CutPoints, source: &Mesh, nodes: &[PieceCorner], slab: u32) {
        for node in nodes {
            let number = self.number(points, node.place, slab);
            self.mesh.corners.push(number);
        }
        self.carry(points, source, nodes);
    }

    /// Adds the values of corners of a piece.
    #[inline(always)]
    pub(crate) fn carry(&mut self, points: &CutPoints, source: &Mesh, nodes: &[PieceCorner]) {
        if !source.uvs.is_empty() {
            for node in nodes {
                let share = if node.is_corner() { 0.0 } else { points.share(node.place) };
                self.mesh.uvs.push(&source.uvs, |list| {
                    let uv = list[node.from as usize];
                    if node.is_corner() { uv } else { uv.lerp(list[node.to as usize], share) }
                });
            }
        }
        if !source.normals.is_empty() {
            self.mesh.normals.extend(nodes.iter().map(|node| {
                let normal = source.normals[node.from as usize];
                if node.is_corner() {
                    return normal;
                }
                normal.lerp(source.normals[node.to as usize], points.share(node.place)).normalize_or(normal)
            }));
        }
    }

    /// Adds a piece with one loop, without the values of its corners. The numbers of its points are known.
    #[inline(always)]
    pub(crate) fn piece<const N: usize>(&mut self, tag: FaceTag, numbers: [u32; N]) {
        self.mesh.corners.extend(numbers);
        self.mesh.end_loop();
        self.mesh.end_face(tag);
    }

    /// The finished mesh. The source itself if the part contains all of it, `None` if the part is empty. `origins` are the
    /// origins of its points, if edges or vertices of the source have tags.
    pub(crate) fn finish(mut self, source: &Arc<Mesh>, closed: bool, origins: &[PointOrigin]) -> Option<Arc<Mesh>> {
        let faces = self.mesh.face_ends.len();
        if faces == 0 {
            return None;
        }
        if self.whole == source.face_ends.len() && faces == self.whole {
            return Some(source.clone());
        }
        if self.dropped {
            self.mesh.points = keep_used(&self.mesh.points, &mut self.mesh.corners);
        }
        if let Some(lead) = self.lead {
            self.mesh.bring_to_front(lead);
        }
        self.mesh.divide_tags(source, |point| origins[point as usize]);
        self.mesh.give_back_room();
        let mesh = self.mesh.checked();
        Some(Arc::new(if closed { mesh.known_closed(true) } else { mesh }))
    }
}
