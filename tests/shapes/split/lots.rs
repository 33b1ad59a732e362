//! The heights of extruded lots, which the compiler knows for its warnings.

use cga::{Shape, cga};

cga! {
    @Allow(slot_never_made, float_without_space)
    grammar Mass;
    attr tilt = 0
    attr height = 9
    Lot --> r(tilt, 2 * tilt, tilt)
        [ extrude(height) split(y) { height / 3 : Part. | height * 2 / 3 : Upper | ~1 : Beyond. } ]
        extrude(height) comp(f) { side : Side | all : NIL }
    Upper --> comp(f) { side : split(y) { height * 0.5 : Part. | ~1 : Rest. } | all : NIL }
    Side --> split(y) { height * 0.7 : Part. | height * 0.3 : Part. | ~1 : Beyond. }
}

#[test]
fn walls_of_a_lot_are_as_high_as_its_extrusion() {
    let corners = [[0.0, 0.0], [14.0, 0.0], [14.0, 12.0], [8.0, 12.0], [8.0, 7.0], [0.0, 7.0]];
    for step in 0..60 {
        let number = f64::from(step);
        let (sin, cos) = libm::sincos(0.37 * number);
        let turned = corners.map(|[x, z]: [f64; 2]| [x * cos - z * sin + 977.3 * number, x * sin + z * cos]);
        for lot in [Shape::footprint(&turned, &[]).expect("an outline"), Shape::rectangle(1.0 + number, 7.3)] {
            let mass = Mass { tilt: f64::from(step % 3) * 7.1, height: 1.0 + 0.31 * number };
            let model = mass.generate(&lot).expect("a model");
            assert_eq!(model.count("Beyond"), 0, "{mass:?}");
            assert!(4 < model.count("Part") && 4 <= model.count("Rest"), "{mass:?}");
        }
    }
}
