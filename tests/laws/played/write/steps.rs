//! Steps of rules.

use super::{Here, RULES, Writer};

const SELECTORS: [&str; 22] = [
    "front",
    "front",
    "back",
    "left",
    "right",
    "top",
    "bottom",
    "side",
    "side",
    "all",
    "vertical",
    "horizontal",
    "aslant",
    "nutant",
    "object.front",
    "world.up",
    "0",
    "1",
    "front",
    "top",
    "top",
    "bottom",
];

impl Writer {
    /// Writes the body of a rule.
    pub(super) fn body(&mut self, here: Here) {
        if 0 < here.depth && self.chance(35) {
            return self.branches(here, None);
        }
        let mark = self.mark();
        self.line(here, &format!("print({mark})"));
        self.steps(here);
    }

    /// Steps, and what becomes of the shape.
    pub(super) fn steps(&mut self, here: Here) {
        self.plain_steps(here);
        match self.random.below(20) {
            0..10 if 0 < here.depth => self.split(here),
            10..13 if 0 < here.depth => self.comp(here),
            13 if 0 < here.depth => {
                self.line(here, "[");
                self.body(here.deeper());
                self.line(here, "]");
                self.call(here);
            }
            14 => self.line(here, "NIL"),
            _ => self.call(here),
        }
    }

    /// Branches, about the same subject as those around them or any.
    fn branches(&mut self, here: Here, subject: Option<String>) {
        if self.chance(15) {
            return self.chances(here);
        }
        let subject = subject.unwrap_or_else(|| self.subject(here));
        for _ in 0..1 + self.random.below(2) {
            let condition = if self.chance(75) { self.about(here, &subject) } else { self.condition(here, 1) };
            self.line(here, &format!("case {condition} :"));
            self.branch(here.deeper(), &subject);
        }
        self.line(here, "else :");
        self.branch(here.deeper(), &subject);
    }

    fn chances(&mut self, here: Here) {
        let percent = self.of(&["0", "50", "100", "30"]);
        self.line(here, &format!("{percent}% :"));
        self.branch(here.deeper(), "a");
        self.line(here, "else :");
        self.branch(here.deeper(), "a");
    }

    fn branch(&mut self, here: Here, subject: &str) {
        if 0 < here.depth && self.chance(40) {
            return self.branches(here, Some(subject.into()));
        }
        let mark = self.mark();
        self.line(here, &format!("print({mark})"));
        self.steps(here);
    }

    fn comp(&mut self, here: Here) {
        if self.chance(70) {
            let size = self.of(&["s(3, 4, 5)", "s(10, 4, 10)", "s(a, 3, 2)", "s('1, 2, '1)"]);
            self.line(here, &format!("{size} primitiveCube()"));
        }
        let kind = self.of(&["f", "f", "f", "f", "e", "v", "fe", "g", "f, zUp"]);
        self.line(here, &format!("comp({kind}) {{"));
        for arm in 0..1 + self.random.below(5) {
            let selector =
                if kind.starts_with('f') && kind != "fe" { self.of(&SELECTORS) } else { self.of(&["all", "0", "1"]) };
            let (bar, mode) = (if arm == 0 { " " } else { "|" }, self.of(&[":", ":", ":", ":", "="]));
            let mark = self.mark();
            self.line(here, &format!("{bar} {selector} {mode} print({mark})"));
            if kind.starts_with('f') && self.chance(12) {
                if self.chance(50) {
                    let depth = self.of(&["scope.sx", "scope.sy", "abs(a)", "'1"]);
                    self.line(here.deeper(), &format!("s('1, '1, {depth})"));
                }
                if self.chance(20) {
                    self.line(here.deeper(), "primitiveCube()");
                }
                self.split_along(here.deeper(), "z");
            } else {
                self.steps(here.deeper());
            }
        }
        self.line(here, "}");
    }

    /// Whom a shape goes to.
    fn call(&mut self, here: Here) {
        if here.rule < RULES.len() && self.chance(60) {
            let rule = here.rule + self.random.below(RULES.len() - here.rule);
            let depth = here.params.first().unwrap_or(&"1");
            let args = self.args(here, rule);
            return self.line(here, &format!("{}({depth}{args})", RULES[rule]));
        }
        if !here.params.is_empty() && self.chance(25) {
            let rule = self.random.below(RULES.len());
            let args = self.args(here, rule);
            return self.line(here, &format!("[ case d > 0 : {}(d - 1{args}) else : Stop. ]", RULES[rule]));
        }
        let leaf = self.of(&["Wall.", "Window.", "Roof."]);
        self.line(here, leaf);
    }

    /// Arguments behind the depth.
    pub(super) fn args(&mut self, here: Here, rule: usize) -> String {
        (0..self.params[rule]).map(|_| format!(", {}", self.number(here, 1))).collect()
    }

    /// Steps that divide nothing.
    pub(super) fn plain_steps(&mut self, here: Here) {
        for _ in 0..*self.random.pick(&[0, 0, 1, 1, 2]) {
            let step = self.step(here);
            self.line(here, &step);
        }
    }

    fn length(&mut self, here: Here) -> String {
        match self.random.below(10) {
            0..4 => "'1".into(),
            4 => format!("'{}", self.of(&["0.5", "2", "0.1", "a"])),
            5..9 => self.of(&["1", "2", "3", "5", "10", "0.5", "20", "1", "4", "0"]).into(),
            _ => self.number(here, 1),
        }
    }

    fn step(&mut self, here: Here) -> String {
        match self.random.below(20) {
            0..5 => format!("s({}, {}, {})", self.length(here), self.length(here), self.length(here)),
            5 | 6 => format!("extrude({})", self.of(&["1", "3", "10", "a", "b - 1", "f(2)", "0"])),
            7 => "primitiveCube()".into(),
            8 => self.of(&["primitiveQuad()", "primitiveCylinder()", "i(\"builtin:cube\")", "offset(-0.3)"]).into(),
            9 => format!("t({}, 0, {})", self.number(here, 1), self.length(here)),
            10 => format!("r({}, {}, 0)", self.of(&["0", "90", "30"]), self.of(&["0", "90", "180", "17"])),
            11 => self
                .of(&[
                    "alignScopeToAxes()",
                    "alignScopeToAxes(y)",
                    "rotateScope(0, 90, 0)",
                    "mirrorScope(true, false, false)",
                    "reverseNormals()",
                    "mirror(true, false, true)",
                    "alignScopeToGeometry(yUp, 0, 0)",
                ])
                .into(),
            12 => format!("set(scope.{}, {})", self.of(&["sx", "sy", "sz"]), self.of(&["1", "4", "0", "a", "0.5"])),
            13 => format!("set(u, {})", self.number(here, 1)),
            14 => "center(xz)".into(),
            15 | 16 => {
                let (mark, by) =
                    (self.mark(), self.of(&["0", "a", "(a - a)", "m", "abs(b)", "0 * 2", "(3 - 3)", "scope.sz"]));
                format!("print(quotient({mark}, {} {} {by}))", self.number(here, 1), self.of(&["/", "/", "%"]))
            }
            17 => format!("print({})", self.place(Here { depth: 2, ..here })),
            18 => format!("print(tell({}))", self.number(here, 1)),
            _ => "color(\"#00ff00\")".into(),
        }
    }
}
