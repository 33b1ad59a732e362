//! The origins of the points of slabs, for meshes with a trace or with tags of edges and vertices.

use super::class::ClassRange;
use super::points::{Location, NONE};
use super::segment::comes_first;
use super::state::CutState;
use crate::each::Each;
use crate::mesh::Mesh;
use crate::origin::PointOrigin;

impl CutState {
    /// The origin of each point of each slab, if the mesh needs them.
    #[inline]
    pub(super) fn needed_origins(&self, mesh: &Mesh) -> impl Iterator<Item = Vec<PointOrigin>> + use<> {
        if mesh.needs_origins() { self.origins(mesh).into_iter() } else { Vec::new().into_iter() }
    }

    /// The origin of each point of each slab, in the order of the finished meshes.
    fn origins(&self, mesh: &Mesh) -> Vec<Vec<PointOrigin>> {
        let of_part = |part: &super::slab::Slab| vec![PointOrigin::New; part.mesh.points.len()];
        let mut lists: Vec<Vec<PointOrigin>> = self.parts.iter().map(of_part).collect();
        let mut put = |place: Location, origin: PointOrigin| {
            if !place.class.is_on_plane() {
                set(&mut lists, place.class.slab(), place.number, origin);
                return;
            }
            let plane = place.class.plane();
            let numbers = self.points.levels[plane as usize].numbers[place.number as usize];
            set(&mut lists, plane, numbers[0], origin);
            set(&mut lists, plane + 1, numbers[1], origin);
        };
        for (place, point) in self.points.places.iter().zip(0..) {
            put(*place, PointOrigin::Old(point));
        }
        let axis = self.points.axis;
        for (ends, first) in self.points.edges.all() {
            let [a, b] = ends.each(|end| self.points.places[end as usize].class);
            let planes = ClassRange::between(a, b).planes();
            let [p, q] = ends.each(|end| mesh.points[end as usize]);
            // Both orders of the ends give the same share.
            let (ends, from, to) = if comes_first(p, q) { (ends, p, q) } else { ([ends[1], ends[0]], q, p) };
            for (plane, index) in planes.clone().zip(0..) {
                let number =
                    if planes.len() == 1 { Some(&first) } else { self.points.crossings.get((first + index) as usize) };
                let at = self.points.planes[plane as usize];
                let share = (at - from[axis]) / (to[axis] - from[axis]);
                if let Some(number) = number {
                    put(Location::on(plane, *number), PointOrigin::Between { ends, share });
                }
            }
        }
        for (list, part) in lists.iter_mut().zip(&self.parts).filter(|(_, part)| part.dropped) {
            let mut used = vec![false; list.len()];
            part.mesh.corners.iter().for_each(|corner| used[*corner as usize] = true);
            let mut is_used = used.into_iter();
            list.retain(|_| is_used.next() == Some(true));
        }
        lists
    }
}

fn set(lists: &mut [Vec<PointOrigin>], slab: u32, number: u32, origin: PointOrigin) {
    if number != NONE
        && let Some(slot) = lists.get_mut(slab as usize).and_then(|list| list.get_mut(number as usize))
    {
        *slot = origin;
    }
}
