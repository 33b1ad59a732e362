//! Streets, sidewalks and junctions from centre lines.
//!
//! [`Network::new`] joins [`Centerline`]s to a graph and returns the parts of its streets. Each part is a mesh on the
//! ground with texture coordinates, and a grammar can start with its [`NetworkPart::shape`]. The start rules are CityEngine's
//! (*Help*, street and intersection shapes): `Street` and `Sidewalk` along lines, `Joint`, `Junction` and `Crossing` at
//! meeting points.
//!
//! ```
//! use cga_street::{Centerline, Kind, Network, NetworkOptions};
//!
//! // A main street of 100 m along x, and a narrower one that comes from the south.
//! let lines = [
//!     Centerline::new(&[[-50.0, 0.0], [50.0, 0.0]]),
//!     Centerline::new(&[[0.0, 0.0], [0.0, 60.0]]).roadway(6.0).sidewalks(1.5, 1.5),
//! ];
//! let network = Network::new(&lines, &NetworkOptions::default())?;
//! let count = |kind| network.parts().iter().filter(|part| part.kind == kind).count();
//! assert_eq!((count(Kind::Street), count(Kind::Junction)), (3, 1));
//!
//! let street = network.parts().iter().find(|part| part.line == Some(1)).unwrap();
//! assert_eq!((street.start_rule(), street.width), ("Street", 6.0));
//! // Set 0 goes from 0 to 1, set 1 counts metres from the start.
//! let most = |set: usize| street.mesh.uv_set(set).iter().map(|uv| uv.x).fold(0.0, f64::max);
//! assert_eq!((most(0), most(1)), (1.0, street.length));
//! let _lot = street.shape();
//! # Ok::<(), cga_street::StreetError>(())
//! ```
//!
//! Conventions: x and z in metres, y up. Lines that cross are joined regardless of their heights, so bridges need a
//! network of their own. The parts of a network do not overlap and leave no gaps. Parts with a common border share its
//! points to the bit, because all parts are faces of one subdivision of the plane on a grid of 60 nm.

#![forbid(unsafe_code)]

mod cell;
mod chain;
mod conflict;
mod error;
#[cfg(feature = "geo-types")]
mod geo;
mod graph;
mod grid;
mod input;
mod junction;
mod mesh;
mod outline;
mod parts;
mod pieces;
mod progress;
mod rounding;
mod section;
mod segment_tree;
mod subdivision;
#[cfg(test)]
mod tests;

pub use error::StreetError;
pub use input::{Centerline, NetworkOptions};

use std::collections::BTreeMap;

use cga_geometry::each::Each;
use cga_geometry::mesh::Mesh;
use cga_geometry::small_sort::SmallSort;
use cga_geometry::work::Supervisor;
use cga_runtime::run::watch::Watch;
use cga_runtime::shape::Shape;

/// The limit on crossings of street borders, which bounds memory and time.
const MOST_CROSSINGS: usize = 2_000_000;

/// The kind of a part of a network.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Kind {
    /// The roadway of a line between junctions.
    Street,
    /// The sidewalk beside a street or around the corner of a junction.
    Sidewalk,
    /// The roadway where two arms with different widths meet, or in a bend that is too tight for quads.
    Joint,
    /// The roadway where one arm meets a street that continues straight.
    Junction,
    /// The roadway of any other junction.
    Crossing,
}

/// A side of a line, relative to its direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Side {
    /// The left side.
    Left,
    /// The right side.
    Right,
}

/// A part of a network.
///
/// Texture coordinates of streets and of the sidewalks beside them (*Help*, street and intersection shape UV): in set
/// 0, u goes from 0 to 1 in the direction of the line and v from 0 to 1 across, over all faces. In sets 1 and 2, u is
/// the distance in metres along the centre line from the start and from the end, and v the distance across. Roadways
/// have v = 0 on the right, sidewalks at the kerb. Other parts have only set 0. Sidewalks around corners have it as
/// above. Roadways of junctions are projected from above, from 0 to 1 along and across the first arm.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct NetworkPart {
    /// The kind of the part.
    pub kind: Kind,
    /// The side of the line that a sidewalk is on.
    pub side: Option<Side>,
    /// The number of the line of a street, or of a sidewalk beside it.
    pub line: Option<usize>,
    /// The length in metres along the centre line; of junctions, the extent along the first arm.
    pub length: f64,
    /// The width in metres; of junctions, the extent across the first arm.
    pub width: f64,
    /// The number of streets that end at a junction, 0 for streets and sidewalks.
    pub arms: usize,
    /// The mesh, in the world. Streets are quads along the centre line; the first edge of each is on the right, along
    /// the street. The first edges of sidewalks are at the kerb.
    pub mesh: Mesh,
}

