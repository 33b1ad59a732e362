use cga_split::{Item, Size};

use super::*;
use crate::op::face::setback::tests::random_lot;
use crate::op::face::swept_edges::tests::{holed, lots, polygon, random};
use crate::shape::Shape;

/// A pattern, with the depth of each written section.
struct Pattern {
    items: Vec<Item>,
    sizes: Vec<Size>,
    depths: Vec<f64>,
}

fn once(sections: &[(Size, f64)]) -> Pattern {
    let (sizes, depths): (Vec<Size>, Vec<f64>) = sections.iter().copied().unzip();
    Pattern { items: vec![Item::Slot; sizes.len()], sizes, depths }
}

fn repeated(sections: &[(Size, f64)]) -> Pattern {
    let mut pattern = once(sections);
    pattern.items.insert(0, Item::Repeat(sections.len() as u32));
    pattern
}

fn metres(length: f64) -> Size {
    Size::absolute(length)
}

/// The faces of each section and of the rest, and the number of faults. Depths grow with the index of the section by `step`.
fn made(
    shape: &Shape,
    pattern: &Pattern,
    step: f64,
    divide: impl FnOnce(&mut Env, &mut Sections<'_>) -> ControlFlow<(), Faces>,
) -> (Faces, usize) {
    let (env, mut sizes) = (&mut Env::for_tests(), pattern.sizes.clone());
    let mut depth = |_: &mut Env, slot: u32, shape: &mut Shape| {
        pattern.depths[slot as usize] + step * f64::from(shape.split.index())
    };
    let mut sections = Sections::new(shape, (&pattern.items, &mut sizes), &mut depth);
    let ControlFlow::Continue(made) = divide(env, &mut sections) else { panic!("no limit is reached") };
    assert_eq!((made.mesh.check(), made.arms.len()), (vec![], made.mesh.face_count()));
    (made, env.take_faults().0.len())
}

/// The area of each section and, last, of the rest.
fn areas(made: &Faces, count: usize) -> Vec<f64> {
    let of = |arm: usize| made.mesh.faces().zip(&made.arms).filter(move |part| *part.1 == Some(arm as u32));
    let sum = |arm: usize| of(arm).map(|(face, _)| face.area()).sum::<f64>();
    (0..=count).map(|arm| (sum(arm) * 1e9).round() / 1e9).collect()
}

fn around(shape: &Shape, offset: Length, pattern: &Pattern, count: usize) -> Vec<f64> {
    let (made, faults) = made(shape, pattern, 0.0, |env, sections| perimeter(env, sections, offset));
    assert_eq!(faults, 0);
    let areas = areas(&made, count);
    let (sum, all) = (areas.iter().sum::<f64>(), shape.to_mesh().area());
    assert!((sum - all).abs() < 1e-6 * all.max(1.0), "{areas:?}, {all}");
    areas
}

fn lot() -> Shape {
    polygon(&[[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]])
}

/// Metres from the start.
const fn from(metres: f64) -> Length {
    Length::Absolute(metres)
}

#[test]
fn a_repeat_fits_around_the_outline() {
    // Four sections of 9 along 36: the second one begins one metre before the corner.
    let pattern = repeated(&[(Size::floating(9.0), 1.0)]);
    let areas = around(&lot(), from(0.0), &pattern, 4);
    // Earlier ones keep the squares at the corners.
    assert_eq!(areas, [9.0, 8.0, 8.0, 7.0, 48.0]);
}

#[test]
fn the_offset_moves_the_start() {
    let pattern = once(&[(metres(4.0), 2.0)]);
    let x = |offset: Length| {
        let (made, _) = made(&lot(), &pattern, 0.0, |env, sections| perimeter(env, sections, offset));
        let face = made.mesh.faces().zip(&made.arms).find(|part| *part.1 == Some(0)).expect("a section").0;
        let all: Vec<f64> = face.outline().map(|at| (at.x * 1e9).round() / 1e9).collect();
        (face.area(), all.iter().copied().fold(f64::INFINITY, f64::min), all.iter().copied().fold(0.0, f64::max))
    };
    assert_eq!(x(from(0.0)), (8.0, 0.0, 4.0));
    assert_eq!(x(from(3.0)), (8.0, 3.0, 7.0));
    // A twelfth of 36 metres; once around more and less.
    assert_eq!(x(Length::Relative(1.0 / 12.0)), (8.0, 3.0, 7.0));
    assert_eq!((x(from(39.0)), x(from(-33.0))), ((8.0, 3.0, 7.0), (8.0, 3.0, 7.0)));
    // Two metres before the start: on the left edge and on the front.
    let (area, low, high) = x(from(-2.0));
    assert_eq!((area, low, high), (4.0, 0.0, 2.0));
}

/// Three edges of a square, deeper than it: both ends are too short, and as long as each other.
#[test]
fn rounding_does_not_choose_the_end_that_stays() {
    let pattern = repeated(&[(metres(2.317), 0.5171)]);
    let first_corner = |rounding: f64| {
        let shape = polygon(&[[0.0, 0.0], [0.31, 0.0], [0.31, 0.31 + rounding], [0.0, 0.31 - rounding]]);
        let mask = Array::from_iter([true, true, false, true]);
        let (made, _) = made(&shape, &pattern, 0.0, |env, sections| perimeter_of(env, sections, from(0.0), 3.0, mask));
        let corner = made.mesh.face(0).outline().next().expect("a corner");
        (corner * 1e9).round()
    };
    let exact = first_corner(0.0);
    assert_eq!((first_corner(1e-16), first_corner(-1e-16)), (exact, exact));
}

/// A share, and gaps that take what is left.
#[test]
fn relative_and_floating_lengths() {
    let sections = [
        (Size::relative(0.5), 1.0),
        (Size::floating(1.0), 0.0),
        (Size::relative(0.4), 1.0),
        (Size::floating(1.0), 0.0),
    ];
    // 18, 1.8, 14.4 and 1.8 metres.
    let areas = around(&lot(), Length::Relative(0.1), &once(&sections), 4);
    assert_eq!((areas[1], areas[3]), (0.0, 0.0));
    // From 3.6 along the front and the right to the back, and then the left to the front.
    let shallow = 6.4 + 8.0 + 3.6 - 1.0 - 1.0;
    assert!((areas[0] - shallow).abs() < 1e-6, "{areas:?}");
    // From 23.4 along the back and the left to 1.8 along the front.
    let last = 4.6 + 8.0 + 1.8 - 1.0 - 1.0;
    assert!((areas[2] - last).abs() < 1e-6, "{areas:?}");
}

#[test]
fn sections_end_at_right_angles_and_have_mitres() {
    let triangle = polygon(&[[0.0, 0.0], [12.0, 0.0], [0.0, 9.0]]);
    // Five metres on both sides of the second corner.
    let areas = around(&triangle, from(7.0), &once(&[(metres(10.0), 1.0)]), 1);
    // Two strips of 5 x 1 without the overlap at the corner: a kite of two right triangles with half the angle.
    let half = libm::atan2(9.0, 12.0) / 2.0;
    assert!((areas[0] - (10.0 - 1.0 / libm::tan(half))).abs() < 1e-6, "{areas:?}");
}

#[test]
fn the_deeper_section_keeps_an_overlap() {
    // Three metres of the front from the corner, and three metres of the right edge.
    let sections = |a: f64, b: f64| [(metres(3.0), a), (metres(3.0), b)];
    assert_eq!(around(&lot(), from(7.0), &once(&sections(4.0, 2.0)), 2), [12.0, 0.0, 68.0]);
    assert_eq!(around(&lot(), from(7.0), &once(&sections(2.0, 4.0)), 2), [0.0, 12.0, 68.0]);
    // As deep: the first one.
    assert_eq!(around(&lot(), from(7.0), &once(&sections(2.0, 2.0)), 2), [6.0, 2.0, 72.0]);
}

/// The union of the strips of its parts, as in the picture *Setback distances*: the section that ends soon after the upper right corner
/// keeps its whole strip beside the right edge.
#[test]
fn a_section_that_ends_soon_after_a_corner_is_whole() {
    let square = polygon(&[[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]]);
    let area = |offset: f64, length: f64| around(&square, from(offset), &once(&[(metres(length), 10.0)]), 1)[0];
    let lengths = [10.0, 20.0, 22.0, 25.0, 28.0, 30.0, 35.0, 40.0, 45.0, 50.0, 60.0, 80.0];
    let expected = [100.0, 200.0, 200.0, 200.0, 200.0, 200.0, 250.0, 300.0, 300.0, 300.0, 400.0, 400.0];
    assert_eq!(lengths.map(|length| area(0.0, length)), expected);
    // Before the corner, where the section begins.
    assert_eq!([1.0, 5.0, 10.0].map(|before| area(20.0 - before, 20.0 + before)), [200.0; 3]);
    // Both ends are short: the longer strip covers the shorter one.
    assert_eq!([[1.0, 6.0], [6.0, 1.0], [6.0, 6.0]].map(|[a, b]| area(20.0 - a, a + b)), [60.0; 3]);
}

/// Right, acute, obtuse and reflex corners, and holes, with strips that do not meet across the lot. The parts add up to the lot.
#[test]
fn longer_sections_are_never_smaller() {
    let [wide, inner] = [[0.0, 30.0], [10.0, 20.0]].map(|[a, b]| [[a, a], [b, a], [b, b], [a, b]]);
    let hexagon = |k: usize| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / 6.0);
        [12.0 * cos, 12.0 * sin]
    };
    let shapes = [
        polygon(&wide),
        holed(&wide, &[&inner]),
        polygon(&[[0.0, 0.0], [20.0, 0.0], [20.0, 12.0], [9.0, 12.0], [9.0, 20.0], [0.0, 20.0]]),
        polygon(&[[0.0, 0.0], [20.0, 0.0], [8.0, 14.0]]),
        polygon(&[[0.0, 0.0], [30.0, 0.0], [3.0, 9.0]]),
        polygon(&(0..6).map(hexagon).collect::<Vec<_>>()),
        polygon(&[[0.0, 0.0], [20.0, 0.0], [26.0, 9.0], [14.0, 22.0], [10.0, 12.0], [-4.0, 15.0]]),
        polygon(&[
            [0.0, 0.0],
            [9.0, 0.0],
            [9.0, 9.0],
            [16.0, 9.0],
            [16.0, 0.0],
            [25.0, 0.0],
            [25.0, 20.0],
            [0.0, 20.0],
        ]),
    ];
    for (number, shape) in shapes.iter().enumerate() {
        let mesh = shape.to_mesh();
        let all: f64 = mesh
            .faces()
            .map(|face| face.edges().map(|[a, b]| face.position(a).distance(face.position(b))).sum::<f64>())
            .sum();
        for depth in [0.5, 1.0, 3.0, 4.5] {
            for offset in [0.0, 3.0, 14.0] {
                let area = |step: u32| {
                    let length = f64::from(step) * all / 64.0;
                    around(shape, from(offset), &once(&[(metres(length), depth)]), 1)[0]
                };
                let areas: Vec<f64> = (1..=64).map(area).collect();
                let fall = areas.windows(2).find(|pair| pair[1] < pair[0] - 1e-6);
                assert_eq!(fall, None, "{number} {depth} {offset} {areas:?}");
            }
        }
    }
}

