//! Compiled and loaded rules give the same: bytes of models, reports, prints, faults, errors and values of attributes.

use crate::host::{self, Make};
use crate::outcome::outcome;
use crate::random::Random;
use crate::{start, write};
use cga::{Grammar, Limits, RuleFile, Settings, Value};

/// The lists of shapes of each grammar. Each has its own attributes.
const LISTS: usize = 2;

/// The shapes of each list.
const SHAPES: usize = 3;

/// Loads the rules of a text, with the Rust functions that written grammars call.
pub(crate) fn load(name: &str, text: &str) -> RuleFile {
    let loader = RuleFile::loader().named(name).with_function("crate::host::wave", |args| match args {
        [Value::Float(x)] => Value::Float(host::wave(*x)),
        _ => panic!("{args:?}"),
    });
    let loader = loader.with_operation("crate::host::tint", |shape, args| match args {
        [Value::Float(grey)] => host::tint(shape, *grey),
        _ => panic!("{args:?}"),
    });
    let loader = loader.warn("repeat_no_progress").warn("endless_rules");
    loader.text(text).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Compares runs of compiled and of loaded rules.
fn are_alike(seed: u64, make: Make, text: &str) -> Vec<String> {
    let limits = Limits { shapes: 400, depth: 64, vertices: 20_000, ..Limits::default() };
    let settings = Settings { limits, assets: start::assets(), ..Settings::default() };
    let (mut differing, loaded) = (Vec::new(), load(&format!("G{seed}"), text));
    for list in 0..LISTS {
        let (mut compiled, mut loaded) = (make(), loaded.clone());
        let random = &mut Random(seed + 1000 * list as u64);
        start::attributes(&mut *compiled, random);
        start::attributes(&mut loaded, &mut Random(seed + 1000 * list as u64));
        for _ in 0..SHAPES {
            let (given, shape) = start::shape(random);
            let [a, b] = [&*compiled as &dyn Grammar, &loaded].map(|grammar| outcome(grammar, &shape, &settings));
            if a != b {
                differing.push(format!("seed {seed}, {given}:\n{a}\n{b}"));
            }
        }
    }
    differing
}

/// The differences of runs of all grammars.
pub(crate) fn differences(grammars: &[(u64, Make)]) -> Vec<String> {
    grammars.iter().flat_map(|(seed, make)| are_alike(*seed, *make, &write::write(*seed))).collect()
}

#[cfg(test)]
#[test]
fn loaded_rules_give_the_same_as_compiled_rules() {
    let differing = differences(crate::grammars::ALL);
    assert!(differing.is_empty(), "{} runs differ, first {}", differing.len(), differing[0]);
}
