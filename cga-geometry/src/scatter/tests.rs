use glam::DVec3;

use super::{Bell, Domain, ScatteredPoint};
use crate::mesh::{FaceTag, Mesh, MeshBuilder};
use crate::primitive::{PrimitiveKind, cube};
use crate::random::Rng;

fn draw(domain: Domain) -> Vec<ScatteredPoint> {
    let mut seed = Rng(7);
    domain.draw(move || seed.unit()).collect()
}

/// The sum of the squared deviations of counts from what is expected, each relative to that.
fn chi_square(
    points: &[ScatteredPoint],
    cells: usize,
    cell: impl Fn(DVec3) -> usize,
    share: impl Fn(usize) -> f64,
) -> f64 {
    let mut counts = vec![0.0; cells];
    points.iter().for_each(|point| counts[cell(point.position)] += 1.0);
    let expected = |cell: usize| share(cell) * points.len() as f64;
    counts.iter().enumerate().map(|(cell, count)| (count - expected(cell)).powi(2) / expected(cell)).sum()
}

/// A bound that a sum with that many degrees of freedom exceeds once in 10,000 seeds; the seed is fixed.
fn bound(freedom: usize) -> f64 {
    let k = freedom as f64;
    k + 4.0 * (2.0 * k).sqrt() + 10.0
}

/// A floor of 4 by 3 with a hole of 2 by 1 in the middle, and a wall of 4 by 2.
fn floor_and_wall() -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut corners = |list: &[[f64; 3]]| list.iter().map(|at| builder.point(*at)).collect::<Vec<u32>>();
    let floor = corners(&[[0.0, 0.0, 3.0], [4.0, 0.0, 3.0], [4.0, 0.0, 0.0], [0.0, 0.0, 0.0]]);
    let hole = corners(&[[1.0, 0.0, 1.0], [3.0, 0.0, 1.0], [3.0, 0.0, 2.0], [1.0, 0.0, 2.0]]);
    let wall = corners(&[[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 2.0, 0.0], [0.0, 2.0, 0.0]]);
    builder.face(&floor, &[&hole], FaceTag::PLAIN);
    builder.face(&wall, &[], FaceTag::PLAIN);
    builder.build().expect("two faces")
}

#[test]
fn points_on_a_surface_are_even_by_area() {
    let points = draw(Domain::surface(&floor_and_wall(), Bell::EVEN, 18_000));
    // Squares of 1 by 1: 12 on the floor without 2 in the hole, and 8 on the wall.
    let square = |at: DVec3| match at.y == 0.0 {
        true => (at.x as usize).min(3) + 4 * (at.z as usize).min(2),
        false => 12 + (at.x as usize).min(3) + 4 * (at.y as usize).min(1),
    };
    let is_hole = |square: usize| square == 5 || square == 6;
    assert!(points.iter().all(|point| !is_hole(square(point.position))));
    let index = |at: DVec3| square(at) - [0, 2][usize::from(6 < square(at))];
    let sum = chi_square(&points, 18, index, |_| 1.0 / 18.0);
    assert!(sum < bound(17), "{sum}");
    let normal = |point: &ScatteredPoint| if point.position.y == 0.0 { DVec3::Y } else { DVec3::Z };
    assert!(points.iter().all(|point| (point.normal - normal(point)).length() < 1e-12));
}

/// Cells of solids and surfaces with equal sides have equal weights, and the last bits of coordinates say nothing about them.
#[test]
fn rounding_moves_no_point_far() {
    let bell = Bell { mean: DVec3::splat(0.5), deviation: DVec3::splat(0.2) };
    for mesh in [cube(), PrimitiveKind::Cone { sides: 8 }.mesh(), PrimitiveKind::Cylinder { sides: 8 }.mesh()] {
        let mut random = Rng(3);
        let mut noise = || 1.0 + (random.unit() - 0.5) * 1e-15;
        let moved = mesh.points().iter().map(|at| *at * DVec3::new(noise(), noise(), noise())).collect();
        let moved = mesh.with_points(moved);
        for (name, domain) in
            [("volume", Domain::volume as fn(&Mesh, Bell, u64) -> Domain), ("surface", Domain::surface)]
        {
            for bell in [bell, Bell::EVEN] {
                let [points, others] = [&mesh, &moved].map(|mesh| draw(domain(mesh, bell, 500)));
                assert_eq!(points.len(), others.len());
                let far = points.iter().zip(&others).map(|(a, b)| (a.position - b.position).length());
                assert!(far.fold(0.0, f64::max) < 1e-12, "{bell:?}, {name} of {} faces", mesh.face_count());
            }
        }
    }
}

