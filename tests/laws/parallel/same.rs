//! Serial, parallel and with any number of threads: the same bytes.

use cga::parallel::run_all;
use cga::sink::buffers::Buffers;
use cga::sink::gltf::Glb;
use cga::{Batches, FaultKind, Grammar, Limits, Model, Report, Settings, Shape};

use super::THREADS;
use super::grammars::{Deep, Park, Shared, Street, cases, lots, settings};
use crate::laws::with_threads;

/// The results of a loop over the shapes: a sink with all leaves, and the merged report.
fn serial<S: cga::Sink>(grammar: &dyn Grammar, shapes: &[Shape], mut sink: S) -> (S, Report) {
    let (mut sum, settings) = (Report::default(), settings());
    for shape in shapes {
        sum.merge(grammar.run(shape, &settings, &mut sink).expect("no limit"), &Limits::default());
    }
    (sink, sum)
}

/// All of the buffers, as text that tells every bit.
fn bits(buffers: &Buffers) -> String {
    let vertices = buffers.vertices().iter().map(|vertex| vertex.map(f32::to_bits)).collect::<Vec<_>>();
    let uvs = buffers.uvs().iter().map(|uv| uv.map(f32::to_bits)).collect::<Vec<_>>();
    let submeshes = buffers.submeshes().collect::<Vec<_>>();
    format!(
        "{vertices:?} {uvs:?} {:?} {submeshes:?} {:?} {:?}",
        buffers.indices(),
        buffers.rules(),
        buffers.materials()
    )
}

fn buffers<G: Grammar + Sync>(grammar: &G, shapes: &[Shape]) -> Batches<Buffers> {
    run_all(grammar, shapes, &settings(), |_| Buffers::new()).expect("no limit")
}

fn one_grammar<G: Grammar + Sync>(grammar: &G, shapes: &[Shape]) {
    let (model, report) = serial(grammar, shapes, Model::new());
    let (glb, obj) = (model.to_glb().expect("a file"), model.to_obj("a.mtl"));
    let (one, _) = serial(grammar, shapes, Buffers::new());
    let mut from_loop = Glb::new();
    assert!(from_loop.buffers(&one).is_continue());
    let from_loop = from_loop.into_bytes().expect("a file");
    let first = with_threads(1, || buffers(grammar, shapes));
    for threads in THREADS {
        let (models, batches) = with_threads(threads, || {
            (cga::parallel::generate_all(grammar, shapes, &settings()).expect("no limit"), buffers(grammar, shapes))
        });
        assert_eq!(format!("{:?}", models.report()), format!("{report:?}"), "{threads} threads");
        assert_eq!(format!("{:?}", batches.report()), format!("{report:?}"), "{threads} threads");
        assert_eq!((models.len(), models.leaves().count()), (shapes.len(), model.len()));
        assert!(models.to_glb().expect("a file") == glb && models.to_obj("a.mtl") == obj);
        assert_eq!(models.bounds(), model.bounds());
        for (batch, shape) in models.iter().zip(shapes) {
            let alone = grammar.generate_with(shape, &settings()).expect("no limit");
            assert_eq!(format!("{:?}", batch.sink.report()), format!("{:?}", alone.report()));
            assert!(batch.sink.to_glb().expect("a file") == alone.to_glb().expect("a file"));
        }
        assert_eq!(batches.len(), first.len());
        for (batch, first) in batches.iter().zip(&first) {
            assert_eq!(batch.shapes, first.shapes);
            assert!(bits(&batch.sink) == bits(&first.sink), "{threads} threads");
        }
        // A batch without texture coordinates has none in the file either.
        let as_one = one.uvs().is_empty();
        let expected = if as_one { &from_loop } else { &first.to_glb().expect("a file") };
        assert!(batches.to_glb().expect("a file") == *expected);
    }
}

#[test]
fn threads_change_no_byte() {
    one_grammar(&Street::default(), &lots(12));
    one_grammar(&Park::default(), &lots(14));
    one_grammar(&Deep::default(), &lots(5));
    one_grammar(&Street::default(), &lots(1));
    one_grammar(&Street::default(), &[]);
}

#[test]
fn the_grammars_have_what_is_compared() {
    let report = |grammar: &dyn Grammar| serial(grammar, &lots(14), Model::new()).1;
    let (street, park, deep) = (report(&Street::default()), report(&Park::default()), report(&Deep::default()));
    assert!(street.reported("area.lot").is_some() && !street.prints().is_empty() && !deep.prints().is_empty());
    let kinds: Vec<_> = park.faults().iter().map(|fault| fault.kind).collect();
    assert!(kinds.contains(&FaultKind::Asset) && kinds.contains(&FaultKind::Value), "{kinds:?}");
    assert!(park.faults().iter().any(|fault| 14 < fault.count));
    assert!(park.reported("tree").is_some_and(|tree| 1 < tree.texts().len()));
}

#[test]
fn stretches_of_several_shapes_are_those_of_a_loop() {
    let (grammar, shapes) = (Street::default(), lots(600));
    let (one, report) = serial(&grammar, &shapes, Buffers::new());
    for threads in THREADS {
        let batches = with_threads(threads, || buffers(&grammar, &shapes));
        assert_eq!(batches.len(), 200);
        assert!(batches.iter().zip(0..).all(|(batch, at)| batch.shapes == (3 * at..3 * at + 3)));
        let vertices: Vec<_> = batches.sinks().flat_map(|batch| batch.vertices().iter().copied()).collect();
        assert!(vertices == one.vertices());
        assert_eq!(batches.report().reported("floor"), report.reported("floor"));
        assert_eq!(format!("{:?}", batches.report()), format!("{report:?}"));
    }
}

#[test]
fn grammars_that_are_chosen_at_run_time_run_in_parallel() {
    for (grammar, shapes) in cases() {
        let grammar: &dyn Shared = &*grammar;
        let (model, report) = serial(grammar, &shapes, Model::new());
        for threads in THREADS {
            let batches =
                with_threads(threads, || run_all(grammar, &shapes, &settings(), |_| Model::new()).expect("no limit"));
            assert_eq!(format!("{:?}", batches.report()), format!("{report:?}"));
            assert!(batches.to_glb().expect("a file") == model.to_glb().expect("a file"));
        }
    }
}

#[test]
fn sums_have_the_limits_of_one_run() {
    let limits = Limits { prints: 10, reports: 2, ..Limits::default() };
    let settings = Settings { limits, ..settings() };
    let shapes = lots(30);
    let mut sum = Report::default();
    for shape in &shapes {
        sum.merge(Street::default().generate_with(shape, &settings).expect("no limit").report().clone(), &limits);
    }
    assert_eq!((sum.prints().len(), sum.prints_left_out(), sum.reports().left_out() != 0), (10, 110, true));
    for threads in THREADS {
        let batches = with_threads(threads, || Street::default().generate_all(&shapes, &settings).expect("no error"));
        assert_eq!(format!("{:?}", batches.report()), format!("{sum:?}"));
    }
}
