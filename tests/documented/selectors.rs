//! *comp operation*, Examples: which faces of a sphere each selector takes, and what the operators make of them.

use std::collections::BTreeMap;

use cga::{Model, Settings};

use cga_tests::pages::comp::{angles, operator_connected, operator_each, operator_together, quadrants};
use cga_tests::pages::example::Example;

/// Faces by colour: how many, and the sum of their normals' direction as a check of which they are.
fn by_color(example: &Example) -> BTreeMap<String, (usize, [f64; 3])> {
    let mut sums: BTreeMap<String, (usize, [f64; 3])> = BTreeMap::new();
    for leaf in example.model(&Settings::default()).leaves() {
        let color = leaf.material().color.expect("a colour");
        let name = [color.r, color.g, color.b].map(|channel| if 0.5 < channel { 'f' } else { '0' }).iter().collect();
        let z = leaf.scope().axes.z_axis;
        let sum = sums.entry(name).or_default();
        sum.0 += 1;
        [z.x, z.y, z.z].iter().zip(&mut sum.1).for_each(|(part, sum)| *sum += part);
    }
    sums
}

#[test]
fn quadrants_of_a_sphere() {
    let found = by_color(&quadrants::EXAMPLE);
    // 16 rows of 16 faces: four rows at each pole, and a quarter of the other eight to each side.
    let expected: [(&str, usize, usize, f64); 6] = [
        ("00f", 64, 1, 1.0),
        ("ff0", 64, 1, -1.0),
        ("f00", 32, 2, 1.0),
        ("f0f", 32, 2, -1.0),
        ("0ff", 32, 0, -1.0),
        ("0f0", 32, 0, 1.0),
    ];
    assert_eq!(found.len(), 6);
    for (color, count, axis, sign) in expected {
        let (faces, sum) = found[color];
        assert_eq!(faces, count, "#{color}");
        for (at, part) in sum.iter().enumerate() {
            if at == axis {
                assert!(0.7 * count as f64 <= part * sign, "#{color}: {sum:?}");
            } else {
                assert!(part.abs() < 1e-9, "#{color}: {sum:?}");
            }
        }
    }
}

#[test]
fn slopes_of_a_sphere() {
    let found = by_color(&angles::EXAMPLE);
    let counts: Vec<_> = found.iter().map(|(color, (count, _))| (color.as_str(), *count)).collect();
    // Rows of 11.25 degrees: the poles, six rows looking up, the two at the equator, six looking down.
    assert_eq!(counts, [("00f", 32), ("f00", 96), ("f0f", 96), ("ff0", 32)]);
    assert!(60.0 < found["f00"].1[1] && found["f0f"].1[1] < -60.0 && found["ff0"].1[1].abs() < 1e-9);
}

#[test]
fn each_or_all_together_or_what_is_connected() {
    let [each, together, connected] = [operator_each::EXAMPLE, operator_together::EXAMPLE, operator_connected::EXAMPLE]
        .map(|example| example.model(&Settings::default()));
    assert_eq!(each.counts(), [("Front", 6), ("Mass", 1)]);
    assert_eq!(each.materials().len(), 7, "each has drawn a colour of its own");
    assert_eq!(together.counts(), [("Front", 1), ("Mass", 1)]);
    assert_eq!(connected.counts(), [("Front", 2), ("Mass", 1)]);
    let faces = |model: &Model| model.leaves_of("Front").map(|leaf| leaf.mesh().0.face_count()).collect::<Vec<_>>();
    assert_eq!((faces(&together), faces(&connected)), (vec![6], vec![2, 4]));
    // Shapes of several faces are set up from the first of them: fronts 0, and 0 and 2.
    let axes = |model: &Model, at: usize| model.leaves_of("Front").nth(at).expect("a front").scope().axes;
    for (model, at, first) in [(&together, 0, 0), (&connected, 0, 0), (&connected, 1, 2)] {
        assert!(axes(model, at).abs_diff_eq(axes(&each, first), 1e-9), "{at}");
    }
    for model in [&together, &connected] {
        assert!((each.area() - model.area()).abs() < 1e-9);
    }
}
