//! The random grammars of `tests/laws` on random lists of shapes: a loop, threads and chunks give the same.

use cga::parallel::run_all;
use cga::sink::buffers::Buffers;
use cga::{Error, Grammar, Limits, Model, Report, RunError, Settings, Shape, Sink};

use super::THREADS;
use super::streamed::{chunks, triangles};
use crate::laws::with_threads;
use crate::random::Random;
use crate::{grammars as written, start};

/// Lists of shapes for each grammar.
const LISTS: u64 = if cfg!(debug_assertions) { 1 } else { 20 };

/// Runs the shapes one after the other, as far as there is no error.
fn serial(
    grammar: &dyn Grammar,
    shapes: &[Shape],
    settings: &Settings,
    sink: &mut dyn Sink,
) -> Result<Report, (usize, Error)> {
    let mut sum = Report::default();
    for (at, shape) in shapes.iter().enumerate() {
        sum.merge(grammar.run(shape, settings, sink).map_err(|error| (at, error))?, &settings.limits);
    }
    Ok(sum)
}

/// All bytes of a model. OBJ has coordinates with all digits of an f64.
fn bytes(glb: Result<Vec<u8>, cga::WriteError>, obj: (String, String)) -> (Result<Vec<u8>, String>, String) {
    (glb.map_err(|error| error.to_string()), obj.0 + &obj.1)
}

#[test]
fn random_grammars_give_the_same_in_parallel_and_streamed() {
    let (mut leaves, mut errors, mut complete) = (0, 0, 0);
    for (seed, make) in written::ALL {
        for number in 0..LISTS {
            let mut random = Random(seed << 32 | number);
            let mut grammar = make();
            let given = start::attributes(&mut *grammar, &mut random);
            let shapes: Vec<Shape> = (0..10).map(|_| start::shape(&mut random).1).collect();
            let limits = Limits { shapes: 1000, depth: 64, vertices: 20_000, ..Limits::default() };
            let settings = Settings { limits, ..Settings::default() };
            let what = format!("seed {seed}, list {number}, {given}");

            let mut model = Model::new();
            let expected = serial(&*grammar, &shapes, &settings, &mut model);
            let threads = *random.pick(&THREADS);
            let batches = with_threads(threads, || run_all(&*grammar, &shapes, &settings, |_| Model::new()));
            match (&expected, batches) {
                (Ok(report), Ok(batches)) => {
                    assert_eq!(format!("{:?}", batches.report()), format!("{report:?}"), "{what}");
                    let (batches, model) =
                        (bytes(batches.to_glb(), batches.to_obj("a")), bytes(model.to_glb(), model.to_obj("a")));
                    assert!(batches == model, "{what}");
                    (leaves, complete) = (leaves + report.leaves, complete + 1);
                }
                (Err((at, error)), Err(RunError { shape, error: other, .. })) => {
                    assert_eq!((Some(*at), error), (shape, &other), "{what}");
                    errors += 1;
                }
                (expected, batches) => panic!("{what}: {:?} and {:?}", expected.as_ref().err(), batches.err()),
            }

            let shapes = match &expected {
                Ok(_) => &shapes[..],
                Err((at, _)) => &shapes[..*at],
            };
            let mut whole = Buffers::new();
            assert!(serial(&*grammar, shapes, &settings, &mut whole).is_ok());
            let max = *random.pick(&[24, 100, 1000, 100_000]);
            let streamed = chunks(max, |sink| assert!(serial(&*grammar, shapes, &settings, sink).is_ok()));
            assert!(streamed.0 == triangles(&whole), "{what}: chunks of {max}");
        }
    }
    println!("{leaves} leaves in {complete} lists, {errors} lists with an error");
    assert!(
        1000 < leaves && 0 < errors && 10 < complete,
        "{leaves} leaves, {errors} errors, {complete} complete lists"
    );
}
