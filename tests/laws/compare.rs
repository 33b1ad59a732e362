//! The comparison of two runs.

use cga::glam::{DAffine3, DVec2, DVec3};
use cga::mesh::{FaceRef, FaceTag};
use cga::{Collection, Fault, LeafView, Mesh, Model, Report, Scope};

/// The result of a run.
pub(crate) struct Outcome {
    pub(crate) model: Model,
    /// The report, or the error that ended the run.
    pub(crate) report: Result<Report, String>,
    /// The leaves that came from templates, where they were counted.
    pub(crate) replayed: usize,
}

/// The differences that are allowed.
#[derive(Clone, Copy)]
pub(crate) struct Tolerance {
    /// The tolerance of positions, in metres.
    pub(crate) length: f64,
}

/// A first difference: what differs, and the two sides.
type Difference = Option<String>;

/// The first difference of two runs. What rules print comes first, since it tells where in the grammar runs part.
pub(crate) fn difference(left: &Outcome, right: &Outcome, tolerance: Tolerance) -> Difference {
    match (&left.report, &right.report) {
        (Ok(a), Ok(b)) => {
            let prints = || prints(a, b, tolerance);
            let leaves = || leaves(&left.model, &right.model, tolerance);
            prints().or_else(leaves).or_else(|| reports(a, b, tolerance))
        }
        (Err(a), Err(b)) => same("the error", a, b).or_else(|| leaves(&left.model, &right.model, tolerance)),
        (a, b) => Some(format!("the error: {:?} and {:?}", a.as_ref().err(), b.as_ref().err())),
    }
}

/// The same for runs that may have ended early: those that did have to agree about the leaves that both have.
pub(crate) fn ended_alike(left: &Outcome, right: &Outcome, tolerance: Tolerance) -> Difference {
    let ended = |run: &Outcome| {
        run.report.as_ref().map_or_else(
            |error| error.split(" (in ").next().unwrap_or_default().to_owned(),
            |report| if report.stopped { "stopped".to_owned() } else { String::new() },
        )
    };
    let (a, b) = (ended(left), ended(right));
    if a.is_empty() && b.is_empty() {
        return difference(left, right, tolerance);
    }
    let pairs = left.model.leaves().zip(right.model.leaves()).enumerate();
    same("the end", &a, &b).or_else(|| {
        pairs
            .into_iter()
            .find_map(|(at, (a, b))| leaf(&a, &b, tolerance).map(|text| format!("leaf {at}, {}, {text}", a.rule())))
    })
}

fn same<T: PartialEq + std::fmt::Debug + ?Sized>(what: &str, a: &T, b: &T) -> Difference {
    (a != b).then(|| format!("{what}: {a:?} and {b:?}"))
}

/// The largest difference between sines and cosines of the angles of two frames. Where the middle angle is upright, a change of
/// the last bit of an axis changes the angle by its root.
const TURN: f64 = 1e-7;

impl Tolerance {
    /// Returns true if two numbers are equal within the tolerance. Numbers that are not lengths may differ by the same share of themselves.
    fn number(self, a: f64, b: f64) -> bool {
        a == b || a.is_nan() && b.is_nan() || (a - b).abs() <= self.length.max(1e-9 * a.abs().max(b.abs()))
    }

    fn vectors(self, a: impl Into<[f64; 3]>, b: impl Into<[f64; 3]>, least: f64) -> bool {
        let close = |(a, b): (f64, f64)| (a - b).abs() <= self.length.max(least);
        a.into().into_iter().zip(b.into()).all(close)
    }

    /// Compares two materials: a colour may be computed from lengths, so its numbers are as near as these.
    fn materials(self, left: &str, right: &str) -> Difference {
        let words = |text: &str| text.split([' ', ',', '(', ')']).map(str::to_owned).collect::<Vec<_>>();
        let close = |(a, b): (&String, &String)| match (a.parse(), b.parse()) {
            (Ok(a), Ok(b)) => self.number(a, b),
            _ => a == b,
        };
        let (words, others) = (words(left), words(right));
        let is_same = words.len() == others.len() && words.iter().zip(&others).all(close);
        (!is_same).then(|| format!("the material: {left} and {right}"))
    }

