//! The laws: two ways to run a grammar that must give the same.

use cga::parallel::run_all;
use cga::sink::buffers::{Buffers, Chunks};
use cga::{Error, Flow, Grammar, Limits, Model, Repeats, Report, Settings, Shape, Sink};

use crate::compare::{Outcome, Tolerance, difference, ended_alike, scope};
use crate::exact;
use crate::few::{Few, Replayed};

/// A grammar with shapes to run it on.
pub(crate) struct Case<'a> {
    pub(crate) grammar: &'a (dyn Grammar + Sync),
    pub(crate) settings: Settings,
    pub(crate) shapes: &'a [Shape],
    /// A number that the law may use: threads, room.
    pub(crate) number: usize,
}

/// A way to compare runs.
pub(crate) struct Law {
    pub(crate) name: &'static str,
    /// The initial shapes of a case.
    pub(crate) shapes: usize,
    /// Compares runs: the first difference, and one of the two outcomes of the last shape.
    pub(crate) holds: fn(&Case<'_>) -> (Option<String>, Option<Outcome>),
}

/// Every law.
pub(crate) const LAWS: &[Law] = &[
    Law { name: "boxes and meshes", shapes: 1, holds: boxes },
    Law { name: "templates kept and made again", shapes: 1, holds: again },
    Law { name: "templates and direct derivation", shapes: 1, holds: direct },
    Law { name: "leaves and the tree of shapes", shapes: 1, holds: tree },
    Law { name: "a session and single runs", shapes: 4, holds: session },
    Law { name: "parallel and serial", shapes: 5, holds: parallel },
    Law { name: "chunks and buffers", shapes: 2, holds: chunks },
];

impl Case<'_> {
    fn tolerance(&self) -> Tolerance {
        let size = self.shapes.iter().map(|shape| shape.scope().size.abs().max_element()).fold(0.0, f64::max);
        Tolerance { length: 1e-9 * size }
    }

    fn with(&self, repeats: Repeats) -> Settings {
        Settings { repeats, ..self.settings.clone() }
    }

    fn model(&self, settings: &Settings, shape: &Shape) -> Outcome {
        let mut model = Model::new();
        let report = self.grammar.run(shape, settings, &mut model);
        Outcome { model, report: report.map_err(|error| error.to_string()), replayed: 0 }
    }

    fn buffers(&self, settings: &Settings, shape: &Shape) -> Buffers {
        let mut buffers = Buffers::new();
        // The report was compared already.
        let _ = self.grammar.run(shape, settings, &mut buffers);
        buffers
    }

    /// Runs the shapes one after the other, up to the first error.
    fn serial(&self, sink: &mut dyn Sink) -> Result<Report, (usize, Error)> {
        let mut sum = Report::default();
        for (at, shape) in self.shapes.iter().enumerate() {
            let report = self.grammar.run(shape, &self.settings, sink).map_err(|error| (at, error))?;
            sum.merge(report, &self.settings.limits);
        }
        Ok(sum)
    }
}

/// Each box and rectangle held as such, and as a mesh.
fn boxes(case: &Case<'_>) -> (Option<String>, Option<Outcome>) {
    let limits = Limits { shapes: 1000, ..case.settings.limits };
    let run = |shape: &Shape| {
        let mut few = Few::new();
        let settings = Settings { limits, ..case.settings.clone() };
        let report = case.grammar.run(shape, &settings, &mut few);
        Outcome { model: few.model, report: report.map_err(|error| error.to_string()), replayed: 0 }
    };
    let [left, right] = [run(&case.shapes[0]), run(&case.shapes[0].clone().held_as_meshes())];
    // Boxes count as vertices only when they become meshes, so that this limit alone may end one run of the two.
    let vertices = |run: &Outcome| run.report.as_ref().is_err_and(|error| error.starts_with("more vertices"));
    if vertices(&left) || vertices(&right) {
        return (None, Some(left));
    }
    (ended_alike(&left, &right, case.tolerance()), Some(left))
}

/// Templates that are kept, and made again for each repetition: the same bytes.
fn again(case: &Case<'_>) -> (Option<String>, Option<Outcome>) {
    let [kept, again] = [Repeats::Kept, Repeats::Again].map(|repeats| case.with(repeats));
    let shape = &case.shapes[0];
    let [mut left, right] = [&kept, &again].map(|settings| case.model(settings, shape));
    let found = exact::outcomes(&left, &right).or_else(|| {
        let [left, right] = [&kept, &again].map(|settings| case.buffers(settings, shape));
        exact::buffers(&left, &right)
    });
    let mut replayed = Replayed::default();
    let _ = case.grammar.run(shape, &kept, &mut replayed);
    left.replayed = replayed.leaves;
    (found, Some(left))
}

