//! Masses: roofs, envelopes and footprints, operations that divide faces or make points, and inlined rules.

use super::{Here, Writer};

/// Operations that make a mass of faces, or outlines of it.
pub(super) const MASSES: &[&str] = &[
    "roofHip($Z)",
    "roofHip($Z, $M, $B)",
    "roofHip(byHeight, $N, $M)",
    "roofGable($Z)",
    "roofGable($Z, $M, $M, $B)",
    "roofGable($Z, $M, 0, false, $I)",
    "roofGable(byHeight, $N, $M)",
    "roofPyramid($Z)",
    "roofPyramid(byHeight, $N)",
    "roofShed($Z, $I)",
    "roofShed(-17.31, $I)",
    "roofShed(byHeight, $N)",
    "roofRidge(byAngle, $Z)",
    "roofRidge(byHeight, $N)",
    "taper($N)",
    "taper(-0.8317)",
    "envelope(normal, $N, c, $Z)",
    "envelope(world.up, 7.31, b, $Z, c, $Z)",
    "envelope(normal, 5.13, c, $Z, 0, 90, b, $Z)",
    "envelope(world.up, a, 0.3, $Z, 0.4, $Z, 0.5, $Z, 0.6, $Z)",
    "envelope(normal, 6.17, [b, 0.7, c], [$Z, 90, $Z])",
    "envelope(world.up, 8.13, b, $Z)",
    "envelope(7.31, c, $Z)",
    "envelope(7.31, b, $Z, c, $Z)",
    "envelope(5.13, c, $Z, 0, 90, b, $Z)",
    "envelope(a, 0.3, $Z, 0.4, $Z, 0.5, $Z, 0.6, $Z)",
    "footprint()",
    "footprint()",
    "innerRect()",
];

/// Operations that divide faces by their edges.
const SETBACKS: &[&str] = &[
    "setback($M)",
    "setback($M)",
    "setback([$M, $M, 0, $M])",
    "setbackPerEdge(scope.sx * 0.1371)",
    "setbackPerEdge(case comp.index % 2 == 0 : $M else : 0.0517)",
    "setbackToArea(geometry.area * 0.6173)",
    "setbackToArea(geometry.area * 0.8171, [0.1, 0.2])",
    "setbackToArea($N, [0.1], [0.3, 0.2, 0.3, 0.4])",
    "setback($M, 1)",
    "setback([$M, 0, $M], 0)",
    "setbackPerEdge($M, 0)",
    "setbackToArea($N, 1)",
    "setbackToArea($N, [0.1], 0)",
    "setbackToArea($N, [0.1], [0.3, 0.2, 0.3, 0.4], 1)",
];

/// Selectors of edges in setbacks.
const EDGES: &[&str] = &[
    "front",
    "back",
    "left",
    "right",
    "top",
    "side",
    "all",
    "object.front",
    "object.side",
    "world.south",
    "world.east",
    "street.front",
    "street.side",
    "uv.left",
    "uv.uMax",
    "$I",
    "front || right",
    "scope.sx > $N",
    "isTagged(\"$J\")",
    "comp.index == 1",
];

/// Operations that divide faces into a part and a remainder.
const PARTED: &[&str] = &[
    "shapeL($M, $M)",
    "shapeU($M, $M, $M)",
    "shapeO($M, $M, $M, $M)",
    "innerRectangle(scope)",
    "innerRectangle(edge)",
];

const PERIMETERS: &[&str] = &[
    "splitAndSetbackPerimeter(0)",
    "splitAndSetbackPerimeter($M)",
    "splitAndSetbackPerimeter('0.1371)",
    "splitAndSetbackPerimeter(0, $I, [true, true, false, true])",
];

/// Points. Points of a normal distribution take long to prepare.
const POINTS: &[&str] = &[
    "scatter(surface, 3, uniform)",
    "scatter(volume, 3, uniform)",
    "scatter(scope, 3, uniform)",
    "scatter(scope, split.index, uniform)",
    "scatter(surface, 2, uniform)",
    "scatter(surface, 2, uniform)",
    "scatter(surface, 2, gaussian)",
    "scatter(volume, 2, gaussian, top, '0.1)",
    "scatter(scope, 2, gaussian, front, 0.371)",
];

/// Geometry at points.
const AT_POINTS: &[&str] = &["s($N, $N, $N) primitiveCube()", "primitiveQuad($N, $N)", "i(\"tree\")", "s('1, 1, '1)"];

/// Steps of the components of `modify`.
const CHANGES: &[&str] = &[
    "s('0.6173, '0.7, '1) center(xy)",
    "t(0.0713, 0, 0.1)",
    "t(0, 0, b)",
    "r(scopeCenter, 0, 0, 10)",
    "color(c, 0, 0)",
    "NIL",
];

