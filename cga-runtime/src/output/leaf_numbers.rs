//! The numbers of leaves' rules and materials in a sink.
//!
//! Leaves that fill their scopes have numbers of the run. A list maps these to the numbers of the sink's table, so a
//! leaf costs two loads, even if rules and materials alternate.

use std::fmt;

use super::sink_table::SinkTable;
use crate::run::sink::{Filled, Leaf};
use crate::shape::look_id::LookId;

/// A table of rule names and materials, and a map from numbers of the current run to numbers of the table.
#[derive(Clone, Default)]
pub(crate) struct Numbers {
    pub(crate) table: SinkTable,
    rules: Vec<u32>,
    materials: Vec<u32>,
}

/// The mark of a number that is not known yet.
const UNKNOWN: u32 = u32::MAX;

impl fmt::Debug for Numbers {
    /// Writes the table alone: the numbers of a run are irrelevant for the leaves.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.table.fmt(f)
    }
}

impl Numbers {
    /// Begins another run, whose numbers have other meanings. The table keeps its numbers.
    pub(crate) fn begin(&mut self) {
        self.rules.clear();
        self.materials.clear();
    }

    /// Removes all entries but keeps the memory.
    pub(crate) fn clear(&mut self) {
        self.table.clear();
        self.begin();
    }

    /// The rule and the material of a leaf.
    #[inline]
    pub(crate) fn leaf(&mut self, leaf: &Leaf<'_>) -> (u32, u32) {
        (self.table.rule(leaf.rule), self.table.material(leaf.material))
    }

    /// The rule and the material of a leaf that fills its scope.
    #[inline]
    pub(crate) fn filled(&mut self, leaf: &Filled<'_>) -> (u32, u32) {
        self.with_look(leaf, leaf.shape.look.get())
    }

    /// The rule of a leaf, for sinks that ignore materials.
    #[inline]
    pub(crate) fn rule(&mut self, leaf: &Filled<'_>) -> u32 {
        match self.rules.get(leaf.rule as usize) {
            Some(&rule) if rule != UNKNOWN => rule,
            _ => {
                let rule = self.table.rule(leaf.rule());
                keep(&mut self.rules, leaf.rule, rule);
                rule
            }
        }
    }

    /// The rule of a leaf and the material of another look of the run.
    #[inline]
    pub(crate) fn with_look(&mut self, leaf: &Filled<'_>, look: LookId) -> (u32, u32) {
        match (self.rules.get(leaf.rule as usize), self.materials.get(look.index() as usize)) {
            (Some(&rule), Some(&material)) if rule != UNKNOWN && material != UNKNOWN => (rule, material),
            _ => self.find(leaf, look),
        }
    }

    /// Looks the leaf up in the table, and keeps the result if the material has a number.
    #[cold]
    #[inline(never)]
    fn find(&mut self, leaf: &Filled<'_>, look: LookId) -> (u32, u32) {
        let rule = self.table.rule(leaf.rule());
        let found = self.table.material(leaf.of_id(look));
        keep(&mut self.rules, leaf.rule, rule);
        if look.is_lasting() {
            keep(&mut self.materials, look.index(), found);
        }
        (rule, found)
    }
}

fn keep(list: &mut Vec<u32>, number: u32, found: u32) {
    let at = number as usize;
    list.resize(list.len().max(at + 1), UNKNOWN);
    list[at] = found;
}
