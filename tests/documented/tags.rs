//! *Geometry tagging*: the tags that operations give, and their propagation, to the numbers of the pictures.

use cga::{Model, Settings, Shape};

use crate::pages::example::Example;
use crate::pages::tags as pages;

/// The colours of the leaves of a rule, in order, each with its number.
fn colours(model: &Model, rule: &str) -> Vec<(String, usize)> {
    let mut found: Vec<(String, usize)> = Vec::new();
    for leaf in model.leaves().filter(|leaf| leaf.rule() == rule) {
        let colour = leaf.material().color.expect("a colour").to_string();
        match found.iter_mut().find(|(known, _)| *known == colour) {
            Some((_, count)) => *count += 1,
            None => found.push((colour, 1)),
        }
    }
    found
}

#[test]
fn show() {
    for example in pages::ALL {
        let model = example.model(&Settings::default());
        println!("{}: {:?} {:?}", example.title, model.counts(), colours(&model, "Bar"));
    }
}
