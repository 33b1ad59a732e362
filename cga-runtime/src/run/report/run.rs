//! The report of a run.

use super::quota::Quota;
use super::{Collection, FAULTS_KEPT, Print, Reports};
use crate::fault::Fault;

/// The counts, faults, reports and lines of a run.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Report {
    /// Shapes derived, leaves included.
    pub shapes: u64,
    /// The leaves passed to the sink. If the sink stops the run within a part that repeats, all leaves of that part
    /// count.
    pub leaves: u64,
    /// True if the sink or a [`Watch`](crate::run::watch::Watch) ended the run.
    pub stopped: bool,
    pub(crate) faults: Vec<Fault>,
    pub(crate) faults_left_out: u64,
    pub(crate) reports: Reports,
    pub(crate) prints: Vec<Print>,
    pub(crate) prints_quota: Quota,
}

impl Report {
    /// The faults of single shapes, each with the rules that led there: the first thousand.
    pub fn faults(&self) -> &[Fault] {
        &self.faults
    }

    /// Puts faults before all others. The first thousand are kept.
    pub(crate) fn begin_with(&mut self, faults: Vec<Fault>) {
        if faults.is_empty() {
            return;
        }
        self.faults.splice(0..0, faults);
        let more = self.faults.split_off(self.faults.len().min(FAULTS_KEPT));
        self.faults_left_out += more.len() as u64;
    }

    /// The number of further faults.
    pub fn faults_left_out(&self) -> u64 {
        self.faults_left_out
    }

    /// The reported values, sorted by key (*report operation*).
    pub fn reports(&self) -> &Reports {
        &self.reports
    }

    /// The values reported under one key. If they have several types, the first type, see [`Reports::of_type`].
    pub fn reported(&self, key: &str) -> Option<&Collection> {
        self.reports.get(key)
    }

    /// The lines that rules printed, breadth first: by the depth of their shape in the tree of shapes, and lines of
    /// equal depth in order of derivation (*getTreeKey function*).
    pub fn prints(&self) -> &[Print] {
        &self.prints
    }

    /// The number of printed lines beyond the limit; see [`Limits::prints`](crate::run::settings::Limits::prints).
    pub fn prints_left_out(&self) -> u64 {
        self.prints_quota.left_out
    }
}
