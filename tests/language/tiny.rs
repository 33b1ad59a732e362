//! Shapes that are almost nothing or almost too large: sinks get finite numbers only.

use cga::{Error, Limits, Settings, Shape};
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
