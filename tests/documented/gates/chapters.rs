//! The examples of the reference's chapters pass the gates. Exceptions are named, and each is needed.

use std::collections::BTreeSet;
use std::fmt::Write;

use cga::Settings;
use cga_gates::{Finding, GlbSurvey, back_faces, fights, holes, inside_out};
use cga_tests::drawn::Drawn;
use cga_tests::pages::{self, assets};

use super::Surveyed;
use super::fights::MOST;

/// The beginnings of the titles of examples whose pages show open surfaces, of which a viewer sees the backs.
const OPEN: &[&str] = &[
    "Boolean operations, open operands",
    "Boolean operations, reference table: inline(unify), plane, normal down",
    "Boolean operations, reference table: subtract { Blue | Green }, plane",
    "Boolean operations, reference table: union, plane, normal down",
    "Shape recomposition, Random split",
    "Shape recomposition, Shifted plane",
    "alignScopeToGeometry operation: a cylinder",
    "alignScopeToGeometry operation: y along",
    "alignScopeToGeometry operation: z along",
    "comp operation, Face split",
    "comp operation, Index-based",
    "comp operation, Logical selection: a function",
    "comp operation, Logical selection: top",
    "comp operation, Trim planes",
    "edgeAttr functions, Sampling on faces",
    "footprint operation",
    "innerRectangle operation, aligned to the world",
    "innerRectangle operation, slanting faces",
    "insertAlongUV operation, Curved surfaces",
    "modify operation, Hyperbolic grid",
    "reduceGeometry operation",
    "rotateUV operation",
    "setNormals operation, inconsistent faces",
    "setupProjection operation, Scope vs.",
    "split operation, UV Split Basics",
    "texture operation",
    // The page's roofs have no undersides beyond their walls.
    "roofGable operation, even gable roof",
    "roofGable operation, simple",
    "roofHip operation, even hip roof: true",
    "roofPyramid operation, trim planes",
];

/// Examples whose parts lie side by side without common corners, or apart.
const APART: &[&str] = &[
    "Geometry tagging, Geometry subdivision",
    "comp operation, Border and Inside Selectors: edges",
    "comp operation, Face Edge Split",
    "comp operation, Logical selection: area and border",
    "comp operation, Vertex Split",
    "comp operation, isTagged Selector",
    "innerRectangle operation, aligned to the world",
    "innerRectangle operation, slanting faces",
    "insertAlongUV operation, Curved surfaces: a sphere",
    "insertAlongUV operation, Repeating geometries",
    "modify operation, Chaikin's corner cutting",
    "roofRidge operation, component tags",
    "roofShed operation, component tags",
    "setbackPerEdge operation, comp shape geometry",
    "setbackToArea operation, setback of 300",
    "setupProjection operation, Scope vs.",
    "splitArea operation, Split with Mixture",
    "splitArea operation, adjust vs. noAdjust: adjust",
];

/// Examples whose pages put parts into one place: bars at edges, balls at corners, copies.
const TOGETHER: &[&str] = &[
    "Boolean operations, layout modeling, step 2",
    "Geometry tagging, Geometry cleanup",
    "Geometry tagging, Geometry subdivision",
    "Geometry tagging, propagation: extrude",
    "Geometry tagging, propagation: offset",
    "Geometry tagging, setback",
    "Geometry tagging, the remainder",
    "Geometry tagging, the set-up of propagation",
    "Subdivision split, Relative split: recursive",
    "comp operation, Face Vertex Split",
    "comp operation, Vertex Split",
    "footprint operation",
    "setTagsFromEdgeAttrs operation, Set",
    "shapeL operation, auto-tags",
    "shapeU operation, auto-tags",
    "translate operation",
];

/// Examples with bent faces, or slivers of a cut, whose triangles do not all look to the side of their face.
const BENT: &[&str] = &["Boolean operations, mass modeling, adding tags", "Shape recomposition, Random split"];

#[test]
fn the_examples_of_the_chapters_pass_the_gates() {
    let (mut text, mut used) = (String::new(), BTreeSet::new());
    for example in pages::all() {
        let title = example.title;
        let surveyed = Surveyed::new(Drawn::new(title, move |settings| {
            Ok((example.run)(&(example.start)(), &Settings { tree: settings.tree, ..assets::settings() })?)
        }));
        let (survey, looks) = (&surveyed.survey, &surveyed.looks);
        let gates: [(&str, usize, &'static [&'static str], Vec<Finding>); 4] = [
            ("inside out", 0, &[], inside_out(survey)),
            ("back faces", 0, OPEN, back_faces(survey, looks)),
            ("holes", 0, APART, holes(survey, looks, &[])),
            ("fights", MOST, TOGETHER, fights(survey, looks)),
        ];
        for (gate, most, exceptions, found) in gates.iter().filter(|(_, most, _, found)| most < &found.len()) {
            match exceptions.iter().find(|beginning| title.starts_with(**beginning)) {
                Some(beginning) => _ = used.insert((*gate, *beginning)),
                None => {
                    _ = write!(text, "{title}: {gate}: {} of {most}\n{}", found.len(), surveyed.report(found));
                }
            }
        }
        let turned = GlbSurvey::of(&surveyed.file).turned_normals.len();
        match BENT.iter().find(|beginning| title.starts_with(**beginning)) {
            _ if turned == 0 => {}
            Some(beginning) => _ = used.insert(("turned normals", *beginning)),
            None => _ = writeln!(text, "{title}: {turned} triangles have normals that look to their backs"),
        }
    }
    let lists = [("back faces", OPEN), ("holes", APART), ("fights", TOGETHER), ("turned normals", BENT)];
    for (gate, beginning) in lists.iter().flat_map(|(gate, list)| list.iter().map(move |beginning| (*gate, *beginning)))
    {
        if !used.contains(&(gate, beginning)) {
            let _ = writeln!(text, "{beginning}: {gate}: the exception is not needed");
        }
    }
    assert!(text.is_empty(), "{text}");
}
