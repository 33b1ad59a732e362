//! A house with a courtyard and a hip roof. Writes `roof.obj`.
//!
//! ```text
//! cargo run --release -p cga-geometry --example roof
//! ```

use std::error::Error;
use std::fs::File;

use cga_geometry::extrude::{Extrude, extrude};
use cga_geometry::glam::{DAffine3, DVec3};
use cga_geometry::mesh::{FaceTag, MeshBuilder};
use cga_geometry::obj;
use cga_geometry::roof::{Rise, RoofForm, roof_over};
use cga_geometry::rotation::sin_cos;

fn main() -> Result<(), Box<dyn Error>> {
    let mut builder = MeshBuilder::new();
    let outline = [[0.0, 0.0], [24.0, 0.0], [24.0, -18.0], [10.0, -18.0], [10.0, -14.0], [0.0, -14.0]];
    let courtyard = [[7.0, -5.0], [7.0, -10.0], [17.0, -10.0], [17.0, -5.0]];
    let [outline, courtyard] = [&outline[..], &courtyard]
        .map(|ring| -> Vec<u32> { ring.iter().map(|&[x, z]| builder.point([x, 0.0, z])).collect() });
    builder.face(&outline, &[&courtyard], FaceTag::PLAIN);
    let lot = builder.build()?;
    let walls = extrude(&lot, Extrude::FaceNormal, 6.0);
    let eaves = lot.map(&DAffine3::from_translation(DVec3::Y * 6.0));
    let (sin, cos) = sin_cos(35.0);
    let roofs = roof_over(&eaves, RoofForm::Hip { overhang: 0.6, even: false }, Rise::Slope(sin / cos));
    assert!(roofs.refused.is_empty(), "{:?}", roofs.refused);
    let height = roofs.mesh.bounds().high.y - 6.0;
    println!("walls of {:.0} m³, a roof of {} faces, {height:.2} m high", walls.volume(), roofs.mesh.face_count());
    obj::write_objects([("walls", &walls), ("roof", &roofs.mesh)], File::create("roof.obj")?)?;
    println!("wrote roof.obj");
    Ok(())
}