#[test]
fn a_depth_of_nothing_makes_nothing() {
    let pattern = repeated(&[(Size::floating(9.0), 0.0)]);
    let (made, faults) = made(&lot(), &pattern, 1.0, |env, sections| perimeter(env, sections, from(0.0)));
    let areas = areas(&made, 4);
    // The depth is the index of the section.
    assert_eq!((areas[0], faults), (0.0, 0));
    assert!(areas[1..].iter().all(|area| 0.0 < *area), "{areas:?}");
    for depth in [0.0, -3.0] {
        assert_eq!(around(&lot(), from(0.0), &once(&[(metres(5.0), depth)]), 1), [0.0, 80.0]);
    }
}

#[test]
fn a_mask_selects_edges() {
    let along = |offset: f64, first: f64, mask: &[bool], pattern: &Pattern| {
        let mask = Array::from(mask.to_vec());
        let (made, faults) =
            made(&lot(), pattern, 0.0, |env, sections| perimeter_of(env, sections, from(offset), first, mask));
        assert_eq!(faults, 0);
        areas(&made, pattern.sizes.len())
    };
    // 70 percent of the left edge and the front, in their middle: 12.6 of 18 metres, 5.3 and 7.3.
    let sections = [(Size::floating(1.0), 0.0), (Size::relative(0.7), 1.0), (Size::floating(1.0), 0.0)];
    let centred = along(0.0, 3.0, &[true, false, false, true], &once(&sections));
    assert!((centred[1] - 11.6).abs() < 1e-6, "{centred:?}");
    // The front alone; missing elements are not selected, and further ones count for nothing.
    let half = once(&[(Size::relative(0.5), 2.0)]);
    for mask in [&[true][..], &[true, false, false, false, true, true]] {
        for first in [0.0, 1.0, 4.0, -4.0, 3.0] {
            assert_eq!(along(0.0, first, mask, &half), [10.0, 70.0], "{mask:?} {first}");
        }
    }
    // Front and back as one chain: from the middle of one to the middle of the other.
    assert_eq!(along(5.0, 0.0, &[true, false, true], &half), [20.0, 60.0]);
    // No edge gives no section, so the rest is the first arm.
    assert_eq!(along(5.0, 0.0, &[], &half), [80.0, 0.0]);
}

