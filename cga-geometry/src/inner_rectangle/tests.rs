//! Rectangles against random ones, known ones, and turned polygons.

use glam::{DMat2, DVec2};

use super::{InnerRectangle, RectangleSides, largest};
use crate::random::Rng;
use crate::segment::nearest_share;

const AXES: RectangleSides = RectangleSides::Axes;
const EDGES: RectangleSides = RectangleSides::Edges;

struct Polygon {
    points: Vec<DVec2>,
    rings: Vec<Vec<u32>>,
}

impl Polygon {
    fn of(rings: &[&[(f64, f64)]]) -> Self {
        let points: Vec<DVec2> = rings.iter().flat_map(|ring| ring.iter().map(|&p| DVec2::from(p))).collect();
        let mut next = 0u32..;
        let rings = rings.iter().map(|ring| next.by_ref().take(ring.len()).collect()).collect();
        Polygon { points, rings }
    }

    fn mapped(&self, map: impl Fn(DVec2) -> DVec2) -> Self {
        Polygon { points: self.points.iter().map(|p| map(*p)).collect(), rings: self.rings.clone() }
    }

    fn edges(&self) -> impl Iterator<Item = [DVec2; 2]> + '_ {
        let at = |point: u32| self.points[point as usize];
        self.rings
            .iter()
            .flat_map(move |ring| (0..ring.len()).map(move |k| [at(ring[k]), at(ring[(k + 1) % ring.len()])]))
    }

    /// Returns true if a rectangle is inside, except for `slack`.
    fn holds(&self, corners: [DVec2; 4], slack: f64) -> bool {
        let x = (corners[1] - corners[0]).normalize_or(DVec2::X);
        let turn = DMat2::from_cols(x, x.perp()).transpose();
        let (low, high) = (turn * corners[0] + slack, turn * corners[2] - slack);
        if high.cmple(low).any() {
            return true;
        }
        let crossed = self.edges().any(|[a, b]| {
            // The edge clipped to the open rectangle has a length.
            let (a, b) = (turn * a, turn * b);
            let (mut from, mut to) = (0.0f64, 1.0f64);
            for axis in 0..2 {
                let (p, way) = (a[axis], b[axis] - a[axis]);
                if way == 0.0 {
                    if p <= low[axis] || high[axis] <= p {
                        return false;
                    }
                } else {
                    let (s, t) = ((low[axis] - p) / way, (high[axis] - p) / way);
                    from = from.max(s.min(t));
                    to = to.min(s.max(t));
                }
            }
            from < to
        });
        let middle = (corners[0] + corners[2]) * 0.5;
        let winding = self.edges().filter(|[a, b]| {
            (a.y <= middle.y) != (b.y <= middle.y) && middle.x < a.x + (b.x - a.x) * ((middle.y - a.y) / (b.y - a.y))
        });
        !crossed && winding.count() % 2 == 1
    }
}

fn area(found: &InnerRectangle) -> f64 {
    let [a, b, c, _] = found.corners;
    a.distance(b) * b.distance(c)
}

fn found(polygon: &Polygon, sides: RectangleSides) -> InnerRectangle {
    let found = largest(&polygon.points, &polygon.rings, sides).expect("a rectangle");
    let extent = polygon.points.iter().fold(0.0, |most: f64, p| most.max(p.distance(polygon.points[0])));
    assert!(polygon.holds(found.corners, 1e-9 * extent), "{found:?} {:?}", polygon.points);
    found
}

