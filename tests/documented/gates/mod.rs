//! The gates over everything that the repository draws, and for each gate a planted scene that it must catch.

mod back_faces;
mod chapters;
mod cracks;
mod fights;
mod files;
mod holes;
mod inside_out;
mod nested;

use std::error::Error;
use std::fmt::Write;
use std::sync::{Mutex, OnceLock};

use cga::{Model, Settings};
use cga_gates::{Finding, Look, Survey, looks, report};
use cga_tests::drawn::{Drawn, drawn};

/// The longer side of a picture, in pixels.
const PIXELS: usize = 400;

/// A model that the repository shows, as the gates see it.
struct Surveyed {
    drawn: Drawn,
    survey: Survey,
    looks: Vec<Look>,
    /// Its GLB file.
    file: Vec<u8>,
}

impl Surveyed {
    fn new(drawn: Drawn) -> Self {
        let units = units(&drawn.name);
        // The other trees are made for messages alone.
        let model = drawn.model(!units.is_empty());
        let survey = Survey::of(&model, units);
        let file = model.to_glb().unwrap_or_else(|error| panic!("{}: {error}", drawn.name));
        Surveyed { looks: looks(&survey, PIXELS), survey, drawn, file }
    }

    fn report(&self, findings: &[Finding]) -> String {
        report(&Survey::of(&self.drawn.model(true), &[]), findings)
    }
}

/// The shapes inside of initial shapes that are buildings of their own.
fn units(name: &str) -> &'static [&'static str] {
    if name == "example massing" { &["House"] } else { &[] }
}

/// All models, made once by two threads.
fn all() -> &'static [Surveyed] {
    static ALL: OnceLock<Vec<Surveyed>> = OnceLock::new();
    ALL.get_or_init(|| {
        let list = Mutex::new(drawn().into_iter());
        let next = || list.lock().expect("the list").next();
        let work = || std::iter::from_fn(next).map(Surveyed::new).collect::<Vec<_>>();
        std::thread::scope(|scope| {
            let other = scope.spawn(work);
            let mut made = work();
            made.extend(other.join().expect("the models"));
            made
        })
    })
}

/// Fails with a list of all findings if a model has more than `limit` of them.
fn check(limit: usize, gate: impl Fn(&Surveyed) -> Vec<Finding>) {
    let mut text = String::new();
    for surveyed in all() {
        let found = gate(surveyed);
        if limit < found.len() {
            let _ = write!(text, "{}: {}\n{}", surveyed.drawn.name, found.len(), surveyed.report(&found));
        }
    }
    assert!(text.is_empty(), "at most {limit} are allowed\n{text}");
}

/// The findings of a gate in a planted scene, as text.
fn planted<E: Error + 'static>(
    make: impl Fn(&Settings) -> Result<Model, E> + Send + Sync + 'static,
    gate: impl Fn(&Surveyed) -> Vec<Finding>,
) -> String {
    let surveyed = Surveyed::new(Drawn::new("planted", move |settings| Ok(make(settings)?)));
    surveyed.report(&gate(&surveyed))
}
