//! Occluders near a region give the answers of all occluders, for queries in that region.

use glam::{DMat3, DVec3};

use super::motion;
use crate::bounds::Bounds;
use crate::random::Rng;
use crate::relation::{Occluder, Occluders, OrientedBox, QueryGeometry, Relation};

/// A point with whole coordinates.
fn whole(rng: &mut Rng, range: u64) -> DVec3 {
    DVec3::from([(); 3].map(|()| (rng.next() % range) as f64))
}

#[test]
fn near_occluders_give_the_answers_of_all() {
    let mut rng = Rng(41);
    let (mut counts, mut few) = ([0usize; 5], 0);
    for round in 0..12 {
        let [city, other] = [motion(&mut rng, [1e2, 1e5, 1e7][round % 3]), motion(&mut rng, 10.0)];
        // Boxes with the axes of the city, one in six turned, one in seven sheared, so that it is not found to be a box.
        let occluder = |number: usize| {
            let (low, size) = (whole(&mut rng, 40), whole(&mut rng, 5) + 1.0);
            let mut place = city;
            place.translation += city.matrix3 * low;
            place.matrix3 *= DMat3::from_diagonal(size);
            if number.is_multiple_of(6) {
                place.matrix3 = other.matrix3 * place.matrix3;
            } else if number.is_multiple_of(7) {
                place.matrix3.x_axis += place.matrix3.y_axis * 0.2;
            }
            Occluder::cuboid(place)
        };
        let occluders = Occluders::new((0..400).map(occluder).collect::<Vec<_>>());
        for _ in 0..12 {
            let corner = whole(&mut rng, 36);
            let corners = [DVec3::ZERO, DVec3::splat(8.0)].map(|at| city.transform_point3(corner + at));
            let middle = (corners[0] + corners[1]) * 0.5;
            let region = Bounds { low: middle - 10.0, high: middle + 10.0 };
            assert!(occluders.near(&region, 3).is_none());
            let mut near = occluders.near(&region, 400).expect("occluders");
            few += usize::from(near.len() < 200);
            let axes = [city.matrix3, other.matrix3, DMat3::IDENTITY];
            for query in 0..60 {
                // Flat along each axis in turn, twice, and a box that is a segment.
                let mut size = whole(&mut rng, 3) + 1.0;
                if query % 4 < 3 {
                    size[query % 4] = 0.0;
                }
                if query % 29 == 5 {
                    size[1] = 0.0;
                }
                let axes = &axes[usize::from(query % 10 == 8) + usize::from(query % 20 == 8)];
                let at = city.transform_point3(corner + whole(&mut rng, 5));
                let geometry = OrientedBox::new(at, axes, size);
                let reach = occluders.reach(&geometry.around());
                if reach.low.cmplt(region.low).any() || region.high.cmplt(reach.high).any() {
                    continue;
                }
                for wanted in [Relation::ALL, Relation::INSIDE, Relation::OVERLAPS, Relation::TOUCHES] {
                    let accept = |number: u32| number % 5 != 2;
                    let expected = occluders.query(&geometry.to_query(), wanted, &mut |number| accept(number));
                    let found = occluders.query_box_near(&mut near, &geometry, wanted, &mut |number| accept(number));
                    assert_eq!(found, expected, "round {round}: {geometry:?}");
                    let found = occluders.query_near(&near, &geometry.to_query(), wanted, &mut |number| accept(number));
                    assert_eq!(found, expected, "round {round}: {geometry:?}");
                    let Relation { inside, overlaps, touches } = expected;
                    counts[usize::from(inside) + usize::from(overlaps) + usize::from(touches)] += 1;
                }
            }
        }
    }
    assert!(counts[..4].iter().all(|count| 60 < *count) && 80 < few, "{counts:?} {few}");
}

#[test]
fn wrong_boxes_have_no_relation() {
    let occluders = Occluders::new([Occluder::cuboid(glam::DAffine3::from_scale(DVec3::splat(2.0)))]);
    let everywhere = Bounds { low: DVec3::splat(-1e9), high: DVec3::splat(1e9) };
    let mut near = occluders.near(&everywhere, 1).expect("one occluder");
    let numbers = [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e61, 1e300];
    let places = numbers.iter().flat_map(|number| (0..3).map(move |axis| (axis, *number)));
    for (axis, number) in places {
        let mut wrong = DVec3::splat(0.5);
        wrong[axis] = number;
        for (at, size) in [(wrong, DVec3::ONE), (DVec3::splat(0.5), wrong)] {
            let geometry = OrientedBox::new(at, &DMat3::IDENTITY, size);
            let found = occluders.query_box_near(&mut near, &geometry, Relation::ALL, &mut |_| true);
            assert_eq!(found, occluders.query(&geometry.to_query(), Relation::ALL, &mut |_| true), "{geometry:?}");
            assert_eq!(found, Relation::NONE, "{geometry:?}");
        }
    }
    let inner = QueryGeometry::oriented(DVec3::ONE, DMat3::IDENTITY, DVec3::splat(0.5));
    assert_eq!(occluders.query_near(&near, &inner, Relation::ALL, &mut |_| true), Relation::ALL);
}
