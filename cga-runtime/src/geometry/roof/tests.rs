//! Laws of roofs over polygons of many kinds.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_4;

use super::*;
use crate::geometry::skeleton::tests::polygons::{Cells, Polygon, Rng, holds};

const HIP: RoofForm = RoofForm::Hip { overhang: 0.0, even: false };
const GABLE: RoofForm = RoofForm::Gable { across: 0.0, along: 0.0, even: false, edge: None };

fn built(polygon: &Polygon, form: RoofForm, rise: Rise) -> Result<Roof, String> {
    let outline = Outline { points: &polygon.points, rings: &polygon.rings, x: DVec2::X };
    roof(&outline, form, rise).map_err(|failure| format!("{failure:?}"))
}

fn flat_area(roof: &Roof, ring: &[u32]) -> f64 {
    let at = |i: usize| (roof.points[ring[i] as usize] - roof.points[ring[0] as usize]).truncate();
    (1..ring.len() - 1).map(|i| at(i).perp_dot(at(i + 1)) * 0.5).sum()
}

/// The normal with the area as its length.
fn normal(roof: &Roof, face: &RoofFace) -> DVec3 {
    let from = roof.points[face.rings[0][0] as usize];
    let at = |point: u32| roof.points[point as usize] - from;
    let arcs = face.rings.iter().flat_map(|ring| plan::arcs(ring));
    arcs.map(|[a, b]| at(a).cross(at(b)) * 0.5).sum()
}

/// Checks the laws of a roof without overhang: closed, planar, above the polygon, every place covered once. Returns the
/// largest distance of a corner from the plane of its face.
fn checked(polygon: &Polygon, roof: &Roof, rng: &mut Rng) -> Result<f64, String> {
    let mut net: BTreeMap<[u32; 2], i32> = BTreeMap::new();
    let mut add =
        |a: u32, b: u32, sign: i32| *net.entry([a.min(b), a.max(b)]).or_default() += if a < b { sign } else { -sign };
    let rings = roof.faces.iter().flat_map(|face| &face.rings);
    rings.flat_map(|ring| plan::arcs(ring)).for_each(|[a, b]| add(a, b, 1));
    polygon.rings.iter().flat_map(|ring| plan::arcs(ring)).for_each(|[a, b]| add(a, b, -1));
    if let Some((arc, _)) = net.iter().find(|(_, count)| **count != 0) {
        return Err(format!("open at {arc:?}"));
    }
    let area = |ring: &Vec<u32>| flat_area(roof, ring);
    let whole: f64 = polygon.rings.iter().map(area).sum();
    let extent = whole.sqrt();
    let mut sum = 0.0;
    let mut off = 0.0f64;
    for (number, face) in roof.faces.iter().enumerate() {
        let (normal, own) = (normal(roof, face), face.rings.iter().map(area).sum::<f64>());
        sum += own;
        if own < -1e-9 * whole || (face.part != RoofPart::Top && 1e-9 * whole < own) {
            return Err(format!("face {number} has area {own}"));
        }
        let up = normal.normalize_or_zero();
        let from = roof.points[face.rings[0][0] as usize];
        // The normal of a thin face is not accurate.
        if 1e-6 * whole < normal.length() {
            let by = face.rings.iter().flatten().map(|&p| (roof.points[p as usize] - from).dot(up).abs());
            off = by.fold(off, f64::max);
        }
        if face.rings.iter().flatten().any(|&point| roof.points[point as usize].z < -1e-9 * extent) {
            return Err(format!("face {number} is below"));
        }
    }
    if (sum - whole).abs() > 1e-9 * whole {
        return Err(format!("areas {sum} of {whole}"));
    }
    let flat: Vec<DVec2> = roof.points.iter().map(|point| point.truncate()).collect();
    let low = polygon.points.iter().copied().reduce(DVec2::min).unwrap();
    let high = polygon.points.iter().copied().reduce(DVec2::max).unwrap();
    for _ in 0..20 {
        let p = low + (high - low) * DVec2::new(rng.unit(), rng.unit());
        let inside = |face: &&RoofFace| face.rings.iter().filter(|ring| holds(&flat, ring, p)).count() % 2 == 1;
        let count = roof.faces.iter().filter(|face| face.part == RoofPart::Top).filter(inside).count();
        if polygon.distance(p) > 1e-6 && count != usize::from(polygon.holds(p)) {
            return Err(format!("{p} is covered {count} times"));
        }
    }
    Ok(off / extent)
}

