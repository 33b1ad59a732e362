//! Random rules.

use super::super::common::random::Random;
use std::fmt::Write;

const NUMBERS: [&str; 18] = [
    "0", "1", "2", "3", "5", "10", "0.1", "0.25", "0.33", "0.5", "0.6", "1.5", "2.7", "-1", "-0.5", "12", "0.999", "4",
];
const SHARES: [&str; 12] = ["0.1", "0.2", "0.25", "0.3", "0.33", "0.5", "0.6", "0.7", "1", "1.2", "0", "-0.1"];
const RULES: [&str; 5] = ["A", "B", "C", "D", "E"];
const SELECTORS: [&str; 12] =
    ["front", "back", "left", "right", "top", "bottom", "side", "all", "vertical", "horizontal", "aslant", "0"];

/// A grammar with four attributes and five rules, the last two with a parameter.
pub(crate) fn write(random: &mut Random) -> String {
    let mut text = String::new();
    for name in ["p", "q"] {
        let (low, high) = (random.below(9) as i64 - 2, random.below(8));
        let _ = writeln!(text, "@Range(min = {low}, max = {})\nattr {name} = {low}", low + high as i64);
    }
    let _ = writeln!(text, "attr u = {}\nattr v = {}", random.pick(&NUMBERS), random.pick(&NUMBERS));
    let _ = writeln!(text, "const k = {}", random.pick(&NUMBERS));
    let _ = writeln!(text, "@StartRule Lot --> {} {}", steps(random, 0, false), call(random, false));
    for name in RULES {
        let param = if matches!(name, "D" | "E") { "(n)" } else { "" };
        let _ = writeln!(text, "{name}{param} --> {}", steps(random, 0, !param.is_empty()));
    }
    text
}

fn number(random: &mut Random, param: bool) -> String {
    match random.below(16) {
        0 => "p".into(),
        1 => "q".into(),
        2 => "u".into(),
        3 => "k".into(),
        4 if param => "n".into(),
        5 => format!("scope.s{}", random.pick(&["x", "y", "z"])),
        6 => format!("({} {} {})", number(random, param), random.pick(&["+", "-", "*", "/"]), number(random, param)),
        7 => format!("min({}, {})", number(random, param), number(random, param)),
        8 => format!("abs({})", number(random, param)),
        9 => {
            format!("(case {} : {} else : {})", condition(random, param), number(random, param), number(random, param))
        }
        10 => format!("rand({}, {})", random.pick(&NUMBERS), random.pick(&NUMBERS)),
        11 => format!("floor({})", number(random, param)),
        _ => (*random.pick(&NUMBERS)).into(),
    }
}

fn condition(random: &mut Random, param: bool) -> String {
    let op = random.pick(&["<", "<=", ">", ">=", "==", "!="]);
    let one = format!("{} {op} {}", number(random, param), number(random, param));
    match random.below(6) {
        0 => format!("({one} && {} < {})", number(random, param), number(random, param)),
        1 => format!("!({one})"),
        2 => format!("({one} || v > {})", number(random, param)),
        _ => one,
    }
}

fn size(random: &mut Random, param: bool) -> String {
    match random.below(6) {
        0 | 1 => format!("'{}", random.pick(&SHARES)),
        2 => format!("~{}", number(random, param)),
        3 => number(random, param),
        _ => (*random.pick(&NUMBERS)).into(),
    }
}

fn call(random: &mut Random, param: bool) -> String {
    match random.below(4) {
        0 => "X.".into(),
        1 => format!("{}({})", random.pick(&["D", "E"]), number(random, param)),
        _ => (*random.pick(&["A", "B", "C"])).into(),
    }
}

fn slots(random: &mut Random, depth: usize, param: bool) -> String {
    let count = 1 + random.below(4);
    let slots: Vec<String> = (0..count)
        .map(|_| match random.below(8) {
            0 if depth < 2 => {
                let star = if random.below(2) == 0 { "*" } else { "" };
                format!("{{ {} }}{star}", slots(random, depth + 1, param))
            }
            _ => format!("{} : {}", size(random, param), steps(random, depth + 1, param)),
        })
        .collect();
    slots.join(" | ")
}

fn steps(random: &mut Random, depth: usize, param: bool) -> String {
    if 2 < depth {
        return call(random, param);
    }
    if random.below(5) == 0 {
        let (yes, no) = (steps(random, depth + 1, param), steps(random, depth + 1, param));
        return format!("case {} : {yes} else : {no}", condition(random, param));
    }
    let mut list: Vec<String> = (0..random.below(3)).map(|_| step(random, depth, param)).collect();
    list.push(match random.below(8) {
        0 => "X.".into(),
        1 if random.below(2) == 0 => "NIL".into(),
        1 => format!("NIL {}", step(random, depth, param)),
        2 | 3 => call(random, param),
        _ => step(random, depth, param),
    });
    list.join(" ")
}

fn step(random: &mut Random, depth: usize, param: bool) -> String {
    match random.below(8) {
        0 => {
            let args: Vec<String> = (0..3)
                .map(|_| match random.below(3) {
                    0 => "'1".into(),
                    1 => format!("'{}", random.pick(&SHARES)),
                    _ => number(random, param),
                })
                .collect();
            format!("s({})", args.join(", "))
        }
        1 => format!("s({}, {}, {})", random.pick(&NUMBERS), random.pick(&NUMBERS), random.pick(&NUMBERS)),
        2 => format!("[ {} ]", steps(random, depth + 1, param)),
        3 => {
            let arms: Vec<String> = (0..1 + random.below(4))
                .map(|_| format!("{} : {}", random.pick(&SELECTORS), steps(random, depth + 1, param)))
                .collect();
            format!("comp(f) {{ {} }}", arms.join(" | "))
        }
        4 => format!("extrude({})", random.pick(&NUMBERS)),
        _ => {
            let star = if random.below(3) == 0 { "*" } else { "" };
            let axis = random.pick(&["x", "y", "z"]);
            format!("split({axis}) {{ {} }}{star}", slots(random, depth + 1, param))
        }
    }
}
