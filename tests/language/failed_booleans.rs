//! A boolean operation that fails keeps its operands.

use cga::{Settings, Shape, cga};

cga! {
    /// Solids too thin to be told from an area, of which one looks inwards.
    grammar Thin;
    @StartRule
    Union --> extrude(0.00000000001) union { Plate | Reversed } R.
    @StartRule
    Unify --> extrude(0.00000000001) inline(unify) { [ Plate ] Reversed } R.
    @StartRule
    Subtract --> extrude(0.00000000001) subtract { Plate | Reversed } R.
    @StartRule
    Intersect --> extrude(0.00000000001) intersect { Plate | Reversed } R.
    Plate --> X.
    Reversed --> reverseNormals() X.
}

#[test]
fn a_failed_boolean_keeps_its_operands() {
    for (start, plates, instead) in [
        ("Union", 2.0, "its faces are joined as they are"),
        ("Unify", 2.0, "its faces are joined as they are"),
        ("Subtract", 1.0, "its first operand stays as it is"),
        ("Intersect", 1.0, "its first operand stays as it is"),
    ] {
        let settings = Settings { start: Some(start.to_owned()), ..Settings::default() };
        let model = Thin::default().generate_with(&Shape::rectangle(1.0, 1.0), &settings).expect("no limit");
        let [fault] = model.faults() else { panic!("{start}: {:?}", model.faults()) };
        assert!(fault.message.ends_with(instead), "{start}: {fault}");
        let areas: Vec<f64> = model.leaves().map(|leaf| leaf.area()).collect();
        assert!(areas.len() == 1 && (areas[0] - 2.0 * plates).abs() < 1e-9, "{start}: {areas:?}");
    }
}
