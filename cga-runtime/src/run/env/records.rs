//! What a run records besides its leaves: reports and printed lines.

use super::Env;
use crate::fault::FaultKind;
use crate::value::Value;
use crate::value::text::Text;

/// The largest number of reports in a template.
pub(crate) const MOST_TAPED: usize = 64;

/// A value that was reported while a template was recorded, with the rules that led there.
#[derive(Clone, Debug)]
pub(crate) struct TapedReport {
    pub(crate) key: Text,
    pub(crate) value: Value,
    pub(crate) trail: Vec<u32>,
}

impl Env {
    /// Adds a value to the collection with a key.
    pub(crate) fn report(&mut self, key: Text, value: Value) {
        // Values after the end of the run do not matter.
        if self.ended() {
            return;
        }
        // A template reports it again and again.
        if self.measures_room() {
            // One more than the largest number tells that there are too many.
            if self.taped_reports.len() <= MOST_TAPED {
                self.taped_reports.push(TapedReport { key, value, trail: self.trail.clone() });
            }
            return;
        }
        let limit = self.settings.limits.reports;
        if !self.reports.add(key, value, limit) && self.reports.left_out() == 1 {
            self.fault(FaultKind::Limit, format!("the limit of {limit} reports is reached; further ones are left out"));
        }
    }

    /// Keeps a printed line.
    pub(crate) fn print(&mut self, value: Value) {
        if self.ended() {
            return;
        }
        let before = self.before.as_deref().map_or(&[][..], |before| &before.rules);
        let rule = self.trail.last().or(before.last()).map_or_else(Text::default, |&rule| self.rule_name(rule));
        let (depth, limit) = (self.depth(), self.settings.limits.prints);
        if !self.prints.add(depth, rule, value, limit) && self.prints.quota.left_out == 1 {
            self.fault(FaultKind::Limit, format!("the limit of {limit} lines is reached; further ones are left out"));
        }
    }
}
