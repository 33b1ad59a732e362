//! The size of buffers before they are filled.

use cga::sink::buffers::{BufferSize, Buffers};
use cga::{Error, Grammar, Limits, Model, Repeats, Session, Settings, Shape, Watch, cga};

cga! {
    grammar Measured;
    Lot   --> extrude(9) comp(f) { side : Front | top : roofHip(30) Roof. | bottom : offset(-1, border) Ring. }
    Front --> split(y) { { ~3 : Floor }* | 0.1 : NIL }
    Floor --> split(x) { { ~2 : Tile }* }
    Tile  --> split(y) { ~1 : Wall. | 1 : extrude(0.2) Glass. | 0.5 : s(^1, ^1, 0.1) primitiveCylinder(6) Pipe. | 0.3 : Lamps | 0.2 : Drawn }
    Lamps --> comp(v) { all : Lamp. }
    Drawn --> 50% : color(rand(1), 0, 0) X. else : NIL
}

/// A lot with a hole and a concave corner.
fn lot() -> Shape {
    let outline = [[0.0, 0.0], [12.0, 0.0], [12.0, 6.0], [5.0, 6.0], [5.0, 10.0], [0.0, 10.0]];
    let hole = vec![[1.5, 1.5], [1.5, 3.0], [3.0, 3.0], [3.0, 1.5]];
    Shape::footprint(&outline, &[hole]).expect("an outline").seed(7)
}

#[test]
fn buffers_have_the_measured_size() {
    let grammar = Measured::default();
    for repeats in [Repeats::Kept, Repeats::Again, Repeats::Direct] {
        let settings = Settings { repeats, ..Settings::default() };
        let mut session = Session::new(&grammar, &settings).expect("a session");
        // The second run has templates and flat meshes.
        for shape in [lot(), lot(), Shape::cuboid(3.0, 4.0, 5.0), Shape::point([1.0, 2.0, 3.0])] {
            let size = session.measure(&shape).expect("no limit");
            let (mut buffers, mut model) = (Buffers::with_capacity(size.vertices, size.indices), Model::new());
            session.run(&shape, &mut buffers).expect("no limit");
            session.run(&shape, &mut model).expect("no limit");
            let filled = (model.len(), buffers.vertices().len(), buffers.indices().len());
            assert_eq!((size.leaves, size.vertices, size.indices), filled, "{repeats:?}");
        }
    }
}

#[test]
fn a_session_that_is_chosen_at_run_time_measures_too() {
    let (grammar, settings) = (Measured::default(), Settings::default());
    let boxed: Box<dyn Grammar> = Box::new(grammar.clone());
    let found = boxed.session(&settings).expect("a session").measure(&lot()).expect("no limit");
    assert_eq!(found, Session::new(&grammar, &settings).expect("a session").measure(&lot()).expect("no limit"));
    assert!(found.leaves > 100 && found.vertices > 1_000, "{found:?}");
}

#[test]
fn runs_that_end_early_have_no_size_or_an_empty_one() {
    let grammar = Measured::default();
    let limits = Limits { shapes: 10, ..Limits::default() };
    let settings = Settings { limits, ..Settings::default() };
    let ended = Session::new(&grammar, &settings).expect("a session").measure(&lot());
    assert!(matches!(ended, Err(Error::Limit { .. })), "{ended:?}");
    let watch = Watch::new();
    watch.stop();
    let settings = Settings { watch: Some(watch), ..Settings::default() };
    let stopped = Session::new(&grammar, &settings).expect("a session").measure(&lot());
    assert_eq!(stopped, Ok(BufferSize::default()));
}
