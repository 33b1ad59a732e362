//! *split attribute*, *comp attribute*, *r operation*, *report operation*: what rules learn about their place in a split.

use cga::{Model, Settings, Shape, cga};

use crate::pieces::near;
use cga_tests::pages::split_attribute::{interleaved, slices};

cga! {
    @Allow(undefined_rule)
    @Allow(size_not_positive)
    grammar Index = r##"
    # Nested groups count on, a split inside a split counts for itself.
    @StartRule
    Nested --> split(x) { 1 : P | { 2 : P | 1 : split(z) { '0.5 : P }* }* }
    P --> set(material.name, split.index + " of " + split.total) P.

    # What gets no room is not counted.
    @StartRule
    Dropped --> split(x) { 1 : P | 0 : P | -1 : P | 3 : P | 100 : P | 1 : P }

    # Before any split.
    @StartRule
    Before --> P
    "##;
}

cga! {
    @Allow(undefined_rule)
    grammar Turned = r#"
    # r operation, Rotation Centers
    height = 18
    dy = 2
    @StartRule
    Lot-->
       extrude(height)
       split(y) {
          dy : r(0, 360*split.index/split.total, 0)
               X
       }*
    @StartRule
    Centred-->
       extrude(height)
       split(y) {
          dy : r(scopeCenter,
                 0, 360*split.index/split.total, 0)
               X
       }*
    "#;
}

cga! {
    @Allow(undefined_rule)
    grammar Report = r#"
    # report operation: the floors of a building of 30 metres
    Lot --> extrude(30) comp(f) { front : Facade }
    Facade --> split(y) { ~5 : Floor | ~0.5 : Ledge }*
    "#;
}

/// Rule and `material.name` of every leaf.
fn names(model: &Model) -> Vec<(&str, String)> {
    let name = |material: &cga::Material| material.name.as_ref().map(ToString::to_string).unwrap_or_default();
    model.leaves().map(|leaf| (leaf.rule(), name(leaf.material()))).collect()
}

fn index_of(rule: &str, shape: &Shape) -> Model {
    Index::default().generate_from(rule, shape).unwrap()
}

#[test]
fn index_and_total_run_over_the_whole_split() {
    let model = interleaved::EXAMPLE.model(&Settings::default());
    let expected: Vec<_> = (0..10).map(|at| (["A", "B"][at % 2], format!("{at} of 10"))).collect();
    assert_eq!(names(&model), expected);
}

#[test]
fn the_first_slice_is_the_lowest() {
    let model = slices::EXAMPLE.model(&Settings::default());
    assert_eq!(model.len(), 10);
    for (at, leaf) in model.leaves().enumerate() {
        assert!(near(leaf.scope().origin.y, 2.0 * at as f64) && near(leaf.size().y, 2.0));
        let color = leaf.material().color.map(|color| (color.r, color.g, color.b));
        let expected = match at {
            0 => Some((1.0, 0.0, 0.0)),
            9 => Some((0.0, 0.0, 1.0)),
            _ => None,
        };
        assert_eq!(color, expected, "slice {at}");
    }
}

#[test]
fn groups_count_on_and_splits_inside_count_for_themselves() {
    // 1, then 2 and 1 three times: seven parts, three of them split in two.
    let model = index_of("Nested", &Shape::cuboid(10.0, 1.0, 1.0));
    let expected = ["0 of 7", "1 of 7", "0 of 2", "1 of 2", "3 of 7", "0 of 2", "1 of 2", "5 of 7", "0 of 2", "1 of 2"];
    assert_eq!(names(&model).iter().map(|(_, name)| name.as_str()).collect::<Vec<_>>(), expected);
}

#[test]
fn parts_that_get_no_room_are_not_counted() {
    let model = index_of("Dropped", &Shape::cuboid(5.0, 1.0, 1.0));
    assert_eq!(names(&model), [("P", "0 of 3".into()), ("P", "1 of 3".into()), ("P", "2 of 3".into())]);
    assert!(model.leaves().map(|leaf| leaf.size().x).eq([1.0, 3.0, 1.0]));
}

#[test]
fn before_any_split_the_index_is_below_zero() {
    assert_eq!(names(&index_of("Before", &Shape::cuboid(5.0, 1.0, 1.0))), [("P", "-1 of 0".into())]);
}

/// Nine slices turned by 0, 40, … 320 degrees, about the scope's origin or its centre.
#[test]
fn slices_turn_by_their_share_of_a_full_turn() {
    let lot = Shape::rectangle(6.0, 4.0);
    for (rule, pivot) in [("Lot", [0.0, 0.0]), ("Centred", [3.0, 2.0])] {
        let model = Turned::default().generate_from(rule, &lot).unwrap();
        assert_eq!(model.len(), 9);
        for (at, leaf) in model.leaves().enumerate() {
            let (scope, angle) = (leaf.scope(), (40.0 * at as f64).to_radians());
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            // About y, x turns away from z.
            let turned = |x: f64, z: f64| (x * cos + z * sin, z * cos - x * sin);
            let x = scope.axes.x_axis;
            assert!(near(x.x, cos) && near(x.y, 0.0) && near(x.z, -sin), "{rule} {at}: {x}");
            let (x, z) = turned(-pivot[0], -pivot[1]);
            assert!(near(scope.origin.x, pivot[0] + x) && near(scope.origin.z, pivot[1] + z), "{rule} {at}");
            assert!(near(scope.origin.y, 2.0 * at as f64) && near(scope.size.y, 2.0), "{rule} {at}");
        }
    }
}

#[test]
fn thirty_metres_make_five_floors() {
    let model = Report::default().generate(&Shape::rectangle(20.0, 10.0)).unwrap();
    assert_eq!(model.counts(), [("Floor", 5), ("Ledge", 5)]);
    for leaf in model.leaves() {
        let height = if leaf.rule() == "Floor" { 60.0 / 11.0 } else { 6.0 / 11.0 };
        assert!(near(leaf.size().x, 20.0) && near(leaf.size().y, height) && near(leaf.size().z, 0.0));
    }
}
