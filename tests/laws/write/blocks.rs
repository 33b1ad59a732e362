//! Ends of bodies: splits, comps, branches, brackets, calls and leaves.

use super::{Here, RULES, Writer};

/// Conditions of branches.
const CONDITIONS: &[&str] = &[
    "geometry.area > $N",
    "geometry.volume > $N",
    "geometry.isClosedSurface",
    "geometry.isRectangular(1)",
    "geometry.isOriented($W)",
    "geometry.isConcave",
    "geometry.nFaces > 2",
    "geometry.nVertices == 4",
    "geometry.height > b",
    "scope.sx > scope.sz",
    "scope.sy < 0",
    "comp.index % 2 == 0",
    "split.index == 0",
    "on && geometry.isPlanar(1)",
];

/// Selectors of faces; edges and vertices have the same.
const SELECTORS: &[&str] = &[
    "$F",
    "$F",
    "$F",
    "$F",
    "$F",
    "$I",
    "all",
    "isTagged(\"$J\")",
    "!isTagged(\"$J\")",
    "$F && geometry.area > $N",
    "$F || $F",
    "!$F",
    "comp.index == 1",
];

impl Writer {
    /// The body of a rule or of a block.
    pub(super) fn body(&mut self, here: Here) {
        if 0 < here.depth && self.chance(15) {
            return self.branches(here);
        }
        self.steps(here);
        if self.chance(30) {
            self.watch(here);
        }
        match self.random.below(24) {
            0..6 if 0 < here.depth => self.split(here),
            6..12 if 0 < here.depth => self.comp(here),
            12 if 0 < here.depth => self.areas(here),
            20 if 0 < here.depth => self.setback(here),
            13 | 14 if 0 < here.depth => {
                self.line(here, "[");
                self.body(here.deeper());
                self.line(here, "]");
                self.steps(here);
                self.call(here);
            }
            15 => self.line(here, "NIL"),
            17 if 0 < here.depth => self.division(here, &mut Self::body),
            18 if 0 < here.depth => self.points(here, &mut Self::body),
            19 if 0 < here.depth => {
                self.inlined(here, &mut Self::body);
                // A rule that divides the sum where the parts were divided cuts through points, up to rounding.
                self.line(here, "rotateScope(0, 17.31, 7.31)");
                self.steps(here);
                self.call(here);
            }
            16 => {
                self.call(here);
                self.steps(here);
                self.call(here);
            }
            _ => self.call(here),
        }
    }

    /// A call of a rule further down, a recursion, or a leaf.
    fn call(&mut self, here: Here) {
        if here.rule + 1 < RULES.len() && self.chance(55) {
            let rule = here.rule + 1 + self.random.below(RULES.len() - here.rule - 1);
            return self.line(here, &format!("{}(d)", RULES[rule]));
        }
        if self.chance(30) {
            let rule = *self.random.pick(&RULES);
            return self.line(here, &format!("[ case d > 0 : {rule}(d - 1) else : Stop. ]"));
        }
        let leaf = *self.random.pick(&["Wall.", "Window.", "Roof."]);
        self.line(here, leaf);
    }

    fn branches(&mut self, here: Here) {
        if self.chance(30) {
            self.line(here, "[ 40% :");
        } else {
            let condition = if self.chance(15) { self.texture_condition() } else { self.fill(CONDITIONS) };
            self.line(here, &format!("[ case {condition} :"));
        }
        self.body(here.deeper());
        self.line(here, "else :");
        self.body(here.deeper());
        self.line(here, "]");
    }

    fn split(&mut self, here: Here) {
        let head = match self.chance(15) {
            true => self.texture_split(),
            false => self.fill(&["split($X)", "split($X)", "split($X, adjust)", "split($X, noAdjust)"]),
        };
        self.line(here, &format!("{head} {{"));
        self.slots(here, 0);
        let star = if self.chance(30) { "}*" } else { "}" };
        self.line(here, star);
    }

