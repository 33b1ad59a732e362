//! Random boxes, rectangles and meshes, compared with brute force. `CGA_RELATIONS=10` plays ten times as many.

use std::collections::BTreeSet;
use std::slice::from_ref;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::{block, bulged, motion};
use crate::boolean::{BooleanOp, combine};
use crate::extrude::{Extrude, extrude};
use crate::mesh::{Mesh, MeshBuilder};
use crate::random::Rng;
use crate::relation::{Occluders, QueryGeometry, Relation};

/// The number of rounds, for a usual number.
fn rounds(usual: usize) -> usize {
    let times = std::env::var("CGA_RELATIONS").ok().and_then(|times| times.parse().ok());
    usual * times.unwrap_or(1usize)
}

fn ask(occluders: &Occluders, geometry: &QueryGeometry<'_>) -> Relation {
    let found = occluders.query(geometry, Relation::ALL, &mut |_| true);
    assert!(found.touches || found == Relation::NONE, "{found:?}");
    found
}

/// A box or a rectangle with whole coordinates.
#[derive(Clone, Copy, Debug)]
struct WholeBox {
    low: [i32; 3],
    high: [i32; 3],
}

impl WholeBox {
    fn random(rng: &mut Rng, range: u64, is_flat: bool) -> Self {
        let low = [(); 3].map(|()| (rng.next() % range) as i32);
        let mut high = low.map(|low| low + 1 + (rng.next() % 4) as i32);
        if is_flat {
            let axis = (rng.next() % 3) as usize;
            high[axis] = low[axis];
        }
        WholeBox { low, high }
    }

    fn mesh(&self, unit: f64) -> Mesh {
        let [low, high] = [self.low, self.high].map(|corner| corner.map(|at| f64::from(at) * unit));
        block(low, high)
    }

    /// The relation to a box, by intervals.
    fn relation(&self, occluder: &WholeBox) -> Relation {
        let common = [0, 1, 2].map(|k| self.high[k].min(occluder.high[k]) - self.low[k].max(occluder.low[k]));
        let is_inside = (0..3).all(|k| occluder.low[k] <= self.low[k] && self.high[k] <= occluder.high[k]);
        let flat = (0..3).find(|k| self.low[*k] == self.high[*k]);
        let (overlaps, contact) = match flat {
            None => (common.iter().all(|part| 0 < *part), {
                let zeros = common.iter().filter(|part| **part == 0).count();
                zeros == 1 && common.iter().all(|part| 0 <= *part)
            }),
            Some(axis) => {
                let has_area = (0..3).all(|k| k == axis || 0 < common[k]);
                let (at, low, high) = (self.low[axis], occluder.low[axis], occluder.high[axis]);
                (has_area && low < at && at < high, has_area && (at == low || at == high))
            }
        };
        Relation::of(is_inside, overlaps, contact)
    }
}

#[test]
fn boxes_and_rectangles_have_the_relations_of_their_intervals() {
    let mut rng = Rng(23);
    let mut counts = [0usize; 8];
    for round in 0..rounds(50) {
        let unit = [1.0, 0.02, 50.0][round % 3];
        let motion = motion(&mut rng, [1e2, 1e4, 1e6][round % 3]);
        let solids: Vec<WholeBox> = (0..40).map(|_| WholeBox::random(&mut rng, 12, false)).collect();
        // One in five as a mesh that is not found to be a box.
        let mesh = |(number, solid): (usize, &WholeBox)| {
            let mesh = solid.mesh(unit);
            (Arc::new(if number % 5 == 0 { bulged(&mesh) } else { mesh }), motion)
        };
        let occluders = Occluders::new(solids.iter().enumerate().map(mesh));
        for number in 0..400 {
            let geometry = WholeBox::random(&mut rng, 12, number % 2 == 0);
            let mesh = geometry.mesh(unit);
            let mesh = if number % 7 == 0 { bulged(&mesh) } else { mesh };
            let expected = solids.iter().fold(Relation::NONE, |sum, solid| sum.or(geometry.relation(solid)));
            let found = ask(&occluders, &QueryGeometry::mesh(&mesh, motion));
            assert_eq!(found, expected, "round {round}, {geometry:?} of {unit} m");
            let Relation { inside, overlaps, touches } = found;
            counts[usize::from(inside) | usize::from(overlaps) << 1 | usize::from(touches) << 2] += 1;
        }
    }
    let seen = [0b000, 0b100, 0b110, 0b101, 0b111];
    assert!(seen.iter().all(|triple| 100 < counts[*triple]), "{counts:?}");
    assert_eq!(seen.iter().map(|triple| counts[*triple]).sum::<usize>(), counts.iter().sum::<usize>());
}