#[test]
fn points_in_a_volume_are_even() {
    // A cone in the unit box: the share below a height h is 1 − (1 − h)³.
    let cone = PrimitiveKind::Cone { sides: 32 }.mesh();
    let many = draw(Domain::volume(&cone, Bell::EVEN, 20_000));
    // Few points have fewer cells.
    let few = (0..400).flat_map(|number| {
        let mut seed = Rng(number);
        Domain::volume(&cone, Bell::EVEN, 20).draw(move || seed.unit()).collect::<Vec<_>>()
    });
    for points in [many, few.collect()] {
        is_even_in_the_cone(&points);
    }
}

fn is_even_in_the_cone(points: &[ScatteredPoint]) {
    assert!(points.len() == 20_000 || points.len() == 8000);
    let below = |step: usize| 1.0 - (1.0 - step as f64 / 8.0).powi(3);
    let sum = chi_square(points, 8, |at| (at.y * 8.0) as usize, |cell| below(cell + 1) - below(cell));
    assert!(sum < bound(7), "{sum}");
    // Even around the axis.
    let sector =
        |at: DVec3| (libm::atan2(at.z - 0.5, at.x - 0.5) / std::f64::consts::TAU * 16.0).rem_euclid(16.0) as usize;
    let sum = chi_square(points, 16, |at| sector(at).min(15), |_| 1.0 / 16.0);
    assert!(sum < bound(15), "{sum}");
}

#[test]
fn points_of_a_bell_are_normal() {
    // The shares of a standard normal distribution between −∞, −1.5, −1, −0.5, 0, … .
    let shares = [0.066_807, 0.091_848, 0.149_882, 0.191_462, 0.191_462, 0.149_882, 0.091_848, 0.066_807];
    let bell = Bell { mean: DVec3::new(3.0, -1.0, 2.0), deviation: DVec3::new(0.5, 2.0, 0.01) };
    let domain = Domain::cuboid(DVec3::splat(-30.0), DVec3::splat(30.0), bell, 20_000);
    let points = draw(domain);
    for axis in 0..3 {
        let cell = |at: DVec3| {
            let place = (at[axis] - bell.mean[axis]) / bell.deviation[axis];
            ((place + 2.0) * 2.0).clamp(0.0, 7.0) as usize
        };
        let sum = chi_square(&points, 8, cell, |cell| shares[cell]);
        assert!(sum < bound(7), "{axis}: {sum}");
    }
}

#[test]
fn a_bell_beside_a_surface_is_cut_off() {
    let bell = Bell { mean: DVec3::new(0.0, 0.0, 1.5), deviation: DVec3::splat(0.4) };
    let points = draw(Domain::surface(&floor_and_wall(), bell, 4000));
    assert_eq!(points.len(), 4000);
    // Half of the bell is left of the floor. The mean of the other half is 0.8 deviations away.
    let mean = points.iter().map(|point| point.position.x).sum::<f64>() / 4000.0;
    assert!((mean - 0.32).abs() < 0.02, "{mean}");
    // Far away, points gather at the nearest place.
    let bell = Bell { mean: DVec3::new(500.0, 0.0, 500.0), deviation: DVec3::splat(0.1) };
    let points = draw(Domain::surface(&floor_and_wall(), bell, 100));
    assert!(points.len() == 100 && points.iter().all(|point| 3.9 < point.position.x && 2.9 < point.position.z));
}

