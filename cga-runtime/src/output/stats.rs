//! Counts and measures without storage: for tests, benches and the cost of a rule. Texture coordinates are not
//! counted.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use super::buffers::Vertex;
use super::flatten::{Flattener, corner_point};
use super::leaf_numbers::Numbers;
use super::measure::{cuboid_area, cuboid_volume, mesh_area, mesh_volume};
use crate::geometry::each::Each;
use crate::geometry::mesh::{Bounds, Mesh};
use crate::run::sink::{Cuboid, Filled, Flow, Leaf, Quad, Replay, Sink};
use crate::shape::base::Form;
use crate::shape::filled_scope;
use crate::value::text::Text;

/// Sums over leaves. Triangles and vertices are counted as [`super::buffers::Buffers`] makes them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measures {
    /// The number of leaves.
    pub leaves: u64,
    /// The number of triangles.
    pub triangles: u64,
    /// The number of unshared vertices.
    pub vertices: u64,
    /// The surface in square metres. It includes all six sides of a box, but not holes.
    pub area: f64,
    /// The enclosed volume in cubic metres. Rectangles add nothing; the volume of other open geometry has no meaning.
    pub volume: f64,
}

/// A sink that measures its leaves.
#[derive(Clone, Debug)]
pub struct Stats {
    numbers: Numbers,
    rules: Vec<Measures>,
    checksum: f64,
    bounds: Bounds,
    flattener: Flattener,
}

impl PartialEq for Stats {
    /// Compares all counts and measures.
    fn eq(&self, other: &Self) -> bool {
        self.rules().eq(other.rules()) && self.checksum == other.checksum && self.bounds == other.bounds
    }
}

impl Default for Stats {
    fn default() -> Self {
        Stats {
            numbers: Numbers::default(),
            rules: Vec::new(),
            checksum: 0.0,
            bounds: Bounds::EMPTY,
            flattener: Flattener::default(),
        }
    }
}

impl Stats {
    /// Statistics without leaves.
    pub fn new() -> Self {
        Stats::default()
    }

    /// The measures of all leaves.
    pub fn total(&self) -> Measures {
        self.rules.iter().fold(Measures::default(), |sum, m| Measures {
            leaves: sum.leaves + m.leaves,
            triangles: sum.triangles + m.triangles,
            vertices: sum.vertices + m.vertices,
            area: sum.area + m.area,
            volume: sum.volume + m.volume,
        })
    }

    /// The rule names with their measures, in the order of the rules' first leaves.
    pub fn rules(&self) -> impl ExactSizeIterator<Item = (&Text, &Measures)> + '_ {
        self.numbers.table.rules().iter().zip(&self.rules)
    }

    /// The measures of one rule; all zero if it made no leaf.
    pub fn rule(&self, name: &str) -> Measures {
        self.rules().find(|&(rule, _)| rule == name).map_or(Measures::default(), |(_, measures)| *measures)
    }

    /// The sum of the signed tetrahedra between the origin of the world and every triangle, in cubic metres. It is
    /// the volume if all geometry together is closed. In any case it changes with every vertex and winding.
    pub fn checksum(&self) -> f64 {
        self.checksum
    }

    /// The axis-aligned bounding box of all geometry, in the world.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    #[inline]
    fn add(&mut self, rule: u32, triangles: u64, vertices: u64, area: f64, volume: f64) {
        let rule = rule as usize;
        if self.rules.len() <= rule {
            self.rules.resize(rule + 1, Measures::default());
        }
        let sum = &mut self.rules[rule];
        sum.leaves += 1;
        sum.triangles += triangles;
        sum.vertices += vertices;
        sum.area += area;
        sum.volume += volume;
    }

    #[inline]
    fn reach(&mut self, points: impl IntoIterator<Item = DVec3>) {
        // NaN is not less than any number, so it does not count.
        let less = |a: f64, b: f64| if a < b { a } else { b };
        let more = |a: f64, b: f64| if b < a { a } else { b };
        let Bounds { mut low, mut high } = self.bounds;
        for p in points {
            low = DVec3::new(less(p.x, low.x), less(p.y, low.y), less(p.z, low.z));
            high = DVec3::new(more(p.x, high.x), more(p.y, high.y), more(p.z, high.z));
        }
        self.bounds = Bounds { low, high };
    }

    #[inline]
    fn rectangle(&mut self, rule: u32, quad: &Quad) {
        let across = quad.u.cross(quad.v);
        self.add(rule, 2, 4, across.length(), 0.0);
        // The sum for both triangles.
        self.checksum += quad.origin.dot(across) / 3.0;
        self.reach(quad.corners());
    }

    #[inline]
    fn block(&mut self, rule: u32, cuboid: &Cuboid) {
        let volume = cuboid_volume(cuboid);
        self.add(rule, 12, 24, cuboid_area(cuboid), volume);
        self.checksum += volume;
        self.reach(cuboid.corners());
    }
}

