//! A lot as machines send it to each other.

use cga_geo::footprint::Footprint;

use super::work::LoadedWork;
use crate::area::Area;
use crate::cell::key;

/// Some lots in numbers. Their order does not matter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sums {
    /// The number of lots.
    pub lots: u64,
    /// The bytes of their footprints.
    pub bytes: u64,
    /// The sums of the lower and of the upper halves of 64 bits of their digests.
    pub digests: [u64; 2],
}

impl Sums {
    /// A lot, by the bytes of its footprint.
    pub fn of(bytes: &[u8]) -> Self {
        let [a, b, c, d, e, f, g, h, ..] = *blake3::hash(bytes).as_bytes();
        let digests = [[a, b, c, d], [e, f, g, h]].map(|half| u64::from(u32::from_le_bytes(half)));
        Sums { lots: 1, bytes: bytes.len() as u64, digests }
    }

    /// Adds other lots.
    pub fn add(&mut self, other: Sums) {
        self.lots += other.lots;
        self.bytes += other.bytes;
        self.digests = [0, 1].map(|half| self.digests[half].wrapping_add(other.digests[half]));
    }
}

/// A checked lot.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitLot {
    /// Its place along the curve; see [`key`].
    pub key: u64,
    /// The class of its size; see [`Area::class`].
    pub class: u8,
    /// It alone in numbers.
    pub sums: Sums,
    /// The box around it if its rules ask about neighbours.
    pub area: Option<Area>,
    /// Its footprint as bytes.
    pub bytes: Vec<u8>,
}

impl UnitLot {
    /// The lot of a footprint.
    pub fn new(footprint: &Footprint, work: &LoadedWork) -> Self {
        let (middle, area, bytes) = (footprint.middle(), Area::of(footprint), footprint.to_bytes());
        let asks = work.asks(footprint);
        UnitLot {
            key: key(middle),
            class: area.class(middle),
            sums: Sums::of(&bytes),
            area: asks.then_some(area),
            bytes,
        }
    }
}
