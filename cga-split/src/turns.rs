//! The repetitions of groups.

/// The repetitions of a group.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turns {
    /// The number of repetitions in each repetition of the group around it: a whole number.
    pub(crate) count: f64,
    /// The final length of one repetition.
    pub(crate) length: f64,
    /// The room for all repetitions. The last one may be cut.
    pub(crate) room: f64,
}

impl Turns {
    pub(crate) const NONE: Turns = Turns { count: 0.0, length: 0.0, room: f64::INFINITY };

    /// The end of the room of a group that begins at `start`.
    #[inline]
    pub(crate) fn limit(&self, start: f64, limit: f64, smallest: f64) -> f64 {
        let end = start + self.room;
        if limit - smallest <= end { limit } else { end }
    }

    /// The end of repetition `number`, counted from 1, of a group that begins at `start`.
    ///
    /// Borders are measured from the group's start. So a million repetitions do not drift, and the computation of one
    /// does not wait for the one before it.
    #[inline]
    pub(crate) fn border(&self, number: f64, start: f64, limit: f64, smallest: f64) -> f64 {
        let border = start + number * self.length;
        if limit - smallest <= border { limit } else { border }
    }
}
