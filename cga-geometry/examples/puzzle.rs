//! A mesh in 3 x 3 x 3 closed parts, moved apart.
//!
//! ```text
//! cargo run --release -p cga-geometry --example puzzle -- mesh.obj puzzle.obj
//! ```
//!
//! Without files it divides a body with bumps and writes `puzzle.obj`.

pub(crate) mod common;

use std::error::Error;
use std::fs::File;
use std::sync::Arc;

use cga_geometry::glam::{DAffine3, DVec3};
use cga_geometry::mesh::Mesh;
use cga_geometry::{Axis, cut, obj};

fn main() -> Result<(), Box<dyn Error>> {
    let (mesh, path) = common::mesh_and_path("puzzle.obj")?;
    let mesh = Arc::new(mesh);
    let parts = puzzle(&mesh);
    let volume: f64 = parts.iter().map(|(_, part)| part.volume()).sum();
    let closed = parts.iter().filter(|(_, part)| part.is_closed()).count();
    println!("{} parts, {closed} of them closed; volume {volume:.6} of {:.6}", parts.len(), mesh.volume());
    let moved = moved_apart(&mesh, &parts);
    obj::write_objects(moved.iter().map(|(name, part)| (name, part)), File::create(&path)?)?;
    println!("wrote {path}");
    Ok(())
}

/// The parts with names, a quarter of a cell between them.
pub(crate) fn moved_apart(mesh: &Mesh, parts: &[([usize; 3], Arc<Mesh>)]) -> Vec<(String, Mesh)> {
    let gap = mesh.bounds().size() / 12.0;
    let moved = |([x, y, z], part): &([usize; 3], Arc<Mesh>)| {
        let away = gap * DVec3::new(*x as f64, *y as f64, *z as f64);
        (format!("part {x}{y}{z}"), part.map(&DAffine3::from_translation(away)))
    };
    parts.iter().map(moved).collect()
}

/// The parts of a mesh in the 27 cells of its bounding box, with their numbers along x, y and z. Empty cells have none.
pub(crate) fn puzzle(mesh: &Arc<Mesh>) -> Vec<([usize; 3], Arc<Mesh>)> {
    let bounds = mesh.bounds();
    let mut parts = vec![([0; 3], mesh.clone())];
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        let along = axis.index();
        let planes = [1.0, 2.0].map(|third| bounds.low[along] + bounds.size()[along] * third / 3.0);
        let mut divided = Vec::new();
        for (cell, part) in parts {
            for (number, slab) in cut::slabs(&part, axis, &planes).parts.into_iter().enumerate() {
                let mut cell = cell;
                cell[along] = number;
                divided.extend(slab.map(|slab| (cell, slab)));
            }
        }
        parts = divided;
    }
    parts
}
