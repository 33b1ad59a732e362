//! Numbers of points and divisions that do not exist.

use cga_geometry::glam::{DAffine3, DVec3};
use cga_geometry::primitive;
use cga_geometry::recompose::{Origins, Weld};
use cga_geometry::trace::UNTRACED;

use crate::guards::message_of;

#[test]
fn points_and_divisions_that_do_not_exist_are_named_at_once() {
    let mut origins = Origins::new();
    let [a, b] = [0.0, 1.0].map(|x| origins.point(DVec3::X * x));
    assert!(message_of(|| origins.divide(3)).contains("division 3 of 1"));
    assert!(message_of(|| origins.on_edge([a, 9], 0.5, 0)).contains("point 9 of 2"));
    assert!(message_of(|| origins.on_edge([a, b], 0.5, 4)).contains("division 4 of 1"));
    assert!(message_of(|| origins.moved(7, 0, DVec3::X)).contains("point 7 of 2"));
    assert!(message_of(|| origins.moved(a, 7, DVec3::X)).contains("division 7 of 1"));
    assert!(message_of(|| origins.mark(&[a, 5])).contains("point 5 of 2"));
    assert_eq!(origins.on_edge([a, UNTRACED], 0.5, 0), UNTRACED);
    // After the refusals all is as it was.
    assert_eq!((origins.point_count(), origins.settle()), (2, vec![DVec3::ZERO, DVec3::X]));
    let cube = primitive::cube();
    assert!(message_of(|| Weld::default().add(&origins, cube, &[a, b])).contains("2 numbers for 8 points"));
}

#[test]
fn points_on_edges_count_only_if_they_are_marked() {
    let quad = primitive::quad();
    let mut origins = Origins::new();
    let numbers: Vec<u32> = quad.points().iter().map(|&point| origins.point(point)).collect();
    let division = origins.divide(0);
    // Made after the marks, or without any.
    for is_marked in [false, true] {
        origins.on_edge([numbers[0], numbers[1]], 0.5, division);
        let mut weld = Weld::default();
        weld.add(&origins, quad.clone(), &numbers);
        let places = origins.settle();
        let (made, _) = weld.finish(&places, &DAffine3::IDENTITY);
        assert_eq!((made.corners().len(), made.area()), (4, 1.0), "{is_marked}");
        origins.mark(&numbers);
    }
}
