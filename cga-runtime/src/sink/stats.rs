//! Counts and measures, without keeping anything: for tests, benches and a look at what a rule costs.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::buffers::Vertex;
use super::flatten::{Flattener, corner_point};
use super::measure::{cuboid_area, cuboid_volume, mesh_area, mesh_volume, quad_area};
use super::table::Table;
use super::{Cuboid, Flow, Leaf, Quad, Sink};
use crate::mesh::{Bounds, Mesh};

/// Sums over some leaves. Triangles and vertices are counted as [`super::buffers::Buffers`] makes them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measures {
    /// How many leaves.
    pub leaves: u64,
    /// How many triangles.
    pub triangles: u64,
    /// How many unshared vertices.
    pub vertices: u64,
    /// Surface in square metres, both ends of a closed box included, holes not.
    pub area: f64,
    /// Enclosed volume in cubic metres. Rectangles add nothing; other open geometry adds something without meaning.
    pub volume: f64,
}

/// Measures what it is handed.
#[derive(Debug)]
pub struct Stats {
    table: Table,
    rules: Vec<Measures>,
    checksum: f64,
    bounds: Bounds,
    flattener: Flattener,
}

impl Default for Stats {
    fn default() -> Self {
        Stats {
            table: Table::new(),
            rules: Vec::new(),
            checksum: 0.0,
            bounds: Bounds::EMPTY,
            flattener: Flattener::default(),
        }
    }
}

impl Stats {
    /// Nothing measured yet.
    pub fn new() -> Self {
        Stats::default()
    }

    /// Everything together.
    pub fn total(&self) -> Measures {
        self.rules.iter().fold(Measures::default(), |sum, m| Measures {
            leaves: sum.leaves + m.leaves,
            triangles: sum.triangles + m.triangles,
            vertices: sum.vertices + m.vertices,
            area: sum.area + m.area,
            volume: sum.volume + m.volume,
        })
    }

    /// Rule names with their measures, in the order in which the rules first made a leaf.
    pub fn rules(&self) -> impl ExactSizeIterator<Item = (&'static str, &Measures)> + '_ {
        self.table.rules().iter().copied().zip(&self.rules)
    }

    /// The measures of one rule; of nothing, when it made no leaf.
    pub fn rule(&self, name: &str) -> Measures {
        self.rules().find(|&(rule, _)| rule == name).map_or(Measures::default(), |(_, measures)| *measures)
    }

    /// The sum of the signed tetrahedra between the origin of the world and every triangle, in cubic metres: the volume
    /// when everything together is closed, and in any case a number that changes when a vertex or a winding does.
    pub fn checksum(&self) -> f64 {
        self.checksum
    }

    /// The axis-aligned box around everything, in the world.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn add(&mut self, leaf: &Leaf<'_>, triangles: u64, vertices: u64, area: f64, volume: f64) {
        let rule = self.table.rule(leaf.rule) as usize;
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

    fn reach(&mut self, point: DVec3) {
        self.bounds = Bounds { low: self.bounds.low.min(point), high: self.bounds.high.max(point) };
    }
}

/// Six times the tetrahedron between the origin and a triangle.
fn tetrahedron(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    a.dot(b.cross(c))
}

impl Sink for Stats {
    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        self.add(leaf, 2, 4, quad_area(quad), 0.0);
        let [a, b, c, d] = quad.corners();
        self.checksum += (tetrahedron(a, b, c) + tetrahedron(a, c, d)) / 6.0;
        [a, b, c, d].into_iter().for_each(|corner| self.reach(corner));
        ControlFlow::Continue(())
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        let volume = cuboid_volume(cuboid);
        self.add(leaf, 12, 24, cuboid_area(cuboid), volume);
        self.checksum += volume;
        cuboid.corners().into_iter().for_each(|corner| self.reach(corner));
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let (mut triangles, mut sum) = (0, 0.0);
        self.flattener.faces(mesh, placement, |face| {
            triangles += face.triangles.len() as u64;
            for triangle in face.triangles {
                let [a, b, c] =
                    triangle.map(|i| placement.transform_point3(corner_point(mesh, face.corners.start + i as usize)));
                sum += tetrahedron(a, b, c);
            }
            true
        });
        self.checksum += sum / 6.0;
        self.add(leaf, triangles, mesh.corners.len() as u64, mesh_area(mesh, placement), mesh_volume(mesh, placement));
        mesh.points.iter().for_each(|&point| self.reach(placement.transform_point3(point)));
        ControlFlow::Continue(())
    }
}

/// [`Stats::checksum`] of finished buffers: coordinates read as `f32`, summed as `f64`.
pub fn checksum(vertices: &[Vertex], indices: &[u32]) -> f64 {
    let point = |index: u32| {
        let [x, y, z, ..] = vertices[index as usize];
        DVec3::new(f64::from(x), f64::from(y), f64::from(z))
    };
    indices.chunks_exact(3).map(|t| tetrahedron(point(t[0]), point(t[1]), point(t[2]))).sum::<f64>() / 6.0
}
