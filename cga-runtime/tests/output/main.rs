//! The tests of sinks and of readers: what is written is read back.

#[cfg(feature = "gltf")]
mod gltf_bytes;
#[cfg(feature = "gltf")]
mod gltf_support;
#[cfg(feature = "obj")]
mod obj_bytes;
#[cfg(feature = "obj")]
mod obj_support;
mod sink_buffers;
#[cfg(feature = "gltf")]
mod sink_gltf;
mod sink_meshes;
mod sink_model;
mod sink_obj;
mod sink_picture;
#[cfg(feature = "gltf")]
mod sink_quantized;
mod sink_support;
#[cfg(all(feature = "gltf", feature = "png"))]
mod sink_textures;
mod writers;
