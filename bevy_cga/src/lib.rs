#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

mod channel;
mod convert;
mod event;
mod parts;
#[cfg(feature = "pbr")]
mod pbr;
mod plugin;
mod run;
mod show;
mod source;

pub use convert::collider_triangles;
pub use event::{CgaError, CgaFailed, CgaGenerated, CgaLeaf};
pub use parts::{CgaMesh, CgaModel, CgaOrigin, CgaRoot};
pub use plugin::{CgaPlugin, CgaSystems};
pub use run::CgaRun;
pub use source::{Cga, LeafEvents};