    /// Compares two texts; numbers between semicolons may differ by the tolerance.
    fn text(self, a: &str, b: &str) -> Difference {
        let same = |name: &str, a: &str, b: &str| match (a.parse::<f64>(), b.parse::<f64>()) {
            (Ok(a), Ok(b)) if name.ends_with("turn") => (a - b).abs() <= TURN,
            (Ok(a), Ok(b)) => self.number(a, b),
            _ => a == b,
        };
        let (left, right): (Vec<&str>, Vec<&str>) = (a.split(';').collect(), b.split(';').collect());
        // Each number belongs to the word before it.
        let mut name = "";
        for (at, (a, b)) in left.iter().zip(&right).enumerate() {
            if !a.is_empty() && a.parse::<f64>().is_err() && 0 < at && a == b {
                name = a;
            }
            if !same(name, a, b) {
                return Some(format!("{}, {name}: {a:?} and {b:?}", left[0]));
            }
        }
        (left.len() != right.len()).then(|| format!("{}, its length: {a} and {b}", left[0]))
    }
}

fn prints(a: &Report, b: &Report, tolerance: Tolerance) -> Difference {
    let lines = |report: &Report| {
        report.prints().iter().map(|print| (print.rule.clone(), print.to_string())).collect::<Vec<_>>()
    };
    let (left, right) = (lines(a), lines(b));
    for (at, ((rule, a), (other, b))) in left.iter().zip(&right).enumerate() {
        if let Some(text) = same("the rule", rule, other).or_else(|| tolerance.text(a, b)) {
            return Some(format!("print {at} in {rule}, {text}"));
        }
    }
    same("the number of prints", &left.len(), &right.len())
}

fn reports(a: &Report, b: &Report, tolerance: Tolerance) -> Difference {
    let kinds = |faults: &[Fault]| {
        let mut kinds: Vec<String> =
            faults.iter().map(|fault| format!("{:?} {}", fault.kind, fault.trail.join(" "))).collect();
        kinds.sort_unstable();
        kinds
    };
    let keys = |report: &Report| report.reports().iter().map(|it| (it.key().to_owned(), it.ty())).collect::<Vec<_>>();
    let (own, its) = (kinds(a.faults()), kinds(b.faults()));
    let first = own.iter().zip(&its).position(|(a, b)| a != b).unwrap_or(own.len().min(its.len()));
    same("the faults", &(own.len(), own.get(first)), &(its.len(), its.get(first)))
        .or_else(|| same("the faults left out", &a.faults_left_out(), &b.faults_left_out()))
        .or_else(|| same("the keys of reports", &keys(a), &keys(b)))
        .or_else(|| a.reports().iter().zip(b.reports().iter()).find_map(|(a, b)| collections(a, b, tolerance)))
        .or_else(|| same("the number of shapes", &a.shapes, &b.shapes))
        .or_else(|| same("the number of leaves said", &a.leaves, &b.leaves))
}

fn collections(a: &Collection, b: &Collection, tolerance: Tolerance) -> Difference {
    let (left, right) = (a.summary(), b.summary());
    let what = format!("what is reported as {:?}", a.key());
    let numbers = [(Some(left.sum), Some(right.sum)), (left.min(), right.min()), (left.max(), right.max())];
    let room = Tolerance { length: tolerance.length * left.count.max(1) as f64 };
    let differs = |(a, b): &(Option<f64>, Option<f64>)| match (a, b) {
        (Some(a), Some(b)) => !room.number(*a, *b),
        (a, b) => a != b,
    };
    same(&what, &(left.count, left.nans), &(right.count, right.nans))
        .or_else(|| numbers.iter().find(|pair| differs(pair)).map(|pair| format!("{what}: {pair:?}")))
        .or_else(|| same(&what, &a.texts().collect::<Vec<_>>(), &b.texts().collect::<Vec<_>>()))
}

fn leaves(a: &Model, b: &Model, tolerance: Tolerance) -> Difference {
    for (at, (a, b)) in a.leaves().zip(b.leaves()).enumerate() {
        if let Some(text) = leaf(&a, &b, tolerance) {
            return Some(format!("leaf {at}, {}, {text}", a.rule()));
        }
    }
    same("the number of leaves", &a.len(), &b.len())
}

/// The difference of scopes.
pub(crate) fn scope(a: &Scope, b: &Scope, tolerance: Tolerance) -> Difference {
    let axes = (0..3).all(|axis| tolerance.vectors(a.axes.col(axis), b.axes.col(axis), 1e-9));
    let is_same = tolerance.vectors(a.origin, b.origin, 0.0) && axes && tolerance.vectors(a.size, b.size, 0.0);
    (!is_same).then(|| format!("the scope:\n    {a:?}\n    {b:?}"))
}

