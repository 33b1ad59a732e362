//! Words and signs of rule bodies that are syntax, not rows: what they do, for messages.

/// A word or sign with a syntax of its own.
#[derive(Debug, PartialEq)]
pub struct Syntax {
    /// As written.
    pub name: &'static str,
    /// What it does, in a line.
    pub about: &'static str,
}

const fn row(name: &'static str, about: &'static str) -> Syntax {
    Syntax { name, about }
}

/// Everything in a rule's body that is neither an operation of the table nor a successor.
pub static SYNTAX: &[Syntax] = &[
    row("set", "sets an attribute of the shape"),
    row("NIL", "makes nothing of the shape"),
    row("[", "works on a copy of the shape up to `]`"),
    row("]", "goes on with the shape as it was before `[`"),
    row("case", "goes on as the first condition that holds says"),
    row("else", "goes on when nothing before it holds"),
];

/// The row of a word or sign.
pub fn syntax(name: &str) -> Option<&'static Syntax> {
    SYNTAX.iter().find(|row| row.name == name)
}