const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
const L: [(f64, f64); 6] = [(0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (5.0, 5.0), (5.0, 10.0), (0.0, 10.0)];

#[test]
fn known_rectangles() {
    for (rings, expected) in [
        (&[&[(0.0, 0.0), (10.0, 0.0), (10.0, 8.0), (0.0, 8.0)][..]][..], 80.0),
        (&[&L[..]], 50.0),
        (&[&[(0.0, 0.0), (10.0, 0.0), (0.0, 10.0)][..]], 25.0),
        // A hole in the middle leaves a strip of 3 at each side.
        (&[&SQUARE[..], &[(3.0, 3.0), (3.0, 7.0), (7.0, 7.0), (7.0, 3.0)]], 30.0),
        // A diamond: half of it.
        (&[&[(0.0, -4.0), (4.0, 0.0), (0.0, 4.0), (-4.0, 0.0)][..]], 16.0),
        // Collinear corners change nothing.
        (&[&[(0.0, 0.0), (4.0, 0.0), (10.0, 0.0), (10.0, 8.0), (5.0, 8.0), (0.0, 8.0), (0.0, 3.0)][..]], 80.0),
    ] {
        let polygon = Polygon::of(rings);
        assert!((area(&found(&polygon, AXES)) - expected).abs() < 1e-9, "{expected}");
    }
    // Along its edges the diamond is the rectangle itself.
    let diamond = Polygon::of(&[&[(0.0, -4.0), (4.0, 0.0), (0.0, 4.0), (-4.0, 0.0)]]);
    assert!((area(&found(&diamond, EDGES)) - 32.0).abs() < 1e-9);
}

#[test]
fn of_equal_rectangles_the_one_nearest_to_the_centre_is_taken() {
    // In a slanted strip the rectangle can slide; the middle of the strip is its centre.
    let strip = Polygon::of(&[&[(0.0, 0.0), (4.0, 0.0), (24.0, 20.0), (20.0, 20.0)]]);
    let rectangle = found(&strip, AXES);
    let middle = (rectangle.corners[0] + rectangle.corners[2]) * 0.5;
    assert!((area(&rectangle) - 4.0).abs() < 1e-9);
    assert!(middle.distance(DVec2::new(12.0, 10.0)) < 1e-6, "{middle}");
    // Three equal wings: the middle one.
    let fork = [
        (0.0, 0.0),
        (10.0, 0.0),
        (10.0, 8.0),
        (8.0, 8.0),
        (8.0, 1.0),
        (6.0, 1.0),
        (6.0, 8.0),
        (4.0, 8.0),
        (4.0, 1.0),
        (2.0, 1.0),
        (2.0, 8.0),
        (0.0, 8.0),
    ];
    for sides in [AXES, EDGES] {
        let rectangle = found(&Polygon::of(&[&fork]), sides);
        assert!((area(&rectangle) - 16.0).abs() < 1e-9);
        assert!(rectangle.corners.iter().all(|at| (at.x - 5.0).abs() - 1.0 < 1e-9), "{rectangle:?}");
    }
}

#[test]
fn short_edges_give_no_directions() {
    // The long edges of this lot are parallel to the axes. A rectangle along the short bevel would not be larger.
    let lot = Polygon::of(&[&[(0.0, 0.0), (10.0, 0.0), (10.0, 9.0), (9.0, 10.0), (0.0, 10.0)]]);
    let rectangle = found(&lot, EDGES);
    assert!(rectangle.along.abs_diff_eq(DVec2::X, 1e-9) || rectangle.along.abs_diff_eq(DVec2::Y, 1e-9));
}

/// A star around the origin, often with a hole.
fn star(rng: &mut Rng, corners: usize) -> Polygon {
    let ring = |rng: &mut Rng, low: f64, high: f64, corners: usize| -> Vec<(f64, f64)> {
        (0..corners)
            .map(|k| {
                let angle = (k as f64 + 0.8 * rng.unit()) / corners as f64 * std::f64::consts::TAU;
                let radius = low + (high - low) * rng.unit();
                (radius * libm::cos(angle), radius * libm::sin(angle))
            })
            .collect()
    };
    let outline = ring(rng, 4.0, 10.0, corners);
    let mut hole = ring(rng, 0.2, 1.0, 3 + corners % 4);
    hole.reverse();
    if rng.unit() < 0.5 { Polygon::of(&[&outline, &hole]) } else { Polygon::of(&[&outline]) }
}

/// A random search: rectangles that grow from random places, and changes of the best one.
fn searched(polygon: &Polygon, along: DVec2, best: [DVec2; 4], rng: &mut Rng) -> f64 {
    let turn = DMat2::from_cols(along, along.perp());
    let back = turn.transpose();
    let corners =
        |low: DVec2, high: DVec2| [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)].map(|p| turn * p);
    let area = |low: DVec2, high: DVec2| (high - low).max(DVec2::ZERO).element_product();
    let (mut low, mut high) = (back * best[0], back * best[2]);
    let own = area(low, high);
    let mut most = own;
    for round in 0..600 {
        let size = 10.0 * libm::exp(-rng.unit() * 16.0);
        let mut change = || DVec2::new(rng.unit() - 0.5, rng.unit() - 0.5) * size;
        let (a, b) = if round % 3 == 0 {
            let (p, q) = (DVec2::ZERO + change() * 2.0, DVec2::ZERO + change() * 2.0);
            (p.min(q), p.max(q))
        } else {
            (low + change(), high + change())
        };
        if most < area(a, b) && polygon.holds(corners(a, b), 0.0) {
            most = area(a, b);
            (low, high) = (a, b);
        }
    }
    most / own - 1.0
}

