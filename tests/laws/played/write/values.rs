//! Declarations of values, and expressions.

use super::{Here, Writer};

const NUMBERS: [&str; 18] = [
    "0", "1", "2", "3", "5", "10", "0.1", "0.25", "0.33", "0.5", "0.6", "1.5", "20", "(-1)", "(-0.5)", "4", "100",
    "7.5",
];

const COMPARISONS: [&str; 8] = ["<", "<=", ">", ">=", "<", ">", "==", "!="];

impl Writer {
    /// Attributes, constants and functions.
    pub(super) fn values(&mut self) {
        for (index, name) in ["a", "b", "c"].into_iter().enumerate() {
            let low = self.random.below(7) as f64 / 2.0 - 1.0;
            let high = low + *self.random.pick(&[0.0, 0.5, 1.0, 3.0, 50.0]);
            let declaration = match self.random.below(10) {
                0..6 => {
                    self.ends[index] = Some([low, high]);
                    let default = if self.chance(50) { low } else { high };
                    let restricted = if self.chance(10) { ", restricted = false" } else { "" };
                    format!("@Range(min = {low}, max = {high}{restricted})\nattr {name} = {default}\n")
                }
                6 => format!("@Enum({low}, {}, {})\nattr {name} = {low}\n", high + 1.0, high + 2.0),
                _ => format!("attr {name} = {}\n", self.of(&NUMBERS)),
            };
            self.text.push_str(&declaration);
        }
        let (on, kind, set) = (self.chance(50), self.of(&["low", "high"]), self.of(&NUMBERS));
        self.text
            .push_str(&format!("attr on = {on}\n@Enum(\"low\", \"high\")\nattr kind = \"{kind}\"\nattr u = {set}\n"));
        let first = self.number_alone();
        let second = self.of(&["a * 2", "max(b, 1)", "c + 1", "min(a, b)", "abs(a) + 1", "scope.sx", "2"]);
        self.text.push_str(&format!("const k = {first}\nconst m = {second}\n"));
        let first = self.of(&[
            "x * 2",
            "max(x, 1)",
            "case x > 1 : 3 else : x",
            "2",
            "abs(x) + 0.5",
            "scope.sx / 2",
            "min(x, a)",
        ]);
        let second = self.of(&["0.5", "case on : 1 else : 2", "rand(1, 2)", "x % 3", "k + 1", "floor(x)", "sqrt(x)"]);
        self.text.push_str(&format!("f(x) = {first}\ng(x) = {second}\n"));
        let here = Here { params: &["x"], rule: 0, depth: 2, indent: 0 };
        let told = self.place(here);
        self.text.push_str(&format!("tell(x) = {told}\n"));
    }

    fn number_alone(&mut self) -> String {
        self.of(&NUMBERS).into()
    }

    /// The number of a place, where conditions decide which.
    pub(super) fn place(&mut self, here: Here) -> String {
        if here.depth == 0 || self.chance(30) {
            return self.mark().to_string();
        }
        let subject = self.subject(here);
        let condition = self.about(here, &subject);
        let inner = here.deeper();
        let (yes, no) = (self.place(inner), self.place(inner));
        if self.chance(30) {
            let (other, more) = (self.about(here, &subject), self.place(inner));
            return format!("(case {condition} : {yes} case {other} : {more} else : {no})");
        }
        format!("(case {condition} : {yes} else : {no})")
    }

    /// A number by name, or as written.
    fn plain(&mut self, here: Here) -> String {
        match self.random.below(20) {
            0..6 => self.number_alone(),
            6..9 => self.of(&["a", "b", "c"]).into(),
            9 => self.of(&["k", "m", "u"]).into(),
            10..14 if !here.params.is_empty() => self.of(here.params).into(),
            14..18 => self.of(&["scope.sx", "scope.sy", "scope.sz"]).into(),
            18 => "split.index".into(),
            _ => self.number_alone(),
        }
    }

    pub(super) fn number(&mut self, here: Here, depth: usize) -> String {
        if depth == 0 || self.chance(40) {
            return self.plain(here);
        }
        let (one, other) = (self.number(here, depth - 1), self.number(here, depth - 1));
        match self.random.below(16) {
            0..5 => format!("({one} {} {other})", self.of(&["+", "-", "*", "/", "%"])),
            5 => format!("{}({one}, {other})", self.of(&["min", "max"])),
            6..9 => format!("{}({one})", self.of(&["abs", "floor", "ceil", "rint", "sqrt", "abs"])),
            9 => format!("rand({one}, {other})"),
            10..12 => format!("(case {} : {one} else : {other})", self.condition(here, 1)),
            12 => format!("({}% : {one} else : {other})", self.of(&["0", "30", "100"])),
            13 | 14 => format!("{}({one})", self.of(&["f", "g"])),
            _ => format!("(-{one})"),
        }
    }

    pub(super) fn condition(&mut self, here: Here, depth: usize) -> String {
        let subject = self.subject(here);
        let one = self.about(here, &subject);
        if depth == 0 {
            return one;
        }
        match self.random.below(10) {
            0 | 1 => format!("({one} {} {})", self.of(&["&&", "||"]), self.condition(here, depth - 1)),
            2 => format!("!({one})"),
            _ => one,
        }
    }

    /// The value that a condition tests. Conditions of a rule often share it.
    pub(super) fn subject(&mut self, here: Here) -> String {
        match self.random.below(13) {
            0 => "on".into(),
            1 => "kind".into(),
            2 => self.number(here, 1),
            3 | 12 => {
                let plain = if self.chance(60) { self.of(&["a", "b", "c", "u"]).into() } else { self.plain(here) };
                self.of(&["f(?)", "g(?)", "abs(?)", "sqrt(?)", "max(?, 2)", "? % 3"]).replace('?', &plain)
            }
            4 | 5 => self.of(&["scope.sx", "scope.sy", "scope.sz"]).into(),
            6..8 if !here.params.is_empty() => self.of(here.params).into(),
            _ => self.of(&["a", "b", "c", "a", "b", "u", "m"]).into(),
        }
    }

    /// A condition about a subject.
    pub(super) fn about(&mut self, here: Here, subject: &str) -> String {
        match subject {
            "on" => self.of(&["on", "!on", "on", "on == true"]).into(),
            "kind" => format!("kind {} \"{}\"", self.of(&["==", "!="]), self.of(&["low", "high", "other"])),
            _ => {
                let op = self.of(&COMPARISONS);
                let index = ["a", "b", "c"].into_iter().position(|name| name == subject);
                let with = match index.and_then(|index| self.ends[index]) {
                    Some(ends) if self.chance(40) => format!("({})", self.random.pick(&ends)),
                    // Functions have ends too.
                    _ if subject.contains(['(', '%']) && self.chance(50) => {
                        self.of(&["(-1)", "0", "2", "3", "5"]).into()
                    }
                    _ if self.chance(80) => self.number_alone(),
                    _ => self.plain(here),
                };
                format!("{subject} {op} {with}")
            }
        }
    }
}
