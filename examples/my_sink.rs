//! A custom sink: the glass and wall areas of a building, without storing any geometry.
//!
//! `cargo run --example my_sink`

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::Arc;

use cga::glam::DAffine3;
use cga::{Flow, Leaf, Mesh, Quad, Settings, Shape, Sink, Text, cga};

cga! {
    /// Walls with windows.
    grammar Office;

    attr height = 40
    glazing = 0.62

    Lot    --> extrude(height) comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { 4.5 : Floor | { ~3.4 : Floor }* }
    Floor  --> split(x) { { ~2.5 : Bay }* }
    Bay    --> split(y) { ^(1 - glazing) : Wall. | ~1 : split(x) { 0.2 : Wall. | ~1 : Window. | 0.2 : Wall. } }
}

/// The square metres and the number of leaves by rule.
#[derive(Debug, Default)]
struct Surfaces {
    by_rule: BTreeMap<Text, (f64, usize)>,
}

impl Surfaces {
    fn add(&mut self, leaf: &Leaf<'_>, area: f64) -> Flow {
        let sum = self.by_rule.entry(leaf.rule.clone()).or_default();
        *sum = (sum.0 + area, sum.1 + 1);
        // `ControlFlow::Break(())` would end the run.
        ControlFlow::Continue(())
    }

    fn area(&self, rule: &str) -> f64 {
        self.by_rule.get(rule).map_or(0.0, |sum| sum.0)
    }
}

impl Sink for Surfaces {
    // Most of a façade consists of rectangles, which need no mesh.
    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        self.add(leaf, quad.u.cross(quad.v).length())
    }

    // All other geometry comes as a mesh.
    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.add(leaf, mesh.map(placement).area())
    }
}

fn main() -> Result<(), cga::Error> {
    let lot = Shape::footprint(&[[0.0, 18.0], [30.0, 18.0], [30.0, 0.0], [12.0, 0.0], [0.0, 8.0]], &[])?;
    let mut surfaces = Surfaces::default();
    let report = Office::default().run(&lot, &Settings::default(), &mut surfaces)?;
    for (rule, (area, count)) in &surfaces.by_rule {
        println!("{rule:<8} {count:>5} pieces {area:>9.1} m²");
    }
    let (glass, wall) = (surfaces.area("Window"), surfaces.area("Wall"));
    println!("{:.0} % glass, {} shapes derived", 100.0 * glass / (glass + wall), report.shapes);
    Ok(())
}
