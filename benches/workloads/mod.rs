//! The workloads: each is a grammar and a hand-written loop with the same output.
//!
//! A new workload is a file with a [`Workload`] for each size, and a line in [`all`].

#![allow(dead_code, reason = "not every program uses all of it")]

mod chance;
mod check;
mod city;
mod color;
pub(crate) mod facade;
mod fold;
mod golden;
mod raw;
mod share;
pub(crate) mod sponge;

use cga::sink::buffers::Buffers;
use cga::sink::gltf::Glb;
use cga::sink::obj::Obj;
use cga::sink::stats::Stats;
use cga::{Model, Sink};

pub(crate) use check::{Expected, check};
pub(crate) use fold::Fold;
pub(crate) use raw::Raw;

/// Runs a grammar on shapes, one after the other. All workloads run through this macro, so that they are comparable.
macro_rules! run {
    ($grammar:expr, $settings:expr, $shapes:expr, $sink:expr) => {
        let mut session = $grammar.session($settings).expect("the attributes are in their ranges");
        for shape in $shapes {
            session.run(shape, $sink).expect("no limit is reached");
        }
    };
}
use run;

/// One workload at one size.
pub(crate) trait Workload {
    /// The name in tables: the workload, then its size in parentheses.
    fn name(&self) -> String;
    /// The counts and sums of its output.
    fn expected(&self) -> Expected;
    /// True for the size that is in tables with one row for each workload.
    fn is_main(&self) -> bool;
    /// Makes the output with a loop that knows all sizes.
    fn by_hand(&mut self, out: &mut Raw);
    /// Makes the output with the grammar.
    fn derive<S: Sink>(&mut self, sink: &mut S);
}

/// A workload with each measured sink.
pub(crate) trait Scene {
    fn name(&self) -> String;
    fn expected(&self) -> Expected;
    fn is_main(&self) -> bool;
    fn by_hand(&mut self, out: &mut Raw);
    fn buffers(&mut self, out: &mut Buffers);
    fn fold(&mut self, out: &mut Fold);
    fn model(&mut self, out: &mut Model);
    fn glb(&mut self, out: &mut Glb);
    fn obj(&mut self, out: &mut Obj<std::io::Sink>);
    fn stats(&mut self, out: &mut Stats);
}

impl<W: Workload> Scene for W {
    fn name(&self) -> String {
        Workload::name(self)
    }

    fn expected(&self) -> Expected {
        Workload::expected(self)
    }

    fn is_main(&self) -> bool {
        Workload::is_main(self)
    }

    fn by_hand(&mut self, out: &mut Raw) {
        Workload::by_hand(self, out);
    }

    fn buffers(&mut self, out: &mut Buffers) {
        self.derive(out);
    }

    fn fold(&mut self, out: &mut Fold) {
        self.derive(out);
    }

    fn model(&mut self, out: &mut Model) {
        self.derive(out);
    }

    fn glb(&mut self, out: &mut Glb) {
        self.derive(out);
    }

    fn obj(&mut self, out: &mut Obj<std::io::Sink>) {
        self.derive(out);
    }

    fn stats(&mut self, out: &mut Stats) {
        self.derive(out);
    }
}

/// All workloads at all sizes, from small to large.
pub(crate) fn all() -> Vec<Box<dyn Scene>> {
    fn boxed<W: Workload + 'static>(sizes: impl IntoIterator<Item = W>) -> Vec<Box<dyn Scene>> {
        sizes.into_iter().map(|size| Box::new(size) as Box<dyn Scene>).collect()
    }
    [
        boxed(facade::sizes().map(facade::Facade::new)),
        boxed(facade::sizes().map(color::Facade::new)),
        boxed(facade::sizes().map(chance::Facade::new)),
        boxed((1..=4).map(sponge::Sponge::new)),
        boxed([10, 12, 14, 16].map(golden::Golden::new)),
        boxed([10, 100, 300, 1000].map(city::City::new)),
    ]
    .into_iter()
    .flatten()
    .collect()
}
