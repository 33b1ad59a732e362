//! The checks against the solver: random rules are checked, then run; what a check calls never or always is so in every
//! run, whatever values attributes get within their ranges.
//!
//! Runs are modelled here: shapes are boxes and their faces, splits go to the solver that real runs use.

mod common;
mod model;

use cga_lang::code::Code;
use cga_lang::compile::compile_text_with;
use cga_lang::diag::{Diag, Level};
use cga_lang::ir::Grammar;
use common::random::Random;
use model::{Facts, Model};

/// Grammars that are made.
const GRAMMARS: u64 = 1000;

/// Runs of each.
const RUNS: u64 = 6;

#[test]
fn what_the_checks_call_never_or_always_is_so_in_every_run() {
    let mut counts = std::collections::BTreeMap::new();
    for seed in 0..GRAMMARS {
        let mut random = Random(seed);
        let text = model::write(&mut random);
        // What is an error of this kind runs all the same.
        let levels = [(Code::RepeatNoProgress, Level::Warning), (Code::EndlessRules, Level::Warning)];
        let source = compile_text_with(&text, &levels);
        let diags = source.compiled.diags;
        assert!(diags.iter().all(|diag| diag.level != Level::Error), "{text}\n{diags:?}");
        let grammar = source.compiled.grammar.expect("no error");
        let mut runs: Vec<Facts> = Vec::new();
        for run in 0..RUNS {
            let mut facts = Facts::default();
            Model::new(&grammar, &mut random, &mut facts, run == 0).run();
            runs.push(facts);
        }
        for diag in &diags {
            *counts.entry(diag.code).or_insert(0u32) += 1;
            let usual = diag.notes.iter().any(|note| note.text.starts_with("so it is with the default"));
            for facts in runs.iter().take(if usual { 1 } else { usize::MAX }) {
                if let Err(why) = holds(diag, facts, &grammar) {
                    panic!("seed {seed}: {} is not so: {why}\n{text}\n{diag:?}", diag.message);
                }
            }
        }
    }
    let seen = |code: Code| counts.get(&code).copied().unwrap_or(0);
    for code in [
        Code::SizeNotPositive,
        Code::SlotNeverMade,
        Code::FloatWithoutSpace,
        Code::SlotAlwaysCut,
        Code::SharesBeyondWhole,
        Code::SizesBeyondExtent,
        Code::GapLeft,
        Code::FlatSplit,
        Code::RepeatNoProgress,
        Code::RepeatOnce,
        Code::RepeatSliver,
        Code::CaseAlways,
        Code::EndlessRules,
        Code::SelectorHidden,
    ] {
        assert!(3 < seen(code), "{}: {} times is too few to say anything; {counts:?}", code.name(), seen(code));
    }
}

/// Whether a finding is true of a run.
fn holds(diag: &Diag, facts: &Facts, grammar: &Grammar) -> Result<(), String> {
    // Sizes are known by their last token, as those of the solver have no prefix.
    let slots = || facts.slots.iter().filter(|slot| slot.token == diag.span.last);
    let all = |what: &str, so: &dyn Fn(&model::Slot) -> bool| match slots().find(|slot| !so(slot)) {
        Some(slot) => Err(format!("{what}: {slot:?}")),
        None => Ok(()),
    };
    match diag.code {
        Code::SizeNotPositive => all("it is positive", &|slot| slot.value <= 0.0 && slot.pieces.is_empty()),
        Code::SlotNeverMade | Code::FloatWithoutSpace => all("it is made", &|slot| slot.pieces.is_empty()),
        Code::SlotAlwaysCut | Code::SharesBeyondWhole | Code::SizesBeyondExtent => {
            all("it is not cut", &|slot| slot.pieces.iter().all(|piece| *piece < slot.size))
        }
        Code::GapLeft => all("there is no gap", &|slot| slot.filled < slot.extent),
        Code::FlatSplit => match facts.extents.iter().find(|(token, _)| *token + 2 == diag.span.first) {
            Some((_, extent)) if 1e-6 < *extent => Err(format!("it extends by {extent}")),
            _ => Ok(()),
        },
        Code::RepeatNoProgress => all("there is one", &|slot| slot.pieces.is_empty()),
        Code::RepeatOnce => all("there are more", &|slot| slot.pieces.len() <= 1),
        Code::RepeatSliver => all("it is no sliver", &|slot| slot.last < 0.1),
        Code::CaseAlways => {
            let truth = diag.message.ends_with("true");
            match facts.conditions.iter().find(|(span, found)| *span == diag.span && *found != truth) {
                Some(_) => Err(format!("it is {}", !truth)),
                None => Ok(()),
            }
        }
        Code::RuleNotReached => match facts.rules.iter().find(|rule| grammar.rules[**rule].span == diag.span) {
            Some(rule) => Err(format!("rule {rule} was reached")),
            None => Ok(()),
        },
        Code::EndlessRules if diag.message.ends_with("never ends") => {
            let reached = facts.rules.iter().any(|rule| grammar.rules[*rule].span == diag.span);
            if reached && !facts.broken_off { Err("it ended".into()) } else { Ok(()) }
        }
        Code::SelectorHidden => match facts.selected.iter().find(|token| **token == diag.span.first) {
            Some(token) => Err(format!("the arm of token {token} got a face")),
            None => Ok(()),
        },
        _ => Ok(()),
    }
}
