//! The source of a model's images.

use std::fmt;
use std::sync::Arc;

use crate::asset::Assets;

/// The assets of the run that made a model, if they are known.
#[derive(Clone, Default)]
pub(crate) struct Files(Option<Arc<Assets>>);

impl Files {
    /// The given assets.
    pub(crate) fn of(assets: Arc<Assets>) -> Self {
        Files(Some(assets))
    }

    /// The assets.
    pub(crate) fn get(&self) -> Option<&Arc<Assets>> {
        self.0.as_ref()
    }
}

impl fmt::Debug for Files {
    /// Writes only that there are assets: the files read so far are irrelevant for a model.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "Assets" } else { "None" })
    }
}
