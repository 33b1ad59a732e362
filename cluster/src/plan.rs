//! Plans in files of the store.

use std::sync::Arc;

use cga_city::units::plan::{Plan, PlanIndex};

use crate::work::{Cache, StoredWork, published, work_with};

/// A plan with its work.
#[derive(Debug)]
pub struct StoredPlan {
    /// The plan.
    pub index: PlanIndex,
    /// The work.
    pub work: Arc<StoredWork>,
}

/// The plan of an address.
///
/// # Errors
/// A sentence about the store or the rules, or the assets of this machine are not the assets of the client.
pub fn plan_at(address: &str) -> Result<Arc<StoredPlan>, String> {
    static KNOWN: Cache<StoredPlan> = Cache::new();
    KNOWN.get(address, |store, name| {
        let plan: Plan = published(&store, name)?;
        let base = address.strip_suffix(name).unwrap_or(address);
        let work = work_with(&format!("{base}{}", plan.work), &plan.digest)?;
        Ok(StoredPlan { index: PlanIndex::new(plan), work })
    })
}
