//! All that a run gives, as text to compare.

use cga::{Error, Grammar, Model, Settings, Shape};

/// The report or the error of a run, the values that it used, and the bytes of its model.
pub fn outcome(grammar: &dyn Grammar, shape: &Shape, settings: &Settings) -> String {
    let mut model = Model::new();
    let result = grammar.run(shape, settings, &mut model);
    let used: Result<_, Error> = grammar.used_values(shape, settings);
    format!("{result:?}\n{used:?}\n{}", bytes(&model.with_assets(settings.assets.clone())))
}

/// The length and the hash of a model's bytes.
pub fn bytes(model: &Model) -> String {
    format!("{:?}", model.to_glb().map(|bytes| (bytes.len(), hash(&bytes))))
}

/// FNV-1a.
fn hash(bytes: &[u8]) -> u64 {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}