/// Templates, and every repetition derived at its place: the same except for rounding.
fn direct(case: &Case<'_>) -> (Option<String>, Option<Outcome>) {
    let [left, right] =
        [Repeats::Kept, Repeats::Direct].map(|repeats| case.model(&case.with(repeats), &case.shapes[0]));
    let found = match (&left.report, &right.report) {
        // A template is counted at once, so that a limit may end the run before its leaves.
        (Err(_), Err(_)) => ended_alike(&left, &right, case.tolerance()),
        _ => difference(&left, &right, case.tolerance()),
    };
    (found, Some(left))
}

/// A model with the tree of its shapes has the same bytes, and the tree has its leaves.
fn tree(case: &Case<'_>) -> (Option<String>, Option<Outcome>) {
    let settings = Settings { tree: true, ..case.settings.clone() };
    let [left, right] = [&case.settings, &settings].map(|settings| case.model(settings, &case.shapes[0]));
    let found = exact::outcomes(&left, &right).or_else(|| {
        right.report.as_ref().ok().filter(|report| !report.stopped)?;
        right.model.leaves().enumerate().find_map(|(at, leaf)| {
            let Some(node) = leaf.node() else { return Some(format!("leaf {at} has no node")) };
            let is_same = (node.rule(), node.leaf()) == (leaf.rule(), Some(at));
            let name = (!is_same).then(|| format!("the node of leaf {at} is {} {:?}", node.rule(), node.leaf()));
            name.or_else(|| {
                scope(node.scope(), &leaf.scope(), case.tolerance()).map(|text| format!("leaf {at}: {text}"))
            })
        })
    });
    (found, Some(left))
}

/// A session that runs several shapes, and a run of its own for each.
fn session(case: &Case<'_>) -> (Option<String>, Option<Outcome>) {
    let Ok(mut session) = case.grammar.session(&case.settings) else { return (None, None) };
    let mut last = None;
    // Twice: what is kept of the first round is used in the second.
    for (at, shape) in case.shapes.iter().chain(case.shapes).enumerate() {
        let mut model = Model::new();
        let report = session.run(shape, &mut model);
        let left = Outcome { model, report: report.map_err(|error| error.to_string()), replayed: 0 };
        let right = case.model(&case.settings, shape);
        if let Some(text) = exact::outcomes(&left, &right) {
            return (Some(format!("{text} (shape {at})")), None);
        }
        if case.shapes.len() <= at {
            let mut left = Buffers::new();
            let _ = session.run(shape, &mut left);
            if let Some(text) = exact::buffers(&left, &case.buffers(&case.settings, shape)) {
                return (Some(format!("{text} (shape {at})")), None);
            }
        }
        last = Some(left);
    }
    (None, last)
}

/// A loop, and threads.
fn parallel(case: &Case<'_>) -> (Option<String>, Option<Outcome>) {
    let threads = 1 + case.number % 3;
    let mut model = Model::new();
    let serial = case.serial(&mut model);
    // `Model` has a part a shape, `Buffers` one for several.
    let models = with_threads(threads, || run_all(case.grammar, case.shapes, &case.settings, |_| Model::new()));
    let found = match (&serial, &models) {
        (Ok(report), Ok(models)) => {
            exact::texts("the report", &format!("{report:?}"), &format!("{:?}", models.report()))
                .or_else(|| exact::leaves(model.leaves(), models.leaves()))
                .or_else(|| exact::texts("the OBJ", &model.to_obj("a").0, &models.to_obj("a").0))
        }
        (Err((at, error)), Err(other)) if other.shape == Some(*at) && other.error == *error => None,
        (serial, models) => Some(format!("the error: {:?} and {:?}", serial.as_ref().err(), models.as_ref().err())),
    };
    let found = found.or_else(|| {
        let parts = with_threads(threads, || run_all(case.grammar, case.shapes, &case.settings, |_| Buffers::new()));
        let parts = parts.ok()?;
        let mut whole = Buffers::new();
        let _ = case.serial(&mut whole);
        let triangles: Vec<_> = parts.sinks().flat_map(exact::triangles).collect();
        (triangles != exact::triangles(&whole)).then(|| "the triangles of parts".into())
    });
    (found.map(|text| format!("{text} ({threads} threads)")), None)
}

/// Chunks, and buffers.
fn chunks(case: &Case<'_>) -> (Option<String>, Option<Outcome>) {
    let max = [24, 25, 100, 1000][case.number % 4];
    let mut whole = Buffers::new();
    let serial = case.serial(&mut whole);
    let mut triangles = Vec::new();
    let mut sink = Chunks::new(max, |chunk: &Buffers| {
        triangles.extend(exact::triangles(chunk));
        Flow::Continue(())
    });
    let other = case.serial(&mut sink);
    let _ = sink.finish();
    drop(sink);
    let found = exact::texts("the report", &format!("{serial:?}"), &format!("{other:?}"))
        .or_else(|| (triangles != exact::triangles(&whole)).then(|| format!("the triangles of chunks of {max}")));
    (found, None)
}

/// Runs it with that many threads; without the feature `rayon` always with one.
pub(crate) fn with_threads<T: Send>(threads: usize, run: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    pool.install(run)
}
