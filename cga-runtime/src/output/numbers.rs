//! Rules and materials of leaves as numbers of a sink.
//!
//! Leaves that fill their scopes have numbers that are those of the run. A list leads from these to the numbers of the sink's
//! table, so that a leaf costs two loads, however often rules and materials alternate.

use std::fmt;

use super::table::Table;
use crate::run::sink::{Filled, Leaf};
use crate::shape::look_id::LookId;

/// A table of rule names and materials, and the numbers of the run under way as numbers of the table.
#[derive(Clone, Default)]
pub(crate) struct Numbers {
    pub(crate) table: Table,
    rules: Vec<u32>,
    materials: Vec<u32>,
}

/// Not yet known.
const UNKNOWN: u32 = u32::MAX;

impl fmt::Debug for Numbers {
    /// The table alone: the numbers of a run tell nothing about the leaves.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.table.fmt(f)
    }
}

impl Numbers {
    /// Another run begins, with numbers of its own. The table keeps its numbers.
    pub(crate) fn begin(&mut self) {
        self.rules.clear();
        self.materials.clear();
    }

    /// Forgets everything, keeps the memory.
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

    /// The rule of a leaf, for sinks that do not show materials.
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

    /// Asks the table, and keeps its answer if the look has a number.
    #[cold]
    #[inline(never)]
    fn find(&mut self, leaf: &Filled<'_>, look: LookId) -> (u32, u32) {
        let rule = self.table.rule(leaf.rule());
        let found = self.table.material(leaf.of_id(look));
        keep(&mut self.rules, leaf.rule, rule);
        if look != LookId::OF_BASE {
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
