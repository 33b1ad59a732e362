//! The marks in the pages' pictures: axes of scopes, pivots, boxes, the initial shape. x is red, y green, z blue.

use std::collections::BTreeMap;
use std::sync::Arc;

use cga::glam::{DAffine3, DMat3, DVec3};
use cga::mesh::Bounds;
use cga::{
    Color, Cuboid, Frame, Geometry, Leaf, LeafView, Material, Mesh, MeshBuilder, Model, Scope, Settings, Shape, Sink,
    Text,
};

use crate::pages::example::{Example, Mark};

const AXES: [[f64; 3]; 3] = [[0.9, 0.05, 0.05], [0.05, 0.75, 0.05], [0.1, 0.2, 0.95]];
const BOX: [f64; 3] = [0.85, 0.75, 0.1];
const INITIAL: [f64; 3] = [0.35; 3];
const BACK: [f64; 3] = [0.02; 3];

/// The lengths of marks, as shares of the diagonal of the marked model.
const LINE: f64 = 0.005;
const ARROW: f64 = 0.008;
const HEAD: f64 = 0.03;
const PIVOT: [f64; 2] = [0.07, 0.013];
/// The distance of a lowered piece from its place, and of a drawn back from its face.
const GAP: f64 = 0.02;
const BEHIND: f64 = 1e-3;

/// The model with the marks of an example.
pub fn marked(model: &Model, example: &Example) -> Model {
    let start = (example.start)();
    let mut pen = Pen { unit: reach(model, &start).size().length(), out: Model::new() };
    let is_lowered = |rule: &str| example.marks.iter().any(|mark| matches!(mark, Mark::Lowered(name) if *name == rule));
    for leaf in model.leaves() {
        if is_lowered(leaf.rule()) {
            pen.lowered(&leaf);
        } else {
            let _ = leaf.replay(&mut pen.out);
        }
    }
    model.leaves().for_each(|leaf| pen.edge(&leaf));
    for mark in example.marks {
        match *mark {
            Mark::Initial => pen.initial(&start),
            Mark::InitialBox => pen.edges(start.scope()),
            Mark::InitialScope => pen.scope(start.scope()),
            Mark::AlongX => pen.along_x(start.scope()),
            Mark::InitialPivot => pen.pivot(start.pivot()),
            Mark::Scopes(rule) => model.leaves_of(rule).for_each(|leaf| pen.scope(&leaf.scope())),
            Mark::Scope(rule, at) => model.leaves_of(rule).skip(at).take(1).for_each(|leaf| pen.scope(&leaf.scope())),
            Mark::Boxes(rule) => model.leaves_of(rule).for_each(|leaf| pen.edges(&leaf.scope())),
            Mark::Pivots(rule) => model.leaves_of(rule).for_each(|leaf| pen.pivot(&first_corner(&leaf))),
            Mark::ScopePivots(rule) => model.leaves_of(rule).for_each(|leaf| pen.pivot(&leaf.scope().frame())),
            Mark::Inner(rule) => inner_scopes(example, rule).iter().for_each(|scope| {
                pen.edges(scope);
                pen.scope(scope);
            }),
            Mark::Backs => model.leaves().for_each(|leaf| pen.back(&leaf)),
            Mark::Lowered(_) | Mark::FromAbove | Mark::From(..) => {}
        }
    }
    pen.out
}

/// The box around the model and the initial scope.
fn reach(model: &Model, start: &Shape) -> Bounds {
    let scope = start.scope();
    let far = scope.origin + scope.axes * scope.size;
    let bounds = model.bounds();
    Bounds::of([bounds.low, bounds.high, scope.origin, far].into_iter().filter(|corner| corner.is_finite()))
}

/// The scopes with which a rule begins, from the tree of shapes.
fn inner_scopes(example: &Example, rule: &str) -> Vec<Scope> {
    let model = example.model(&Settings { tree: true, ..Settings::default() });
    let mut found = BTreeMap::new();
    for leaf in model.leaves() {
        let shapes = std::iter::successors(leaf.node(), |node| node.parent());
        found.extend(shapes.filter(|node| node.rule() == rule).map(|node| (node.index(), *node.scope())));
    }
    assert!(!found.is_empty(), "{}: no shape of {rule} to mark", example.title);
    found.into_values().collect()
}

/// The pivot that `comp` gives a face: the start of its first edge, with the axes of its scope.
fn first_corner(leaf: &LeafView<'_>) -> Frame {
    let (mesh, placement) = leaf.mesh();
    let first = mesh.corners().first().map_or(DVec3::ZERO, |&corner| mesh.points()[corner as usize]);
    Frame { origin: placement.transform_point3(first), axes: leaf.scope().axes }
}

/// Draws into a model.
struct Pen {
    /// The diagonal of the marked model.
    unit: f64,
    out: Model,
}

impl Pen {
    /// Draws the initial shape, a little below the model.
    fn initial(&mut self, shape: &Shape) {
        let scope = Scope { origin: shape.scope().origin - DVec3::Y * (LINE * self.unit * 0.1), ..*shape.scope() };
        let place = DAffine3 { matrix3: scope.axes, translation: scope.origin };
        self.mesh(shape.to_mesh(), INITIAL, &place);
    }

    /// Draws a short arrow along the x axis of a scope on the ground, in front of it.
    fn along_x(&mut self, scope: &Scope) {
        let front = scope.origin + scope.axes.z_axis * (scope.size.z + HEAD * self.unit);
        let size = DVec3::new(0.12 * self.unit, 0.0, 0.0);
        self.scope(&Scope { origin: front, size, ..*scope });
    }

