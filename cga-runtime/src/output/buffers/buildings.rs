//! The buildings whose triangles buffers have.

use std::collections::VecDeque;
use std::ops::Range;

use super::{Buffers, Submesh};
use crate::run::building::Building;

/// The buildings of buffers that record them, in order.
#[derive(Clone, Debug, Default)]
pub(super) struct Buildings {
    /// Each with the numbers of indices and of vertices up to its last ones.
    complete: Vec<(Building, (usize, usize))>,
    /// The one whose leaves come now; it has its name and its seed alone.
    open: Option<Building>,
}

impl Buildings {
    pub(super) fn begin(&mut self, name: &str, seed: u64) {
        self.open = Some(Building::new(name, seed));
    }

    pub(super) fn end(&mut self, building: Building, end: (usize, usize)) {
        self.open = None;
        self.complete.push((building, end));
    }

    /// Removes all but the one whose leaves come now.
    pub(super) fn clear(&mut self) {
        self.complete.clear();
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
        let ends = self.building_ends().map(|(building, (indices, _))| (building, indices));
        ends.scan(0, |start, (building, end)| Some((building, std::mem::replace(start, end)..end)))
    }

    /// The buildings, each with the numbers of indices and of vertices up to its last ones.
    fn building_ends(&self) -> impl Iterator<Item = (&Building, (usize, usize))> {
        self.buildings.iter().flat_map(|own| {
            let open = own.open.iter().map(|open| (open, (self.indices().len(), self.vertices().len())));
            own.complete.iter().map(|(building, end)| (building, *end)).chain(open)
        })
    }

    /// The submeshes of each building, divided where buildings end. The last list has the submeshes of no building.
    pub(crate) fn submeshes_of_buildings(&self) -> Vec<(Option<&Building>, Vec<Submesh>)> {
        let mut rest: VecDeque<Submesh> = self.submeshes().collect();
        let mut lists = Vec::new();
        for (building, (indices, vertices)) in self.building_ends() {
            let mut own = Vec::new();
            while let Some(next) = rest.front_mut().filter(|next| next.indices.start < indices) {
                let is_whole = next.indices.end <= indices;
                let end = if is_whole { (next.indices.end, next.vertices.end) } else { (indices, vertices) };
                own.push(Submesh {
                    indices: next.indices.start..end.0,
                    vertices: next.vertices.start..end.1,
                    ..next.clone()
                });
                (next.indices.start, next.vertices.start) = end;
                if is_whole {
                    rest.pop_front();
                }
            }
            lists.push((Some(building), own));
        }
        lists.push((None, rest.into()));
        lists
    }
}
