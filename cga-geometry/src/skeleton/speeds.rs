//! The speeds of edges.

/// The speeds of the edges of a polygon, from 0 to 1, and the meaning of points at one place.
#[derive(Clone, Copy, Debug)]
pub enum Speeds<'a> {
    /// All edges have speed 1.
    Equal,
    /// One for each edge. The times of points are heights, as of a roof: points at one place at different times are
    /// different, and the strip of an edge with speed 0 has no area. Neighbours in one line with different speeds are refused.
    Heights(&'a [f64]),
    /// The same, but of neighbours in one line the faster one takes the place of the slower one.
    Slopes(&'a [f64]),
    /// One for each edge. Only places count: points at one place are the same, and blunt corners between different speeds
    /// are divided.
    Places(&'a [f64]),
}

impl Speeds<'_> {
    /// The speed of an edge.
    pub(crate) fn of(&self, edge: usize) -> f64 {
        match self {
            Speeds::Equal => 1.0,
            Speeds::Heights(each) | Speeds::Slopes(each) | Speeds::Places(each) => each[edge],
        }
    }

    /// Returns true if the times of points are heights.
    pub(super) fn has_heights(&self) -> bool {
        matches!(self, Speeds::Heights(_) | Speeds::Slopes(_))
    }
}
