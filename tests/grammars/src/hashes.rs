//! Hashes of runs, one line for each grammar and shape: equal on every platform, in every build, in a loop and on threads.

use crate::hash::{Hash, buffers};
use crate::host::Make;
use crate::random::Random;
use crate::{start, write};
use cga::mesh::FaceTag;
use cga::parallel::run_all;
use cga::sink::buffers::Buffers;
use cga::{Error, Grammar, Limits, Model, Report, Settings, Shape};
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The lists of shapes of each grammar. Each has its own attributes.
const LISTS: usize = 4;

/// The shapes of each list.
const SHAPES: usize = 5;

/// A run of one shape: the hash of its leaves, and what it reports.
type Run = (u64, Result<Report, Error>);

/// Prints the lines of all grammars. Returns false if runs panic, or differ between a loop and threads.
pub(crate) fn print(grammars: &[(u64, Make)]) -> bool {
    grammars.iter().filter(|(seed, make)| !grammar(*seed, *make)).count() == 0
}

/// Prints the lines of one grammar; what goes wrong is written to standard error, with the rules.
fn grammar(seed: u64, make: Make) -> bool {
    let mut random = Random(seed);
    let mut holds = true;
    for list in 0..LISTS {
        let mut grammar = make();
        let attributes = start::attributes(&mut *grammar, &mut random);
        let (given, shapes): (Vec<String>, Vec<Shape>) = (0..SHAPES).map(|_| start::shape(&mut random)).unzip();
        let mut fails = |what: &str, shape: &str| {
            eprintln!("seed {seed}: {what}: {shape} with {attributes}");
            holds = false;
        };
        let mut runs = Vec::new();
        for (at, shape) in shapes.iter().enumerate() {
            let Ok((line, run)) = catch_unwind(AssertUnwindSafe(|| alone(&*grammar, shape))) else {
                fails("a run panics", &given[at]);
                continue;
            };
            println!("seed {seed}, shape {}: {line}", SHAPES * list + at);
            runs.push((shape.clone(), run));
        }
        match catch_unwind(AssertUnwindSafe(|| are_alike(&*grammar, &runs))) {
            Ok(true) => (),
            Ok(false) => fails("a loop and threads differ", &given.join(", ")),
            Err(_) => fails("a run on threads panics", &given.join(", ")),
        }
    }
    if !holds {
        eprintln!("{}", write::write(seed));
    }
    holds
}

/// Limits that keep a run short.
fn settings() -> Settings {
    let limits = Limits { shapes: 400, depth: 64, vertices: 20_000, ..Limits::default() };
    Settings { limits, assets: start::assets(), ..Settings::default() }
}

/// Runs one shape, into a model and into buffers. Returns the line, and the run into the model.
fn alone(grammar: &dyn Grammar, shape: &Shape) -> (String, Run) {
    let (mut model, mut flat) = (Model::new(), Buffers::new());
    let report = grammar.run(shape, &settings(), &mut model);
    // The same report.
    let _ = grammar.run(shape, &settings(), &mut flat);
    let hash = leaves(&model);
    let all = (model.len(), buffers(&flat), Hash::of(format!("{report:?}").as_bytes()));
    let line = format!("{} leaves {hash:016x}, buffers {:016x}, report {:016x}", all.0, all.1, all.2);
    (line, (hash, report))
}

/// Compares runs with runs of the same shapes at once. Shapes whose runs end with an error are left out: they end all runs.
fn are_alike(grammar: &(dyn Grammar + Sync), runs: &[(Shape, Run)]) -> bool {
    let mut sum = Report::default();
    let (mut shapes, mut hashes) = (Vec::new(), Vec::new());
    for (shape, (hash, report)) in runs {
        if let Ok(report) = report {
            sum.merge(report.clone(), &settings().limits);
            shapes.push(shape.clone());
            hashes.push(*hash);
        }
    }
    let models = run_all(grammar, &shapes, &settings(), |_| Model::new());
    models.is_ok_and(|models| {
        format!("{:?}", models.report()) == format!("{sum:?}") && models.sinks().map(leaves).eq(hashes)
    })
}

/// The hash of all that leaves have: rules, materials, scopes, and meshes with all digits of their numbers. Sets of tags count by their
/// names, as their numbers cannot be seen.
fn leaves(model: &Model) -> u64 {
    let mut hash = Hash::new();
    for leaf in model.leaves() {
        let (mesh, placement) = leaf.mesh();
        let (rule, material, scope) = (leaf.rule(), leaf.material(), leaf.scope());
        let text = write!(hash, "{rule} {material:?} {scope:?} {placement:?} {:?} {:?}", mesh.points(), mesh.normals());
        text.expect("a hash takes all text");
        for face in mesh.faces() {
            let loops: Vec<&[u32]> = face.loops().collect();
            let tag = face.tag();
            let tags = mesh.tag_sets().get(tag.tags as usize).map_or(&[][..], |set| set.names());
            let attributes = FaceTag { tags: FaceTag::NONE, ..tag };
            write!(hash, "{loops:?} {attributes:?} {tags:?}").expect("a hash takes all text");
        }
        let names = (mesh.groups(), mesh.materials::<cga::Material>());
        let sets: Vec<_> = (0..10).map(|set| mesh.uv_set(set)).collect();
        write!(hash, "{names:?} {sets:?}").expect("a hash takes all text");
    }
    hash.0
}
