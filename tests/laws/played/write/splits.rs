//! Splits, of the kinds that checks look at.

use super::{Here, Writer};

const SHARES: [&str; 12] = ["0.5", "0.6", "0.3", "0.33", "1", "0.2", "0.45", "0", "0.9", "0.49", "0.25", "1.2"];
const METRES: [&str; 14] = ["1", "2", "3", "5", "0.5", "4.9", "10", "0", "(-1)", "20", "7", "4", "a", "b"];

/// An item in braces.
enum Item {
    /// A prefix and a number.
    Slot(&'static str, String),
    Group(Vec<Item>, bool),
}

impl Writer {
    pub(super) fn split(&mut self, here: Here) {
        let axis = self.of(&["x", "x", "x", "y", "y", "z", "z"]);
        // Parts have sizes of their own to know.
        if self.chance(if here.depth < 3 { 45 } else { 75 }) {
            let known = ["10", "5", "3", "8", "4"];
            let list: &[&str] = if self.chance(70) { &known } else { &["10", "0.5", "0", "a", "m", "'1"] };
            let [a, b, c] = [0; 3].map(|_| self.of(list));
            let filled = self.of(&["primitiveCube()", "primitiveCube()", "primitiveCylinder()"]);
            self.line(here, &format!("s({a}, {b}, {c}) {filled}"));
        }
        self.split_along(here, axis);
    }

    /// Splits the shape as it is.
    pub(super) fn split_along(&mut self, here: Here, axis: &str) {
        let (items, star) = self.items(here);
        let mark = self.mark();
        let mut sizes = String::new();
        values(&items, &mut sizes);
        self.line(here, &format!("set(at, seen({mark}, scope.s{axis}){sizes}) print(at)"));
        let adjust = if self.chance(25) { ", noAdjust" } else { "" };
        self.line(here, &format!("split({axis}{adjust}) {{"));
        self.written(here.deeper(), axis, items);
        self.line(here, if star { "}*" } else { "}" });
    }

    /// The items in the braces of a split; true if a `*` follows.
    fn items(&mut self, here: Here) -> (Vec<Item>, bool) {
        let slot = |prefix: &'static str, text: &str| Item::Slot(prefix, text.into());
        match self.random.below(18) {
            0 => ((0..2 + self.random.below(3)).map(|_| slot("'", self.of(&SHARES))).collect(), false),
            1..4 => ((0..2 + self.random.below(3)).map(|_| slot("", self.of(&METRES))).collect(), false),
            4 | 5 => {
                let first = slot("", self.of(&["3", "5", "7", "2", "a"]));
                (vec![first, slot("'", self.of(&["0.5", "0.6", "0.9", "0.3"]))], false)
            }
            // Nearly the whole.
            6 => (vec![slot("'", "0.5"), slot("'", self.of(&["0.49", "0.499", "0.4", "0.5"]))], false),
            7 => (vec![slot("'", self.of(&["0.33", "0.49", "0.3", "0.24", "0.9", "1", "0.5"]))], true),
            8 => (vec![slot("'", self.of(&SHARES)), slot("'", self.of(&SHARES))], true),
            9 => (vec![slot("", self.of(&["0", "(-1)", "(a - a)", "7.5", "10"]))], true),
            10 => {
                let size = if self.chance(50) { self.number(here, 1) } else { self.of(&METRES).into() };
                (vec![Item::Slot(self.of(&["", "", "~"]), size)], true)
            }
            11 => {
                let first = slot("", self.of(&METRES));
                (vec![first, slot("~", self.of(&["1", "2", "1"])), slot("'", self.of(&SHARES))], false)
            }
            12 => (vec![slot("", self.of(&METRES)), slot("~", "1"), slot("", self.of(&METRES))], false),
            13 => {
                let group = Item::Group(vec![slot("", self.of(&METRES))], true);
                (vec![group, slot(self.of(&["~", "", "'"]), "1")], false)
            }
            _ => (self.any_items(here, 0), self.chance(25)),
        }
    }

    fn any_items(&mut self, here: Here, depth: usize) -> Vec<Item> {
        let mut list = Vec::new();
        for _ in 0..1 + self.random.below(3) {
            if depth < 2 && self.chance(20) {
                list.push(Item::Group(self.any_items(here, depth + 1), self.chance(75)));
                continue;
            }
            let prefix = self.of(&["", "", "'", "~"]);
            let text = match self.random.below(10) {
                0..4 => self.number(here, 2),
                _ if prefix == "'" => self.of(&SHARES).into(),
                _ => self.of(&METRES).into(),
            };
            list.push(Item::Slot(prefix, text));
        }
        list
    }

    fn written(&mut self, here: Here, axis: &str, items: Vec<Item>) {
        for (index, item) in items.into_iter().enumerate() {
            let bar = if index == 0 { " " } else { "|" };
            match item {
                Item::Slot(prefix, text) => {
                    let mark = self.mark();
                    self.line(here, &format!("{bar} {prefix}{text} : print(piece({mark}, scope.s{axis}))"));
                    self.steps(here.deeper());
                }
                Item::Group(inner, star) => {
                    self.line(here, &format!("{bar} {{"));
                    self.written(here.deeper(), axis, inner);
                    self.line(here, if star { "}*" } else { "}" });
                }
            }
        }
    }
}

/// Adds the sizes, if they do not depend on chance.
fn values(items: &[Item], text: &mut String) {
    for item in items {
        match item {
            Item::Slot(_, number) if ["rand", "% :", "g("].iter().any(|word| number.contains(word)) => {
                text.push_str(" + \";?\"");
            }
            Item::Slot(_, number) => text.push_str(&format!(" + \";\" + {number}")),
            Item::Group(inner, _) => values(inner, text),
        }
    }
}
