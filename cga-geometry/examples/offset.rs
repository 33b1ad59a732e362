//! An outline with a hole, moved inwards and outwards. Writes `offset.obj`.
//!
//! ```text
//! cargo run --release -p cga-geometry --example offset
//! ```

use std::error::Error;
use std::fs::File;

use cga_geometry::glam::{DAffine3, DVec3};
use cga_geometry::mesh::{FaceTag, MeshBuilder};
use cga_geometry::obj;
use cga_geometry::offset::{OffsetFaces, offset};

fn main() -> Result<(), Box<dyn Error>> {
    let mut builder = MeshBuilder::new();
    // On the ground, counter-clockwise as seen from above; the hole runs clockwise.
    let outline =
        [[0.0, 0.0], [20.0, 0.0], [20.0, -12.0], [12.0, -12.0], [12.0, -6.0], [8.0, -6.0], [8.0, -12.0], [0.0, -12.0]];
    let hole = [[2.0, -2.0], [2.0, -4.0], [18.0, -4.0], [18.0, -2.0]];
    let [outline, hole] = [&outline[..], &hole]
        .map(|ring| -> Vec<u32> { ring.iter().map(|&[x, z]| builder.point([x, 0.0, z])).collect() });
    builder.face(&outline, &[&hole], FaceTag::PLAIN);
    let lot = builder.build()?;
    println!("the face: {} m²", lot.area());
    let mut objects = Vec::new();
    for distance in [-0.5, -1.5, 0.5, 1.5] {
        let (inside, refused) = offset(&lot, distance, OffsetFaces::Inside);
        assert!(refused.is_empty(), "{refused:?}");
        println!("moved by {distance:>4} m: {} faces, {:.2} m²", inside.face_count(), inside.area());
        let lifted = DAffine3::from_translation(DVec3::Y * (2.0 - distance));
        objects.push((format!("moved by {distance}"), inside.map(&lifted)));
    }
    objects.push(("lot".to_owned(), lot));
    obj::write_objects(objects.iter().map(|(name, mesh)| (name, mesh)), File::create("offset.obj")?)?;
    println!("wrote offset.obj");
    Ok(())
}
