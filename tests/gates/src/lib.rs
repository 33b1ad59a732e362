//! Gates for scenes: each finds one kind of error that a viewer of a model sees. Tests run them over every scene, example and
//! picture of the repository.
//!
//! A [`Survey`] has the triangles of a model. A [`Look`] is the model from one side, as numbers of triangles. Each gate has a file and
//! gives [`Finding`]s.
//!
//! The package is optimized in all builds, because it draws the scenes from twelve sides.
#![forbid(unsafe_code)]
#![allow(missing_docs, reason = "the package is not published")]

mod back_faces;
mod cracks;
mod fights;
mod finding;
mod glb;
mod holes;
mod inside_out;
mod look;
mod nested;
mod raster;
mod survey;

pub use back_faces::back_faces;
pub use cracks::Triangles;
pub use fights::fights;
pub use finding::{Finding, report};
pub use glb::{GlbFile, GlbSurvey, number};
pub use holes::holes;
pub use inside_out::inside_out;
pub use look::{Look, looks};
pub use nested::nested;
pub use survey::{Part, Survey, Triangle};
