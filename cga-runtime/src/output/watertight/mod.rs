//! Leaves without cracks between them.
//!
//! A floor with five windows is below a floor with four: the corners of the one are inside the edges of the other. Graphics cards round
//! the corners of triangles to parts of a pixel, so single pixels between the two floors show what is behind them.

mod edge_points;
mod subdivided;

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use self::edge_points::{EdgePoints, Points};
use self::subdivided::subdivided;
use crate::geometry::mesh::{Bounds, Mesh};
use crate::geometry::uv_map::SetMap;
use crate::material::Material;
use crate::output::near_origin::near_origin;
use crate::run::building::Building;
use crate::run::sink::{Cuboid, Flow, Leaf, Quad, Sink, cuboid_mesh, quad_mesh};
use crate::shape::scope::Scope;
use crate::value::text::Text;

/// A sink that passes leaves on to another one, with the corners of all leaves of an initial shape as corners of the edges that they lie
/// in. Then neighbours have the same edges, and no pixel between them is left out. In faces as narrow as frames of windows, some points may
/// remain inside of edges.
///
/// It works with every sink, and texture coordinates, normals, rules, materials and tags stay. Faces with additional points become
/// triangles; a leaf without additional points is passed on as it was. The leaves of one initial shape are in memory at a time. Different initial
/// shapes keep their own corners, and so do inserted assets that nothing has cut ([`Sink::instance`]): one mesh serves all their places.
///
/// A house of 8,000 triangles gets 1.6 to 1.8 times as many. [`Model::watertight`](crate::output::model::Model::watertight) does the same
/// for a model.
///
/// ```
/// # use cga_runtime as cga;
/// use cga::output::model::Model;
/// use cga::output::watertight::Watertight;
/// use cga::run::sink::{Leaf, Quad, Sink};
/// use cga::value::text::Text;
/// # use std::sync::Arc;
/// # use cga::glam::DVec3;
/// # use cga::material::Material;
/// # use cga::shape::scope::Scope;
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
    /// True after the other sink has ended the run.
    ended: bool,
}

/// A leaf that waits for the other leaves of its initial shape.
#[derive(Clone, Debug)]
struct Held {
    rule: Text,
    material: Arc<Material>,
    scope: Scope,
    uvs: Vec<SetMap>,
    geometry: HeldGeometry,
}

#[derive(Clone, Debug)]
enum HeldGeometry {
    Placement,
    Quad(Quad),
    Cuboid(Cuboid),
    Mesh(Arc<Mesh>, DAffine3),
    Instance(Arc<Mesh>, DAffine3),
}

impl Held {
    fn leaf(&self) -> Leaf<'_> {
        Leaf::new(&self.rule, &self.material, &self.scope).with_uvs(&self.uvs)
    }

    /// Calls `each` with the points of each loop of the faces, in the world.
    fn loops(&self, each: &mut dyn FnMut(&[DVec3])) {
        match &self.geometry {
            HeldGeometry::Placement | HeldGeometry::Instance(..) => {}
            HeldGeometry::Quad(quad) => each(&quad.corners()),
            HeldGeometry::Cuboid(cuboid) => cuboid.faces().iter().for_each(|face| each(&face.corners())),
            HeldGeometry::Mesh(mesh, placement) => {
                let mut points = Vec::new();
                for face in mesh.faces() {
                    for ring in face.loops() {
                        points.clear();
                        points.extend(
                            ring.iter().map(|&point| placement.transform_point3(mesh.points()[point as usize])),
                        );
                        each(&points);
                    }
                }
            }
        }
    }

    /// Passes the leaf on as it was.
    fn pass_to<S: Sink>(&self, sink: &mut S) -> Flow {
        match &self.geometry {
            HeldGeometry::Placement => sink.placement(&self.leaf()),
            HeldGeometry::Quad(quad) => sink.quad(&self.leaf(), quad),
            HeldGeometry::Cuboid(cuboid) => sink.cuboid(&self.leaf(), cuboid),
            HeldGeometry::Mesh(mesh, placement) => sink.mesh(&self.leaf(), mesh, placement),
            HeldGeometry::Instance(mesh, placement) => sink.instance(&self.leaf(), mesh, placement),
        }
    }

    /// Passes the leaf on with all points inside of its edges.
    fn pass_divided_to<S: Sink>(&self, sink: &mut S, edges: &EdgePoints) -> Flow {
        let mut divides = false;
        self.loops(&mut |ring| divides |= edges.divides(ring));
        if !divides {
            return self.pass_to(sink);
        }
        let leaf = self.leaf();
        let (mesh, placement) = match &self.geometry {
            HeldGeometry::Quad(quad) => (quad_mesh(&leaf, quad), DAffine3::IDENTITY),
            HeldGeometry::Cuboid(cuboid) => (cuboid_mesh(&leaf, cuboid), DAffine3::IDENTITY),
            HeldGeometry::Mesh(mesh, placement) => (mesh.clone(), *placement),
            HeldGeometry::Placement | HeldGeometry::Instance(..) => return self.pass_to(sink),
        };
        sink.mesh(&leaf, &Arc::new(subdivided(&mesh, &placement, edges)), &placement)
    }
}

impl<S: Sink> Watertight<S> {
    /// Passes leaves on to `inner`.
    pub fn new(inner: S) -> Self {
        Watertight { inner, held: Vec::new(), ended: false }
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
        self.held.push(Held {
            rule: leaf.rule.clone(),
            material: leaf.material.clone(),
            scope: leaf.scope(),
            uvs: leaf.uvs().to_vec(),
            geometry,
        });
        ControlFlow::Continue(())
    }

    /// Passes on the leaves of the initial shape that has ended.
    fn pass_held(&mut self) {
        let held = std::mem::take(&mut self.held);
        if held.is_empty() || self.ended {
            return;
        }
        let mut bounds = Bounds::EMPTY;
        held.iter().for_each(|leaf| leaf.loops(&mut |ring| bounds = bounds.union(Bounds::of(ring.iter().copied()))));
        let mut points = Points::new(near_origin(bounds));
        held.iter().for_each(|leaf| leaf.loops(&mut |ring| points.add(ring)));
        let edges = points.edges();
        let flow = held.iter().try_for_each(|leaf| leaf.pass_divided_to(&mut self.inner, &edges));
        self.ended = flow.is_break();
    }
}

impl<S: Sink> Sink for Watertight<S> {
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
