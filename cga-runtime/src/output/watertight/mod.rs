//! Leaves without cracks between them.
//!
//! A floor with five windows is below a floor with four: the corners of the one are inside the edges of the other. Graphics cards round
//! the corners of triangles to parts of a pixel, so single pixels between the two floors show what is behind them.

mod held;
mod known_edges;
mod network;
mod numbered_keys;
mod search;
mod straight;
mod subdivided;

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use self::held::{Held, HeldGeometry};
use self::network::Network;
use self::straight::StraightCorners;
use self::subdivided::{PlacedMesh, Subdivider};
use crate::geometry::mesh::{Bounds, Mesh};
use crate::geometry::work::{self, Supervisor};
use crate::run::building::Building;
use crate::run::sink::{Cuboid, Flow, Leaf, Quad, Sink};
use crate::run::watch::Watch;

/// A sink that passes leaves on to another one, with the corners of all leaves of an initial shape as corners of the edges that they lie
/// in. Then neighbours have the same edges, and graphics cards leave out no pixel between them.
///
/// It works with every sink, and texture coordinates, normals, rules, materials and tags stay. Faces with points or straight corners in
/// their sides become triangles, and none of these has three points in one line. Leaves without such faces are passed on as they were. A
/// corner that touches the inside of a face is no crack, also on the diagonal between two triangles of the face: it stays as it is.
///
/// The leaves of one initial shape are in memory at a time. Different initial shapes keep their own corners, and so do inserted assets
/// that nothing has cut ([`Sink::instance`]): one mesh serves all their places. Each added corner adds one triangle: the house of the README
/// gets 1.6 times as many triangles.
///
/// The time grows with the number of corners, times its logarithm. Runs ask their watch meanwhile. A shape with very many parts in one
/// place could need corners without limit; it gets at most eight times its own, and some of its edges keep points inside.
///
/// [`Model::watertight`](crate::output::model::Model::watertight) does the same for a model.
///
/// ```
/// # use cga_runtime::facade as cga;
/// use cga::sink::watertight::Watertight;
/// use cga::{Leaf, Model, Quad, Sink, Text};
/// # use std::sync::Arc;
/// # use cga::glam::DVec3;
/// # use cga::{Material, Scope};
/// # let (material, scope) = (Arc::new(Material::default()), Scope { origin: DVec3::ZERO, axes: cga::glam::DMat3::IDENTITY, size: DVec3::ONE });
/// let name = Text::fixed("Wall");
/// let leaf = Leaf::new(&name, &material, &scope);
/// let wall = |x: f64, y: f64, width: f64| Quad::new(DVec3::new(x, y, 0.0), DVec3::X * width, DVec3::Y);
/// let mut sink = Watertight::new(Model::new());
/// // One wall of two metres below two of one metre each.
/// for quad in [wall(0.0, 0.0, 2.0), wall(0.0, 1.0, 1.0), wall(1.0, 1.0, 1.0)] {
///     let _ = sink.quad(&leaf, &quad);
/// }
/// let model = sink.into_inner();
/// let points: Vec<usize> = model.leaves().map(|leaf| leaf.mesh().0.points().len()).collect();
/// assert_eq!(points, [5, 4, 4]);
/// ```
#[derive(Clone, Debug, Default)]
pub struct Watertight<S> {
    inner: S,
    held: Vec<Held>,
    watch: Option<Watch>,
    /// True after the other sink or the watch has ended the run.
    ended: bool,
}

/// The most corners that a shape may get, for each of its corners, and for every shape. Only shapes with many parts in one place have more.
const MOST_CORNERS: (usize, usize) = (8, 1 << 16);

/// The units of work of a leaf.
const LEAF: usize = 64;

impl<S: Sink> Watertight<S> {
    /// Passes leaves on to `inner`.
    pub fn new(inner: S) -> Self {
        Watertight { inner, held: Vec::new(), watch: None, ended: false }
    }

    /// Asks a watch while it works. In a run it asks the watch of the run, so this is for leaves that come from elsewhere, such as
    /// [`Model::replay`](crate::output::model::Model::replay). After the watch is stopped, the leaves of the initial shape are passed on as they
    /// were, and the next leaf ends the run.
    #[must_use]
    pub fn with_watch(self, watch: Watch) -> Self {
        Watertight { watch: Some(watch), ..self }
    }

    /// The other sink, with all leaves. It is not [finished](Sink::finish).
    pub fn into_inner(mut self) -> S {
        self.pass_held();
        self.inner
    }

