//! The limit on entries of reports and on printed lines.

/// The bytes of all keys and texts that are kept; the limits count entries, not their length.
pub(super) const MOST_BYTES: usize = 64 << 20;

/// The room that entries have taken, and the number of entries for which there was none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Quota {
    entries: u64,
    pub(super) bytes: usize,
    pub(crate) left_out: u64,
}

impl Quota {
    /// Takes room for one more entry of `bytes` bytes, or counts it as left out.
    pub(super) fn take(&mut self, bytes: usize, limit: u64) -> bool {
        let has_room = self.entries < limit && self.bytes + bytes <= MOST_BYTES;
        if has_room {
            self.entries += 1;
            self.bytes += bytes;
        } else {
            self.left_out += 1;
        }
        has_room
    }
}