#[test]
fn numbers_that_make_no_sense_leave_faults() {
    let faults = |pattern: &Pattern, offset: Length, first: f64| {
        let mask = Array::from(vec![true; 4]);
        made(&lot(), pattern, 0.0, |env, sections| perimeter_of(env, sections, offset, first, mask)).1
    };
    let pattern = once(&[(metres(4.0), 2.0)]);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(faults(&pattern, from(bad), 0.0), 1);
        assert_eq!(faults(&pattern, Length::Relative(bad), 0.0), 1);
        assert_eq!(faults(&pattern, from(0.0), bad), 1);
        assert_eq!(faults(&once(&[(metres(bad), 2.0)]), from(0.0), 0.0), 1);
        assert_eq!(faults(&once(&[(metres(4.0), bad)]), from(0.0), 0.0), 1);
    }
    for huge in [1e300, -1e300] {
        assert_eq!(faults(&pattern, from(huge), huge), 0);
    }
    // Too many sections.
    assert_eq!(faults(&repeated(&[(metres(1e-3), 1.0)]), from(0.0), 0.0), 1);
    for shape in [Shape::point([0.0; 3]), Shape::rectangle(0.0, 5.0), Shape::mesh(Mesh::default())] {
        let (made, _) = made(&shape, &pattern, 0.0, |env, sections| perimeter(env, sections, from(0.0)));
        assert!(made.arms.iter().all(|arm| *arm == Some(0) || *arm == Some(1)), "{made:?}");
    }
}

