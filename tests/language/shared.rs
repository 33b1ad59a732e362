//! Threads may share grammars, shapes, settings and models.

use cga::sink::buffers::Buffers;
use cga::street::{Centerline, Network};
use cga::{
    Array, Assets, Attribute, AttributeError, Batches, Error, Fault, Grammar, Mesh, Model, Report, RunError, Settings,
    Shape, Text, Value, Watch, cga,
};

cga! {
    grammar House;
    attr height = 12
    attr wall = "brick"
    attr heights = [4, 3]
    attr storeys = rint(rand(2, 5))
    Lot --> extrude(height + size(heights) + storeys) set(material.name, wall) House.
}

fn shared<T: Send + Sync + 'static>() {}

fn shared_value(_: &(impl Send + Sync + 'static)) {}

#[test]
fn data_can_be_shared_between_threads() {
    shared::<House>();
    shared::<(Shape, Settings, Assets, Watch)>();
    shared::<(Model, Report, Batches<Model>, Batches<Buffers>, Mesh)>();
    shared::<(Value, Text, Array<f64>, Array<Text>, Attribute)>();
    shared::<(Error, Fault, AttributeError, RunError)>();
    shared::<(Centerline, Network)>();
    let (text, number) = (String::from("a"), 3.0);
    shared_value(&cga! { Lot --> print("" + #text) extrude(#number) House. });
}

#[test]
fn a_thread_runs_a_grammar_of_another() {
    let house: Box<dyn Grammar + Send + Sync> = Box::new(House { storeys: Some(2.0), ..House::default() });
    let lot = Shape::rectangle(1.0, 1.0);
    let volume = || house.generate(&lot).map(|model| model.volume());
    let volumes = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..3).map(|_| scope.spawn(volume)).collect();
        threads.into_iter().map(|thread| thread.join().expect("no panic")).collect::<Vec<_>>()
    });
    assert!(volumes.iter().all(|volume| *volume == Ok(16.0)), "{volumes:?}");
}
