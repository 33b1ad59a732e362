//! Words and signs of rule bodies that are syntax and not rows, with descriptions for messages.

/// A word or sign with a syntax of its own.
#[derive(Debug, PartialEq)]
pub struct Syntax {
    /// The spelling in rules.
    pub name: &'static str,
    /// The description of its effect, in one line.
    pub about: &'static str,
}

const fn row(name: &'static str, about: &'static str) -> Syntax {
    Syntax { name, about }
}

/// All words and signs of a rule's body that are neither an operation of the table nor a successor.
pub static SYNTAX: &[Syntax] = &[
    row("set", "sets an attribute of the shape"),
    row("NIL", "deletes the shape"),
    row("[", "works on a copy of the shape up to `]`"),
    row("]", "restores the shape as it was before `[`"),
    row("case", "continues with the first branch whose condition is true"),
    row("else", "continues here if no condition before it is true"),
];

/// The row of a word or sign.
pub fn syntax(name: &str) -> Option<&'static Syntax> {
    SYNTAX.iter().find(|row| row.name == name)
}
