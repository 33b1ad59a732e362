//! Facts that the compiler finds, against runs: what a rule does not use makes no difference.

use std::sync::Mutex;

use cga::glam::{DMat3, DVec3};
use cga::{Model, Scope, Settings, Shape, cga};
use cga_lang::compile::compile_text;
use cga_lang::ir::facts::{Facts, RuleFacts, Uses};

cga! { grammar Rules in "rules/facts.cga"; }

/// Parts of splits: 2 by 4 by 5 metres, or 2 by 5.
static PARTS: Mutex<Vec<Shape>> = Mutex::new(Vec::new());

fn keep(shape: &mut Shape) {
    PARTS.lock().expect("no panic in between").push(shape.clone());
}

cga! {
    grammar Split;
    Lot --> split(x) { { 2 : crate::facts::keep() X. }* }
}

/// A part of a split that divides `whole`, whose width is a multiple of 2. Inner parts have one form.
fn part(whole: Shape, index: usize) -> Shape {
    let mut parts = PARTS.lock().expect("no panic in between");
    parts.clear();
    drop(parts);
    Split::default().generate(&whole).expect("a split");
    PARTS.lock().expect("no panic in between").swap_remove(index)
}

/// The names and the facts of the start rules.
fn starts() -> Vec<(String, RuleFacts)> {
    let text = std::fs::read_to_string("rules/facts.cga").expect("the rules");
    let grammar = compile_text(&text).compiled.grammar.expect("rules without errors");
    let facts = Facts::new(&grammar);
    grammar.starts.iter().map(|start| (start.name.clone(), *facts.rule(start.rule))).collect()
}

fn run(rule: &str, shape: &Shape) -> Model {
    let settings = Settings { start: Some(rule.to_owned()), ..Settings::default() };
    let rules = Rules { drawn: Some(1.25), ..Rules::default() };
    rules.generate_with(shape, &settings).unwrap_or_else(|error| panic!("{rule}: {error}"))
}

/// The leaves in the coordinates of a scope: their rules and materials, and the corners of their scopes and of their meshes.
fn leaves(model: &Model, from: &Scope) -> Vec<(String, Vec<DVec3>)> {
    let local = |point: DVec3| from.axes.transpose() * (point - from.origin);
    let leaf = |leaf: cga::LeafView<'_>| {
        let (scope, (mesh, placement)) = (leaf.scope(), leaf.mesh());
        let axes = (0..3).map(|axis| scope.origin + scope.axes.col(axis) * (1.0 + scope.size[axis]));
        let corners = [scope.origin].into_iter().chain(axes);
        let points = mesh.points().iter().map(|point| placement.transform_point3(*point));
        (format!("{} {:?}", leaf.rule(), leaf.material()), corners.chain(points).map(local).collect())
    };
    model.leaves().map(leaf).collect()
}

fn differ(a: &[(String, Vec<DVec3>)], b: &[(String, Vec<DVec3>)]) -> bool {
    let far = |(a, b): (&DVec3, &DVec3)| 1e-9 < (*a - *b).length();
    a.len() != b.len()
        || a.iter().zip(b).any(|(a, b)| a.0 != b.0 || a.1.len() != b.1.len() || a.1.iter().zip(&b.1).any(far))
}

/// A shape of the same size elsewhere. Its pivot stays.
fn elsewhere(shape: &Shape) -> Shape {
    let (mut moved, scope) = (shape.clone(), *shape.scope());
    let turn = DMat3::from_rotation_x(0.3) * DMat3::from_rotation_y(2.1);
    moved.set_scope(Scope { origin: scope.origin + DVec3::new(3.0, 40.0, -5.0), axes: turn * scope.axes, ..scope });
    moved
}

#[test]
fn what_a_rule_does_not_use_makes_no_difference() {
    // A change, whether the facts say that a rule does not see it, and how many rules do see it.
    let mut seen = [0; 4];
    for whole in [|width: f64| Shape::cuboid(width, 4.0, 5.0), |width: f64| Shape::rectangle(width, 5.0)] {
        let shape = part(whole(6.0), 1).seed(1);
        let mut counted = part(whole(8.0), 2).seed(1);
        counted.set_scope(*shape.scope());
        let all = elsewhere(&counted).seed(7);
        for (rule, facts) in starts() {
            let below = facts.below;
            let model = run(&rule, &shape);
            let expected = leaves(&model, shape.scope());
            let says = !model.prints().is_empty() || model.reports().iter().next().is_some();
            assert!(below.has(Uses::SAYS) || below.has(Uses::REPORTS) || !says, "{rule} says something: {facts:?}");
            let cases = [
                ("seed", below.has(Uses::DRAWS), shape.clone().seed(7)),
                ("counter", !below.counters().is_none(), counted.clone()),
                // Operations on whole shapes see a pivot that stays.
                ("place", !facts.rigid || below.has(Uses::BODY), all.clone()),
            ];
            for (at, (what, used, other)) in cases.into_iter().enumerate() {
                let differ = differ(&expected, &leaves(&run(&rule, &other), other.scope()));
                assert!(used || !differ, "another {what} is seen by {rule}: {facts:?}");
                seen[at] += usize::from(differ);
            }
            seen[3] += usize::from(facts.rigid);
        }
    }
    // Changes are seen at all, and there are rules that are rigid.
    assert!(12 <= seen[0] && 4 <= seen[1] && 40 <= seen[2] && 24 <= seen[3], "{seen:?}");
}
