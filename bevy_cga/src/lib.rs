#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

mod channel;
mod convert;
mod event;
#[cfg(feature = "pbr")]
mod mip_levels;
mod parts;
#[cfg(feature = "pbr")]
mod pbr;
mod plugin;
#[cfg(feature = "eval")]
mod rules;
mod run;
mod scene;
mod show;
mod source;

pub use convert::collider_triangles;
pub use event::{CgaError, CgaFailed, CgaGenerated, CgaLeaf};
pub use parts::{CgaMesh, CgaModel, CgaOrigin, CgaRoot};
pub use plugin::{CgaPlugin, CgaSystems};
#[cfg(feature = "eval")]
pub use rules::{CgaFile, CgaRuleLoader, CgaRules};
pub use run::CgaRun;
pub use scene::{CgaLotOf, CgaLots, CgaScene};
pub use source::{Cga, LeafEvents};
