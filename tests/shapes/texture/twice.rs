//! A part takes the stored texture coordinates or the function that changes them, never both: operations that keep faces and operations on
//! texture coordinates may change places, and all ways out agree.

use std::collections::BTreeSet;

use cga::sink::buffers::Buffers;
use cga::{LeafView, Model, Shape, cga};

cga! {
    grammar Steps;

    attr a = 0
    attr b = 0
    attr c = 0
    /// Whether the last step is `comp`.
    attr parts = true

    step(n) = case n == 0 : a case n == 1 : b case n == 2 : c else : -1

    Lot --> extrude(3) setupProjection(0, world.xy, 1, 1) projectUV(0) copyUV(0, 2) Step(0)
    Step(n) -->
        case step(n) == 0 : convexify() Step(n + 1)
        case step(n) == 1 : offset(-0.25, inside) Step(n + 1)
        case step(n) == 2 : cleanupGeometry(all, 0) Step(n + 1)
        case step(n) == 3 : mirror(true, false, false) Step(n + 1)
        case step(n) == 4 : rotateScope(0, 30, 0) Step(n + 1)
        case step(n) == 5 : alignScopeToAxes(y) Step(n + 1)
        case step(n) == 6 : setNormals(hard) Step(n + 1)
        case step(n) == 7 : comp(f) { all = Step(n + 1) }
        case step(n) == 8 : split(x) { ~1 : Step(n + 1) }
        case step(n) == 9 : s(^1, ^1, ^2) Step(n + 1)
        case step(n) == 10 : mirrorScope(true, false, false) Step(n + 1)
        case step(n) == 11 : deleteHoles() Step(n + 1)
        case step(n) == 12 : reverseNormals() Step(n + 1)
        case step(n) == 13 : r(10, 20, 0) t(1, 2, 3) Step(n + 1)
        case step(n) == 14 : inline(append) { comp(f) { all : Piece. } } Step(n + 1)
        case step(n) == 20 : scaleUV(0, 2, 3) Step(n + 1)
        case step(n) == 21 : translateUV(0, 0.25, -1) Step(n + 1)
        case step(n) == 22 : rotateUV(0, 90) Step(n + 1)
        case step(n) == 23 : copyUV(0, 1) Step(n + 1)
        case step(n) == 24 : scaleUV(2, -0.5, 0.5) Step(n + 1)
        case step(n) == 25 : copyUV(2, 0) Step(n + 1)
        case step(n) == 26 : deleteUV(2) Step(n + 1)
        else : End
    End --> case parts : comp(f) { all : print(geometry.uMax(0)) Face. } else : Whole.
}

/// The operations that keep faces, and the operations on texture coordinates.
const KEEP: std::ops::Range<u8> = 0..15;
const UV: std::ops::Range<u8> = 20..27;

fn run(steps: [u8; 3], parts: bool) -> Model {
    let [a, b, c] = steps.map(f64::from);
    // Concave, so that `convexify` has work.
    let lot = Shape::footprint(&[[0.0, 0.0], [10.0, 0.0], [10.0, -6.0], [4.0, -6.0], [4.0, -9.0], [0.0, -9.0]], &[]);
    Steps { a, b, c, parts }.generate(&lot.expect("a lot")).expect("no limit")
}

/// The coordinates of all corners of a leaf, by set.
fn coordinates(leaf: &LeafView<'_>) -> Vec<Vec<[f64; 2]>> {
    let (mesh, _) = leaf.mesh();
    (0..3).map(|set| mesh.uv_set(set).iter().map(|uv| uv.to_array()).collect()).collect()
}

/// The first difference between the coordinates of two models.
fn difference(one: &Model, other: &Model) -> Option<String> {
    if one.len() != other.len() {
        return Some(format!("{} and {} leaves", one.len(), other.len()));
    }
    for (number, (a, b)) in one.leaves().zip(other.leaves()).enumerate() {
        for (set, (a, b)) in coordinates(&a).iter().zip(coordinates(&b)).enumerate() {
            let near = |(a, b): (&[f64; 2], &[f64; 2])| (0..2).all(|i| (a[i] - b[i]).abs() < 1e-9);
            if a.len() != b.len() || !a.iter().zip(&b).all(near) {
                return Some(format!("leaf {number}, set {set}: {a:?} and {b:?}"));
            }
        }
    }
    None
}

/// The order in which operations on texture coordinates come last, and the order in which they come first.
fn orders(steps: [u8; 3]) -> [[u8; 3]; 2] {
    let mut last = steps;
    last.sort_by_key(|step| (*step == 99, UV.contains(step)));
    let mut first = steps;
    first.sort_by_key(|step| (*step == 99, KEEP.contains(step)));
    [last, first]
}

