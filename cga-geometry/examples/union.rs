//! Three pipes as one solid, and a block without them. Writes `union.obj`.
//!
//! ```text
//! cargo run --release -p cga-geometry --example union
//! ```

use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::fs::File;

use cga_geometry::boolean::{BooleanOp, combine};
use cga_geometry::glam::{DAffine3, DVec3};
use cga_geometry::mesh::Mesh;
use cga_geometry::{obj, primitive};

fn main() -> Result<(), Box<dyn Error>> {
    // A cylinder of length 4 and diameter 1 with its middle at the origin, along y, then turned to x and to z.
    let centred = DAffine3::from_scale(DVec3::new(1.0, 4.0, 1.0)) * DAffine3::from_translation(DVec3::splat(-0.5));
    let pipe = primitive::cylinder(32).map(&centred);
    let pipes: [Mesh; 3] = [
        pipe.clone(),
        pipe.map(&DAffine3::from_rotation_z(FRAC_PI_2)),
        pipe.map(&DAffine3::from_rotation_x(FRAC_PI_2)),
    ];
    // The largest rounding error of coordinates of this size.
    let rounding = 2.0 * f64::EPSILON;
    let cross = combine(BooleanOp::Unify, [&pipes, &[]], rounding).map_err(|error| format!("{error:?}"))?;
    let block = primitive::cube()
        .map(&(DAffine3::from_scale(DVec3::splat(2.0)) * DAffine3::from_translation(DVec3::splat(-0.5))));
    let drilled = combine(BooleanOp::Subtract, [&[block], &pipes], rounding).map_err(|error| format!("{error:?}"))?;
    for (name, solid) in [("the pipes", &cross), ("the block without them", &drilled)] {
        let (faces, volume) = (solid.face_count(), solid.volume());
        println!("{name}: {faces} faces, volume {volume:.4}, closed: {}", solid.is_closed());
    }
    let aside = drilled.map(&DAffine3::from_translation(DVec3::X * 5.0));
    obj::write_objects([("pipes", &cross), ("block", &aside)], File::create("union.obj")?)?;
    println!("wrote union.obj");
    Ok(())
}