impl NetworkPart {
    /// CityEngine's start rule for the part: the name of its kind.
    pub fn start_rule(&self) -> &'static str {
        match self.kind {
            Kind::Street => "Street",
            Kind::Sidewalk => "Sidewalk",
            Kind::Joint => "Joint",
            Kind::Junction => "Junction",
            Kind::Crossing => "Crossing",
        }
    }

    /// The initial shape of a run, named after its start rule. The x axis of its scope is along the first edge.
    pub fn shape(&self) -> Shape {
        Shape::mesh(self.mesh.clone()).named(self.start_rule())
    }

    /// The borders of the part as loops of points in the world. Seen from above, outlines are counter-clockwise and
    /// holes clockwise.
    pub fn outlines(&self) -> Vec<Vec<[f64; 3]>> {
        outlines(&self.mesh)
    }
}

/// The streets, sidewalks and junctions of some centre lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Network {
    parts: Vec<NetworkPart>,
}

impl Network {
    /// Lays out the streets of centre lines. Lines without length are skipped. Of coincident lines the first one is
    /// kept.
    ///
    /// # Errors
    /// [`StreetError`] if a coordinate, a width or a setting is NaN, infinite or out of range, if more than 256 streets meet at one
    /// point, if the lines cross millions of times, if very many lie over each other, or if their borders have more than ten
    /// million edges.
    pub fn new(lines: &[Centerline], options: &NetworkOptions) -> Result<Self, StreetError> {
        // The watch of a run around this call does not end it.
        let _supervisor = Supervisor::new(|_| true);
        Network::within(lines, options, conflict::MOST_ATTEMPTS)
    }

    /// The same as [`Network::new`], until the watch is stopped or its time is over.
    ///
    /// ```
    /// use std::time::Duration;
    ///
    /// # mod cga { pub use cga_runtime::run::watch::Watch; pub use cga_street as street; }
    /// use cga::Watch;
    /// use cga::street::{Centerline, Network, NetworkOptions, StreetError};
    ///
    /// let lines = [Centerline::new(&[[0.0, 0.0], [50.0, 0.0]])];
    /// let network = Network::with_watch(&lines, &NetworkOptions::default(), &Watch::deadline(Duration::from_secs(5)))?;
    /// assert_eq!(network.parts().len(), 3);
    ///
    /// let stopped = Watch::new();
    /// stopped.stop();
    /// assert_eq!(Network::with_watch(&lines, &NetworkOptions::default(), &stopped), Err(StreetError::Stopped));
    /// # Ok::<(), StreetError>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`Network::new`], and [`StreetError::Stopped`] if the watch ends the layout.
    pub fn with_watch(lines: &[Centerline], options: &NetworkOptions, watch: &Watch) -> Result<Self, StreetError> {
        let watch = watch.clone();
        if watch.is_stopped() {
            return Err(StreetError::Stopped);
        }
        let _supervisor = Supervisor::new(move |_| !watch.is_stopped());
        Network::within(lines, options, conflict::MOST_ATTEMPTS)
    }

    /// The network after a number of attempts to find a plan without overlaps.
    fn within(lines: &[Centerline], options: &NetworkOptions, attempts: usize) -> Result<Self, StreetError> {
        input::check(lines, options)?;
        let graph = graph::Graph::new(lines, options)?;
        let (chains, nodes) = chain::chains(&graph, lines, options)?;
        let mut plan = pieces::JunctionDraft::new(chains, nodes, options.corner_radius);
        let pieces = conflict::resolve(&mut plan, attempts)?;
        Ok(Network { parts: parts::parts(&plan, &pieces)? })
    }

    /// The parts: streets and sidewalks in the order of lines, then corners, then junctions.
    pub fn parts(&self) -> &[NetworkPart] {
        &self.parts
    }

    /// Converts the network into its parts.
    pub fn into_parts(self) -> Vec<NetworkPart> {
        self.parts
    }
}

/// The loops of edges of a mesh that belong to one face only.
fn outlines(mesh: &Mesh) -> Vec<Vec<[f64; 3]>> {
    let (adjacency, corners) = (mesh.adjacency(), mesh.corners());
    let mut next: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for corner in (0..corners.len() as u32).filter(|&corner| adjacency.is_border(adjacency.edge(corner))) {
        let [a, b] = [corner, adjacency.next(corner)].each(|corner| corners[corner as usize]);
        next.entry(a).or_default().push(b);
    }
    next.values_mut().for_each(|ends| ends.small_sort());
    let mut loops = Vec::new();
    while let Some((&from, _)) = next.first_key_value() {
        let mut ring = Vec::new();
        let mut at = from;
        while let Some(list) = next.get_mut(&at) {
            ring.push(mesh.points()[at as usize].to_array());
            let to = list.pop();
            if list.is_empty() {
                next.remove(&at);
            }
            match to {
                Some(to) => at = to,
                None => break,
            }
        }
        loops.push(ring);
    }
    loops
}

/// The code of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
