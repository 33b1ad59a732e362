//! Laws of cutting along lines of constant texture coordinate, on random meshes.

use std::collections::HashMap;
use std::sync::Arc;

use crate::cut_support::*;
use crate::iso_support::*;
use cga_geometry::cut::iso_bands;
use cga_geometry::extrude::{Extrude, extrude};
use cga_geometry::mesh::{Flaw, Mesh, UvAxis};
use cga_geometry::primitive;
use glam::{DVec2, DVec3};

const MOST: usize = 1 << 24;

/// Random meshes of many kinds.
fn samples(rng: &mut Rng) -> Vec<Sample> {
    let (columns, rows) = (1 + rng.below(5), 1 + rng.below(4));
    let flat = grid(columns, rows, false, |i, j| DVec3::new(i as f64, 0.0, -(j as f64)));
    let heights: Vec<f64> = (0..100).map(|_| rng.unit()).collect();
    let bent = |triangles| {
        grid(columns, rows, triangles, |i, j| {
            DVec3::new(i as f64 + 0.4 * heights[i + 7 * j], heights[(i * 5 + j * 3) % 100], -(j as f64))
        })
    };
    let values: Vec<DVec2> = (0..400).map(|_| DVec2::new(number(rng, 4), number(rng, 4))).collect();
    let [a, b, c, d] = [0; 4].map(|_| rng.unit() * 2.0 - 1.0);
    let whole = rng.below(2) == 0;
    let affine = move |_: usize, _: usize, p: DVec3, set: usize| match (set, whole) {
        (0, true) => DVec2::new(p.x, -p.z),
        (0, false) => DVec2::new(a * p.x + b * p.z + c * p.y, b * p.y + d * p.z + 0.25 * p.x),
        _ => DVec2::new(d * p.x - p.z + a, c * p.z + b * p.y),
    };
    let outlines = [
        ring(14, |i| if i % 2 == 0 { 3.0 } else { 1.0 }),
        vec![(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)],
        vec![
            (0.0, 0.0),
            (5.0, 0.0),
            (5.0, 4.0),
            (4.0, 4.0),
            (4.0, 1.0),
            (3.0, 1.0),
            (3.0, 4.0),
            (2.0, 1.0),
            (1.0, 4.0),
            (0.0, 4.0),
        ],
        ring(9, |i| 1.0 + heights[i]),
        square(0.0, 0.0, 4.0),
    ];
    let outline = &outlines[rng.below(outlines.len())];
    let polygon_mesh = Mesh::from_polygon(&polygon(outline), &[]).unwrap();
    let windows: Vec<Vec<DVec3>> =
        (0..9).map(|i| polygon(&square(0.5 + 2.0 * f64::from(i % 3), 1.0 + 2.0 * f64::from(i / 3), 1.0))).collect();
    let plate = Mesh::from_polygon(&polygon(&square(0.0, 0.0, 7.0)), &windows).unwrap();
    let by_point = |p: DVec3| (p.x * 31.0 + p.y * 57.0 - p.z * 17.0).abs() as usize;
    let sample = |name: &str, mesh: Mesh, flags: [bool; 3]| Sample {
        name: name.into(),
        mesh,
        is_seamless: flags[0],
        is_as_triangulated: flags[1],
        is_planar: flags[2],
    };
    let chart_of_face = |face: usize, _: usize, p: DVec3, set: usize| {
        let sign = if face.is_multiple_of(2) { 1.0 } else { -1.0 };
        DVec2::new(sign * p.x + (face * set) as f64, p.y - p.z)
    };
    vec![
        sample("flat grid", charted(&flat, &[0, 3], affine), [true, true, true]),
        sample("mirrored and with seams", charted(&flat, &[0, 3], chart_of_face), [false, true, true]),
        sample(
            "own square of each face",
            charted(&flat, &[0], |_, n, _, _| [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y][n]),
            [false, true, true],
        ),
        sample(
            "wild triangles",
            charted(&bent(true), &[0, 3], |_, _, p, set| values[(by_point(p * 7.0) + set) % 400]),
            [true, true, true],
        ),
        sample(
            "wild triangles with seams",
            charted(&bent(true), &[0, 3], |f, n, _, _| values[(7 * f + n) % 400]),
            [false, true, true],
        ),
        sample("bent quads", charted(&bent(false), &[0, 3], affine), [true, false, false]),
        sample("wild quads", charted(&flat, &[0], |_, _, p, _| values[by_point(p) % 400]), [true, false, true]),
        sample("street", street(&[(0.0, 0.0), (10.0, 1.0), (18.0, 7.0), (30.0, 5.0)], 4.0), [true, false, true]),
        sample("polygon", charted(&polygon_mesh, &[0, 3], affine), [true, true, true]),
        sample(
            "wild polygon",
            charted(&polygon_mesh, &[0, 3], |_, n, _, set| values[(n + set) % 400]),
            [true, false, true],
        ),
        sample("plate with holes", charted(&plate, &[0, 3], affine), [true, true, true]),
        sample(
            "wild plate with holes",
            charted(&plate, &[0, 3], |_, n, _, set| values[(n + set) % 400]),
            [true, true, true],
        ),
        sample("prism", charted(&extrude(&plate, Extrude::FaceNormal, 2.0), &[0, 3], affine), [true, true, true]),
        sample("torus", charted(&torus(12, 7, 2.0, 0.7), &[0], affine), [true, false, false]),
        sample("cube", charted(&primitive::cube(), &[0, 9], affine), [true, true, true]),
    ]
}

