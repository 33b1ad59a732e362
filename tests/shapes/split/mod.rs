//! The split operation from rules to shapes: what a part is, in which order things happen, where recursion ends, and that
//! it makes no difference whether a split was solved by the macro. Lengths are the solver's business: see
//! `cga-split/tests`.

mod again;
mod area;
mod known;
mod lots;
mod order;
mod parts;
mod repeated;
mod restored;
mod small;

use cga::Model;

/// The numbers that rules printed behind that word.
fn values(model: &Model, word: &str) -> Vec<f64> {
    let lines = model.prints().iter().map(|print| print.value.to_string());
    let numbers = lines.filter_map(|line| line.strip_prefix(word)?.trim().parse().ok());
    numbers.collect()
}
