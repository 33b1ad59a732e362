//! Cuts by texture coordinates of every mesh that a builder accepts: no panics, and no surface with edges is lost.

use std::sync::Arc;

use crate::cut_support::Rng;
use crate::iso_support::number;
use cga_geometry::along_uv::{AlongUv, HeightAlignment, HeightDirection, insert_along_uv};
use cga_geometry::cut::iso_bands;
use cga_geometry::mesh::{FaceTag, MeshBuilder, UvAxis};
use cga_geometry::primitive;
use glam::{DVec2, DVec3};

#[test]
fn soups_of_polygons_are_cut() {
    let mut rng = Rng(77);
    for round in 0..6000 {
        let mut builder = MeshBuilder::new();
        let points = 4 + rng.below(12);
        let flat = rng.below(2) == 0;
        for _ in 0..points {
            let y = if flat { 0.0 } else { number(&mut rng, 3) };
            builder.point([number(&mut rng, 4), y, number(&mut rng, 4)]);
        }
        for _ in 0..1 + rng.below(6) {
            let corners: Vec<u32> = (0..3 + rng.below(7)).map(|_| rng.below(points) as u32).collect();
            let hole: Vec<u32> = (0..3 + rng.below(2)).map(|_| rng.below(points) as u32).collect();
            let holes: &[&[u32]] = if rng.below(4) == 0 { &[&hole] } else { &[] };
            builder.face(&corners, holes, FaceTag::PLAIN);
            let count = corners.len() + if holes.is_empty() { 0 } else { hole.len() };
            let uvs: Vec<DVec2> = (0..count).map(|_| DVec2::new(number(&mut rng, 3), number(&mut rng, 3))).collect();
            builder.uvs(&uvs).uv_set(4, &uvs);
        }
        let mesh = Arc::new(builder.build().unwrap());
        let mut lines: Vec<f64> = (0..rng.below(6)).map(|_| number(&mut rng, 3)).collect();
        lines.sort_by(f64::total_cmp);
        lines.dedup();
        for axis in [UvAxis::U, UvAxis::V] {
            let bands = iso_bands(&mesh, 0, axis, &lines, 1 << 20).unwrap();
            let mut vector = DVec3::ZERO;
            for (number, band) in bands.iter().enumerate().filter_map(|(i, band)| Some((i, band.as_ref()?))) {
                let low = if number == 0 { f64::NEG_INFINITY } else { lines[number - 1] };
                let high = lines.get(number).copied().unwrap_or(f64::INFINITY);
                for flaw in band.check() {
                    use cga_geometry::mesh::Flaw::{Hole, NotPlanar};
                    assert!(matches!(flaw, NotPlanar { .. } | Hole { .. }), "{round}: {flaw}");
                }
                assert!(band.uvs().iter().all(|uv| (low..=high).contains(&uv[axis.index()])), "{round}");
                assert_eq!(band.uvs(), band.uv_set(4));
                vector += band.faces().map(|face| face.normal() * face.area()).sum::<DVec3>();
            }
            let whole: DVec3 = mesh.faces().map(|face| face.normal() * face.area()).sum();
            assert!((vector - whole).length() < 1e-9, "{round}: {vector} of {whole} at {lines:?}");
        }
        assert!(mesh.uv_extent(0, DVec3::ONE).is_none_or(|extent| extent.metres.is_finite()));
        let options = AlongUv {
            set: 0,
            height: number(&mut rng, 2) - 1.0,
            direction: [HeightDirection::ScopeY, HeightDirection::VertexNormal][rng.below(2)],
            alignment: HeightAlignment::AlignPosition,
            rounding: 1e-15 * rng.below(2) as f64,
        };
        if round % 8 == 0 {
            let made = insert_along_uv(&mesh, &primitive::sphere(5, 4), &options, 1 << 20).unwrap();
            assert!(made.points().iter().all(|point| point.is_finite()));
        }
    }
}
