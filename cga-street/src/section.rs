//! Cross-sections of a chain: the positions of its four borders.

use cga_geometry::each::Each;
use glam::DVec2;

use super::chain::Polyline;
use super::grid::Point;

/// A position on a chain where it can be cut across.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Station {
    /// At a vertex of the chain, along the mitre.
    Vertex(usize),
    /// In a segment, at a distance from the start of the chain, at a right angle.
    Within(usize, f64),
}

/// A cross-section: from the left border of the left sidewalk to the right border of the right one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CrossSection {
    /// The distance from the start of the chain.
    pub(super) along: f64,
    pub(super) height: f64,
    pub(super) borders: [Point; 4],
}

/// The shortest part of a segment between its mitres that can be cut, in metres.
const LEAST_CORE: f64 = 0.05;

impl Polyline {
    /// The cross-section at a station.
    pub(super) fn section(&self, station: Station) -> CrossSection {
        let (along, place, across, height) = match station {
            Station::Vertex(at) => (self.along[at], self.place(at), self.mitre(at), self.points[at].z),
            Station::Within(segment, along) => {
                let part = (along - self.along[segment]) / (self.along[segment + 1] - self.along[segment]);
                let [low, high] = [self.points[segment].z, self.points[segment + 1].z];
                let place = self.place(segment).lerp(self.place(segment + 1), part);
                (along, place, self.direction(segment).perp(), low + (high - low) * part)
            }
        };
        CrossSection {
            along,
            height,
            borders: self.widths.borders().each(|distance| Point::near(place + across * distance)),
        }
    }

    /// The vector across the chain at a vertex. Times a border's distance it gives the border's offset.
    pub(super) fn mitre(&self, at: usize) -> DVec2 {
        let [before, after] = self.segments_at(at).each(|segment| self.direction(segment).perp());
        (before + after) / (1.0 + before.dot(after))
    }

    /// The range of distances from the start where a segment can be cut at a right angle. `None` if the mitres leave no
    /// room.
    fn core(&self, segment: usize) -> Option<[f64; 2]> {
        let widest = self.widths.half + self.widths.left.max(self.widths.right);
        let reach = |at: usize| widest * libm::tan(self.bend(at).abs() / 2.0);
        let core = [self.along[segment] + reach(segment), self.along[segment + 1] - reach(segment + 1)];
        (core[0] + LEAST_CORE < core[1]).then_some(core)
    }

    /// The first station at or after a distance from the start.
    pub(super) fn station_after(&self, along: f64) -> Station {
        if along <= 0.0 {
            return Station::Vertex(0);
        }
        let segment = self.segment_at(along);
        match self.core(segment) {
            // The end of the chain has no mitre, so its section can be used.
            Some([low, high]) if along <= high => self.within(segment, along.max(low)),
            _ => Station::Vertex(segment + 1),
        }
    }

    /// The last station at or before a distance from the start.
    pub(super) fn station_before(&self, along: f64) -> Station {
        if self.length() <= along {
            return Station::Vertex(self.len());
        }
        let segment = self.segment_at(along);
        match self.core(segment) {
            Some([low, high]) if low <= along => self.within(segment, along.min(high)),
            _ => Station::Vertex(segment),
        }
    }

    fn within(&self, segment: usize, along: f64) -> Station {
        if along <= self.along[segment] {
            Station::Vertex(segment)
        } else if self.along[segment + 1] <= along {
            Station::Vertex(segment + 1)
        } else {
            Station::Within(segment, along)
        }
    }

    fn segment_at(&self, along: f64) -> usize {
        self.along[1..self.len()].partition_point(|&start| start <= along)
    }

    /// The distance of a station from the start.
    pub(super) fn along(&self, station: Station) -> f64 {
        match station {
            Station::Vertex(at) => self.along[at],
            Station::Within(_, along) => along,
        }
    }

    /// The same station, counted in the other direction.
    pub(super) fn reversed_station(&self, station: Station) -> Station {
        match station {
            Station::Vertex(at) => Station::Vertex(self.len() - at),
            Station::Within(segment, along) => Station::Within(self.len() - 1 - segment, self.length() - along),
        }
    }

    /// A border of the chain as a poly-line, at a distance from the centre line, positive on the left.
    pub(super) fn border(&self, distance: f64) -> Vec<DVec2> {
        (0..=self.len()).map(|at| self.place(at) + self.mitre(at) * distance).collect()
    }

    /// Returns true if a border has no length beside a segment, because both ends bend towards it.
    pub(super) fn is_folded(&self, segment: usize, distance: f64) -> bool {
        let shorter = |at: usize| distance * libm::tan(self.bend(at) / 2.0);
        let length = self.along[segment + 1] - self.along[segment];
        length - shorter(segment) - shorter(segment + 1) < 0.01 * length
    }
}
