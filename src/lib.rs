#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]

pub use cga_macros::cga;
pub use cga_runtime::array::Array;
pub use cga_runtime::asset::{AssetError, Assets};
pub use cga_runtime::attribute::{
    Attribute, AttributeDefault, AttributeError, AttributeKind, ChoiceValues, Choices, Range,
};
pub use cga_runtime::derive::Report;
pub use cga_runtime::fault::{Error, Fault, FaultKind, LimitKind};
/// The vector types in meshes and sinks.
pub use cga_runtime::glam;
pub use cga_runtime::grammar::{Grammar, Rules, StartRule};
pub use cga_runtime::material::{Channel, Color, Layer, LayerPart, Material, MaterialNumber, MaterialText};
pub use cga_runtime::mesh::{Mesh, MeshBuilder, MeshError};
pub use cga_runtime::model::{Geometry, LeafView, Model};
pub use cga_runtime::parallel::{Part, Parts, ShapeError, Stretch};
pub use cga_runtime::report::{Collection, Print, Reports, Summary};
pub use cga_runtime::scope::{Axis, Frame, Scope};
pub use cga_runtime::session::{DynSession, Session};
pub use cga_runtime::settings::{Limits, Settings};
pub use cga_runtime::shape::{Shape, ShapeRef};
pub use cga_runtime::sink::{Cuboid, Flow, Leaf, Quad, Sink};
pub use cga_runtime::text::Text;
pub use cga_runtime::value::{Value, ValueType};
pub use cga_runtime::watch::{Progress, Watch};

/// Meshes: building, measuring, checking, reading.
pub mod mesh {
    #[cfg(feature = "obj")]
    pub use cga_runtime::asset::obj::{ObjError, ObjFile, read_obj};
    pub use cga_runtime::mesh::check::Flaw;
    pub use cga_runtime::mesh::{Bounds, FaceRef, FaceTag, Mesh, MeshBuilder, MeshError};
}

/// Where leaves go: the trait and the sinks that come with the crate.
pub mod sink {
    #[cfg(feature = "gltf")]
    pub use cga_runtime::sink::gltf;
    pub use cga_runtime::sink::{Cuboid, Flow, Leaf, Quad, Sink};
    pub use cga_runtime::sink::{buffers, error, obj, picture, stats, svg, table};
}

/// Many initial shapes at once.
pub mod parallel {
    pub use cga_runtime::parallel::{Part, Parts, ShapeError, Stretch, derive_all, generate_all, run_all};
}

/// The split solver on its own: sizes and an extent → pieces.
pub mod split {
    pub use cga_runtime::split::{Item, Piece, Prefix, Size, Solution, solve};
}

/// What generated code uses. No promise is made about it.
#[doc(hidden)]
pub mod __rt {
    pub use cga_runtime::rt::*;
}
