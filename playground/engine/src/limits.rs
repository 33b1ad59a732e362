//! The limits of runs in a page.

use cga::Limits;

/// A page must stay responsive, and a 32-bit memory has 4 GB.
pub(crate) const LIMITS: Limits = Limits {
    shapes: 400_000,
    depth: 1024,
    vertices: 4_000_000,
    waiting: 50_000,
    calls: 10_000_000,
    reports: 1000,
    prints: 200,
    array: 100_000,
    text: 1_000_000,
    bytes: 700_000_000,
};

/// The most seconds of a run.
pub(crate) const SECONDS: u64 = 10;
