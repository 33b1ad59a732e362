//! Cases for the cutter from arbitrary bytes, for a fuzzer and its stable equivalent.

use cga_geometry::mesh::{FaceTag, MeshBuilder};

use super::corpus::{Case, Quality};
use super::{cells, prism, ring, together, turned};

/// Reads bytes one by one; zeros after the end.
struct Bytes<'b>(&'b [u8]);

impl Bytes<'_> {
    fn next(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    fn below(&mut self, limit: u8) -> u8 {
        self.next() % limit
    }

    /// A small integer, a half or a quarter of one, or a number very close to one.
    fn number(&mut self) -> f64 {
        let number = f64::from(self.below(9));
        match self.below(8) {
            0 => number + 0.5,
            1 => number + 0.25,
            2 => number + 1e-15,
            3 => number * (1.0 - f64::EPSILON),
            4 => number + f64::from(self.next()) / 256.0,
            _ => number,
        }
    }
}

/// The case encoded in the bytes.
pub fn case(bytes: &[u8]) -> Case {
    let bytes = &mut Bytes(bytes);
    let axis = bytes.below(3) as usize;
    let mut planes: Vec<f64> = (0..bytes.below(6)).map(|_| bytes.number()).collect();
    planes.sort_by(f64::total_cmp);
    planes.dedup();
    let kind = bytes.below(5);
    let (mesh, quality) = match kind {
        0 => {
            let filled: Vec<bool> = (0..27).map(|_| bytes.next() & 1 == 1).collect();
            // Cells that touch at an edge or a corner share no points there.
            (cells(3, |x, y, z| filled[(x * 9 + y * 3 + z) as usize]), Quality::Clean)
        }
        1 => {
            let corners = 3 + usize::from(bytes.below(12));
            let radii: Vec<f64> = (0..corners).map(|_| 1.0 + f64::from(bytes.below(8))).collect();
            // Smaller than the incircle of a triangle of radius 1.
            let court = f64::from(bytes.below(4)) / 8.0;
            let hole: Vec<(f64, f64)> = ring(4, |_| court).into_iter().rev().collect();
            let holes = if court == 0.0 { vec![] } else { vec![hole] };
            (prism(&ring(corners, |at| radii[at]), &holes, 1.0 + f64::from(bytes.below(4))), Quality::Simple)
        }
        _ => {
            let mut builder = MeshBuilder::new();
            let points = 4 + bytes.below(12);
            for _ in 0..points {
                builder.point([bytes.number(), bytes.number(), bytes.number()]);
            }
            let most = if kind == 2 { 1 } else { 4 };
            for _ in 0..1 + bytes.below(16) {
                let corners: Vec<u32> = (0..3 + bytes.below(most)).map(|_| u32::from(bytes.below(points))).collect();
                let hole: Vec<u32> = (0..3).map(|_| u32::from(bytes.below(points))).collect();
                let holes: &[&[u32]] = if kind != 2 && bytes.below(6) == 0 { &[&hole] } else { &[] };
                builder.face(&corners, holes, FaceTag::PLAIN);
            }
            let mesh = builder.build().expect("finite numbers");
            // All faces twice, the second time reversed: always closed.
            let mesh = if kind == 4 { mesh } else { together(&[mesh.clone(), mesh.reversed()]) };
            (mesh, if kind == 2 { Quality::Simple } else { Quality::Any })
        }
    };
    if bytes.below(8) == 0 {
        // Rounding may make touching faces cross.
        let quality = if quality == Quality::Any { quality } else { Quality::Simple };
        return Case::of("turned", quality, &turned(&mesh), axis, &planes);
    }
    Case::of(["cells", "prism", "triangles", "soup", "open soup"][kind as usize], quality, &mesh, axis, &planes)
}
