//! Random grammars with many groups that repeat, and everything that may be found below or above them.
//!
//! Rules print and report little, so that most parts are derived from templates.

use super::masses::{MASSES, TOOL};
use super::meshes::MESHES;
use super::{Here, Writer};

/// The rules, from a façade down to its smallest parts.
const RULES: [&str; 6] = ["Facade", "Floor", "Bay", "Tile", "Pane", "Bit"];

/// Rules with a number, which repeats hand them.
const NUMBERED: [&str; 2] = ["Num", "Deep"];

const LEAVES: &[&str] = &["Wall.", "Window.", "Glass.", "Roof.", "NIL"];

const TEXT: &str = r##"attr a = 3.71
attr b = 1.37
attr c = 0.613
attr on = true
attr held = 0.4
const grey = "#808890"
const lucky = $K
half = scope.sx / 2
shown(n) = n + ";size;" + scope.sx + ";" + scope.sy + ";place;" + scope.tx + ";" + scope.ty + ";" + scope.tz +
    ";split;" + split.index + ";" + split.total + ";comp;" + comp.index + ";" + comp.sel + ";held;" + held
"##;

/// Operations that do the same wherever a shape is.
const RIGID: &[&str] = &[
    "t(0, 0, -0.0731)",
    "t('0.1, '0.1, 0)",
    "t(0.037, c * 0.1, 0)",
    "s('0.6317, '0.8, '1)",
    "s('1, '0.7113, '0.0913) center(y)",
    "s($S, $S, $S)",
    "s('(-1), '1, '1)",
    "set(scope.sx, -scope.sx)",
    "center($C)",
    "extrude(0.0831)",
    "extrude($D)",
    "extrude(0)",
    "r(0, $A, 0)",
    "r(scopeCenter, 0, 0, $A)",
    "color(\"#ff8000\")",
    "color(grey)",
    "color(\"#3060a0\")",
    "color(0.2, c, 0.7)",
    "set(material.opacity, 0.5)",
    "set(material.name, \"brick\")",
    "texture(\"wall.png\")",
    "mirrorScope(true, false, false)",
    "primitiveCube()",
    "primitiveQuad()",
    "primitiveDisk(6)",
    "reverseNormals()",
    "setPivot(xyz, 3)",
    "extrude(0.3) comp(f) { top : X. | side : Side. }",
];

/// Operations that draw, ask or tell.
const OPEN: &[&str] = &[
    "color(rand(0.1, 0.9), 0.5, 0.5)",
    "color(split.index / 10, 0.5, split.total / 40)",
    "set(material.opacity, rand(0.3, 0.7))",
    "texture(\"wall\" + split.index + \".png\")",
    "set(material.name, \"m\" + split.index)",
    "t(0, 0, rand(-0.1, 0.1))",
    "t(0, split.index * 0.013, 0)",
    "s('rand(0.5, 0.9), '1, '1)",
    "extrude(rand(0.1, 0.3))",
    "extrude(world.up, 0.2)",
    "r(0, rand(-20, 20), 0)",
    "set(held, held + 0.1)",
    "set(held, scope.sx)",
    "t(0, held * 0.1, 0)",
    "alignScopeToAxes(world.y)",
    "translate(rel, world, 0.1, 0.2, 0)",
    "rotate(rel, world, 0, 10, 0)",
    "i(\"builtin:cube\")",
    "i(\"tree\")",
    "i(\"missing\")",
    "print(shown(MARK))",
    "report(\"width\", scope.sx)",
    "report(\"index.\" + split.index, split.total)",
    "report(\"height\", scope.elevation)",
    "crate::host::tint(scope.sx + split.index)",
    "s('1, crate::host::wave(scope.sx), '1)",
    "t(0, 0, crate::host::wave(seedian) * 0.1)",
    "offset(-0.05)",
    "projectUV(0)",
    "label(\"here\")",
    "color(1 / (split.index - split.index), 0, 0)",
    "t(0, 0, lucky * 0.01)",
    "set(trim.vertical, on)",
];

const CONDITIONS: &[&str] = &[
    "scope.sx > $L",
    "scope.sx > scope.sy",
    "half > 0.4",
    "scope.sy < b",
    "on",
    "a > 3",
    "split.index % 2 == 0",
    "split.index == split.total - 1",
    "p(0.4)",
    "rand > 0.5",
    "scope.elevation > 3",
    "comp.sel == \"front\"",
    "held > 0.5",
];

