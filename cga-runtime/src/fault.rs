//! What can go wrong in a run: faults, which a model carries, and errors, which end a run.

use std::fmt;

/// The kinds of faults.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FaultKind {
    /// A number, colour or other value that cannot be used; what was done instead is in the message.
    Value,
    /// An asset that is missing or cannot be read.
    Asset,
    /// Geometry that an operation cannot handle as asked, such as a cut through a mesh that is not closed.
    Geometry,
    /// Something that a run may keep only so much of: reports, printed lines, files to search.
    Limit,
    /// A part of the language that this runtime has not yet.
    NotImplemented,
    /// Reported by an operation written in Rust.
    Host,
}

/// Something that went wrong with one shape. The run goes on; the model lists its faults.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fault {
    /// What kind.
    pub kind: FaultKind,
    /// What happened and what was done instead.
    pub message: String,
    /// How often it happened: files that are missing are reported once each.
    pub count: u64,
    /// The rules that led there the first time, from the start rule down.
    pub trail: Vec<&'static str>,
}

impl Fault {
    /// A fault for an operation written in Rust to return.
    pub fn new(message: impl Into<String>) -> Self {
        Fault { kind: FaultKind::Host, message: message.into(), count: 1, trail: Vec::new() }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        if 1 < self.count {
            write!(f, " ({} times)", self.count)?;
        }
        write_trail(f, &self.trail)
    }
}

impl std::error::Error for Fault {}

/// What a limit counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LimitKind {
    /// Shapes derived.
    Shapes,
    /// Nesting of rules that can reach themselves.
    Depth,
    /// Vertices in meshes that operations make.
    Vertices,
    /// Calls of functions that can reach themselves.
    Calls,
    /// How deep calls of functions nest: fixed, and lower for functions that need much of the stack.
    Nesting,
    /// Calls of rules that wait.
    Waiting,
    /// Elements of an array.
    Array,
    /// Bytes of text.
    Text,
}

impl fmt::Display for LimitKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            LimitKind::Shapes => "shapes",
            LimitKind::Depth => "depth",
            LimitKind::Vertices => "vertices",
            LimitKind::Calls => "function calls",
            LimitKind::Nesting => "nested function calls",
            LimitKind::Waiting => "waiting calls",
            LimitKind::Array => "elements in an array",
            LimitKind::Text => "bytes of text",
        })
    }
}

/// Why a run ended without a model.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A limit of the [`Limits`](crate::run::settings::Limits) was reached.
    Limit {
        /// Which.
        what: LimitKind,
        /// The limit.
        limit: u64,
        /// The rules that led there, from the start rule down.
        trail: Vec<&'static str>,
    },
    /// An attribute's value is refused.
    Attribute {
        /// Its name.
        name: &'static str,
        /// Why.
        message: String,
    },
    /// Attributes and constants need each other, and no condition keeps the run from closing the cycle.
    Cycle {
        /// Their names, each before one that it needs. The last one needs the first.
        names: Vec<&'static str>,
    },
    /// There is no rule of that name that a run can start with.
    StartRule {
        /// The name asked for.
        name: String,
        /// The names there are, without those of hidden rules.
        known: Vec<&'static str>,
    },
    /// The initial shape cannot be used.
    Shape(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Limit { what, limit, trail } => {
                write!(f, "more {what} than the limit of {limit} allows")?;
                write_trail(f, trail)
            }
            Error::Attribute { name, message } => write!(f, "attribute `{name}`: {message}"),
            Error::Cycle { names } => write_cycle(f, names),
            Error::StartRule { known, .. } if known.is_empty() => {
                f.write_str("there is no rule that a run can start with: one without parameters that is not hidden")
            }
            Error::StartRule { name, known } => {
                const NAMED: usize = 12;
                let more = if NAMED < known.len() { ", …" } else { "" };
                let known = &known[..known.len().min(NAMED)];
                write!(f, "no rule `{name}` to start with; there is {}{more}", known.join(", "))
            }
            Error::Shape(message) => f.write_str(message),
        }
    }
}

impl std::error::Error for Error {}

/// Names each attribute of a cycle with the next one; of long cycles the beginning.
fn write_cycle(f: &mut fmt::Formatter<'_>, names: &[&'static str]) -> fmt::Result {
    const NAMED: usize = 12;
    let Some(first) = names.first() else { return f.write_str("an attribute needs its own value") };
    write!(f, "`{first}` needs its own value")?;
    for (at, name) in names.iter().enumerate().skip(1).take(NAMED) {
        f.write_str(if at == 1 { " by way of " } else { ", " })?;
        write!(f, "`{name}`")?;
    }
    if NAMED + 1 < names.len() {
        write!(f, " and {} more", names.len() - NAMED - 1)?;
    }
    let what = if names.len() < 2 { "it" } else { "one of them" };
    write!(f, ": set {what}, or change the conditions that lead there")
}

/// Long trails are recursion: the beginning and the end say it.
fn write_trail(f: &mut fmt::Formatter<'_>, trail: &[&'static str]) -> fmt::Result {
    const ENDS: usize = 6;
    if trail.is_empty() {
        return Ok(());
    }
    f.write_str(" (in ")?;
    if trail.len() <= 2 * ENDS {
        f.write_str(&trail.join(" > "))?;
    } else {
        let (head, tail) = (&trail[..ENDS], &trail[trail.len() - ENDS..]);
        write!(f, "{} > … {} more … > {}", head.join(" > "), trail.len() - 2 * ENDS, tail.join(" > "))?;
    }
    f.write_str(")")
}