/// Rectilinear outlines, turned, jittered, with holes, and stars.
fn outlines(count: u64) -> impl Iterator<Item = (String, Polygon)> {
    let kinds = [(0.0, 0.0), (0.3, 0.0), (FRAC_PI_4, 0.0), (0.3, 1e-9), (0.3, 1e-6), (0.3, 1e-4), (0.3, 2e-2)];
    (0..count).flat_map(move |seed| {
        let cells = Cells::random(&mut Rng(seed), 3 + (seed % 5) as i32).polygon();
        let cells = (!cells.rings.is_empty()).then_some(cells);
        let turned = cells.into_iter().flat_map(move |cells| {
            kinds.map(|(turn, jitter)| {
                let polygon = cells.turned(turn, 0.0).jittered(jitter, &mut Rng(seed + 7));
                (format!("cells {seed} turned {turn} jittered {jitter}"), polygon)
            })
        });
        let star = Polygon::star(&mut Rng(seed), 3 + (seed % 40) as usize, seed % 3 == 0);
        let round = star.rounded(6.0 + 20.0 * Rng(seed).unit());
        turned.chain([(format!("star {seed}"), star), (format!("round {seed}"), round)])
    })
}

fn complain(failures: &[String], of: usize) {
    assert!(failures.is_empty(), "{} of {of}: {:#?}", failures.len(), &failures[..failures.len().min(8)]);
}

/// The number of seeds; `CGA_ROOFS` sets another one.
fn seeds() -> u64 {
    std::env::var("CGA_ROOFS").ok().and_then(|count| count.parse().ok()).unwrap_or(60)
}

fn law(form: RoofForm, law: impl Fn(&Polygon, &Roof) -> Result<(), String>) {
    let (mut failures, mut count, mut bent, mut worst) = (Vec::new(), 0, 0, (0.0, String::new()));
    for (name, polygon) in outlines(seeds()) {
        count += 1;
        let found = built(&polygon, form, Rise::Slope(0.8)).and_then(|roof| {
            law(&polygon, &roof)?;
            checked(&polygon, &roof, &mut Rng(count as u64))
        });
        match found {
            Ok(off) => {
                bent += usize::from(1e-9 < off);
                if worst.0 < off {
                    worst = (off, name);
                }
            }
            Err(why) => {
                failures.push(format!("{name}: {why}"));
            }
        }
    }
    println!("{count} outlines, {bent} not quite planar, the worst {worst:?}");
    complain(&failures, count);
    // An entangled outline is moved by up to 1e-7 of its extent, so its roof is planar up to that.
    assert!(worst.0 < 2e-7 && bent * 200 <= count, "{bent}, {worst:?}");
}

#[test]
fn hip_roofs_are_closed_planar_and_equally_steep() {
    law(HIP, |polygon, roof| {
        let edges: Vec<[u32; 2]> = polygon.rings.iter().flat_map(|ring| plan::arcs(ring)).collect();
        for face in &roof.faces {
            let normal = normal(roof, face);
            let cosine = 1.0 / libm::sqrt(1.64);
            if 1e-4 < normal.length() && (normal.z / normal.length() - cosine).abs() > 1e-5 {
                return Err(format!("a slope of {}", normal.z / normal.length()));
            }
        }
        // Each face begins with its edge.
        let begins = |(face, edge): (&RoofFace, &[u32; 2])| face.rings[0][..2] == *edge;
        let all = roof.faces.len() == edges.len() && roof.faces.iter().zip(&edges).all(begins);
        if all { Ok(()) } else { Err(format!("{} faces over {} edges", roof.faces.len(), edges.len())) }
    });
}