fn leaf(a: &LeafView<'_>, b: &LeafView<'_>, tolerance: Tolerance) -> Difference {
    let ((mesh, placement), (other, place)) = (a.mesh(), b.mesh());
    let points = || {
        let world = |(a, b): (&cga::glam::DVec3, &cga::glam::DVec3)| {
            let [a, b] = [placement.transform_point3(*a), place.transform_point3(*b)];
            (!tolerance.vectors(a, b, 0.0)).then(|| format!("{a} and {b}"))
        };
        let (mine, its) = (Numbering::of(&mesh), Numbering::of(&other));
        let pairs = mine.points(&mesh).zip(its.points(&other));
        let (at, found) = pairs.map(world).enumerate().find(|it| it.1.is_some())?;
        found.map(|text| format!("the position of vertex {at}: {text}"))
    };
    same("the rule", a.rule(), b.rule())
        .or_else(|| tolerance.materials(&format!("{:?}", a.material()), &format!("{:?}", b.material())))
        .or_else(|| scope(&a.scope(), &b.scope(), tolerance))
        .or_else(|| {
            let found = faces(&mesh, &other, &placement, tolerance).or_else(points)?;
            // Where a cut follows an edge or meets a corner up to rounding, a face that is thinner or an edge that is shorter than rounding is
            // made or not. Where flat geometry is cut, rounding decides the first corner of the cap.
            let [mesh, other] = [mesh.map(&placement), other.map(&place)];
            (!differs_by_rounding(&mesh, &other, tolerance)).then_some(found)
        })
}

/// The length of the shortest edge.
fn shortest_edge(mesh: &Mesh) -> f64 {
    let length = |[a, b]: [u32; 2]| mesh.points()[a as usize].distance(mesh.points()[b as usize]);
    mesh.face_edges().map(length).fold(f64::INFINITY, f64::min)
}

/// Returns true if a mesh has thin faces or edges that are shorter than the tolerance, and the other faces and the bounds of both are alike.
fn differs_by_rounding(a: &Mesh, b: &Mesh, tolerance: Tolerance) -> bool {
    let thick = |mesh: &Mesh| -> Vec<_> {
        let faces = mesh.faces().filter(|face| !is_thin(face, tolerance));
        let tell = |face: FaceRef<'_>| {
            let tag = face.tag();
            let tags = face.tags().map(|tags| format!("{tags:?}"));
            (tag.cap, tags, mesh.groups().get(tag.group as usize).cloned(), face.area(), face.normal())
        };
        faces.map(tell).collect()
    };
    let (own, its) = (thick(a), thick(b));
    let is_alike = |((cap, tags, group, area, normal), its): (&_, &(_, _, _, f64, _))| {
        (cap, tags, group) == (&its.0, &its.1, &its.2)
            && tolerance.number(*area, its.3)
            && tolerance.vectors(*normal, its.4, 1e-9)
    };
    let [low, high] = [(a.bounds().low, b.bounds().low), (a.bounds().high, b.bounds().high)];
    let is_rounded = || shortest_edge(a).min(shortest_edge(b)) <= tolerance.length;
    (own.len() < a.face_count().max(b.face_count()) || is_rounded())
        && own.len() == its.len()
        && own.iter().zip(&its).all(is_alike)
        && tolerance.vectors(low.0, low.1, 0.0)
        && tolerance.vectors(high.0, high.1, 0.0)
}

/// Returns true if a face is narrower than the tolerance.
fn is_thin(face: &FaceRef<'_>, tolerance: Tolerance) -> bool {
    let ring: Vec<DVec3> = face.outline().collect();
    let longest = (0..ring.len()).map(|at| ring[at].distance(ring[(at + 1) % ring.len()])).fold(0.0, f64::max);
    face.area() <= tolerance.length * longest
}

/// Compares the coordinates of a set at all corners; lists are as long as each other or empty.
fn coordinates(set: usize, a: &Mesh, b: &Mesh, placement: &DAffine3, tolerance: Tolerance) -> Difference {
    let (mesh, a, b) = (a, a.uv_set(set), b.uv_set(set));
    let far = a.iter().chain(b).map(|uv| uv.abs().max_element()).fold(1.0, f64::max);
    let close = |a: DVec2, b: DVec2, room: f64| a == b || (a - b).abs().max_element() <= room;
    same(&format!("the number of coordinates in set {set}"), &a.len(), &b.len()).or_else(|| {
        let most = tolerance.length.max(1e-9 * far);
        let differs = |at: &usize| !close(a[*at], b[*at], most);
        // Only a few meshes need the room that rounding takes.
        let found = (0..a.len()).find(differs)?;
        let room = rounding(mesh, set, placement);
        let at = (found..a.len()).find(|at| differs(at) && !close(a[*at], b[*at], most.max(room[*at])))?;
        let most = most.max(room[at]);
        Some(format!("the coordinates in set {set} of corner {at}: {} and {}, beyond {most:e}", a[at], b[at]))
    })
}