#[test]
fn thin_and_slanted_solids_are_filled() {
    // A plate of 0.001 from one corner of a box to the other.
    let across = DVec3::new(1.0, -1.0, 0.0).normalize() * 0.001;
    let mut builder = MeshBuilder::new();
    let quad = [DVec3::ZERO, DVec3::Z, DVec3::ONE, DVec3::new(1.0, 1.0, 0.0)];
    let all = quad.iter().copied().chain(quad.iter().map(|point| *point + across));
    let corners: Vec<u32> = all.map(|point| builder.point(point.to_array())).collect();
    for face in [[0, 1, 2, 3], [7, 6, 5, 4], [1, 0, 4, 5], [2, 1, 5, 6], [3, 2, 6, 7], [0, 3, 7, 4]] {
        builder.face(&face.map(|corner: usize| corners[corner]), &[], FaceTag::PLAIN);
    }
    let plate = builder.build().expect("a plate");
    assert!(plate.is_closed());
    let points = draw(Domain::volume(&plate, Bell::EVEN, 2000));
    assert_eq!(points.len(), 2000);
    assert!(points.iter().all(|point| (0.0..=0.001).contains(&(point.position - DVec3::ZERO).dot(across.normalize()))));
}

#[test]
fn solids_are_divided_only_where_that_saves_time() {
    let cells = |mesh: &Mesh, count| Domain::volume(mesh, Bell::EVEN, count).cells.len();
    assert_eq!([1, 100_000].map(|count| cells(&cube(), count)), [1, 1]);
    // A cone misses two of three points: two misses for each point that is kept, and a halving for four misses.
    let cone = PrimitiveKind::Cone { sides: 256 }.mesh();
    let expected = |count: f64| count * (12.0 / std::f64::consts::PI - 1.0) / 4.0;
    for count in [10, 40, 160] {
        let cells = cells(&cone, count) as f64;
        assert!(cells <= expected(count as f64) + 2.0, "{cells} for {count}");
        // Halves outside of the solid are left out.
        assert!(expected(count as f64) * 0.4 <= cells, "{cells} for {count}");
    }
    // A solid over itself, as often as fills its box and more: the volume says nothing.
    let again = |mesh: &Mesh, times| {
        let mut builder = MeshBuilder::new();
        for _ in 0..times {
            let all: Vec<u32> = mesh.points().iter().map(|point| builder.point(point.to_array())).collect();
            for face in mesh.faces() {
                builder.polygon(&face.outer().iter().map(|&point| all[point as usize]).collect::<Vec<_>>());
            }
        }
        builder.build().expect("solids")
    };
    let many = again(&PrimitiveKind::Cone { sides: 8 }.mesh(), 5);
    assert!(1.0 < many.volume() && 100 < cells(&many, 100));
    assert_eq!(draw(Domain::volume(&many, Bell::EVEN, 100)).len(), 100);
}

#[test]
fn a_domain_without_extent_has_one_place_or_none() {
    assert!(draw(Domain::surface(&Mesh::default(), Bell::EVEN, 10)).is_empty());
    assert!(draw(Domain::volume(&Mesh::default(), Bell::EVEN, 10)).is_empty());
    let points = draw(Domain::cuboid(DVec3::ONE, DVec3::ONE, Bell::EVEN, 10));
    assert!(points.len() == 10 && points.iter().all(|point| point.position == DVec3::ONE));
}