#[test]
fn gable_roofs_are_closed_and_planar() {
    law(GABLE, |_, _| Ok(()));
}

#[test]
fn pyramids_are_closed_and_planar() {
    let mut count = 0;
    for (name, polygon) in outlines(seeds() / 4) {
        let roof = built(&polygon, RoofForm::Pyramid, Rise::Height(1.0)).unwrap();
        let net: f64 = roof.faces.iter().map(|face| flat_area(&roof, &face.rings[0])).sum();
        let whole: f64 = polygon.rings.iter().map(|ring| flat_area(&roof, ring)).sum();
        assert!((net - whole).abs() < 1e-9 * whole, "{name}");
        count += 1;
    }
    assert!(100 < count);
}

#[test]
fn shed_and_ridge_roofs_are_closed_and_planar() {
    for edge in [0, 3, -1] {
        law(RoofForm::Shed { edge }, |_, _| Ok(()));
    }
    law(RoofForm::Ridge, |_, _| Ok(()));
}

/// Overhangs continue the planes of the roof: faces stay planar and equally steep, and no place is covered twice.
#[test]
fn overhangs_continue_the_roof() {
    for (across, along) in [(0.1, 0.1), (0.3, 0.0), (0.0, 0.2), (2.0, 1.5)] {
        let (mut failures, mut count) = (Vec::new(), 0);
        for (name, polygon) in outlines(seeds() / 2) {
            let hip = RoofForm::Hip { overhang: across, even: false };
            let gable = RoofForm::Gable { across, along, even: false, edge: None };
            for form in [hip, gable] {
                count += 1;
                if let Err(why) = built(&polygon, form, Rise::Slope(0.8)).and_then(|roof| overhanging(&polygon, &roof))
                {
                    failures.push(format!("{name} {form:?}: {why}"));
                }
            }
        }
        complain(&failures, count);
    }
}

fn overhanging(polygon: &Polygon, roof: &Roof) -> Result<(), String> {
    let flat: Vec<DVec2> = roof.points.iter().map(|point| point.truncate()).collect();
    let tops: Vec<&RoofFace> = roof.faces.iter().filter(|face| face.part == RoofPart::Top).collect();
    let extent = polygon.rings.iter().map(|ring| flat_area(roof, ring)).sum::<f64>().sqrt();
    for face in &tops {
        let normal = normal(roof, face);
        if 1e-3 < normal.length() && (normal.z / normal.length() - 1.0 / libm::sqrt(1.64)).abs() > 1e-5 {
            return Err(format!("a slope of {}", normal.z / normal.length()));
        }
        let (from, up) = (roof.points[face.rings[0][0] as usize], normal.normalize_or_zero());
        let off = |&point: &u32| (roof.points[point as usize] - from).dot(up).abs();
        let off = face.rings[0].iter().map(off).fold(0.0, f64::max);
        if 1e-3 < normal.length() && 1e-6 * extent < off {
            return Err(format!("bent by {off}"));
        }
    }
    let low = flat.iter().copied().reduce(DVec2::min).unwrap();
    let high = flat.iter().copied().reduce(DVec2::max).unwrap();
    let rng = &mut Rng(1);
    for _ in 0..40 {
        let p = low + (high - low) * DVec2::new(rng.unit(), rng.unit());
        let count = tops.iter().filter(|face| holds(&flat, &face.rings[0], p)).count();
        if polygon.distance(p) > 1e-6 && (count > 1 || (polygon.holds(p) && count == 0)) {
            return Err(format!("{p} is covered {count} times"));
        }
    }
    Ok(())
}