    /// Draws arrows along the axes of a scope, longer than the scope by an arrowhead. An axis without a size has no
    /// arrow.
    fn scope(&mut self, scope: &Scope) {
        // Arrows on a flat shape are on top of it.
        let lift = if scope.size.y == 0.0 { scope.axes.y_axis * (0.3 * HEAD * self.unit) } else { DVec3::ZERO };
        for (axis, color) in AXES.into_iter().enumerate() {
            let length = scope.size[axis].abs();
            if 0.0 < length {
                let along = scope.axes.col(axis) * scope.size[axis].signum();
                let (u, v) = along.any_orthonormal_pair();
                let place = DAffine3 { matrix3: DMat3::from_cols(along, u, v), translation: scope.origin + lift };
                let arrow = arrow(length + HEAD * self.unit, ARROW * self.unit, HEAD * self.unit);
                self.mesh(Arc::new(arrow), color, &place);
            }
        }
    }

    /// Draws the edge of a leaf that is an edge with a colour.
    fn edge(&mut self, leaf: &LeafView<'_>) {
        let (size, width) = (leaf.size(), LINE * self.unit);
        let Some(Color { r, g, b, .. }) = leaf.material().color else { return };
        if matches!(leaf.geometry(), Geometry::Placement) && 0.0 < size.x && size.y == 0.0 && size.z == 0.0 {
            let low = DVec3::new(0.0, -0.5 * width, -0.5 * width);
            self.bar(&leaf.scope().frame(), low, DVec3::new(size.x, width, width), [r, g, b]);
        }
    }

    /// Draws a leaf a little lower than it is.
    fn lowered(&mut self, leaf: &LeafView<'_>) {
        let (mesh, place) = leaf.mesh();
        let down = DVec3::NEG_Y * (GAP * self.unit);
        let scope = Scope { origin: leaf.scope().origin + down, ..leaf.scope() };
        let place = DAffine3::from_translation(down) * place;
        let _ = self.out.mesh(&Leaf::new(&Text::from(leaf.rule()), leaf.material(), &scope), &mesh, &place);
    }

    /// Draws the faces of a leaf again, in black and a little behind.
    fn back(&mut self, leaf: &LeafView<'_>) {
        let (mesh, place) = leaf.mesh();
        for face in mesh.faces() {
            let behind = place.transform_vector3(face.normal()).normalize_or_zero() * (-BEHIND * self.unit);
            let mut rings = face.loops().map(|ring| ring.iter().map(|&point| mesh.points()[point as usize]).collect());
            let (outline, holes): (Vec<DVec3>, _) = (rings.next().expect("an outline"), rings.collect::<Vec<_>>());
            let alone = Mesh::from_polygon(&outline, &holes).expect("the rings of a face");
            self.mesh(Arc::new(alone), BACK, &(DAffine3::from_translation(behind) * place));
        }
    }

    /// Draws short bars along the axes of a pivot.
    fn pivot(&mut self, pivot: &Frame) {
        let [length, width] = PIVOT.map(|share| share * self.unit);
        for (axis, color) in AXES.into_iter().enumerate() {
            let mut size = DVec3::splat(width);
            size[axis] = length;
            let mut low = DVec3::splat(-0.5 * width);
            low[axis] = 0.0;
            self.bar(pivot, low, size, color);
        }
    }

    /// Draws the edges of a scope, thinner than arrows.
    fn edges(&mut self, scope: &Scope) {
        let (frame, width) = (scope.frame(), LINE * self.unit);
        for axis in 0..3 {
            let [across, up] = [(axis + 1) % 3, (axis + 2) % 3];
            for (a, b) in [(0.0, 1.0), (1.0, 0.0), (1.0, 1.0), (0.0, 0.0)] {
                let mut low = DVec3::splat(-0.5 * width);
                low[across] += a * scope.size[across];
                low[up] += b * scope.size[up];
                let mut size = DVec3::splat(width);
                size[axis] += scope.size[axis];
                self.bar(&frame, low, size, BOX);
            }
        }
    }

    fn bar(&mut self, frame: &Frame, low: DVec3, size: DVec3, color: [f64; 3]) {
        let scope = Scope { origin: frame.to_world(low), axes: frame.axes, size };
        let cuboid = Cuboid::new(scope.origin, scope.axes * DMat3::from_diagonal(size));
        let material = paint(color);
        let _ = self.out.cuboid(&Leaf::new(&Text::fixed("Mark"), &material, &scope), &cuboid);
    }

    fn mesh(&mut self, mesh: Arc<Mesh>, color: [f64; 3], place: &DAffine3) {
        let material = paint(color);
        let scope = Scope { origin: place.translation, axes: place.matrix3, size: mesh.bounds().size() };
        let _ = self.out.mesh(&Leaf::new(&Text::fixed("Mark"), &material, &scope), &mesh, place);
    }
}

fn paint([r, g, b]: [f64; 3]) -> Arc<Material> {
    let mut material = Material::default();
    material.color = Some(Color::new(r, g, b));
    Arc::new(material)
}

/// An arrow along x: a bar with four sides and a pyramid.
fn arrow(length: f64, width: f64, head: f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut ring = |x: f64, half: f64| {
        [[-half, -half], [half, -half], [half, half], [-half, half]].map(|[y, z]| builder.point([x, y, z]))
    };
    let neck = length - head;
    let (start, end, base) = (ring(0.0, 0.5 * width), ring(neck, 0.5 * width), ring(neck, 0.3 * head));
    let tip = builder.point([length, 0.0, 0.0]);
    for at in 0..4 {
        let next = (at + 1) % 4;
        builder.polygon(&[start[at], start[next], end[next], end[at]]);
        builder.polygon(&[base[at], base[next], tip]);
    }
    for [a, b, c, d] in [start, base] {
        builder.polygon(&[d, c, b, a]);
    }
    builder.build().expect("an arrow")
}