    fn flow(&self) -> Flow {
        if self.ended { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn hold(&mut self, leaf: &Leaf<'_>, geometry: HeldGeometry) -> Flow {
        self.flow()?;
        self.held.push(Held::new(leaf, geometry));
        ControlFlow::Continue(())
    }

    /// Passes on the leaves of the initial shape that has ended.
    fn pass_held(&mut self) {
        let held = std::mem::take(&mut self.held);
        if held.is_empty() || self.ended {
            return;
        }
        let watch = self.watch.clone();
        let _supervisor = watch.map(|watch| Supervisor::new(move |units| watch.allows(units)));
        // Small shapes would end before the first question.
        let goes_on = self.watch.is_none() || work::ask();
        let flow = match goes_on {
            true => pass_divided(&held, &mut self.inner),
            false => held.iter().try_for_each(|leaf| leaf.pass_to(&mut self.inner)),
        };
        self.ended = flow.is_break() || self.watch.as_ref().is_some_and(Watch::is_stopped);
    }
}

/// Passes leaves on with all points inside of their edges.
fn pass_divided<S: Sink>(held: &[Held], sink: &mut S) -> Flow {
    let (mut bounds, mut points, mut corners) = (Bounds::EMPTY, Vec::new(), 0);
    for leaf in held {
        if let Some(faces) = leaf.faces(&mut points) {
            corners += faces.mesh.corners().len();
            let is_finite = |point: &DVec3| point.is_finite();
            bounds = bounds.union(Bounds::of(points.iter().copied().filter(is_finite)));
        }
    }
    let mut network = Network::new(bounds, corners);
    let mut parts = Vec::with_capacity(held.len());
    for leaf in held {
        let faces = leaf.faces(&mut points);
        if !work::spend(LEAF + points.len()) {
            break;
        }
        parts.push(faces.map(|faces| (network.add(faces.mesh, &points, faces.is_box), faces.is_unit)));
    }
    let mut goes_on = network.find_points();
    let near = network.near();
    let (mut subdivider, mut straight) = (Subdivider::default(), StraightCorners::default());
    let mut room = MOST_CORNERS.0 * corners + MOST_CORNERS.1;
    for (number, leaf) in held.iter().enumerate() {
        let part = parts.get(number).copied().flatten();
        goes_on = goes_on && work::spend(LEAF + part.map_or(0, |(part, _)| part.size()));
        let divided = part.filter(|_| goes_on && 0 < room).and_then(|(part, is_unit)| {
            let mut has_straight =
                || leaf.faces(&mut points).is_some_and(|faces| straight.are_in(faces.mesh, &points, near));
            if network.count_inside(part) == 0 && (is_unit || !has_straight()) {
                return None;
            }
            let whole;
            let placed = if leaf.is_plain_unit() {
                PlacedMesh::at(leaf.faces(&mut points)?.mesh, &points)
            } else {
                whole = leaf.mesh()?;
                PlacedMesh::of(&whole)
            };
            let made = subdivider.subdivided(&placed, &network, part, (!is_unit).then_some(near))?;
            let rest = room.checked_sub(made.corners().len());
            room = rest.unwrap_or_default();
            rest.map(|_| made)
        });
        match divided {
            Some(mesh) => sink.mesh(&leaf.leaf(), &Arc::new(mesh), &DAffine3::IDENTITY)?,
            None => leaf.pass_to(sink)?,
        }
    }
    ControlFlow::Continue(())
}

impl<S: Sink> Sink for Watertight<S> {
    fn begin(&mut self) {
        self.pass_held();
        self.inner.begin();
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        self.hold(leaf, HeldGeometry::Quad(*quad))
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.hold(leaf, HeldGeometry::Cuboid(*cuboid))
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.hold(leaf, HeldGeometry::Mesh(mesh.clone(), *placement))
    }

    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.hold(leaf, HeldGeometry::Instance(mesh.clone(), *placement))
    }

    fn placement(&mut self, leaf: &Leaf<'_>) -> Flow {
        self.hold(leaf, HeldGeometry::Placement)
    }

    fn begin_building(&mut self, name: &str, seed: u64) {
        self.pass_held();
        self.inner.begin_building(name, seed);
    }

    fn end_building(&mut self, building: &dyn Fn() -> Building) {
        self.pass_held();
        self.inner.end_building(building);
    }

    fn keeps_tree(&self) -> bool {
        self.inner.keeps_tree()
    }

    fn finish(&mut self) -> Flow {
        self.pass_held();
        self.flow()?;
        self.inner.finish()
    }
}

#[cfg(test)]
mod tests;
