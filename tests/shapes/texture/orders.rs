//! Operations that keep faces and operations on texture coordinates, in all orders and on all ways out.

use cga::glam::DVec2;
use cga::mesh::read_gltf;
use cga::sink::buffers::Buffers;
use cga::{MeshBuilder, Settings, Shape, cga};
use rayon::prelude::*;

use crate::collect::Leaves;

cga! {
    /// Three steps. A step is a number below `KEEPS + CHANGES`.
    grammar Steps;
    attr start = 0
    attr first = 0
    attr second = 0
    attr third = 0

    Lot -->
        case start == 0 : extrude(3) setupProjection(0, world.xy, 2, 3, 0.25, -1) projectUV(0) Step(0)
        case start == 1 : extrude(3) primitiveCube() Step(0)
        case start == 2 : extrude(3) setupProjection(0, scope.xy, 1, ~1) comp(f) { all = projectUV(0) Step(0) }
        case start == 4 : extrude(3) setupProjection(0, world.xy, 2, 3, 0.25, -1) projectUV(0) split(y) { 1 : NIL | ~1 : Step(0) }
        case start == 5 : extrude(3) primitiveCube() split(x) { 1 : NIL | ~1 : Step(0) | 0.5 : Step(0) }
        else : Step(0)

    step(n) = case n == 0 : first case n == 1 : second else : third

    Step(n) -->
        case n == 3 :
            report("uMin", geometry.uMin(0)) report("uMax", geometry.uMax(0))
            report("vMin", geometry.vMin(0)) report("vMax", geometry.vMax(0))
            X.
        case step(n) < 41 : Keep(step(n), n + 1)
        else : Change(step(n) - 41, n + 1)

    Keep(k, n) -->
        case k == 0 : convexify() Step(n)
        case k == 1 : comp(f) { all = Step(n) }
        case k == 2 : comp(f) { all : Step(n) }
        case k == 3 : comp(f, noAlign) { front : Step(n) | all = Step(n) }
        case k == 4 : offset(-0.1, inside) Step(n)
        case k == 5 : setback(0.1) { all : NIL | remainder = Step(n) }
        case k == 6 : cleanupGeometry(all, 0) Step(n)
        case k == 7 : mirror(true, false, false) Step(n)
        case k == 8 : modify(f, noAlign) { top : t(0, 0, 0.5) Y. } Step(n)
        case k == 9 : inline(append) { Y. } Step(n)
        case k == 10 : subtract { Y. | s(^0.5, ^2, ^0.5) Y. } Step(n)
        case k == 11 : setPivot(yzx, 2) Step(n)
        case k == 12 : mirrorScope(true, false, true) Step(n)
        case k == 13 : alignScopeToAxes(world.y) Step(n)
        case k == 14 : rotateScope(10, 20, 30) Step(n)
        case k == 15 : reverseNormals() Step(n)
        case k == 16 : setNormals(soft) tag("t") deleteHoles() split(x) { ~1 : Step(n) }
        case k == 17 : extrude(0.5) Step(n)
        case k == 18 : comp(f) { front : extrude(0.5) Step(n) | all = Step(n) }
        case k == 19 : comp(f) { all : taper(0.5) Step(n) }
        case k == 20 : t(1, 2, 3) r(0, 30, 0) s(^2, ^1, ^0.5) center(xz) Step(n)
        case k == 21 : comp(f) { all : split(x) { ~1 : Step(n) | 0.5 : Step(n) } }
        case k == 22 : shapeL(1, 1) { shape = Step(n) | remainder : NIL }
        case k == 23 : innerRectangle(edge) { shape = Step(n) | remainder : NIL }
        case k == 24 : roofHip(30) Step(n)
        case k == 25 : roofGable(30, 0.5, 0.5) Step(n)
        case k == 26 : comp(f) { all : roofShed(20) trim() Step(n) }
        case k == 27 : reduceGeometry(0.2) Step(n)
        case k == 28 : union { Y. | t(0.5, 1, 0.5) Y. } Step(n)
        case k == 29 : intersect { Y. | s(^1, ^0.5, ^1) Y. } Step(n)
        case k == 30 : inline(unify) { Y. } Step(n)
        case k == 31 : inline(recompose) { comp(f) { all : Y. } } Step(n)
        case k == 32 : rectify(5) Step(n)
        case k == 33 : setbackPerEdge(0.1) { all : NIL | remainder = Step(n) }
        case k == 34 : splitAndSetbackPerimeter(0) { ~1 : 0.2 : NIL }* { remainder = Step(n) }
        case k == 35 : comp(f) { all : splitArea(x) { 2 : Step(n) | ~1 : NIL } }
        case k == 36 : taper(0.5) Step(n)
        case k == 37 : alignScopeToGeometry(yUp, 0, 0) Step(n)
        case k == 38 : comp(f) { side : setback(0.1) { all : Step(n) | remainder : Step(n) } | all = Step(n) }
        case k == 39 : envelope(world.up, 5, 2, 60, 1, 45, 3, 50) Step(n)
        else : offset(0.1, all) Step(n)

    Change(k, n) -->
        case k == 0 : translateUV(0, 0.25, -0.5) Step(n)
        case k == 1 : scaleUV(0, 2, -3) Step(n)
        case k == 2 : rotateUV(0, 30) Step(n)
        case k == 3 : copyUV(0, 1) scaleUV(1, 2, 2) Step(n)
        case k == 4 : copyUV(0, 1) scaleUV(1, 2, 2) copyUV(1, 0) Step(n)
        else : copyUV(0, 2) deleteUV(1) Step(n)
}

