//! Polygon meshes with holes, and operations on them: cuts with caps, boolean operations, offsets, straight skeletons, roofs.
//!
//! ```
//! use std::sync::Arc;
//! use cga_geometry::{Axis, cut, obj, primitive};
//!
//! let sphere = Arc::new(primitive::sphere(24, 12));
//! let slabs = cut::slabs(&sphere, Axis::Y, &[0.25, 0.5, 0.75]);
//! let parts: Vec<_> = slabs.parts.iter().flatten().collect();
//! assert!(parts.len() == 4 && parts.iter().all(|part| part.is_closed()));
//! let volume: f64 = parts.iter().map(|part| part.volume()).sum();
//! assert!((volume - sphere.volume()).abs() < 1e-12);
//! let mut text = Vec::new();
//! obj::write_objects(parts.iter().map(|part| ("slab", &***part)), &mut text)?;
//! # Ok::<(), std::io::Error>(())
//! ```
//!
//! A [`Mesh`](mesh::Mesh) has points and faces over them. A face is a planar polygon with holes, counter-clockwise as seen from
//! outside. It may have a group, a material, tags, texture coordinates in ten sets and normals; all operations keep or derive them.
//! Meshes are made by a [`MeshBuilder`](mesh::MeshBuilder), which checks them, by [`primitive`] or from [`obj`] text. Faces should be planar:
//! [`planar_faces`](unbent::planar_faces) makes them so.
//!
//! | | modules |
//! |---|---|
//! | meshes | [`mesh`], [`primitive`], [`obj`], [`solid`], [`wire`] |
//! | solids | [`cut`], [`boolean`], [`extrude`](mod@extrude), [`extrude_wire`](mod@extrude_wire), [`roof`], [`envelope`], [`relation`] |
//! | faces | [`offset`](mod@offset), [`inner_rectangle`], [`convexify`](mod@convexify), [`holes`], [`footprint`](mod@footprint), [`triangulate`], [`unbent`] |
//! | surfaces | [`cleanup`](mod@cleanup), [`reduce`](mod@reduce), [`rectify`](mod@rectify), [`conform`](mod@conform), [`scatter`], [`along_uv`], [`extract`](mod@extract) |
//! | the plane | [`skeleton`], [`overlay`], [`nesting`], [`hull`](mod@hull), [`segment`] |
//! | predicates | [`exact`], [`tol`] |
//! | operations of your own | [`derive`](mod@derive), [`origin`], [`trace`], [`recompose`], [`work`] |
//! | values | [`Axis`], [`Frame`], [`face_frame`], [`rotation`], [`uv_map`], [`provenance`] |
//! | lists | [`buckets`], [`disjoint`], [`each`], [`small_sort`] |
//!
//! Conventions: right-handed coordinates with y up, metres, f64. Angles are in degrees where a name says so, and ratios elsewhere.
//!
//! # Promises
//!
//! - **Closed stays closed.** Volumes and areas of parts add up, for concave, nested and touching input with planar faces.
//! - **Bad input is safe.** Degenerate, tangled and huge meshes cause no panic and do not block an operation. The operation returns an
//!   error, lists the faces that it left unchanged, or gives the result that its page describes. A section *Panics* lists the mistakes
//!   of a program that panic. Operations that may take much time or memory have limits; cuts have a limit on request
//!   ([`slabs_within`](cut::slabs_within)).
//! - **The same bits everywhere.** Results do not depend on the platform, on threads or on hashing.
//! - **No value is lost.** Texture coordinates, normals, groups, materials and tags follow from the origins of points and faces
//!   ([`derive`](mod@derive)). An operation that forgets an origin does not compile.
//! - **No unsafe code.** The crates it needs are `glam` and `libm`.
#![forbid(unsafe_code)]

pub use glam;

pub mod along_uv;
mod average_normal;
pub mod boolean;
pub(crate) mod bounds;
pub mod bounds_tree;
pub mod buckets;
pub mod cleanup;
pub mod conform;
pub mod convexify;
pub mod cut;
pub mod derive;
pub mod disjoint;
pub mod each;
pub mod envelope;
pub mod exact;
pub mod extract;
pub mod extrude;
pub mod extrude_wire;
pub mod face_frame;
pub mod footprint;
pub(crate) mod frame;
pub mod holes;
pub mod hull;
pub mod inner_rectangle;
pub mod level_face;
pub mod long_sort;
pub mod mesh;
pub mod nesting;
pub mod obj;
pub mod offset;
pub mod origin;
pub mod overlay;
pub mod primitive;
pub mod provenance;
#[cfg(test)]
pub(crate) mod random;
pub mod recompose;
pub mod rectify;
pub mod reduce;
pub mod relation;
pub mod roof;
pub mod rotation;
pub mod scatter;
pub mod segment;
pub mod skeleton;
pub mod small_sort;
pub(crate) mod soften;
pub mod solid;
mod status;
pub mod tol;
pub mod trace;
pub mod triangulate;
pub mod unbent;
pub(crate) mod upward_ray;
pub mod uv_map;
pub(crate) mod vector;
pub mod wire;
pub mod work;

pub use frame::{Axis, Frame};

/// The code of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
