//! The faults of a run.

use std::collections::BTreeMap;
use std::fmt::Display;

use super::Env;
use crate::fault::{Fault, FaultKind};
use crate::run::report::FAULTS_KEPT;

/// The faults so far.
#[derive(Debug, Default)]
pub(super) struct FaultList {
    pub(super) list: Vec<Fault>,
    /// The number of faults beyond the limit.
    pub(super) left_out: u64,
    /// The faults of files by their messages, as indices of the list.
    pub(super) of_files: BTreeMap<String, usize>,
    /// The texts reported so far of those that are reported once a run: names that are not implemented, messages.
    pub(super) said_once: Vec<String>,
    /// The number of attempts to report such a text, and of repetitions of counted faults.
    pub(super) said_again: u64,
}

impl Env {
    /// Records a fault unless it was recorded before.
    pub(crate) fn fault_once(&mut self, kind: FaultKind, message: &str) {
        if self.is_new(message) {
            self.fault(kind, message);
        }
    }

    /// Records that something is not implemented, once a run.
    pub(crate) fn not_implemented(&mut self, name: &str, instead: &str) {
        if self.is_new(name) {
            self.fault(FaultKind::NotImplemented, format!("`{name}` is not implemented yet; {instead}"));
        }
    }

    /// Returns true if a text that is reported once a run was not reported yet.
    fn is_new(&mut self, text: &str) -> bool {
        self.faults.said_again += 1;
        let is_new = !self.faults.said_once.iter().any(|said| said == text);
        if is_new {
            self.faults.said_once.push(text.to_owned());
        }
        is_new
    }

    /// The number of faults so far, repetitions included.
    pub(crate) fn fault_count(&self) -> u64 {
        self.faults.list.len() as u64 + self.faults.left_out + self.faults.said_again
    }

    /// Records a fault with the trail that led to it.
    #[cold]
    pub fn fault(&mut self, kind: FaultKind, message: impl Into<String>) {
        self.add_fault(kind, message.into());
    }

    /// Records a fault of a file. Repetitions are only counted: rules insert the same file thousands of times.
    #[cold]
    pub(crate) fn asset_fault(&mut self, message: String) {
        if let Some(&at) = self.faults.of_files.get(&message) {
            self.faults.said_again += 1;
            // A template that makes a fault is not kept, and its rule runs again.
            if !self.measures_room() {
                self.faults.list[at].count = self.faults.list[at].count.saturating_add(1);
            }
            return;
        }
        if let Some(at) = self.add_fault(FaultKind::Asset, message.clone()) {
            self.faults.of_files.insert(message, at);
        }
    }

    /// Records a fault of an image, once in a run: looks are kept, so the number of times that rules ask for an image depends on what is
    /// kept.
    #[cold]
    pub(crate) fn image_fault(&mut self, message: String) {
        if self.faults.of_files.contains_key(&message) {
            self.faults.said_again += 1;
        } else {
            self.asset_fault(message);
        }
    }

    /// Adds a fault, if there is room for it. Returns its index.
    fn add_fault(&mut self, kind: FaultKind, message: String) -> Option<usize> {
        // The failure of an operation that was ended is no fault of the rules.
        if self.ask().is_break() {
            return None;
        }
        if FAULTS_KEPT <= self.faults.list.len() {
            self.faults.left_out += 1;
            return None;
        }
        let trail = self.trail();
        self.faults.list.push(Fault { kind, message, count: 1, trail });
        Some(self.faults.list.len() - 1)
    }

    /// The number, or 0 with a fault if it is not finite (*CGA changelog 2013.1*: the default policy for such
    /// arguments).
    #[inline]
    pub(crate) fn finite(&mut self, value: f64, what: impl Display) -> f64 {
        if value.is_finite() {
            return value;
        }
        self.fault(FaultKind::Value, format!("{what} is {value}; 0 is used instead"));
        0.0
    }

    pub(crate) fn take_faults(&mut self) -> (Vec<Fault>, u64) {
        self.faults.of_files.clear();
        (std::mem::take(&mut self.faults.list), self.faults.left_out)
    }
}