/// Boolean operations with the rule [`TOOL`].
const BOOLEANS: &[&str] = &[
    "union { X. | Tool }",
    "subtract { X. | Tool }",
    "subtract { Tool | X. }",
    "intersect { X. | Tool }",
    "union Tool",
    "subtract Tool",
    "subtract(swap) Tool",
    "intersect Tool",
];

/// An operand of boolean operations. Its faces are in the planes of no other ones.
pub(super) const TOOL: &str = "
Tool -->
    s('0.6173, '1.1317, '0.7131) t('0.2137, '(-0.0713), '0.1317) rotateScope(7.31, 17.31, 13.71) primitiveCube() Tooled.
";

impl Writer {
    /// A division of faces. `part` writes the steps of a part.
    pub(super) fn division(&mut self, here: Here, part: &mut dyn FnMut(&mut Self, Here)) {
        match self.random.below(8) {
            0..3 => {
                let head = self.fill(SETBACKS);
                self.line(here, &format!("{head} {{"));
                for arm in 0..1 + self.random.below(2) {
                    let bar = if arm == 0 { " " } else { "|" };
                    let selector = self.fill(EDGES);
                    self.arm(here, &format!("{bar} {selector}"), part);
                }
                if self.chance(70) {
                    self.arm(here, "| remainder", part);
                }
                self.line(here, "}");
            }
            3..6 => {
                let head = self.fill(PARTED);
                self.line(here, &format!("{head} {{"));
                let labels = *self.random.pick(&[&["  shape", "| remainder"][..], &["  shape"], &["  remainder"]]);
                labels.iter().for_each(|label| self.arm(here, label, part));
                self.line(here, "}");
            }
            _ => self.perimeter(here, part),
        }
    }

    fn arm(&mut self, here: Here, selector: &str, part: &mut dyn FnMut(&mut Self, Here)) {
        let joined = *self.random.pick(&[":", ":", "="]);
        self.line(here, &format!("{selector} {joined}"));
        part(self, here.deeper());
    }

    fn perimeter(&mut self, here: Here, part: &mut dyn FnMut(&mut Self, Here)) {
        let head = self.fill(PERIMETERS);
        self.line(here, &format!("{head} {{"));
        for section in 0..1 + self.random.below(3) {
            let bar = if section == 0 { " " } else { "|" };
            let length = self.fill(&["2.317", "a", "~(a + b)", "'0.2713", "~1.713"]);
            let depth = self.fill(&["$M", "$M", "split.index * 0.0713", "rand(0.1, 0.3)"]);
            self.line(here, &format!("{bar} {length} : {depth} :"));
            part(self, here.deeper());
        }
        let star = if self.chance(30) { "}* {" } else { "} {" };
        self.line(here, star);
        self.arm(here, "  remainder", part);
        self.line(here, "}");
    }

    /// Points, with geometry at each.
    pub(super) fn points(&mut self, here: Here, part: &mut dyn FnMut(&mut Self, Here)) {
        let often = if self.chance(20) { POINTS } else { &POINTS[..6] };
        let head = self.fill(often);
        self.line(here, &format!("{head} {{"));
        let step = self.fill(AT_POINTS);
        self.line(here.deeper(), &step);
        part(self, here.deeper());
        self.line(here, "}");
    }

    /// Steps whose leaves become the current shape.
    pub(super) fn inlined(&mut self, here: Here, part: &mut dyn FnMut(&mut Self, Here)) {
        if self.chance(40) {
            let kind = *self.random.pick(&["f", "f", "f, noAlign", "fe", "e", "v", "fv"]);
            self.line(here, &format!("modify({kind}) {{"));
            for arm in 0..1 + self.random.below(2) {
                let bar = if arm == 0 { " " } else { "|" };
                let selector = self.fill(&["front", "top", "side", "$I", "all", "comp.index == 1"]);
                let joined = *self.random.pick(&[":", ":", "=", "=:"]);
                let step = self.fill(CHANGES);
                self.line(here, &format!("{bar} {selector} {joined} {step} X."));
            }
            return self.line(here, "}");
        }
        if self.chance(30) {
            let step = *self.random.pick(BOOLEANS);
            return self.line(here, step);
        }
        let head = *self.random.pick(&[
            "inline {",
            "inline(append) {",
            "inline(unify) {",
            "inline(recompose) {",
            "inline(recompose) {",
        ]);
        self.line(here, head);
        part(self, here.deeper());
        self.line(here, "}");
    }
}
