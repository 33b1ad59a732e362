//! The places where vertices meet.

use glam::DVec2;

use super::wavefront::Wavefront;

/// The place where vertices meet: their mean. The faster a vertex, the less accurate its position.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Meeting {
    /// A node that was made at the current time.
    known: Option<u32>,
    sum: DVec2,
    weights: f64,
}

impl Meeting {
    pub(super) fn add(&mut self, front: &Wavefront, vertex: u32) {
        let position = front.positions[vertex as usize];
        let vertex = &front.vertices[vertex as usize];
        if vertex.born == front.now {
            self.known = self.known.or(Some(vertex.node));
        }
        let weight = 1.0 / vertex.velocity.length_squared().max(1.0);
        self.sum += position * weight;
        self.weights += weight;
    }

    /// The node of the skeleton at this place.
    pub(super) fn node(self, front: &mut Wavefront) -> u32 {
        self.known.unwrap_or_else(|| front.node(self.sum / self.weights))
    }
}