/// The corners of the faces of a mesh.
fn faces(mesh: &Mesh, motion: &DAffine3) -> Vec<Vec<DVec3>> {
    mesh.faces().map(|face| face.outline().map(|point| motion.transform_point3(point)).collect()).collect()
}

/// The part of a convex polygon within the block from (0, 0, 0) to a corner, which grows by a margin on all sides.
fn within(polygon: &[DVec3], size: DVec3, margin: f64) -> Vec<DVec3> {
    let mut inner = polygon.to_vec();
    for axis in 0..3 {
        for (sign, bound) in [(1.0, size[axis] + margin), (-1.0, margin)] {
            let mut next = Vec::new();
            for (number, &b) in inner.iter().enumerate() {
                let a = inner[(number + inner.len() - 1) % inner.len()];
                let [from, to] = [a, b].map(|point| bound - sign * point[axis]);
                if (from < 0.0) != (to < 0.0) {
                    next.push(a + (b - a) * (from / (from - to)));
                }
                if 0.0 <= to {
                    next.push(b);
                }
            }
            inner = next;
        }
    }
    inner
}

#[test]
fn turned_boxes_and_rectangles_have_the_relations_of_their_clipped_faces() {
    const MARGIN: f64 = 0.01;
    let mut rng = Rng(29);
    let mut counts = [0usize; 4];
    for round in 0..rounds(1500) {
        let mut side = || 1.0 + (rng.next() % 40) as f64 / 10.0;
        let [outer, mut inner] = [[side(), side(), side()], [side(), side(), side()]];
        let is_flat = round % 2 == 0;
        if is_flat {
            inner[round / 2 % 3] = 0.0;
        }
        let is_small = round % 3 == 0;
        let inner = inner.map(|side| if is_small { side * 0.2 } else { side });
        let (mut place, world) = (motion(&mut rng, 3.0), motion(&mut rng, 1e4));
        if is_small {
            place.translation = place.translation.abs();
        }
        let [occluder, geometry] = [block([0.0; 3], outer), block([0.0; 3], inner)];
        let inverse = place.inverse();
        // The answers with the occluder grown and shrunk.
        let expected = [MARGIN, -MARGIN].map(|margin| {
            let is_common = |polygon: &Vec<DVec3>| !within(polygon, DVec3::from(outer), margin).is_empty();
            let is_around = |polygon: &Vec<DVec3>| !within(polygon, DVec3::from(inner), margin).is_empty();
            let own = faces(&geometry, &place);
            let is_in = |point: &DVec3| {
                point.cmpge(DVec3::splat(-margin)).all() && point.cmple(DVec3::from(outer) + margin).all()
            };
            let overlaps = own.iter().any(is_common) || !is_flat && faces(&occluder, &inverse).iter().any(is_around);
            (overlaps, own.iter().flatten().all(is_in))
        });
        let occluders = [&occluder, &bulged(&occluder)].map(|mesh| Occluders::new([(Arc::new(mesh.clone()), world)]));
        for occluders in &occluders {
            for mesh in [&geometry, &bulged(&geometry)] {
                let found = ask(occluders, &QueryGeometry::mesh(mesh, world * place));
                let is_decided = expected[0] == expected[1];
                counts[usize::from(is_decided) * (1 + usize::from(found.overlaps) + usize::from(found.inside))] += 1;
                if expected[0].0 == expected[1].0 {
                    assert_eq!(found.overlaps, expected[0].0, "round {round}");
                }
                if expected[0].1 == expected[1].1 {
                    assert_eq!(found.inside, expected[0].1, "round {round}");
                }
                // In random positions nothing is coplanar.
                assert!(!is_decided || found.touches == found.overlaps, "round {round}");
            }
        }
    }
    assert!(counts[0] * 10 < counts.iter().sum() && counts[1..].iter().all(|count| 100 < *count), "{counts:?}");
}

/// Unit cubes, by their low corners.
type Cells = BTreeSet<[i32; 3]>;

/// The neighbours of a cell, and the sides of the cell towards them.
fn neighbours(cell: [i32; 3]) -> [[i32; 3]; 6] {
    let step = |axis: usize, by: i32| {
        let mut next = cell;
        next[axis] += by;
        next
    };
    [step(0, 1), step(0, -1), step(1, 1), step(1, -1), step(2, 1), step(2, -1)]
}

/// The surface of cells, a square for each side of a cell without a neighbour.
fn surface(cells: &Cells) -> Mesh {
    let mut builder = MeshBuilder::new();
    for &cell in cells {
        for (side, next) in neighbours(cell).iter().enumerate() {
            if cells.contains(next) {
                continue;
            }
            let (axis, up) = (side / 2, side % 2 == 0);
            let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
            let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[along, across]| {
                let mut corner = cell;
                corner[axis] += i32::from(up);
                corner[a] += along;
                corner[b] += across;
                builder.point(corner.map(f64::from))
            });
            let [p, q, r, s] = corners;
            builder.polygon(&if up { [p, q, r, s] } else { [s, r, q, p] });
        }
    }
    builder.build().unwrap()
}

