//! Changes of looks by parameters: each value has its own look, however many values there are, and wherever shapes meet them.

use cga::{Fault, Model, Settings, Shape, cga};

/// Declares rules that pass values to a rule which changes looks, and the same rules with a step that makes the shape whole before.
macro_rules! twins {
    ($($before:tt)*) => {
        cga! {
            pub(super) grammar Looks;
            @Allow(unused_attribute)
            attr dummy = 0
            attr count = 40
            attr tone = rand(0.2, 0.8)
            shade(n) = case n % 3 == 0 : "#ff0000" case n % 3 == 1 : "#00ff00" else : "#0000ff"
            list(n) = case n % 2 == 0 : ["wall.png", "roof"] else : ["roof.png", "wall"]

            Lot --> extrude(3) [ Cut ] primitiveCube() Cut
            Cut --> split(x) { { ~1 : Row(split.index) }* }
            Row(n) --> split(z) { { ~1 : Cell(n, split.index, n % 2 == 0, shade(n)) }* | ~1 : Plain }
            Cell(n, m, isEven, tint) with ( half := n / 2 ) -->
                case m == 1 : Stone(tint, "stone") Empty
                case m == 2 : split(y) { { ~0.5 : Number(n + split.index / 8) }* }
                case m == 3 : $($before)* scaleUV(0, half + 1, m) rotateUV(0, n) color(tone, n / count, half / count) Turned.
                case m == 4 : Listed(list(n), 0 * -m) Stone(tint, "wood")
                else        : $($before)* color(tint) set(material.doubleSided, isEven) set(material.opacity, half / count) Clear.
            Empty -->
            Number(n) --> $($before)* color(n / count, n / count, 0) set(material.roughness, n / count) Number. comp(f) { front : Front(n) }
            Front(n) --> $($before)* setupProjection(0, scope.xy, 1, 1) projectUV(0) translateUV(0, n, 0 - n) set(material.metallic, n / count) Front.
            Stone(tint, name) -->
                $($before)* color(tint) texture(name + ".png") set(material.normalmap, name + "_normal.png") translateUV(0, 0.25, 0) Stone.
            Listed(names, zero) --> $($before)* set(material.opacity, zero) texture(names[0]) set(material.name, names[1]) Listed.
            Plain --> color("#ffffff") set(material.opacity, 0.5) Plain.
        }
    };
}

mod by_values {
    use super::cga;
    twins!();
    pub(super) fn grammar(count: f64) -> Looks {
        Looks { count, ..Looks::default() }
    }
}

mod whole {
    use super::cga;
    twins!(set(dummy, 1));
    pub(super) fn grammar(count: f64) -> Looks {
        Looks { count, ..Looks::default() }
    }
}

fn lot(count: f64, seed: u64) -> Shape {
    Shape::rectangle(count, 6.0).seed(seed)
}

fn compare(found: &Model, faults: &[Fault], expected: &Model, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (number, (a, b)) in found.leaves().zip(expected.leaves()).enumerate() {
        assert_eq!((a.rule(), a.material()), (b.rule(), b.material()), "{what}: leaf {number}");
        assert_eq!(a.scope(), b.scope(), "{what}: leaf {number}");
        let ((a, _), (b, _)) = (a.mesh(), b.mesh());
        let near = |(a, b): (&cga::glam::DVec2, &cga::glam::DVec2)| a.abs_diff_eq(*b, 1e-9 * (1.0 + b.length()));
        assert_eq!(a.uvs().len(), b.uvs().len(), "{what}: leaf {number}");
        assert!(a.uvs().iter().zip(b.uvs()).all(near), "{what}: leaf {number}: {:?} and {:?}", a.uvs(), b.uvs());
    }
    let texts = |faults: &[Fault]| faults.iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!(texts(faults), texts(expected.faults()), "{what}");
}

#[test]
fn values_of_parameters_give_the_looks_of_whole_shapes() {
    // Few values, and more than a place keeps.
    for count in [5.0, 40.0, 300.0] {
        let (own, twin) = (by_values::grammar(count), whole::grammar(count));
        let settings = Settings::default();
        let mut session = cga::Grammar::session(&own, &settings).expect("a session");
        for seed in [1, 2, 1] {
            let lot = lot(count, seed);
            let expected = twin.generate(&lot).expect("no error");
            assert!(2.0 * 6.0 * count < expected.len() as f64);
            let alone = own.generate(&lot).expect("no error");
            compare(&alone, alone.faults(), &expected, "alone");
            let mut model = Model::new();
            let report = session.run(&lot, &mut model).expect("no error");
            compare(&model, report.faults(), &expected, "in a session");
        }
    }
}

#[test]
fn values_that_differ_in_each_leaf_are_right_beyond_all_limits() {
    cga! {
        grammar Stripes;
        Lot --> split(x) { { ~1 : Stripe(split.index / 2000, "s" + split.index) }* }
        Stripe(n, text) --> color(n, 1 - n, 0) set(material.name, text) Stripe. Named(n, text)
        Named(n, text) --> set(material.opacity, n) color("#ffffff") set(material.name, text + text) Named.
    }
    let model = Stripes::default().generate(&Shape::rectangle(2000.0, 1.0)).expect("no error");
    assert_eq!((model.count("Stripe"), model.count("Named")), (2000, 2000));
    for (number, leaf) in model.leaves().enumerate() {
        let (at, material) = (number / 2, leaf.material());
        let (n, name) = (at as f64 / 2000.0, material.name.as_ref().expect("a name").as_str());
        let color = material.color.expect("a colour");
        if leaf.rule() == "Stripe" {
            assert_eq!(([color.r, color.g, color.b], name), ([n, 1.0 - n, 0.0], &*format!("s{at}")));
        } else {
            assert_eq!((material.opacity, color.g, name), (Some(n), 1.0, &*format!("s{at}s{at}")));
        }
    }
}