impl Writer {
    /// A grammar of this kind.
    pub(super) fn repeats(&mut self) {
        let lucky = *self.random.pick(&["3", "rand(1, 9)", "floor(initialShape.origin.px)", "a + 1"]);
        self.text.push_str(&TEXT.replace("$K", lucky));
        self.text.push_str(TOOL);
        let here = Here { rule: 0, depth: 3, indent: 1 };
        self.text.push_str("\n@StartRule\nLot -->\n");
        if self.chance(50) {
            self.texture(here);
        }
        if self.chance(25) {
            self.open(here);
        }
        match self.random.below(8) {
            0 => self.row(here, "y"),
            1 => self.line(here, "Facade"),
            2 => {
                self.line(here, "[ extrude(world.up, 7.3) comp(f) { side : Facade | top : Roof. } ]");
                self.line(here, "t(0, 0, '1) Floor");
            }
            3 => self.line(here, "[ case scope.sy > 0 : comp(f) { side : Facade | all : Roof. } else : Facade ]"),
            _ => {
                self.line(here, "[ case scope.sy > 0 :");
                self.line(here, "    comp(f) { side : Facade | top : Roof. }");
                self.line(here, "else :");
                self.line(here, "    extrude(6.3) comp(f) { side : Facade | top : Bit | bottom : NIL } ]");
            }
        }
        for (rule, name) in RULES.into_iter().enumerate() {
            self.text.push_str(&format!("\n{name} -->\n"));
            // Most rules are rigid; some draw, ask or tell.
            let is_open = self.chance(25);
            let here = Here { rule, depth: if rule < 4 { 2 } else { 1 }, indent: 1 };
            if self.chance(40) {
                self.texture(here);
            }
            self.part(here, is_open);
        }
        for name in NUMBERED {
            self.text.push_str(&format!("\n{name}(n) -->\n"));
            let is_open = self.chance(40);
            let here = Here { rule: RULES.len() - 2, depth: 1, indent: 1 };
            match (name, self.random.below(3)) {
                ("Deep", 0) => self.line(here, "[ case n < 1 : X. else : split(x) { ~1 : Y. | '0.6 : Deep(n - 1) } ]"),
                ("Deep", 1) => {
                    self.line(here, "[ case n < 1 : X. else : [ s('0.3, '1, '1) X. ] t('0.1, 0, 0.01) Deep(n - 1) ]")
                }
                (_, 0) => self.line(here, "[ case n % 2 == 0 : s('1, '0.9, '1) Window. else : Wall. ]"),
                _ => self.part(here, is_open),
            }
        }
    }

    fn open(&mut self, here: Here) {
        let list = if self.chance(20) { MASSES } else { OPEN };
        let step = self.fill(list).replace("MARK", &self.mark.to_string());
        self.mark += 1;
        self.line(here, &step);
    }

    /// The body of a rule or of a slot.
    fn part(&mut self, here: Here, is_open: bool) {
        let most = if here.rule < 3 { 2 } else { 3 };
        for _ in 0..self.random.below(most) * self.random.below(2) {
            if self.chance(if here.rule < 3 { 40 } else { 25 }) {
                self.texture(here);
            } else if is_open && self.chance(60) {
                self.open(here);
            } else if self.chance(8) {
                let step = self.fill(MESHES);
                self.line(here, &step);
            } else if self.chance(85) {
                let step = self.fill(&RIGID[..RIGID.len() - 8]);
                self.line(here, &step);
            } else {
                let step = self.fill(&RIGID[RIGID.len() - 8..]);
                self.line(here, &step);
            }
        }
        let is_high = here.rule < 4;
        let drawn = self.random.below(28);
        match if here.rule < 3 && here.depth == 2 && self.chance(60) { 0 } else { drawn } {
            0..11 if 0 < here.depth && is_high => {
                let axis = match (here.rule, self.random.below(10)) {
                    (0, 0..7) => "y",
                    (_, 0) => "z",
                    (_, 1 | 2) => "y",
                    _ => "x",
                };
                self.row(here, axis);
            }
            0..5 if 0 < here.depth => self.row(here, "x"),
            11..14 if 0 < here.depth => {
                if is_open && self.chance(50) || self.chance(20) {
                    self.line(here, "[ 40% :");
                } else {
                    let range = if is_open { 0..CONDITIONS.len() } else { 0..6 };
                    let condition =
                        if self.chance(20) { self.texture_condition() } else { self.fill(&CONDITIONS[range]) };
                    self.line(here, &format!("[ case {condition} :"));
                }
                self.part(here.deeper(), is_open);
                self.line(here, "else :");
                self.part(here.deeper(), is_open);
                self.line(here, "]");
            }
            14 | 15 if 0 < here.depth => {
                let arms = self.fill(&[
                    "front : %G | all : Side.",
                    "front : %G | side : %G | top = %G",
                    "0 : %G | all : NIL",
                    "horizontal : Flat. | vertical : %G",
                    "world.up : Flat. | all : %G",
                    "object.front : %G | all : Side.",
                    "aslant : %G | all = Side.",
                ]);
                let arms = self.calls(here, &arms);
                let head = *self.random.pick(&["comp(f)", "comp(f)", "comp(f, noAlign)", "extrude(0.21) comp(f)"]);
                self.line(here, &format!("{head} {{ {arms} }}"));
            }
            16 => {
                let arm = self.target(here);
                self.line(here, &format!("[ t(0, 0, '0.1) {arm} ]"));
                let arm = self.target(here);
                self.line(here, &arm);
            }
            18 | 19 if 0 < here.depth => self.division(here, &mut |writer, here| writer.part(here, is_open)),
            20 if 0 < here.depth => self.points(here, &mut |writer, here| writer.part(here, is_open)),
            21 if 0 < here.depth => {
                self.inlined(here, &mut |writer, here| writer.part(here, is_open));
                let arm = self.target(here);
                self.line(here, &arm);
            }
            17 if 0 < here.depth => {
                let arms = self.calls(here, "all : s('1, 0.1, 0.1) primitiveCube() %G");
                self.line(here, &format!("comp(fe) {{ {arms} }}"));
            }
            _ => {
                let arm = self.target(here);
                self.line(here, &arm);
            }
        }
    }