fn lines(rng: &mut Rng, low: f64, high: f64) -> Vec<f64> {
    let mut lines: Vec<f64> = match rng.below(4) {
        0 => (-8..=16).map(|i| f64::from(i) * 0.5).collect(),
        1 => vec![low + (high - low) * rng.unit()],
        2 => (0..40).map(|_| low + (high - low) * (1.2 * rng.unit() - 0.1)).collect(),
        _ => (0..4).map(|_| number(rng, 4)).collect(),
    };
    lines.sort_by(f64::total_cmp);
    lines.dedup();
    lines
}

fn range(mesh: &Mesh, axis: UvAxis) -> (f64, f64) {
    let values = mesh.uvs().iter().map(|uv| uv[axis.index()]);
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), value| (l.min(value), h.max(value)))
}

fn area_vector(mesh: &Mesh) -> DVec3 {
    mesh.faces().map(|face| face.normal() * face.area()).sum()
}

/// Cuts, and checks every law of a single cut.
fn check(sample: &Sample, axis: UvAxis, lines: &[f64]) -> Vec<Option<Arc<Mesh>>> {
    let what = format!("{} along {axis:?} at {lines:?}", sample.name);
    let mesh = Arc::new(sample.mesh.clone());
    let bands = iso_bands(&mesh, 0, axis, lines, MOST).unwrap();
    assert_eq!(bands.len(), lines.len() + 1, "{what}");
    let scale = mesh.bounds().size().max_element().powi(2) * 10.0;
    let border = |line: usize| lines.get(line).copied();
    let mut uvs: HashMap<[u64; 3], Vec<u64>> = HashMap::new();
    for (number, band) in bands.iter().enumerate() {
        let low = number.checked_sub(1).and_then(border).unwrap_or(f64::NEG_INFINITY);
        let high = border(number).unwrap_or(f64::INFINITY);
        let area = band.as_ref().map_or(0.0, |band| band.area());
        if sample.is_as_triangulated {
            let expected = area_between(&mesh, 0, axis, low, high);
            assert!((area - expected).abs() <= 1e-12 * scale, "{what}: band {number}: {area} {expected}");
        }
        let Some(band) = band else { continue };
        let flaws: Vec<Flaw> = band.check();
        assert!(
            flaws.iter().all(|flaw| matches!(flaw, Flaw::NotPlanar { .. } if !sample.is_planar)),
            "{what}: {flaws:?}"
        );
        assert!(band.uvs().iter().all(|uv| (low..=high).contains(&uv[axis.index()])), "{what}: band {number}");
        if sample.is_seamless {
            for (corner, &point) in band.corners().iter().enumerate() {
                let bits = [0, 3].iter().flat_map(|&set| band.uv_set(set).get(corner)).flat_map(|uv| uv.to_array());
                let bits: Vec<u64> = bits.map(f64::to_bits).collect();
                let place = band.points()[point as usize].to_array().map(f64::to_bits);
                assert_eq!(uvs.entry(place).or_insert_with(|| bits.clone()), &bits, "{what}: band {number}");
            }
            if mesh.is_closed() {
                let mut net: HashMap<(u32, u32), i32> = HashMap::new();
                for ring in band.faces().flat_map(|face| face.loop_ranges()) {
                    for corner in ring.clone() {
                        let next = if corner + 1 == ring.end { ring.start } else { corner + 1 };
                        let value = |c: usize| band.uvs()[c][axis.index()];
                        if value(corner) == value(next) && (value(corner) == low || value(corner) == high) {
                            continue;
                        }
                        let [a, b] = [corner, next].map(|c| band.corners()[c]);
                        *net.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
                    }
                }
                assert!(net.values().all(|&count| count == 0), "{what}: band {number} comes apart");
            }
        }
    }
    let all = bands.iter().flatten();
    let vector: DVec3 = all.clone().map(|band| area_vector(band)).sum();
    assert!((vector - area_vector(&mesh)).length() <= 1e-12 * scale, "{what}");
    if sample.is_planar {
        let area: f64 = all.map(|band| band.area()).sum();
        assert!((area - mesh.area()).abs() <= 1e-12 * scale, "{what}: {area} of {}", mesh.area());
    }
    bands
}

