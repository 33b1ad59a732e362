//! GLB files of models.

use std::io;
use std::path::Path;
use std::sync::Arc;

use glam::DVec3;

use super::Glb;
use crate::asset::Assets;
use crate::output::batches::Batches;
use crate::output::error::WriteError;
use crate::output::model::Model;
use crate::output::near_origin::near_origin_within;
use crate::run::sink::Flow;

impl Model {
    /// The model as a GLB file; see [`Glb`]. A model far from the origin of the world is stored relative to its own
    /// middle.
    ///
    /// # Errors
    /// As [`Glb::into_bytes`].
    pub fn to_glb(&self) -> Result<Vec<u8>, WriteError> {
        self.glb().into_bytes()
    }

    /// Writes the model as a GLB file; see [`Model::to_glb`].
    ///
    /// # Errors
    /// As [`Glb::into_bytes`], and errors of the file system.
    pub fn write_glb(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        self.glb().write_file(path.as_ref())
    }

    /// Writes the bytes of [`Model::to_glb`] to `out`.
    ///
    /// # Errors
    /// As [`Glb::write_to`].
    pub fn write_glb_to(&self, out: impl io::Write) -> Result<(), WriteError> {
        self.glb().write_to(out)
    }

    fn glb(&self) -> Glb {
        from_models(self.near_origin(), self.assets(), |glb| self.replay(glb))
    }
}

impl Batches<Model> {
    /// All models as one GLB file, equal to the file of one model with all leaves.
    ///
    /// # Errors
    /// As [`Glb::into_bytes`].
    pub fn to_glb(&self) -> Result<Vec<u8>, WriteError> {
        self.glb().into_bytes()
    }

    /// Writes all models as one GLB file.
    ///
    /// # Errors
    /// As [`Glb::into_bytes`], and errors of the file system.
    pub fn write_glb(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        self.glb().write_file(path.as_ref())
    }

    /// Writes the bytes of one GLB file with all models to `out`.
    ///
    /// # Errors
    /// As [`Glb::write_to`].
    pub fn write_glb_to(&self, out: impl io::Write) -> Result<(), WriteError> {
        self.glb().write_to(out)
    }

    fn glb(&self) -> Glb {
        let assets = self.sinks().next().and_then(Model::assets);
        let reach = self.sinks().map(Model::reach).fold(0.0, f64::max);
        from_models(near_origin_within(reach, || self.bounds()), assets, |glb| self.replay(glb))
    }
}

fn from_models(origin: DVec3, assets: Option<&Arc<Assets>>, replay: impl FnOnce(&mut Glb) -> Flow) -> Glb {
    let mut glb = Glb { files: assets.cloned(), ..Glb::new().with_origin(origin) };
    // It stops when it is full; `into_bytes` reports that.
    let _ = replay(&mut glb);
    glb
}