    /// Replaces each `%G` by a call.
    fn calls(&mut self, here: Here, text: &str) -> String {
        let mut parts = text.split("%G");
        let mut all = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            all += &self.target(here);
            all += part;
        }
        all
    }

    /// A call of a rule further down, or a leaf.
    fn target(&mut self, here: Here) -> String {
        match self.random.below(20) {
            drawn @ 0..15 if here.rule + 1 < RULES.len() && (drawn < 11 || here.rule < 3 && self.chance(70)) => {
                let next = here.rule + 1 + self.random.below(2);
                RULES[next.min(RULES.len() - 1)].to_owned()
            }
            11 if here.rule + 2 < RULES.len() => "Num(split.index)".to_owned(),
            12 if here.rule + 2 < RULES.len() => "Num(3)".to_owned(),
            13 if here.rule + 2 < RULES.len() => "Deep(3)".to_owned(),
            14 if here.rule + 2 < RULES.len() => "Num(scope.sx)".to_owned(),
            // A recursion that ends because shapes shrink.
            15 => format!("[ case scope.sx > 2.1 : s('0.4, '0.9, '1) {} else : Stop. ]", RULES[here.rule.min(5)]),
            _ => (*self.random.pick(LEAVES)).to_owned(),
        }
    }

    /// A split with groups that repeat.
    fn row(&mut self, here: Here, axis: &str) {
        let adjust = *self.random.pick(&["", "", "", ", noAdjust", ", adjust"]);
        let head = if self.chance(8) { self.texture_split() } else { format!("split({axis}{adjust})") };
        self.line(here, &format!("{head} {{"));
        let groups = 1 + self.random.below(3);
        let with = self.random.below(groups);
        for slot in 0..groups {
            let bar = if slot == 0 { " " } else { "|" };
            if slot == with || self.chance(30) {
                self.line(here, &format!("{bar} {{"));
                self.turns(here.deeper(), axis, 0);
                self.line(here, "}*");
            } else {
                self.slot(here.deeper(), bar, axis);
            }
        }
        self.line(here, "}");
    }

    /// The slots of a group.
    fn turns(&mut self, here: Here, axis: &str, nested: usize) {
        for slot in 0..1 + self.random.below(3) {
            let bar = if slot == 0 { " " } else { "|" };
            if nested < 1 && self.chance(12) {
                self.line(here, &format!("{bar} {{"));
                self.turns(Here { indent: here.indent + 1, ..here }, axis, nested + 1);
                self.line(here, "}*");
            } else {
                self.slot(here, bar, axis);
            }
        }
    }

    fn slot(&mut self, here: Here, bar: &str, axis: &str) {
        let sizes =
            ["~(scope.s? * 0.2371)", "~(scope.s? * 0.171)", "'0.2", "'0.2713", "~$L", "~b", "$L", "~a", "0.31", "~1"];
        let size = self.fill(&sizes).replace('?', axis);
        if self.chance(80) {
            // A call alone: the group can be derived from a template.
            let target = self.target(here);
            return self.line(here, &format!("{bar} {size} : {target}"));
        }
        self.line(here, &format!("{bar} {size} :"));
        let is_open = self.chance(15);
        self.part(here.deeper(), is_open);
    }
}