/// The number of starts, and of operations of each kind, in the grammar.
const STARTS: u32 = 6;
const KEEPS: u32 = 41;
const CHANGES: u32 = 6;

/// A lot with the form of an L.
fn lot() -> Shape {
    let outline = [[0.0, 0.0], [6.0, 0.0], [6.0, 2.0], [2.5, 2.0], [2.5, 5.0], [0.0, 5.0]];
    Shape::footprint(&outline, &[]).expect("an outline").at([3.0, 0.0, -7.0])
}

/// A face in the form of an L and an upright one beside it, with coordinates of their own in set 0.
fn mesh() -> Shape {
    let mut builder = MeshBuilder::new();
    let lying = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [1.5, 2.0], [1.5, 4.0], [0.0, 4.0]];
    let upright = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]];
    let uv = |[x, y]: [f64; 2]| DVec2::new(0.3 * x + 1.0, 0.7 * y - x);
    let corners = lying.map(|[x, y]| builder.point([x, 0.0, -y]));
    builder.polygon(&corners).uvs(&lying.map(uv));
    let corners = upright.map(|[x, y]| builder.point([x, y - 1.0, 0.0]));
    builder.polygon(&corners).uvs(&upright.map(uv));
    Shape::mesh(builder.build().expect("two faces"))
}

fn steps(start: u32, [first, second, third]: [u32; 3]) -> Steps {
    let [start, first, second, third] = [start, first, second, third].map(f64::from);
    Steps { start, first, second, third }
}

fn input(start: u32) -> Shape {
    if start == 3 { mesh() } else { lot() }
}

/// The steps with all operations of one kind first; the order within a kind stays.
fn partitioned(steps: [u32; 3], changes_first: bool) -> [u32; 3] {
    let mut sorted = steps;
    sorted.sort_by_key(|step| (*step < KEEPS) == changes_first);
    sorted
}

fn derived(start: u32, order: [u32; 3]) -> Leaves {
    let mut leaves = Leaves::default();
    steps(start, order).run(&input(start), &Settings::default(), &mut leaves).expect("no error");
    leaves
}

/// Checks that two runs give the same leaves, except for rounding. Copies of a set make no difference.
fn compare(a: &Leaves, b: &Leaves, what: &str) {
    assert_eq!(a.0.len(), b.0.len(), "{what}");
    for ((rule, a), (other, b)) in a.0.iter().zip(&b.0) {
        assert_eq!((rule, a.len()), (other, b.len()), "{what}");
        for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
            let near = |a: DVec2, b: DVec2| a.abs_diff_eq(b, 1e-9 * (1.0 + a.abs().max_element()));
            let same = a.uvs.iter().zip(&b.uvs).all(|(a, b)| a.zip(*b).map_or(a == b, |(a, b)| near(a, b)));
            assert!(a.point.abs_diff_eq(b.point, 1e-9) && same, "{what}: {a:?} and {b:?}");
        }
    }
}

/// The smallest and the largest coordinates in a list.
fn range(uvs: impl Iterator<Item = DVec2>) -> Option<[DVec2; 2]> {
    uvs.fold(None, |range, uv| {
        let [low, high] = range.unwrap_or([uv; 2]);
        Some([low.min(uv), high.max(uv)])
    })
}

