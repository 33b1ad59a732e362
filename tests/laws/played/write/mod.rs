//! Random grammars.
//!
//! Prints show which places a run passes. A number from [`FIRST_MARK`] on stands for itself: a place. Splits note in an
//! attribute, which their pieces inherit, how large the shape is and what the sizes are; pieces print that and their own
//! length; quotients are printed as they are.

mod splits;
mod steps;
mod tails;
mod values;

use crate::random::Random;

/// Places are numbered from there on; rules have no numbers that large but these.
pub(crate) const FIRST_MARK: u32 = 1001;

/// The attributes and functions with which rules print.
const TOOLS: &str = r#"attr at = ""
seen(n, extent) = "split;" + n + ";" + rand + ";" + extent
piece(n, length) = "piece;" + n + ";" + length + ";" + split.index + ";" + split.total + ";" + at
quotient(n, x) = "quotient;" + n + ";" + x
"#;

/// The names of rules that others call, in the order in which they may call each other freely.
const RULES: [&str; 5] = ["Block", "Front", "Storey", "Part", "Detail"];

/// Writes a grammar.
struct Writer {
    random: Random,
    text: String,
    marks: u32,
    /// The ends of what the attributes `a`, `b` and `c` may be; nothing where that is anything.
    ends: [Option<[f64; 2]>; 3],
    /// The number of parameters of each of [`RULES`], its depth not counted.
    params: [usize; RULES.len()],
}

/// Where something is written.
#[derive(Clone, Copy)]
struct Here {
    /// Parameters in sight.
    params: &'static [&'static str],
    /// Which of [`RULES`] may be called freely: those from here on.
    rule: usize,
    /// The number of levels that may still be nested.
    depth: usize,
    indent: usize,
}

impl Here {
    fn deeper(self) -> Here {
        Here { depth: self.depth.saturating_sub(1), indent: self.indent + 1, ..self }
    }
}

/// The grammar of a seed.
pub(crate) fn write(seed: u64) -> String {
    let mut random = Random(seed);
    let params = [0; RULES.len()].map(|_| random.below(3));
    let mut writer = Writer { random, text: format!("// Seed {seed}.\n"), marks: FIRST_MARK, ends: [None; 3], params };
    writer.values();
    writer.text.push_str(TOOLS);
    writer.rules();
    writer.text
}

impl Writer {
    /// Returns true with a probability in percent.
    fn chance(&mut self, percent: usize) -> bool {
        self.random.below(100) < percent
    }

    fn of<'t>(&mut self, list: &[&'t str]) -> &'t str {
        list[self.random.below(list.len())]
    }

    fn line(&mut self, here: Here, line: &str) {
        self.text.push_str(&" ".repeat(4 * here.indent));
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// The number of a new place.
    fn mark(&mut self) -> u32 {
        self.marks += 1;
        self.marks - 1
    }

    /// A rule that runs begin with and those that it calls, and more that runs may begin with.
    fn rules(&mut self) {
        let here = Here { params: &[], rule: 0, depth: 3, indent: 1 };
        self.text.push_str("\n@StartRule\nLot -->\n");
        let (mark, told) = (self.mark(), self.number(here, 1));
        self.line(here, &format!("print({mark}) print(tell({told}))"));
        if self.chance(50) {
            self.line(here, "s(10, 5, 8) primitiveCube()");
        } else {
            self.plain_steps(here);
        }
        for (rule, name) in RULES.into_iter().enumerate() {
            // Those further down know more of what they are called with when it is seldom.
            if rule == 0 || self.chance(60) {
                let (depth, args) = (self.random.below(3), self.args(here, rule));
                self.line(here, &format!("{name}({depth}{args})"));
            }
        }
        for (rule, name) in RULES.into_iter().enumerate() {
            let params: &[&str] = &["d", "p", "q"][..1 + self.params[rule]];
            self.text.push_str(&format!("\n{name}({}) -->\n", params.join(", ")));
            self.body(Here { params, rule: rule + 1, ..here });
        }
        self.text.push_str("\nSide -->\n");
        self.body(Here { rule: RULES.len(), ..here });
        self.text.push_str("\nRound -->\n");
        let to = self.of(&["Around(0)", "Around(a)", "End."]);
        self.line(here, to);
        self.text.push_str("\nAround(d) -->\n");
        self.around(Here { params: &["d"], rule: RULES.len(), depth: 1, indent: 1 });
        self.text.push_str("\nMany -->\n");
        self.many(here);
        self.tails(here);
        if self.chance(50) {
            self.text.push_str("\nLost(d) -->\n");
            self.body(Here { params: &["d"], rule: 1, depth: 1, indent: 1 });
        }
    }

    /// A repeat of what is hardly there.
    fn many(&mut self, here: Here) {
        let (split, piece) = (self.mark(), self.mark());
        let size = self.of(&["0.0000001", "0.00000005", "a * 0.0000001", "abs(b) / 100000000", "min(a, 0.0000001)"]);
        let extent = self.of(&["10", "5", "0.1", "c", "'1"]);
        self.line(here, &format!("s({extent}, 5, 8) primitiveCube()"));
        self.line(here, &format!("set(at, seen({split}, scope.sx) + \";\" + {size}) print(at)"));
        self.line(here, &format!("split(x) {{ {size} : print(piece({piece}, scope.sx)) End. }}*"));
    }

    /// Steps that call `Around` again, or end.
    fn around(&mut self, here: Here) {
        let (mark, other) = (self.mark(), self.mark());
        let again = |d: &str| format!("print({mark}) Around({d})");
        let aside = format!("print({other}) Around(d + 2)");
        let end = format!("print({other}) End.");
        let condition = self.condition(here, 1);
        let text = match self.random.below(10) {
            0 => again("d + 1"),
            1 => format!("t(1, 0, 0) [ {} ] X.", again("d + 1")),
            2 => format!("case d > 5 : {end} else : {}", again("d + 1")),
            3 => format!("case {condition} : {} else : {aside}", again("d + 1")),
            4 => format!("case {condition} : {end} else : {}", again("d + 1")),
            5 => format!("0% : {end} else : {}", again("d + 1")),
            6 => format!("100% : {} else : {end}", again("d + 1")),
            7 => format!("50% : {} else : {aside}", again("d + 1")),
            8 => format!("50% : {} else : {end}", again("d + 1")),
            _ => {
                let seen = format!("set(at, seen({}, scope.sx) + \";0.5;1\") print(at)", self.mark());
                let [piece, last] = [mark, other].map(|mark| format!("print(piece({mark}, scope.sx))"));
                format!("{seen} split(x) {{ '0.5 : {piece} Around(d + 1) | ~1 : {last} End. }}")
            }
        };
        self.line(here, &text);
    }
}
