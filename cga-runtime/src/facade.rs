//! The names of the package `cga`, for the examples of this documentation: it is also shown there. A test compiles their `use` lines
//! with that package.

pub use crate::asset::Assets;
pub use crate::fault::Error;
pub use crate::geometry::mesh::{Mesh, MeshBuilder};
pub use crate::glam;
pub use crate::grammar::Grammar;
pub use crate::grammar::grammars::Grammars;
pub use crate::grammar::parallel::Stretch;
pub use crate::grammar::scene::Scene;
pub use crate::grammar::scene::shared::{SceneLot, SharedScene};
pub use crate::grammar::session::DynSession;
pub use crate::material::Material;
pub use crate::output::model::Model;
pub use crate::run::building::Building;
pub use crate::run::coordinate_system::CoordinateSystem;
pub use crate::run::report::Report;
pub use crate::run::settings::{Limits, Settings};
pub use crate::run::sink::{Flow, Leaf, Quad, Sink};
pub use crate::run::watch::Watch;
pub use crate::shape::Shape;
pub use crate::shape::scope::Scope;
pub use crate::value::Value;
pub use crate::value::text::Text;

pub mod mesh {
    #[cfg(feature = "gltf")]
    pub use crate::asset::gltf::read_gltf;
    pub use crate::geometry::mesh::FaceTag;
}

pub mod sink {
    #[cfg(feature = "gltf")]
    pub use crate::output::gltf;
    pub use crate::output::{buffers, meshes, picture, watertight};
    pub use crate::run::sink::{Filled, PartId, Replay};
}