#[test]
fn pieces_are_what_a_slow_cut_says() {
    let mut rng = Rng(19);
    for _ in 0..60 {
        for sample in samples(&mut rng) {
            for axis in [UvAxis::U, UvAxis::V] {
                let (low, high) = range(&sample.mesh, axis);
                check(&sample, axis, &lines(&mut rng, low, high));
            }
        }
    }
}

#[test]
fn pieces_of_pieces_are_pieces() {
    let mut rng = Rng(5);
    for _ in 0..40 {
        for sample in samples(&mut rng).into_iter().filter(|sample| {
            // Pieces of faces that were cut as triangles may be triangulated differently.
            !["wild quads", "wild polygon", "wild plate with holes"].contains(&&*sample.name)
        }) {
            let (low, high) = range(&sample.mesh, UvAxis::U);
            let all = lines(&mut rng, low, high);
            let some: Vec<f64> = all.iter().copied().filter(|_| rng.below(2) == 0).collect();
            let mesh = Arc::new(sample.mesh);
            let once = iso_bands(&mesh, 0, UvAxis::U, &all, MOST).unwrap();
            let mut twice = vec![None; once.len()];
            for band in iso_bands(&mesh, 0, UvAxis::U, &some, MOST).unwrap().into_iter().flatten() {
                for (part, slot) in iso_bands(&band, 0, UvAxis::U, &all, MOST).unwrap().into_iter().zip(&mut twice) {
                    if part.is_some() {
                        assert!(std::mem::replace(slot, part).is_none(), "{}", sample.name);
                    }
                }
            }
            for (one, two) in once.iter().zip(&twice) {
                let measure = |band: &Option<Arc<Mesh>>| {
                    band.as_ref().map_or((0.0, 0, 0), |band| (band.area(), band.face_count(), band.points().len()))
                };
                let (one, two) = (measure(one), measure(two));
                let what = format!("{} at {all:?}, {some:?} first", sample.name);
                assert!(
                    (one.0 - two.0).abs() <= 1e-12 * (1.0 + one.0) && one.1 == two.1 && one.2 == two.2,
                    "{what}: {one:?} {two:?}"
                );
            }
        }
    }
}
