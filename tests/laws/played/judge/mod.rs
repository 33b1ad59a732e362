//! Checks claims of *never* and *always* against runs.

mod splits;

use crate::played::places::Places;
use crate::played::run::Run;
use Verdict::{Broken, Silent, So};
use cga_lang::diag::code::Code;
use cga_lang::diag::{Basis, Detail, Diag};

/// The verdict of a run on a finding.
#[derive(PartialEq)]
pub(crate) enum Verdict {
    /// It never came there.
    Silent,
    /// It came there, and it is so.
    So,
    /// It is not so, and why.
    Broken(String),
}

/// Judges a finding by a run.
pub(crate) fn judge(diag: &Diag, places: &Places, run: &Run) -> Verdict {
    match diag.code {
        Code::CaseAlways => condition(diag, places, run),
        // A run that is told to may begin there.
        Code::RuleNotReached | Code::UnmarkedStart if diag.basis == Basis::Start => Silent,
        Code::RuleNotReached => match places.rules.iter().find(|rule| rule.name == diag.span) {
            Some(rule) if heard(run, &rule.marks) => Broken("it is reached".into()),
            Some(_) if run.limit.is_none() => So,
            _ => Silent,
        },
        Code::EndlessRules if diag.basis == Basis::Rules => endless(diag, places, run),
        Code::SelectorHidden => match places.arms.iter().find(|arm| arm.selector == diag.span) {
            Some(arm) if heard(run, &arm.own) => Broken("it found something".into()),
            Some(arm) if heard(run, &arm.all) => So,
            _ => Silent,
        },
        Code::DivisionByZero => quotient(diag, places, run),
        _ => splits::judge(diag, places, run),
    }
}

fn heard(run: &Run, marks: &[u32]) -> bool {
    marks.iter().any(|mark| run.marks.contains(mark))
}

fn condition(diag: &Diag, places: &Places, run: &Run) -> Verdict {
    let Some(branch) = places.branches.iter().find(|branch| branch.condition == diag.span) else { return Silent };
    let Detail::Condition(truth) = diag.detail else { return Silent };
    let (so, not) = if truth { (&branch.then, &branch.otherwise) } else { (&branch.otherwise, &branch.then) };
    match (heard(run, so), heard(run, not)) {
        (_, true) => Broken(format!("it is {}", !truth)),
        (true, false) => So,
        (false, false) => Silent,
    }
}

fn quotient(diag: &Diag, places: &Places, run: &Run) -> Verdict {
    let Some((_, number)) = places.quotients.iter().find(|(divisor, _)| *divisor == diag.span) else { return Silent };
    let values: Vec<f64> = run.quotients.iter().filter(|(own, _)| own == number).map(|(_, value)| *value).collect();
    match values.iter().find(|value| value.is_finite()) {
        Some(value) => Broken(format!("the result is {value}")),
        None if values.is_empty() => Silent,
        None => So,
    }
}

fn endless(diag: &Diag, places: &Places, run: &Run) -> Verdict {
    let Some(rule) = places.rules.iter().find(|rule| rule.name == diag.span) else { return Silent };
    match &run.limit {
        Some(trail) if trail.iter().any(|name| name.is(&rule.text)) => So,
        None if run.whole && heard(run, &rule.marks) => Broken("the run came to its end".into()),
        _ => Silent,
    }
}