/// Checks that reports, buffers and files give the same coordinates as the leaves.
fn compare_ways_out(start: u32, order: [u32; 3], what: &str) {
    let (grammar, shape) = (steps(start, order), input(start));
    let model = grammar.generate(&shape).expect("no error");
    let mut leaves = Leaves::default();
    assert!(model.replay(&mut leaves).is_continue());
    compare(&derived(start, order), &leaves, what);
    let expected = range(leaves.0.iter().flat_map(|(_, faces)| faces.iter().flatten().filter_map(|at| at.uvs[0])));
    let near = |name: &str, found: Option<[DVec2; 2]>| {
        let same = found.zip(expected).map_or(found == expected, |(found, expected)| {
            found.iter().zip(expected).all(|(a, b)| a.abs_diff_eq(b, 1e-5 * (1.0 + b.abs().max_element())))
        });
        assert!(same, "{what}: {name} {found:?}, leaves {expected:?}");
    };
    if expected.is_some() {
        let told = |key: &str| model.reported(key).expect("a report").summary();
        let low = DVec2::new(told("uMin").min().expect("numbers"), told("vMin").min().expect("numbers"));
        let high = DVec2::new(told("uMax").max().expect("numbers"), told("vMax").max().expect("numbers"));
        near("reports", Some([low, high]));
    }
    let mut buffers = Buffers::new();
    assert!(model.replay(&mut buffers).is_continue());
    let pairs = |list: &[[f32; 2]]| range(list.iter().map(|[u, v]| DVec2::new(f64::from(*u), f64::from(*v))));
    near("buffers", pairs(buffers.uvs()));
    let (obj, _) = model.to_obj("m");
    let numbers = |line: &str| {
        let numbers: Vec<f64> = line.split(' ').map(|number| number.parse().expect("a number")).collect();
        DVec2::new(numbers[0], numbers[1])
    };
    near("OBJ", range(obj.lines().filter_map(|line| line.strip_prefix("vt ").map(numbers))));
    let glb = model.to_glb().expect("a file");
    let file = read_gltf(&glb, &mut |_| None).expect("a file that can be read");
    near("GLB", range(file.mesh.uv_set(0).iter().copied()));
}

#[test]
fn a_stored_set_and_a_function_are_not_both_applied() {
    cga! {
        grammar Block;
        Lot -->
            extrude(3) setupProjection(0, world.xy, 1, 1) projectUV(0) convexify() scaleUV(0, 2, 2)
            comp(f) { front : report("u", geometry.uMax) X. | all : NIL }
    }
    let model = Block::default().generate(&Shape::rectangle(10.0, 6.0)).expect("no error");
    assert_eq!(model.reported("u").expect("a report").summary().max(), Some(20.0));
    let mut buffers = Buffers::new();
    assert!(model.replay(&mut buffers).is_continue());
    assert_eq!(buffers.uvs().iter().map(|[u, _]| *u).fold(0.0, f32::max), 20.0);
}

#[test]
fn pairs_of_operations_give_the_same_in_both_orders() {
    let check = |start: u32, keep: u32, change: u32| {
        let what = format!("start {start}, operations {keep} and {change}");
        // The third step changes nothing else.
        let [one, two] = [[keep, change, KEEPS], [change, keep, KEEPS]];
        compare(&derived(start, one), &derived(start, two), &what);
        compare_ways_out(start, one, &what);
        compare_ways_out(start, two, &what);
    };
    (0..STARTS * KEEPS).into_par_iter().for_each(|at| {
        (KEEPS..KEEPS + CHANGES).for_each(|change| check(at / KEEPS, at % KEEPS, change));
    });
}

/// The number of random triples, which `CGA_TRIPLES` sets.
fn triples() -> u32 {
    let text = std::env::var("CGA_TRIPLES").ok();
    text.map_or(1_000, |text| text.parse().expect("`CGA_TRIPLES` is a number"))
}

#[test]
fn random_triples_of_operations_give_the_same_in_all_orders() {
    let mut random = 7_u64;
    let mut below = |count: u32| {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 33) as u32 % count
    };
    for _ in 0..triples() {
        let (start, order) = (below(STARTS), [0; 3].map(|_| below(KEEPS + CHANGES)));
        let what = format!("start {start}, operations {order:?}");
        let leaves = derived(start, order);
        for changes_first in [false, true] {
            let sorted = partitioned(order, changes_first);
            if sorted != order {
                compare(&leaves, &derived(start, sorted), &what);
            }
        }
    }
}
