//! Merging the reports of several runs, in the order of the runs.

use super::FAULTS_KEPT;
use super::Reports;
use super::quota::MOST_BYTES;
use crate::fault::{Fault, FaultKind};
use crate::run::report::Report;
use crate::run::settings::Limits;

impl Report {
    /// Adds the report of the next run. Counts are added, faults and lines appended, collections joined. Equal
    /// reports in equal order give the same sum, bit for bit.
    ///
    /// The limits of one run also hold for the sum: entries beyond them are only counted. A fault that a run reports
    /// once, such as a missing file, is kept once for all runs, with a count.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::{Limits, Report};
    ///
    /// let (mut sum, mut next) = (Report::default(), Report::default());
    /// (sum.leaves, next.leaves) = (3, 4);
    /// sum.merge(next, &Limits::default());
    /// assert_eq!(sum.leaves, 7);
    /// ```
    pub fn merge(&mut self, next: Report, limits: &Limits) {
        self.shapes = self.shapes.saturating_add(next.shapes);
        self.leaves = self.leaves.saturating_add(next.leaves);
        self.stopped |= next.stopped;
        next.faults.into_iter().for_each(|fault| self.merge_fault(fault));
        self.faults_left_out += next.faults_left_out;
        self.reports.merge(next.reports, limits.reports);
        let room = usize::try_from(limits.prints).unwrap_or(usize::MAX).saturating_sub(self.prints.len());
        let room = if MOST_BYTES < self.prints_quota.bytes + next.prints_quota.bytes { 0 } else { room };
        let kept = next.prints.len().min(room);
        self.prints_quota.left_out += next.prints_quota.left_out + (next.prints.len() - kept) as u64;
        if kept != 0 {
            self.prints_quota.bytes += next.prints_quota.bytes;
            self.prints.extend(next.prints.into_iter().take(kept));
        }
    }

    fn merge_fault(&mut self, fault: Fault) {
        let once = matches!(fault.kind, FaultKind::Asset | FaultKind::Limit);
        let known = |kept: &&mut Fault| kept.kind == fault.kind && kept.message == fault.message;
        if let Some(kept) = self.faults.iter_mut().filter(|_| once).find(known) {
            kept.count = kept.count.saturating_add(fault.count);
        } else if self.faults.len() < FAULTS_KEPT {
            self.faults.push(fault);
        } else {
            self.faults_left_out += fault.count;
        }
    }

    /// Returns true if merging this report needs its counts only.
    pub(crate) fn is_only_counts(&self) -> bool {
        self.faults.is_empty()
            && self.faults_left_out == 0
            && self.reports.is_empty()
            && self.reports.left_out() == 0
            && self.prints.is_empty()
            && self.prints_quota.left_out == 0
    }
}

impl Reports {
    /// Joins the collections of the next run to these.
    fn merge(&mut self, next: Reports, limit: u64) {
        self.quota.left_out += next.quota.left_out;
        for (id, next) in next.collections {
            let Some((own, quota)) = self.collection(id, limit) else {
                // One of them was counted.
                self.quota.left_out += next.summary.count.saturating_sub(1);
                continue;
            };
            own.summary.merge(&next.summary);
            for (text, count) in next.texts {
                own.add_text(text, count, quota, limit);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::value::text::Text;

    fn report(add: &[(&'static str, crate::value::Value)]) -> Report {
        let mut reports = Reports::default();
        for (key, value) in add {
            assert!(reports.add(Text::fixed(key), value.clone(), 100));
        }
        Report { reports, ..Report::default() }
    }

    #[test]
    fn merged_collections_are_those_of_one_run() {
        let parts = [("a", 1.0.into()), ("b", "x".into()), ("a", 2.5.into()), ("b", "y".into()), ("b", "x".into())];
        let mut sum = report(&parts[..2]);
        sum.merge(report(&parts[2..]), &Limits::default());
        assert_eq!(sum.reports, report(&parts).reports);
    }

    #[test]
    fn what_has_no_room_is_counted() {
        let mut sum = report(&[("a", "x".into())]);
        let limits = Limits { reports: 3, ..Limits::default() };
        sum.merge(report(&[("a", "y".into()), ("a", "z".into()), ("a", "z".into()), ("b", 1.0.into())]), &limits);
        assert_eq!(sum.reports.left_out(), 3);
        assert_eq!(sum.reports.get("a").map(|a| (a.summary().count, a.texts().len())), Some((4, 2)));
        assert!(sum.reports.get("b").is_none());
    }

    #[test]
    fn faults_of_files_are_kept_once_and_others_in_order() {
        let fault = |kind, message: &str| Fault { kind, ..Fault::new(message) };
        let with = |faults: Vec<Fault>| Report { faults, ..Report::default() };
        let mut sum = with(vec![fault(FaultKind::Asset, "tree"), fault(FaultKind::Value, "nan")]);
        sum.merge(with(vec![fault(FaultKind::Value, "nan"), fault(FaultKind::Asset, "tree")]), &Limits::default());
        assert_eq!(sum.faults.iter().map(|fault| fault.count).collect::<Vec<_>>(), [2, 1, 1]);
        for _ in 0..2 {
            let many = (0..600).map(|at| fault(FaultKind::Value, &at.to_string())).collect();
            sum.merge(with(many), &Limits::default());
        }
        assert_eq!((sum.faults.len(), sum.faults_left_out), (FAULTS_KEPT, 203));
    }
}
