//! The faults of a run, which a model carries, and the errors, which end a run.

use std::fmt;

use crate::value::shown::shown;
use crate::value::text::Text;

/// The kinds of faults.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum FaultKind {
    /// A number, colour or other value that cannot be used. The message names the value used instead.
    Value,
    /// An asset that is missing or cannot be read.
    Asset,
    /// Geometry that an operation cannot handle, such as a mesh that is not closed in a cut.
    Geometry,
    /// A limit on data that a run keeps: reports, printed lines, files to search.
    Limit,
    /// Reported by an operation written in Rust.
    Host,
}

/// A problem with one shape. The run goes on; the model lists its faults.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Fault {
    /// The kind.
    pub kind: FaultKind,
    /// The problem, and the substitute that was used.
    pub message: String,
    /// The number of occurrences: a missing file is reported once.
    pub count: u64,
    /// The rules that led to the first occurrence, from the start rule down.
    pub trail: Vec<Text>,
}

impl Fault {
    /// A fault returned by an operation written in Rust.
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

/// The quantity that a limit restricts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum LimitKind {
    /// Derived shapes.
    Shapes,
    /// The nesting of recursive rules.
    Depth,
    /// Vertices in meshes that operations make.
    Vertices,
    /// Calls of recursive functions.
    Calls,
    /// The nesting of function calls. This limit is fixed, and lower for functions that need much stack.
    Nesting,
    /// Waiting calls of rules.
    Waiting,
    /// Elements of an array.
    Array,
    /// Bytes of text.
    Text,
    /// Bytes of shapes and meshes.
    Bytes,
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
            LimitKind::Bytes => "bytes of shapes and meshes",
        })
    }
}

/// The reason why a run ended without a model.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A limit of the [`Limits`](crate::run::settings::Limits) was reached.
    Limit {
        /// The quantity.
        what: LimitKind,
        /// The limit.
        limit: u64,
        /// The rules that led there, from the start rule down.
        trail: Vec<Text>,
    },
    /// An attribute's value is refused.
    Attribute {
        /// The name of the attribute.
        name: Text,
        /// The reason.
        message: String,
    },
    /// Attributes and constants need each other, and no condition keeps the run from closing the cycle.
    Cycle {
        /// The names of the cycle, each before one that it needs. The last one needs the first.
        names: Vec<Text>,
    },
    /// No start rule has that name.
    StartRule {
        /// The requested name.
        name: String,
        /// The names of the start rules, without hidden ones.
        known: Vec<Text>,
    },
    /// An attribute, the start rule or the grammar of a lot is wrong, and
    /// [`Settings::wrong_lots`](crate::run::settings::Settings::wrong_lots) makes this an error.
    Lot {
        /// The name of the lot; empty if it has none.
        lot: String,
        /// The problems, as in "attribute `height` is a number, and the value is text".
        problems: Vec<String>,
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
                f.write_str("the grammar has no visible start rule: a rule without parameters that is not hidden")
            }
            Error::StartRule { name, known } => {
                const NAMED: usize = 12;
                let more = if NAMED < known.len() { ", …" } else { "" };
                let known = &known[..known.len().min(NAMED)];
                write!(f, "`{}` is not a start rule; the start rules are {}{more}", shown(name), known.join(", "))
            }
            Error::Lot { lot, problems } => {
                match lot.as_str() {
                    "" => f.write_str("a lot without a name: ")?,
                    lot => write!(f, "lot `{}`: ", shown(lot))?,
                }
                f.write_str(&problems.join("; also, "))
            }
            Error::Shape(message) => f.write_str(message),
        }
    }
}

impl std::error::Error for Error {}

/// Writes each attribute of a cycle before the one that it needs; of a long cycle the beginning.
fn write_cycle(f: &mut fmt::Formatter<'_>, names: &[Text]) -> fmt::Result {
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

/// Writes a trail. Long trails are recursion, so their beginning and end are enough.
fn write_trail(f: &mut fmt::Formatter<'_>, trail: &[Text]) -> fmt::Result {
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
