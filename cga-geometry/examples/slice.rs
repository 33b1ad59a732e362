//! Cuts a mesh into ten slabs of one height.
//!
//! ```text
//! cargo run --release -p cga-geometry --example slice -- mesh.obj slabs.obj
//! ```
//!
//! Without files it cuts a body with bumps and writes `slabs.obj`.

mod common;

use std::error::Error;
use std::fs::File;
use std::sync::Arc;

use cga_geometry::{Axis, cut, obj};

fn main() -> Result<(), Box<dyn Error>> {
    let (mesh, path) = common::mesh_and_path("slabs.obj")?;
    let bounds = mesh.bounds();
    let planes: Vec<f64> = (1..10).map(|k| bounds.low.y + bounds.size().y * f64::from(k) / 10.0).collect();
    let slabs = cut::slabs(&Arc::new(mesh), Axis::Y, &planes);
    for (number, part) in slabs.parts.iter().enumerate() {
        match part {
            Some(part) => println!("slab {number}: {} faces, volume {:.4}", part.face_count(), part.volume()),
            None => println!("slab {number}: empty"),
        }
    }
    if !slabs.open.is_empty() {
        println!("{} cuts stay open, because the mesh is open there", slabs.open.len());
    }
    let named = slabs.parts.iter().enumerate().filter_map(|(k, part)| Some((format!("slab {k}"), &**part.as_ref()?)));
    obj::write_objects(named, File::create(&path)?)?;
    println!("wrote {path}");
    Ok(())
}