/// Counts in slabs along each axis follow their volumes, for solids whose triangulations have edges through the middles of boxes.
#[test]
fn points_are_even_in_solids_of_many_forms() {
    use std::sync::Arc;

    use glam::{DAffine3, DMat3};

    use crate::Axis;
    use crate::cut::slabs;
    use crate::extrude::{Extrude, extrude};

    const SLABS: usize = 10;
    let cube = PrimitiveKind::Cylinder { sides: 4 }.mesh();
    let grown = |outline: &[[f64; 2]], hole: &[[f64; 2]]| {
        let ring = |ring: &[[f64; 2]]| ring.iter().map(|[x, z]| DVec3::new(*x, 0.0, *z)).collect::<Vec<_>>();
        let holes: Vec<Vec<DVec3>> = Some(ring(hole)).into_iter().filter(|hole| !hole.is_empty()).collect();
        extrude(&Mesh::from_polygon(&ring(outline), &holes).expect("a polygon"), Extrude::FaceNormal, 4.0)
    };
    let square = [[0.0, 0.0], [10.0, 0.0], [10.0, -10.0], [0.0, -10.0]];
    let solids = [
        ("cube", grown(&square, &[]).map(&DAffine3::from_scale(DVec3::new(1.0, 2.5, 1.0)))),
        ("turned cube", cube.map(&DAffine3::from_mat3(DMat3::from_euler(glam::EulerRot::XYZ, 0.3, 0.7, 1.1) * 10.0))),
        ("prism", grown(&[[0.0, 0.0], [10.0, 0.0], [5.0, -8.0]], &[])),
        ("L", grown(&[[0.0, 0.0], [10.0, 0.0], [10.0, -5.0], [5.0, -5.0], [5.0, -10.0], [0.0, -10.0]], &[])),
        ("ring", grown(&square, &[[3.0, -3.0], [3.0, -7.0], [7.0, -7.0], [7.0, -3.0]])),
        ("cylinder", PrimitiveKind::Cylinder { sides: 32 }.mesh()),
    ];
    for (name, mesh) in solids {
        assert!(mesh.is_closed() && 0.0 < mesh.volume(), "{name}");
        let points = draw(Domain::volume(&mesh, Bell::EVEN, 6000));
        assert_eq!(points.len(), 6000, "{name}");
        let (bounds, whole) = (mesh.bounds(), mesh.volume());
        let mesh = Arc::new(mesh);
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let (low, size) = (bounds.low[axis.index()], bounds.size()[axis.index()]);
            let offsets: Vec<f64> = (1..SLABS).map(|i| low + size * i as f64 / SLABS as f64).collect();
            let parts = slabs(&mesh, axis, &offsets).parts;
            let shares: Vec<f64> =
                parts.iter().map(|part| part.as_ref().map_or(0.0, |part| part.volume()) / whole).collect();
            let cell = |at: DVec3| (((at[axis.index()] - low) / size * SLABS as f64) as usize).min(SLABS - 1);
            let sum = chi_square(&points, SLABS, cell, |cell| shares[cell]);
            assert!(sum < bound(SLABS - 1), "{name} {axis:?}: {sum}");
        }
        // The middle, which a diagonal of each box leads through.
        let middle = bounds.low + bounds.size() * 0.5;
        if name == "cube" {
            let near = points.iter().filter(|point| point.position.distance(middle) < 2.0).count();
            let expected = 6000.0 * 4.0 / 3.0 * std::f64::consts::PI * 8.0 / 1000.0;
            assert!((near as f64 - expected).abs() < 4.0 * expected.sqrt(), "{near} of {expected}");
        }
    }
}

#[test]
fn rounding_of_corners_on_an_edge_does_not_move_points() {
    let [a, b, c] = [DVec3::new(0.313, 2.0, 0.7), DVec3::new(1.0, 0.0, 0.3), DVec3::new(-0.5, 1.0, -0.7)];
    let outline = [a, a.lerp(b, 0.613), b, c, c.lerp(a, 0.2717), c.lerp(a, 0.713)];
    let mut random = Rng(5);
    let mut points = |noise: f64| {
        let mut nudge = || DVec3::new(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5) * noise;
        let corners: Vec<DVec3> = outline.iter().map(|&corner| corner + nudge()).collect();
        draw(Domain::surface(&Mesh::from_polygon(&corners, &[]).unwrap(), Bell::EVEN, 20))
    };
    let expected = points(0.0);
    for _ in 0..100 {
        let is_near = |(a, b): (&ScatteredPoint, &ScatteredPoint)| a.position.distance(b.position) < 1e-9;
        assert!(points(1e-15).iter().zip(&expected).all(is_near));
    }
}