#[test]
fn a_section_may_cover_several_edges_and_all() {
    for shape in lots() {
        let all = shape.to_mesh().area();
        let areas = around(&shape, from(1.0), &once(&[(Size::relative(1.0), 1e3)]), 1);
        assert!((areas[0] - all).abs() < 1e-6, "{areas:?} {all}");
    }
}

/// Sections that overlap, around a lot and a lot with many concave corners.
#[test]
fn many_sections_end() {
    let teeth = |k: usize| [[k as f64, 4.0], [k as f64 + 0.5, 2.0]];
    let saw: Vec<[f64; 2]> = (0..100).flat_map(teeth).chain([[100.0, 4.0], [100.0, 40.0], [0.0, 40.0]]).collect();
    for shape in [lot(), polygon(&saw)] {
        let pattern = repeated(&[(Size::relative(0.01), 0.5), (Size::relative(0.01), 1.0)]);
        let (made, faults) = made(&shape, &pattern, 0.01, |env, sections| perimeter(env, sections, from(0.3)));
        let (sum, all) = (made.mesh.area(), shape.to_mesh().area());
        assert!((sum - all).abs() < 1e-9 * all && faults == 0, "{sum} {all} {faults}");
    }
}

#[test]
fn areas_of_random_faces_add_up() {
    let state = &mut 23;
    for number in 0..150 {
        let shape = random_lot(number, state);
        let each = |state: &mut u64| (Size::floating(2.0 + 20.0 * random(state)), 6.0 * random(state) - 1.0);
        let sections: Vec<(Size, f64)> = (0..1 + number % 7).map(|_| each(state)).collect();
        let pattern = if number % 2 == 0 { once(&sections) } else { repeated(&sections) };
        let offset = from(100.0 * random(state) - 50.0);
        let (made, faults) = made(&shape, &pattern, 0.0, |env, sections| perimeter(env, sections, offset));
        let (sum, all) = (made.mesh.area(), shape.to_mesh().area());
        assert!((sum - all).abs() < 1e-9 * all && faults == 0, "{number}: {sum} {all} {faults}");
    }
}
