//! Shapes that are almost nothing or almost too large: sinks get finite numbers only.

use cga::{Error, Limits, Settings, Shape, cga};
use cga_tests::stopped::{Every, rules};

use super::stopping;

/// Long runs end after as many questions to their watch.
const QUESTIONS: u64 = 30;

#[test]
fn leaves_are_finite_for_every_operation_on_every_size() {
    const SIZES: [[f64; 2]; 5] = [[5e-324, 1.0], [1e-310, 1e-310], [1.0, 1e-200], [1e100, 5e-324], [1e100, 1e100]];
    let limits = Limits { vertices: 6_000, shapes: 2_000, ..Limits::default() };
    let mut broken = Vec::new();
    for rule in rules() {
        for [width, depth] in SIZES {
            let watch = Some(stopping::after(QUESTIONS));
            let settings = Settings { start: Some(rule.to_string()), limits, watch, ..Settings::default() };
            let model = match Every::default().generate_with(&Shape::rectangle(width, depth), &settings) {
                Ok(model) => model,
                Err(Error::Limit { .. } | Error::Shape(_)) => continue,
                Err(error) => panic!("{rule}: {error}"),
            };
            let is_finite = |leaf: cga::LeafView<'_>| {
                let (mesh, placement) = leaf.mesh();
                mesh.points().iter().all(|point| placement.transform_point3(*point).is_finite())
            };
            if !model.leaves().all(is_finite) {
                broken.push(format!("{rule} on {width} by {depth}"));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

cga! {
    /// Boxes in scopes that are thin, whose sizes the macro knows or reads from an attribute.
    grammar Thin;
    attr thin = 1e-9
    attr thick = 2e-9
    @StartRule
    KnownThin  --> s(1e-9, 1, 1) Parts
    @StartRule
    ReadThin   --> s(thin, 1, 1) Parts
    @StartRule
    KnownThick --> s(1, 2e-9, 1) Parts
    @StartRule
    ReadThick  --> s(1, thick, 1) Parts
    Parts --> primitiveCube() split(x) { 0.25 : A. | ~1 : B. | 0.25 : A. }
}

#[test]
fn known_sizes_that_are_too_thin_follow_from_the_others() {
    let made = |start: &str| {
        let model = Thin::default().generate(&Shape::rectangle(3.0, 3.0).start(start)).expect("a model");
        assert!(model.faults().is_empty(), "{start}: {:?}", model.faults());
        (
            model.counts().into_iter().map(|(rule, count)| (rule.to_owned(), count)).collect::<Vec<_>>(),
            model.bounds().size(),
        )
    };
    assert_eq!(made("KnownThin"), made("ReadThin"));
    assert_eq!(made("KnownThin").1, cga::glam::DVec3::ONE);
    assert_eq!(made("KnownThick"), made("ReadThick"));
}