/// Cells that grow from one cell.
fn lump(rng: &mut Rng, range: u64) -> (Cells, Mesh) {
    let start = [(); 3].map(|()| (rng.next() % range) as i32);
    let mut cells = Cells::from([start]);
    for _ in 0..rng.next() % 9 {
        let from = *cells.iter().nth(rng.next() as usize % cells.len()).unwrap();
        cells.insert(neighbours(from)[rng.next() as usize % 6]);
    }
    let mesh = surface(&cells);
    (cells, mesh)
}

/// A concave outline of steps, extruded upwards or along another axis.
fn stairs(rng: &mut Rng, range: u64) -> (Cells, Mesh) {
    let corner = [(); 3].map(|()| (rng.next() % range) as i32);
    let depths: Vec<i32> = (0..1 + rng.next() % 4).map(|_| 1 + (rng.next() % 3) as i32).collect();
    let (height, turn) = (1 + (rng.next() % 3) as i32, (rng.next() % 3) as usize);
    let place = |[x, y, z]: [i32; 3]| {
        let mut at = [x, y, z];
        at.rotate_left(turn);
        [0, 1, 2].map(|axis| corner[axis] + at[axis])
    };
    let mut outline = vec![[0, 0, 0], [depths.len() as i32, 0, 0]];
    for (x, depth) in depths.iter().enumerate().rev() {
        outline.extend([[x as i32 + 1, 0, -*depth], [x as i32, 0, -*depth]]);
    }
    let points: Vec<DVec3> = outline.iter().map(|corner| DVec3::from(place(*corner).map(f64::from))).collect();
    // Steps of equal depth have a point twice in a row; a step down has none to spare.
    let mesh = extrude(&Mesh::from_polygon(&points, &[]).unwrap(), Extrude::FaceNormal, f64::from(height));
    let mut cells = Cells::new();
    for (x, depth) in depths.iter().enumerate() {
        for z in 1..=*depth {
            cells.extend((0..height).map(|y| place([x as i32, y, -z])));
        }
    }
    (cells, mesh)
}

/// The relation of solids of cells.
fn relation_of_cells(geometry: &Cells, occluder: &Cells) -> Relation {
    let is_inside = geometry.is_subset(occluder);
    let overlaps = !geometry.is_disjoint(occluder);
    // Sides of cells that are surfaces of both.
    let is_contact = |cell: &[i32; 3]| {
        let mut others = neighbours(*cell).into_iter().filter(|next| !geometry.contains(next));
        let own = occluder.contains(cell);
        others.any(|next| occluder.contains(&next) != own)
    };
    Relation::of(is_inside, overlaps, geometry.iter().any(is_contact))
}

/// The relation of a rectangle to a solid of cells.
fn relation_of_rectangle(rectangle: &WholeBox, occluder: &Cells) -> Relation {
    let WholeBox { low, high } = rectangle;
    let axis = (0..3).find(|axis| low[*axis] == high[*axis]).unwrap();
    let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
    let (mut is_inside, mut overlaps, mut contact) = (true, false, false);
    for at_a in low[a]..high[a] {
        for at_b in low[b]..high[b] {
            let mut cell = *low;
            (cell[a], cell[b]) = (at_a, at_b);
            let ahead = occluder.contains(&cell);
            cell[axis] -= 1;
            let behind = occluder.contains(&cell);
            is_inside &= ahead || behind;
            overlaps |= ahead && behind;
            contact |= ahead != behind;
        }
    }
    Relation::of(is_inside, overlaps, contact)
}

