//! The buildings whose triangles buffers have.

#[cfg(feature = "gltf")]
use std::collections::VecDeque;
use std::ops::Range;

use super::Buffers;
#[cfg(feature = "gltf")]
use super::Submesh;
use crate::run::building::Building;

/// The buildings of buffers that record them, in order.
#[derive(Clone, Debug, Default)]
pub(super) struct Buildings {
    complete: Vec<(Building, BuildingRange)>,
    /// The one whose leaves come now, with its name and its seed alone, and the place of its first leaf.
    open: Option<(Building, Place)>,
}

/// The numbers of indices and of vertices before a place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place {
    pub(super) indices: usize,
    #[cfg_attr(not(feature = "gltf"), expect(dead_code, reason = "only GLB files divide vertices"))]
    pub(super) vertices: usize,
}

/// The triangles of a building.
type BuildingRange = Range<Place>;

impl Buildings {
    pub(super) fn begin(&mut self, name: &str, seed: u64, at: Place) {
        self.open = Some((Building::new(name, seed), at));
    }

    pub(super) fn end(&mut self, building: Building, at: Place) {
        let start = self.open.take().map_or(at, |(_, start)| start);
        self.complete.push((building, start..at));
    }

    /// Removes all but the one whose leaves come now.
    pub(super) fn clear(&mut self) {
        self.complete.clear();
        self.open.iter_mut().for_each(|(_, start)| *start = Place::default());
    }
}

impl Buffers {
    /// Records which triangles belong to which initial shape; see [`Buffers::buildings`].
    pub fn with_buildings(mut self) -> Self {
        self.buildings = Some(Buildings::default());
        self
    }

    /// The initial shapes whose triangles the buffers have, each with the range of its [indices](Buffers::indices); none without
    /// [`Buffers::with_buildings`]. A building that is not complete, as in a chunk that ends inside of it, has its name and its seed alone.
    pub fn buildings(&self) -> impl Iterator<Item = (&Building, Range<usize>)> {
        self.building_ranges().map(|(building, range)| (building, range.start.indices..range.end.indices))
    }

    /// The place after the last triangle.
    pub(super) fn end(&self) -> Place {
        Place { indices: self.indices().len(), vertices: self.vertices().len() }
    }

    fn building_ranges(&self) -> impl Iterator<Item = (&Building, BuildingRange)> {
        self.buildings.iter().flat_map(|own| {
            let open = own.open.iter().map(|(open, start)| (open, *start..self.end()));
            own.complete.iter().map(|(building, range)| (building, range.clone())).chain(open)
        })
    }

    /// The submeshes of each building, divided where buildings end, and of the triangles between them.
    #[cfg(feature = "gltf")]
    pub(crate) fn submeshes_of_buildings(&self) -> Vec<(Option<&Building>, Vec<Submesh>)> {
        let mut rest: VecDeque<Submesh> = self.submeshes().collect();
        let mut lists = Vec::new();
        for (building, range) in self.building_ranges() {
            lists.push((None, take_until(range.start, &mut rest)));
            lists.push((Some(building), take_until(range.end, &mut rest)));
        }
        lists.push((None, rest.into()));
        lists
    }
}

/// Removes the submeshes before a place; one that the place divides stays with its second part.
#[cfg(feature = "gltf")]
fn take_until(end: Place, list: &mut VecDeque<Submesh>) -> Vec<Submesh> {
    let mut taken = Vec::new();
    while let Some(next) = list.front_mut().filter(|next| next.indices.start < end.indices) {
        if next.indices.end <= end.indices {
            taken.extend(list.pop_front());
            continue;
        }
        let (indices, vertices) = (next.indices.start..end.indices, next.vertices.start..end.vertices);
        taken.push(Submesh { indices, vertices, ..next.clone() });
        (next.indices.start, next.vertices.start) = (end.indices, end.vertices);
    }
    taken
}