/// The rounding of the coordinates of each corner: the rounding of its position in the world, four bits of the largest coordinate, times
/// the change of texture coordinates for a metre along the edges at its point, in whatever face they are: one projection has them all.
fn rounding(mesh: &Mesh, set: usize, placement: &DAffine3) -> Vec<f64> {
    let mut uvs = mesh.uv_set(set).iter();
    let mut most = vec![0.0_f64; mesh.points().len()];
    let mut numbers = Vec::with_capacity(uvs.len());
    for ring in mesh.faces().flat_map(|face| face.loops().map(<[u32]>::to_vec).collect::<Vec<_>>()) {
        let place = |point: u32| placement.transform_point3(mesh.points()[point as usize]);
        let corners: Vec<(DVec3, DVec2)> = ring.iter().copied().map(place).zip(uvs.by_ref().copied()).collect();
        let slope = |(point, uv): (DVec3, DVec2), (next, other): (DVec3, DVec2)| {
            let metres = point.distance(next);
            if metres == 0.0 { 0.0 } else { (uv - other).abs().max_element() / metres }
        };
        for (at, (corner, &point)) in corners.iter().zip(&ring).enumerate() {
            let [next, last] = [1, corners.len() - 1].map(|step| corners[(at + step) % corners.len()]);
            let steepest = slope(*corner, next).max(slope(*corner, last));
            let room = &mut most[point as usize];
            *room = room.max(4.0 * f64::EPSILON * corner.0.abs().max_element() * steepest);
            numbers.push(point);
        }
    }
    numbers.into_iter().map(|point| most[point as usize]).collect()
}

/// The points of a mesh in the order in which its faces come to them. Rounding may change the order in which an operation makes them.
#[derive(Default)]
struct Numbering {
    order: Vec<u32>,
    loops: Vec<Vec<Vec<u32>>>,
}

impl Numbering {
    fn of(mesh: &Mesh) -> Self {
        let mut numbering = Self::default();
        let mut numbers = vec![None; mesh.points().len()];
        for face in mesh.faces() {
            let mut number = |point: &u32| {
                *numbers[*point as usize].get_or_insert_with(|| {
                    numbering.order.push(*point);
                    numbering.order.len() as u32 - 1
                })
            };
            numbering.loops.push(face.loops().map(|ring| ring.iter().map(&mut number).collect()).collect());
        }
        // Points without a face keep their order.
        numbering.order.extend((0..).zip(&numbers).filter(|(_, number)| number.is_none()).map(|(point, _)| point));
        numbering
    }

    fn points<'m>(&'m self, mesh: &'m Mesh) -> impl Iterator<Item = &'m DVec3> {
        self.order.iter().map(move |point| &mesh.points()[*point as usize])
    }
}

/// Everything about two meshes but positions. The placement is of the first.
fn faces(a: &Mesh, b: &Mesh, placement: &DAffine3, tolerance: Tolerance) -> Difference {
    let list = |mesh: &Mesh, what: fn(&Mesh, FaceTag) -> String| {
        mesh.faces().map(|face| what(mesh, face.tag())).collect::<Vec<_>>()
    };
    let materials = |mesh: &Mesh| {
        list(mesh, |mesh, tag| format!("{:?}", mesh.materials::<cga::Material>().get(tag.material as usize))).join(" ")
    };
    let by_name = |what: &str, tell: fn(&Mesh, FaceTag) -> String| same(what, &list(a, tell), &list(b, tell));
    same("the number of faces", &a.face_count(), &b.face_count())
        .or_else(|| same("the number of vertices", &a.points().len(), &b.points().len()))
        .or_else(|| same("the loops of the faces", &Numbering::of(a).loops, &Numbering::of(b).loops))
        .or_else(|| by_name("the caps", |_, tag| tag.cap.to_string()))
        .or_else(|| by_name("the tags", |mesh, tag| format!("{:?}", mesh.tag_sets().get(tag.tags as usize))))
        .or_else(|| by_name("the groups", |mesh, tag| format!("{:?}", mesh.groups().get(tag.group as usize))))
        .or_else(|| tolerance.materials(&materials(a), &materials(b)))
        .or_else(|| (0..10).find_map(|set| coordinates(set, a, b, placement, tolerance)))
        .or_else(|| same("whether there are normals", &a.normals().is_empty(), &b.normals().is_empty()))
}
