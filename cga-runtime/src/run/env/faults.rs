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
    /// The messages so far that are reported once a run.
    pub(super) said_once: Vec<String>,
    /// The number of attempts to report such a message, and of repetitions of counted faults.
    pub(super) said_again: u64,
}

impl Env {
    /// Records a fault unless it was recorded before.
    pub(crate) fn fault_once(&mut self, kind: FaultKind, message: &str) {
        self.faults.said_again += 1;
        if !self.faults.said_once.iter().any(|said| said == message) {
            self.faults.said_once.push(message.to_owned());
            self.fault(kind, message);
        }
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