#[test]
fn solids_of_cubes_have_the_relations_of_their_cubes() {
    let mut rng = Rng(31);
    let mut counts = [0usize; 8];
    for round in 0..rounds(400) {
        let make = |rng: &mut Rng| if round % 2 == 0 { lump(rng, 4) } else { stairs(rng, 4) };
        let motion = motion(&mut rng, 1e3);
        let solids: Vec<(Cells, Mesh)> = (0..3).map(|_| make(&mut rng)).collect();
        let occluders = Occluders::new(solids.iter().map(|(_, mesh)| (Arc::new(mesh.clone()), motion)));
        let mut count = |found: Relation| {
            let Relation { inside, overlaps, touches } = found;
            counts[usize::from(inside) | usize::from(overlaps) << 1 | usize::from(touches) << 2] += 1;
        };
        for _ in 0..4 {
            let (cells, mesh) = if rng.next() & 1 == 0 { lump(&mut rng, 4) } else { stairs(&mut rng, 4) };
            for (number, solid) in (0..).zip(&solids) {
                let geometry = QueryGeometry::mesh(&mesh, motion);
                let found = occluders.query(&geometry, Relation::ALL, &mut |other| other == number);
                assert_eq!(found, relation_of_cells(&cells, &solid.0), "round {round}: {cells:?} {:?}", solid.0);
                count(found);
            }
        }
        for _ in 0..8 {
            let rectangle = WholeBox::random(&mut rng, 5, true);
            let mesh = rectangle.mesh(1.0);
            let geometry = QueryGeometry::mesh(&mesh, motion);
            for (number, solid) in (0..).zip(&solids) {
                let found = occluders.query(&geometry, Relation::ALL, &mut |other| other == number);
                assert_eq!(found, relation_of_rectangle(&rectangle, &solid.0), "{rectangle:?} {:?}", solid.0);
                count(found);
            }
        }
    }
    let seen = [0b000, 0b100, 0b110, 0b101, 0b111];
    assert!(seen.iter().all(|triple| 10 < counts[*triple]), "{counts:?}");
    assert_eq!(seen.iter().map(|triple| counts[*triple]).sum::<usize>(), counts.iter().sum::<usize>());
}

/// A prism over a star with some corners, about 2 m wide and high.
fn prism(rng: &mut Rng) -> Mesh {
    let count = 3 + rng.next() % 5;
    let corner = |number: u64| {
        let (sin, cos) = crate::rotation::sin_cos(-360.0 * number as f64 / count as f64);
        let radius = 0.4 + rng.unit();
        DVec3::new(radius * cos, 0.0, radius * sin)
    };
    let outline: Vec<DVec3> = (0..count).map(corner).collect();
    extrude(&Mesh::from_polygon(&outline, &[]).unwrap(), Extrude::FaceNormal, 0.5 + 1.5 * rng.unit())
}

#[test]
fn turned_prisms_have_the_relations_of_their_intersections() {
    let mut rng = Rng(37);
    let mut counts = [0usize; 3];
    for round in 0..rounds(120) {
        let mut occluder = prism(&mut rng);
        if round % 3 == 0 {
            occluder = occluder.map(&DAffine3::from_scale(DVec3::splat(8.0)));
        }
        let mut place = motion(&mut rng, 2.0);
        place.translation.y += 1.0;
        let geometry = prism(&mut rng).map(&place);
        let world = motion(&mut rng, 1e3);
        let common = combine(BooleanOp::Intersect, [from_ref(&geometry), from_ref(&occluder)], 1e-15).unwrap();
        let (volume, all) = (common.volume(), geometry.volume());
        let occluders = Occluders::new([(Arc::new(occluder), world)]);
        let found = ask(&occluders, &QueryGeometry::mesh(&geometry, world));
        // A corner that is inside by a millimetre, or outside, has a volume of this size.
        const MARGIN: f64 = 1e-4;
        if volume == 0.0 || MARGIN < volume {
            assert_eq!(found.overlaps, 0.0 < volume, "round {round}: {volume}");
        }
        if (all - volume).abs() < 1e-9 || MARGIN < all - volume {
            assert_eq!(found.inside, (all - volume).abs() < 1e-9, "round {round}: {volume} of {all}");
        }
        counts[usize::from(found.overlaps) + usize::from(found.inside)] += 1;
    }
    assert!(counts.iter().all(|count| 5 < *count), "{counts:?}");
}

#[test]
fn queries_compare_few_of_many_boxes() {
    for count in [1usize << 8, 1 << 11, 1 << 14] {
        let mut rng = Rng(41);
        let side = (count as f64).sqrt() * 10.0;
        let mut place = |size: f64| {
            let low = DVec3::new(rng.unit() * side, 0.0, rng.unit() * side);
            DAffine3 { matrix3: glam::DMat3::from_diagonal(DVec3::splat(size)), translation: low }
        };
        let places: Vec<DAffine3> = (0..count).map(|_| place(6.0)).collect();
        let occluders = Occluders::new(places.iter().map(|place| crate::relation::Occluder::cuboid(*place)));
        let mut compared = 0;
        for number in 0..1000 {
            let geometry = QueryGeometry::cuboid(place(2.0));
            // All candidates, not only the first one that overlaps.
            let wanted = if number % 2 == 0 { Relation::ALL } else { Relation::INSIDE };
            compared += occluders.query_counted(&geometry, wanted, &mut |_| true).1;
        }
        let (each, levels) = (compared / 1000, count.ilog2() as usize);
        assert!(each <= 5 * levels, "{each} of {count}");
    }
}
