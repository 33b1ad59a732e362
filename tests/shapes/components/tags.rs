//! `isTagged`, by the tags that `extrude` gives (*comp operation*, *Geometry tagging*).

use cga::{Grammar, Shape, cga};

use super::run;

cga! {
    @Allow(rule_not_reached)
    grammar Tags;

    // Each part of an extrusion, of a box and of a footprint with a hole.
    @StartRule Parts --> extrude(4) comp(f) {
        isTagged("extrude.bottom") : Bottom. | isTagged("extrude.side.outer") : Outer. |
        isTagged("extrude.side.inner") : Inner. | isTagged("extrude.top") : Top. | all : Other. }
    // All sides at once, by their common part; and with a part left open.
    Sides --> extrude(4) comp(f) { isTagged("extrude.side") : Side. | isTagged("?.top") : Top. | isTagged("*.bottom") : Bottom. }
    // Of a split building only the first storey has the bottom, and only the last the top; cuts have no tags.
    Storeys --> extrude(9) split(y) { 3 : Storey }*
    Storey --> comp(f) { isTagged("extrude.bottom") : Bottom. | isTagged("extrude.top") : Top. |
        isTagged("extrude") : Side. | all : Cut. }
    // Edges and vertices by the faces around them.
    Edges --> extrude(4) comp(e) { isTagged("extrude.top") : extrude(1) Top. | isTagged("extrude.bottom") : extrude(1) Bottom. |
        all : extrude(1) Upright. }
    Ends --> extrude(4) comp(e) { isTagged("extrude.bottom", v) : extrude(1) Touches. | all : extrude(1) Other. }
    Vertices --> extrude(4) comp(v) { isTagged("extrude.bottom") : primitiveCube() Bottom. | all : primitiveCube() Other. }
    // Faces by those beside them.
    Beside --> extrude(4) comp(f) { isTagged("extrude.bottom", e) && !isTagged("extrude.bottom") : Beside. | all : Other. }
    // Primitives have no tags.
    Primitive --> extrude(4) primitiveCube() comp(f) { isTagged("extrude") : Tagged. | all : Plain. }
    // A second extrusion gives new ones.
    Again --> extrude(4) comp(f) { isTagged("extrude.top") : Roof }
    Roof --> extrude(1) comp(f) { isTagged("extrude.top") : Top. | isTagged("extrude.side") : Side. | all : Bottom. }
}

/// The leaves of a start rule, by name.
fn counts(start: &str, shape: &Shape) -> Vec<(&'static str, usize)> {
    let model = run(&Tags::default() as &dyn Grammar, start, shape);
    let mut counts: Vec<_> =
        model.counts().into_iter().map(|(rule, count)| (&*rule.to_owned().leak(), count)).collect();
    counts.sort_unstable();
    counts
}

fn yard() -> Shape {
    let square = |low: f64, high: f64| vec![[low, low], [high, low], [high, high], [low, high]];
    Shape::footprint(&square(0.0, 9.0), &[square(3.0, 6.0)]).expect("a lot")
}

#[test]
fn the_parts_of_an_extrusion_are_told_apart() {
    let lot = Shape::rectangle(4.0, 3.0);
    assert_eq!(counts("Parts", &lot), [("Bottom", 1), ("Outer", 4), ("Top", 1)]);
    assert_eq!(counts("Parts", &yard()), [("Bottom", 1), ("Inner", 4), ("Outer", 4), ("Top", 1)]);
    assert_eq!(counts("Sides", &lot), [("Bottom", 1), ("Side", 4), ("Top", 1)]);
    assert_eq!(counts("Sides", &yard()), [("Bottom", 1), ("Side", 8), ("Top", 1)]);
}

#[test]
fn cuts_have_no_tags() {
    let storeys = [("Bottom", 1), ("Cut", 4), ("Side", 12), ("Top", 1)];
    assert_eq!(counts("Storeys", &Shape::rectangle(4.0, 3.0)), storeys);
    let yard = [("Bottom", 1), ("Cut", 4), ("Side", 24), ("Top", 1)];
    assert_eq!(counts("Storeys", &self::yard()), yard);
}

#[test]
fn edges_vertices_and_neighbours_have_the_tags_of_faces() {
    for (shape, n) in [(Shape::rectangle(4.0, 3.0), 4), (yard(), 8)] {
        assert_eq!(counts("Edges", &shape), [("Bottom", n), ("Top", n), ("Upright", n)]);
        assert_eq!(counts("Ends", &shape), [("Other", n), ("Touches", 2 * n)]);
        assert_eq!(counts("Vertices", &shape), [("Bottom", n), ("Other", n)]);
        assert_eq!(counts("Beside", &shape), [("Beside", n), ("Other", 2)]);
    }
}

#[test]
fn primitives_and_new_extrusions_replace_tags() {
    let lot = Shape::rectangle(4.0, 3.0);
    assert_eq!(counts("Primitive", &lot), [("Plain", 6)]);
    assert_eq!(counts("Again", &lot), [("Bottom", 1), ("Side", 4), ("Top", 1)]);
}
