//! The tutorial as a reader follows it: each step's rules are put into the program of the step before.

use std::fmt::Write;
use std::fs;

use crate::tree::root;

/// The steps that change rules between the braces of `cga!`.
pub const INLINE: usize = 10;

/// The program after a step.
#[derive(Clone, Debug, Default)]
pub struct Step {
    /// The number of the step, from 1 on.
    pub number: usize,
    /// The text of the step.
    pub text: String,
    /// The rules, attributes and constants, in the order in which a reader has them.
    pub rules: Vec<Declaration>,
    /// The `use` lines.
    uses: String,
    /// The function `main`.
    main: String,
}

/// A rule, attribute or constant with its annotations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declaration {
    pub name: String,
    pub lines: Vec<String>,
}

impl Step {
    /// The whole file `src/main.rs`.
    pub fn program(&self) -> String {
        let mut rules = String::new();
        for line in self.rules.iter().flat_map(|declaration| &declaration.lines) {
            let _ = writeln!(rules, "{line}");
        }
        self.program_with(&format!("cga! {{\n    pub grammar House;\n\n{rules}}}\n"))
    }

    /// The whole file with another `cga!`.
    pub fn program_with(&self, grammar: &str) -> String {
        format!("{}\n{grammar}\n{}", self.uses, self.main)
    }
}

/// The text of the tutorial.
pub fn text() -> String {
    fs::read_to_string(root().join("docs/guide/tutorial.md")).expect("the tutorial")
}

/// The blocks of Rust in a text.
pub fn blocks(text: &str) -> Vec<&str> {
    let mut list = Vec::new();
    for rest in text.split("\n```rust").skip(1) {
        let start = rest.find('\n').expect("a block") + 1;
        let end = start + rest[start..].find("\n```").expect("an end") + 1;
        list.push(&rest[start..end]);
    }
    list
}

/// The declarations of rules that are indented as between the braces of `cga!`.
pub fn declarations(rules: &str) -> Vec<Declaration> {
    let mut list: Vec<Declaration> = Vec::new();
    let mut before = Vec::new();
    for line in rules.lines().filter(|line| !line.trim().is_empty()) {
        let own = line.strip_prefix("    ").expect("an indented line");
        if own.starts_with(' ') {
            list.last_mut().expect("a declaration").lines.push(line.into());
        } else if own.starts_with("///") || own.starts_with('@') {
            before.push(line.into());
        } else {
            let words = own.trim_start_matches("attr ").trim_start_matches("const ");
            let name = words.split([' ', '(']).next().unwrap_or_default().to_owned();
            before.push(line.into());
            list.push(Declaration { name, lines: std::mem::take(&mut before) });
        }
    }
    list
}

/// Steps 1 to [`INLINE`].
///
/// # Panics
/// If the tutorial has another form.
pub fn steps() -> Vec<Step> {
    let text = text();
    let mut parts = text.split("\n## ");
    let first = blocks(parts.next().expect("a beginning"))[0].to_owned();
    let (uses, rest) = first.split_once("\ncga! {\n").expect("a grammar");
    let (_, main) = rest.split_once("\n}\n\n").expect("a main");
    let mut step = Step { uses: uses.into(), main: main.into(), ..Step::default() };
    let mut steps = Vec::new();
    for (number, part) in (1..=INLINE).zip(parts) {
        (step.number, step.text) = (number, part.into());
        let blocks = blocks(part);
        for new in declarations(blocks[0]) {
            match step.rules.iter_mut().find(|old| old.name == new.name) {
                Some(old) => *old = new,
                None => step.rules.push(new),
            }
        }
        if let Some((uses, main)) = blocks.get(1).and_then(|block| block.split_once("\n\nfn main")) {
            (step.uses, step.main) = (format!("{uses}\n"), format!("fn main{main}"));
        }
        steps.push(step.clone());
    }
    steps
}

/// The programs that read the tutorial's files, by name: the last two steps with inline rules, the last with its rules in a file,
/// and the program that loads them.
///
/// # Panics
/// If the tutorial has another form.
pub fn programs() -> [(&'static str, String); 4] {
    let (text, steps) = (text(), steps());
    let (_, loaded) = text.split_once("\n## 11. ").expect("step 11");
    let [header, program] = blocks(loaded)[..] else { panic!("step 11 has two blocks") };
    let [.., ninth, tenth] = &steps[..] else { panic!("ten steps") };
    [
        ("ninth", ninth.program()),
        ("tenth", tenth.program()),
        ("file", tenth.program_with(header)),
        ("loaded", program.to_owned()),
    ]
}