/// Six times the volume of the tetrahedron between the origin and a triangle.
fn tetrahedron(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    a.dot(b.cross(c))
}

impl Sink for Stats {
    fn begin(&mut self) {
        self.numbers.begin();
    }

    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        let (scope, unit) = (leaf.scope(), leaf.shape.unit.get());
        let rule = self.numbers.rule(leaf);
        match leaf.shape.form {
            Form::Rect(axis) => self.rectangle(rule, &filled_scope::rectangle(&scope, axis, unit)),
            Form::Box => self.block(rule, &filled_scope::cuboid(&scope, unit)),
            Form::Empty | Form::Other => {}
        }
        ControlFlow::Continue(())
    }

    fn replay(&mut self, replay: &Replay<'_>) -> Flow {
        if !replay.is_plain() {
            return replay.each(self);
        }
        let mut leaf = 0;
        for (filled, mark) in replay.marks() {
            let rule = self.numbers.rule(&filled);
            for (placed, record, _) in replay.leaves(leaf..leaf + mark.leaves) {
                let (origin, unit) = ((replay.origin() + placed.origin).truncate(), record.unit);
                let [u, v, w] = placed.sides.each(|side| side.truncate());
                match record.form {
                    Form::Box => self.block(rule, &Cuboid { origin, sides: DMat3::from_cols(u, v, w), unit }),
                    _ => self.rectangle(rule, &Quad { origin, u, v, unit }),
                }
            }
            leaf += mark.leaves;
        }
        ControlFlow::Continue(())
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        let rule = self.numbers.table.rule(leaf.rule);
        self.rectangle(rule, quad);
        ControlFlow::Continue(())
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        let rule = self.numbers.table.rule(leaf.rule);
        self.block(rule, cuboid);
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let (mut triangles, mut sum) = (0, 0.0);
        self.flattener.faces(mesh, placement, |face| {
            triangles += face.triangles.len() as u64;
            for triangle in face.triangles {
                let [a, b, c] =
                    triangle.each(|i| placement.transform_point3(corner_point(mesh, face.corners.start + i as usize)));
                sum += tetrahedron(a, b, c);
            }
            true
        });
        self.checksum += sum / 6.0;
        let rule = self.numbers.table.rule(leaf.rule);
        self.add(
            rule,
            triangles,
            mesh.corners().len() as u64,
            mesh_area(mesh, placement),
            mesh_volume(mesh, placement),
        );
        self.reach(mesh.points().iter().map(|&point| placement.transform_point3(point)));
        ControlFlow::Continue(())
    }

    fn placement(&mut self, leaf: &Leaf<'_>) -> Flow {
        let rule = self.numbers.table.rule(leaf.rule);
        self.add(rule, 0, 0, 0.0, 0.0);
        ControlFlow::Continue(())
    }
}

/// The [`Stats::checksum`] of finished buffers: coordinates read as `f32`, summed as `f64`.
pub fn checksum(vertices: &[Vertex], indices: &[u32]) -> f64 {
    let point = |index: u32| {
        let [x, y, z, ..] = vertices[index as usize];
        DVec3::new(f64::from(x), f64::from(y), f64::from(z))
    };
    indices.chunks_exact(3).map(|t| tetrahedron(point(t[0]), point(t[1]), point(t[2]))).sum::<f64>() / 6.0
}
