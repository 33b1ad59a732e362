//! The lots around a tile, for rules that ask about other buildings: `touches(inter)`, `minimumDistance(inter, "tower")`.

use cga_geo::footprint::Footprint;
use serde::{Deserialize, Serialize};

/// The distances in metres up to which the rules of a lot find others; see [`cga::Scene`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Distances {
    /// The distance of occlusion queries: `touches`, `overlaps`, `inside`.
    pub occlusion: f64,
    /// The distance of queries of labelled shapes: `minimumDistance`, `contextCount`, `contextCompare`.
    pub context: f64,
}

impl Default for Distances {
    fn default() -> Self {
        Distances { occlusion: 1.0, context: 100.0 }
    }
}

/// The most metres of a distance. Each tile reads the lots around it up to this distance.
pub const MOST_DISTANCE: f64 = 1000.0;

impl Distances {
    /// The larger distance.
    pub fn largest(&self) -> f64 {
        self.occlusion.max(self.context)
    }
}

/// The lots around a tile.
#[derive(Clone, Debug, PartialEq)]
pub struct Surroundings {
    /// The distances of queries.
    pub distances: Distances,
    /// The lots of other tiles that the rules of this one may ask about, by id, then by digest; or the reason why they are left out.
    pub lots: Result<Vec<Footprint>, String>,
    /// The digests of these lots.
    pub digests: Vec<[u8; 32]>,
}

impl Surroundings {
    /// Adds all that a tile depends on to its digest.
    pub(crate) fn add_to(&self, digest: &mut blake3::Hasher) {
        digest.update(b"neighbours");
        for distance in [self.distances.occlusion, self.distances.context] {
            digest.update(&distance.to_le_bytes());
        }
        digest.update(&[u8::from(self.lots.is_ok())]);
        self.digests.iter().for_each(|own| {
            digest.update(own);
        });
    }
}
