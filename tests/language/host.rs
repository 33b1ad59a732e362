//! Rust in rules: values, functions, operations.

use std::cell::Cell;

use cga::{Color, Fault, FaultKind, Model, Shape, cga};

fn lot() -> Shape {
    Shape::rectangle(10.0, 10.0)
}

fn names(model: &Model) -> Vec<&str> {
    model.leaves().map(|leaf| leaf.rule()).collect()
}

mod items {
    use super::*;

    const HEIGHT: f64 = 4.0;
    static NAMES: [&str; 2] = ["brick", "glass"];

    fn tall() -> bool {
        true
    }

    cga! {
        grammar Items;
        attr bonus = #HEIGHT / 2
        const name = "" + #(NAMES[1])
        Lot --> case #(tall()) : Mass else : B.
        Mass --> extrude(#HEIGHT + bonus) set(material.name, #(NAMES[0]) + "/" + name) A.
    }

    #[test]
    fn a_grammar_sees_the_items_around_it() {
        let model = Items::default().generate(&lot()).expect("no limit");
        let leaf = model.leaves().next().expect("a leaf");
        assert_eq!((leaf.rule(), leaf.volume()), ("A", 600.0));
        assert_eq!(leaf.material().name.as_deref(), Some("brick/glass"));
    }

    #[test]
    fn an_attribute_that_needs_rust_is_computed_unless_it_is_given() {
        let rules = Items { bonus: Some(1.0) };
        assert_eq!(rules.generate(&lot()).expect("no limit").volume(), 500.0);
    }
}

#[test]
fn values_of_every_useful_type_are_captured() {
    let (float, double, int, byte, yes) = (0.5f32, 0.25f64, 2i32, 1u8, true);
    let (text, owned, reference) = ("a", String::from("b"), &3usize);
    let rules = cga! {
        attr height = 2
        Lot --> case #yes : Mass else : No.
        Mass --> extrude(height + #float + #double + #int + #byte + #reference + #(1i64 + 2)) Name("" + #text + #owned + #reference + #(&owned) + #yes)
        Name(name) --> set(material.name, name) Yes.
    };
    // Text was copied, not moved.
    assert_eq!(owned, "b");
    let model = rules.generate(&lot()).expect("no limit");
    let leaf = model.leaves().next().expect("a leaf");
    assert_eq!((leaf.rule(), leaf.size().y), ("Yes", 11.75));
    assert_eq!(leaf.material().name.as_deref(), Some("ab3btrue"));
}

#[test]
fn captured_values_are_evaluated_once_and_from_left_to_right() {
    let mut order = Vec::new();
    let mut next = |number: i32| {
        order.push(number);
        number
    };
    let rules = cga! {
        @Allow(unused_attribute)
        attr first = #(next(1)) + #(next(2))
        // The rule is used often, its value is not computed again.
        Lot --> extrude(#(next(3))) split(x) { { ~1 : Part(#(next(4))) }* }
        Part(n) --> s(^1, #(next(5)) + n, ^1) Part.
    };
    let (one, other) = (rules.generate(&lot()).expect("no limit"), rules.clone().generate(&lot()).expect("no limit"));
    assert_eq!(order, [1, 2, 3, 4, 5]);
    assert_eq!((one.len(), other.len(), other.volume()), (10, 10, 900.0));
}

#[test]
fn captured_values_do_not_change_later() {
    let height = Cell::new(2.0);
    let rules = cga! { Lot --> extrude(#(height.get())) A. };
    height.set(5.0);
    assert_eq!(rules.generate(&lot()).expect("no limit").volume(), 200.0);
}

#[test]
fn rules_without_a_header_have_attributes_as_fields() {
    let extra = 1;
    let mut rules = cga! {
        attr height = 2
        attr name = "a" + height
        attr tall = rand(0, 1) > 2
        Lot --> case tall : extrude(height + #extra) A. else : set(material.name, name) B.
    };
    assert_eq!(names(&rules.generate(&lot()).expect("no limit")), ["B"]);
    rules.height = 40.0;
    rules.tall = Some(true);
    rules.name = Some("x".into());
    assert_eq!(rules.generate(&lot()).expect("no limit").volume(), 4100.0);
    let (height, name): (f64, &Option<String>) = (rules.height, &rules.name);
    assert_eq!((height, name.as_deref()), (40.0, Some("x")));
}

mod functions {
    use super::*;

    fn noise(x: f64) -> f64 {
        x * 0.5
    }

    mod deeper {
        pub(crate) fn word(number: f64, text: &str, yes: bool) -> String {
            format!("{text}{number}{yes}")
        }

        pub(super) fn is_wide(width: f64) -> bool {
            5.0 < width
        }

        pub(super) fn count() -> usize {
            3
        }
    }

    cga! {
        grammar Functions;
        wide = self::deeper::is_wide(scope.sx)
        Lot --> case wide && crate::host::functions::noise(2) == 1 : Split else : Small.
        Split --> split(x) { { ~scope.sx / self::deeper::count() : Part(split.index) }* }
        Part(n) --> set(material.name, deeper::word(n, "part", n > 1)) set(scope.sy, self::noise(scope.sz)) Part.
    }

    #[test]
    fn rust_functions_compute_in_expressions() {
        let model = Functions::default().generate(&lot()).expect("no limit");
        let parts =
            model.leaves().map(|leaf| (leaf.material().name.clone().unwrap_or_default().to_string(), leaf.size().y));
        assert_eq!(
            parts.collect::<Vec<_>>(),
            [("part0false".to_string(), 5.0), ("part1false".into(), 5.0), ("part2true".into(), 5.0)]
        );
    }
}

mod operations {
    use super::*;

    fn lift(shape: &mut Shape, height: f64) {
        let mut scope = *shape.scope();
        scope.origin.y += height;
        shape.set_scope(scope);
    }

    fn paint(shape: &mut Shape, name: &str, opaque: bool) -> Result<(), Fault> {
        let Some(grey) = name.strip_prefix("grey").and_then(|grey| grey.parse::<f64>().ok()) else {
            return Err(Fault::new(format!("no colour `{name}`")));
        };
        shape.set_color(Color::new(grey / 100.0, grey / 100.0, grey / 100.0));
        shape.change_material(|material| material.opacity = (!opaque).then_some(0.5));
        Ok(())
    }

    fn break_it(shape: &mut Shape) {
        let mut scope = *shape.scope();
        scope.origin.x = f64::NAN;
        shape.set_scope(scope);
    }

    cga! {
        grammar Operations;
        attr colour = "grey50"
        Lot --> extrude(2) Upper
        Upper --> crate::host::operations::lift(scope.sy / 2) self::paint(colour, false) split(y) { ~1 : Half }
        Half --> A. [ self::lift(1) B. ] C.
        Broken --> s(1, 2, 3) self::break_it() A.
    }

    #[test]
    fn rust_operations_change_the_shape() {
        let model = Operations::default().generate(&lot()).expect("no limit");
        let leaves = model.leaves().map(|leaf| (leaf.rule(), leaf.scope().origin.y, leaf.material().color().r));
        assert_eq!(leaves.collect::<Vec<_>>(), [("A", 1.0, 0.5), ("B", 2.0, 0.5), ("C", 1.0, 0.5)]);
        assert_eq!(model.faults(), []);
    }

    #[test]
    fn a_fault_of_an_operation_is_in_the_model_with_its_trail() {
        let rules = Operations { colour: "mauve".into() };
        let model = rules.generate(&lot()).expect("faults end no run");
        assert_eq!(names(&model), ["A", "B", "C"]);
        let [fault] = model.faults() else { panic!("{:?}", model.faults()) };
        assert_eq!((fault.kind, fault.trail.join(" ")), (FaultKind::Host, "Lot Upper".to_owned()));
        assert_eq!(fault.to_string(), "no colour `mauve` (in Lot > Upper)");
    }

    #[test]
    fn an_operation_cannot_bring_in_what_is_no_number() {
        let model = Operations::default().generate_from("Broken", &lot()).expect("faults end no run");
        assert_eq!(model.leaves().next().expect("a leaf").size().to_array(), [1.0, 2.0, 3.0]);
        let [fault] = model.faults() else { panic!("{:?}", model.faults()) };
        assert_eq!((fault.kind, fault.trail.join(" ")), (FaultKind::Value, "Broken".to_owned()));
    }
}

mod closures {
    use super::*;

    #[test]
    fn what_a_value_borrows_need_not_outlive_it() {
        let rules = {
            let text = String::from("short-lived");
            cga! { Lot --> set(material.name, #text) A. }
        };
        let model = rules.generate(&lot()).expect("no limit");
        assert_eq!(model.leaves().next().expect("a leaf").material().name.as_deref(), Some("short-lived"));
    }

    #[test]
    fn a_value_may_leave_the_function_early() -> Result<(), std::num::ParseIntError> {
        let rules = cga! { Lot --> extrude(#("12".parse::<i32>()?)) A. };
        assert_eq!(rules.generate(&lot()).expect("no limit").volume(), 1200.0);
        Ok(())
    }
}

mod arrays {
    use super::*;
    use cga::{Array, Text};

    const WIDTHS: [f64; 3] = [1.0, 2.0, 3.0];
    static NAMES: &[&str] = &["brick", "glass"];

    /// Arguments that rules pass are `&Array`, or `&Array<Text>` for text.
    fn halves(list: &Array<f64>, by: f64) -> Vec<f64> {
        list.as_slice().iter().map(|number| number / by).collect()
    }

    fn doors(list: &Array<bool>, names: &Array<Text>) -> [String; 2] {
        let open = list.as_slice().iter().filter(|door| **door).count();
        [format!("{open} open"), names.as_slice().iter().map(Text::as_str).collect::<Vec<_>>().join("+")]
    }

    fn rows(list: &Array<f64>) -> Array<f64> {
        list.iter_rows().map(|row| row.iter().sum::<f64>()).collect()
    }

    fn is_odd(list: &Array<f64>) -> Vec<bool> {
        list.into_iter().map(|number| number % 2.0 == 1.0).collect()
    }

    fn place(shape: &mut Shape, at: &Array<f64>, names: &Array<Text>) -> Result<(), Fault> {
        let [x, y] = at.as_slice() else { return Err(Fault::new(format!("{} numbers", at.len()))) };
        let mut scope = *shape.scope();
        (scope.origin.x, scope.origin.y) = (*x, *y);
        shape.set_scope(scope);
        let name = names.get(0).map_or("", Text::as_str);
        shape.change_material(|material| material.name = Some(name.into()));
        Ok(())
    }

    fn lines(model: &Model) -> Vec<String> {
        model.prints().iter().map(|line| line.to_string()).collect()
    }

    cga! {
        grammar Arrays;
        attr widths = [floatArray(#WIDTHS), 4]
        kinds = [stringArray(#NAMES), "stone"]
        total(list) = sum(self::halves(list, 2))
        Lot --> print(widths) print(kinds[2]) print(total(widths)) print(stringArray(self::doors([true, false, true], kinds)))
                print(self::rows([1, 2; 3, 4]) .+ 0) print(widths[boolArray(self::is_odd(widths))]) print("" + self::halves([9], 2)[0])
                self::place([3, 4], kinds) Placed.
        Broken --> self::place([3], kinds) X.
    }

    #[test]
    fn items_are_arrays_in_rules_and_rust_gets_and_gives_arrays() {
        let model = Arrays::default().generate(&lot()).expect("no limit");
        assert_eq!(
            lines(&model),
            ["(4)[1,2,3,4]", "stone", "5", "(2)[2 open,brick+glass+stone]", "(2)[3,7]", "(2)[1,3]", "4.5"]
        );
        let leaf = model.leaves().next().expect("a leaf");
        assert_eq!((leaf.scope().origin.x, leaf.scope().origin.y), (3.0, 4.0));
        assert_eq!(leaf.material().name.as_deref(), Some("brick"));
        assert_eq!(model.faults(), []);
        let model = Arrays::default().generate_from("Broken", &lot()).expect("faults end no run");
        assert_eq!(model.faults()[0].message, "1 numbers");
        let given = Arrays { widths: Some([5.0].into()) };
        assert_eq!(lines(&given.generate(&lot()).expect("no limit"))[0], "(1)[5]");
    }

    #[test]
    fn arrays_of_every_useful_type_are_captured() {
        let (vector, slice, names): (Vec<i32>, &[f32], &[&str]) = (vec![1, 2], &[0.5], &["a", "b"]);
        let (owned, truths, yes, own) =
            (vec![String::from("c")], [true, false], true, Array::from(vec![vec![1.0], vec![2.0]]));
        let rules = cga! {
            attr list = [floatArray(#vector), floatArray(#slice)]
            Lot --> print(list) print([stringArray(#names); stringArray(#owned), "d"]) print(.!#truths) print(#own[1, 0]) print(sum(#(vec![1.0, 2.0])))
                    print(size(stringArray(#names))) print(sum(#(&vector))) print(#vector .* 2) print(floatArray(#own)) print(float(#(3u8))) print(bool(#yes)) print(str(#yes))
        };
        assert_eq!((vector.len(), owned.len()), (2, 1), "they were copied");
        let model = rules.generate(&lot()).expect("no limit");
        assert_eq!(
            lines(&model),
            [
                "(3)[1,2,0.5]",
                "(2x2)\n   a   b\n   c   d",
                "(2)[false,true]",
                "2",
                "3",
                "2",
                "3",
                "(2)[2,4]",
                "(2x1)\n   1\n   2",
                "3",
                "true",
                "true",
            ]
        );
    }
}