#[test]
fn no_random_search_finds_a_larger_one() {
    let rng = &mut Rng(5);
    for round in 0..250 {
        let polygon = star(rng, 3 + round % 14);
        for sides in [AXES, EDGES] {
            let rectangle = found(&polygon, sides);
            let gain = searched(&polygon, rectangle.along, rectangle.corners, rng);
            assert!(gain < 1e-7, "{gain} {:?}", polygon.points);
        }
    }
}

#[test]
fn a_turned_polygon_has_the_turned_rectangle() {
    let rng = &mut Rng(9);
    for round in 0..100 {
        let polygon = star(rng, 4 + round % 9);
        let rectangle = found(&polygon, EDGES);
        for (angle, scale, by) in [(0.7, 1.0, 0.0), (2.0, 1e-9, 0.0), (4.0, 1e9, 1e9), (1.0, 1.0, 5e5)] {
            let map = |p: DVec2| DMat2::from_angle(angle) * p * scale + by;
            let turned = found(&polygon.mapped(map), EDGES);
            assert!((area(&turned) / (scale * scale) / area(&rectangle) - 1.0).abs() < 1e-7, "{:?}", polygon.points);
            let middle = |found: &InnerRectangle| (found.corners[0] + found.corners[2]) * 0.5;
            assert!(middle(&turned).distance(map(middle(&rectangle))) < 1e-4 * scale, "{:?}", polygon.points);
        }
    }
}

#[test]
fn a_rectangle_touches_the_outline_on_all_sides() {
    let rng = &mut Rng(21);
    for round in 0..100 {
        let polygon = star(rng, 5 + round % 9);
        let [a, b, c, d] = found(&polygon, AXES).corners;
        for side in [[a, b], [b, c], [c, d], [d, a]] {
            let touches = polygon.edges().any(|edge| {
                let near =
                    |p: DVec2, [from, to]: [DVec2; 2]| from.lerp(to, nearest_share(p, [from, to])).distance(p) < 1e-7;
                side.iter().any(|p| near(*p, edge)) || edge.iter().any(|p| near(*p, side))
            });
            assert!(touches, "{side:?} {:?}", polygon.points);
        }
    }
}

#[test]
fn a_thousand_corners_take_little_time() {
    let rng = &mut Rng(2);
    let round: Vec<(f64, f64)> = (0..1000)
        .map(|k| {
            let angle = k as f64 / 1000.0 * std::f64::consts::TAU;
            (libm::cos(angle), libm::sin(angle))
        })
        .collect();
    // The square in a circle.
    assert!((area(&found(&Polygon::of(&[&round]), AXES)) - 2.0).abs() < 1e-4);
    let comb: Vec<(f64, f64)> = (0..500)
        .flat_map(|k| {
            let x = k as f64;
            [(x, 0.0), (x + 0.5, 10.0 + rng.unit())]
        })
        .chain([(500.0, 40.0), (0.0, 40.0)])
        .collect();
    found(&star(rng, 1000), AXES);
    found(&Polygon::of(&[&comb]), EDGES);
}

#[test]
fn nothing_is_inside_of_nothing() {
    let line = Polygon::of(&[&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]]);
    assert_eq!(largest(&line.points, &line.rings, AXES), None);
    let point = Polygon::of(&[&[(1.0, 1.0), (1.0, 1.0), (1.0, 1.0)]]);
    assert_eq!(largest(&point.points, &point.rings, EDGES), None);
}

/// The limit on work is reached before the sides of a rectangle are known.
#[test]
fn polygons_with_thousands_of_corners_have_rectangles() {
    let count = 1250;
    let wall = |far: bool| {
        (0..count).map(move |i| {
            let tooth = f64::from(i % 2);
            if far { (f64::from(count - 1 - i), 8.0 + tooth) } else { (f64::from(i), tooth) }
        })
    };
    let saw: Vec<(f64, f64)> = wall(false).chain(wall(true)).collect();
    let polygon = Polygon::of(&[&saw]);
    let rectangle = found(&polygon, AXES);
    assert!(polygon.holds(rectangle.corners, 1e-6) && 100.0 < area(&rectangle), "{rectangle:?}");
}