#[test]
fn the_documented_number_is_doubled_once() {
    let model = run([0, 20, 99], true);
    let largest = model.report().prints().iter().map(|print| print.to_string()).collect::<BTreeSet<_>>();
    assert!(largest.contains("20") && !largest.contains("40"), "{largest:?}");
}

#[test]
fn operations_that_keep_faces_and_operations_on_coordinates_change_places() {
    let all: Vec<u8> = KEEP.chain(UV).collect();
    let mut random = 7u64;
    let mut below = |count: usize| {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 33) as usize % count
    };
    let pairs = KEEP.flat_map(|keep| UV.map(move |uv| [keep, uv, 99]));
    let triples =
        (0..if cfg!(debug_assertions) { 1500 } else { 10_000 }).map(|_| [0; 3].map(|_: u8| all[below(all.len())]));
    let (mut count, mut wrong) = (0, Vec::new());
    for steps in pairs.chain(triples) {
        let [last, first] = orders(steps);
        let model = run(steps, true);
        for other in [last, first] {
            count += 1;
            if let Some(why) = (other != steps).then(|| difference(&model, &run(other, true))).flatten() {
                wrong.push(format!("{steps:?} and {other:?}: {why}"));
            }
        }
    }
    assert!(3000 < count && wrong.is_empty(), "{} of {count}: {:#?}", wrong.len(), &wrong[..wrong.len().min(6)]);
}

/// Different coordinates of a set, as whole numbers.
type Distinct = BTreeSet<[i64; 2]>;

fn distinct(uvs: impl IntoIterator<Item = [f64; 2]>) -> Distinct {
    uvs.into_iter().map(|uv| uv.map(|c| (c * 1e4).round() as i64)).collect()
}

/// The coordinates of the first set in the buffer views of a GLB file.
fn in_glb(glb: &[u8]) -> Distinct {
    let word = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().expect("four bytes")) as usize;
    let (json, binary) = (&glb[20..20 + word(12)], &glb[28 + word(12)..]);
    let json: serde_json::Value = serde_json::from_slice(json).expect("JSON");
    let number = |value: &serde_json::Value| value.as_u64().unwrap_or(0) as usize;
    let mut found = Distinct::new();
    for mesh in json["meshes"].as_array().expect("meshes") {
        for primitive in mesh["primitives"].as_array().expect("primitives") {
            let Some(accessor) = primitive["attributes"]["TEXCOORD_0"].as_u64() else { continue };
            let accessor = &json["accessors"][accessor as usize];
            let view = &json["bufferViews"][number(&accessor["bufferView"])];
            let stride = view["byteStride"].as_u64().unwrap_or(8) as usize;
            let start = number(&view["byteOffset"]) + number(&accessor["byteOffset"]);
            let float = |at: usize| f64::from(f32::from_le_bytes(binary[at..at + 4].try_into().expect("four bytes")));
            found.extend(distinct((0..number(&accessor["count"])).map(|i| {
                let at = start + i * stride;
                // v runs down in glTF.
                [float(at), 1.0 - float(at + 4)]
            })));
        }
    }
    found
}

#[test]
fn all_ways_out_have_the_same_coordinates() {
    for (keep, uv, parts) in KEEP.flat_map(|keep| UV.flat_map(move |uv| [(keep, uv, true), (keep, uv, false)])) {
        let model = run([keep, uv, 99], parts);
        let expected = distinct(model.leaves().flat_map(|leaf| coordinates(&leaf).swap_remove(0)));
        let mut buffers = Buffers::new();
        assert!(model.replay(&mut buffers).is_continue());
        let (obj, _) = model.to_obj("model.mtl");
        let numbers = |line: &str| {
            let mut numbers = line.split(' ').map(|number| number.parse::<f64>().expect("a number"));
            [numbers.next().expect("u"), numbers.next().expect("v")]
        };
        let in_obj = distinct(obj.lines().filter_map(|line| line.strip_prefix("vt ")).map(numbers));
        let ways = [
            distinct(buffers.uv_set(0).iter().map(|uv| uv.map(f64::from))),
            in_obj,
            in_glb(&model.to_glb().expect("a file")),
        ];
        for (way, found) in ways.iter().enumerate() {
            assert!(
                !expected.is_empty() && *found == expected,
                "{keep} {uv} {parts}: way {way}: {found:?} {expected:?}"
            );
        }
        // What rules print is what leaves have.
        if parts {
            let most =
                model.leaves().map(|leaf| coordinates(&leaf)[0].iter().fold(f64::MIN, |most, uv| most.max(uv[0])));
            for (print, most) in model.report().prints().iter().zip(most) {
                let print: f64 = print.to_string().parse().expect("a number");
                assert!((print - most).abs() < 1e-4 * most.abs().max(1.0), "{keep} {uv}: {print} {most}");
            }
        }
    }
}