    fn slots(&mut self, here: Here, nested: usize) {
        // The part of the scope that the slots so far take. A slot beyond the end would be a warning, and it would be true.
        let mut taken = 0.0;
        for slot in 0..1 + self.random.below(3) {
            let bar = if slot == 0 { " " } else { "|" };
            if nested < 2 && self.chance(20) {
                self.line(here, &format!("{bar} {{"));
                self.slots(Here { indent: here.indent + 1, ..here }, nested + 1);
                self.line(here, "}*");
                continue;
            }
            let mut size = self.fill(&["$L", "$L", "'0.2713", "'0.4117", "'c", "~$L", "~1", "~b"]);
            if let Some(part) = size.strip_prefix('\'') {
                // `c` is an attribute with this default.
                taken += part.parse().unwrap_or(0.613);
                if taken > 1.0 {
                    size = "~b".to_owned();
                }
            }
            self.line(here, &format!("{bar} {size} :"));
            self.body(here.deeper());
        }
    }

    fn areas(&mut self, here: Here) {
        let head = self.fill(&["splitArea($X)", "splitArea($X, adjust)", "splitArea($X, noAdjust)"]);
        self.line(here, &format!("{head} {{"));
        for slot in 0..1 + self.random.below(2) {
            let bar = if slot == 0 { " " } else { "|" };
            let size = self.fill(&["'0.3117", "'0.5713", "2.317", "~1", "a"]);
            self.line(here, &format!("{bar} {size} :"));
            self.body(here.deeper());
        }
        let star = if self.chance(40) { "}*" } else { "}" };
        self.line(here, star);
    }

    fn setback(&mut self, here: Here) {
        let head = self.fill(&["setback($N)", "setback(0.2317)", "setback(c * 0.5)", "shapeL(0.1731, 0.4117)"]);
        self.line(here, &format!("{head} {{"));
        let arms: &[&str] = match head.starts_with("shape") {
            true => &["shape", "remainder"],
            false => &["$W", "isTagged(\"$J\")", "remainder"],
        };
        for (number, selector) in arms.iter().enumerate() {
            let bar = if number == 0 { " " } else { "|" };
            let selector = self.fill(&[*selector]);
            let joined = *self.random.pick(&[":", "="]);
            self.line(here, &format!("{bar} {selector} {joined}"));
            if self.chance(40) {
                self.watch(here.deeper());
            }
            self.body(here.deeper());
        }
        self.line(here, "}");
    }

    fn comp(&mut self, here: Here) {
        let kind = *self.random.pick(&["f", "f", "f", "f", "f", "e", "fe", "fe", "v", "fv", "g", "m", "h"]);
        let align = *self.random.pick(&["", "", ", zUp", ", noAlign"]);
        let head = self.fill(&[&format!("comp({kind}{align})")]);
        self.line(here, &format!("{head} {{"));
        for arm in 0..1 + self.random.below(4) {
            let bar = if arm == 0 { " " } else { "|" };
            let selector = match kind {
                "g" | "m" | "h" => (*self.random.pick(&["all", "0", "$F"])).replace("$F", "front"),
                _ => self.fill(SELECTORS),
            };
            let joined = *self.random.pick(&[":", ":", ":", "=", "=:"]);
            self.line(here, &format!("{bar} {selector} {joined}"));
            let arm = here.deeper();
            if self.chance(40) {
                self.watch(arm);
            }
            match kind {
                // Edges and points show nothing unless something is put there.
                "e" | "fe" if self.chance(60) => {
                    let step =
                        self.fill(&["extrude($D)", "s('1, $N, $N) primitiveCube()", "s('1, $N, 0) primitiveQuad()"]);
                    self.line(arm, &step);
                }
                "v" | "fv" if self.chance(60) => {
                    let step = self.fill(&["primitiveCube($N, $N, $N)", "s($N, $N, $N) primitiveCube()"]);
                    self.line(arm, &step);
                }
                _ => {}
            }
            self.body(arm);
        }
        self.line(here, "}");
    }
}
