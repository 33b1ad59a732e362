//! The three doors through which rules come in. A door knows where token n is; nothing else does.

mod content;
mod file;
mod literal;
pub(crate) mod tokens;

use cga_lang::compile::Door;
use cga_lang::diag::Diag;
use cga_lang::span;
use cga_lang::token::Tokens;
use proc_macro2::{Ident, Span, TokenStream};

use crate::header::{Body, Header};

/// Rules as tokens, and what it takes to speak about them.
pub(crate) struct Source {
    tokens: Tokens,
    findings: Vec<Diag>,
    hosts: Vec<Host>,
    place: Place,
}

/// A Rust value in the rules: `#name` or `#(…)`.
pub(crate) struct Host {
    /// The expression.
    pub(crate) expr: TokenStream,
    /// Where it stands, without the `#`.
    pub(crate) span: Span,
}

/// Where tokens are.
enum Place {
    /// Inline: each token begins and ends somewhere, and a path has its own tokens.
    Inline { spans: Vec<(Span, Span)>, paths: Vec<(u32, TokenStream)>, end: Span },
    /// In a string or a file: the literal stands for all that is in it, and there is a text to quote from.
    Text { span: Span, text: TextPlace, tracking: TokenStream },
}

/// A text that findings quote from.
pub(crate) struct TextPlace {
    /// What the user calls it: a path.
    pub(crate) name: String,
    /// The text as it is written, escapes and all, in the place where it stands in its file.
    pub(crate) written: String,
    /// For each token, its bytes in `written`.
    pub(crate) ranges: Vec<std::ops::Range<usize>>,
}

/// A door that could not be opened.
pub(crate) struct Problem {
    first: Span,
    last: Span,
    message: String,
}

impl Problem {
    pub(crate) fn new(first: Span, last: Span, message: impl Into<String>) -> Self {
        Problem { first, last, message: message.into() }
    }

    /// The error alone.
    pub(crate) fn error(&self) -> TokenStream {
        crate::report::error(self.first, self.last, &self.message)
    }
}

/// Opens the door that the header names.
pub(crate) fn open(header: &Header, body: Body) -> Result<Source, Problem> {
    match body {
        Body::Inline(stream) => {
            let end = header.name.as_ref().map_or_else(Span::call_site, Ident::span);
            Ok(tokens::read(stream, end))
        }
        Body::Text(literals) => literal::read(&literals),
        Body::File(literal) => file::read(&literal),
    }
}

impl Source {
    pub(crate) fn tokens(&self) -> &Tokens {
        &self.tokens
    }

    /// Inline is strict, text is compatible.
    pub(crate) fn strictness(&self) -> Door {
        match self.place {
            Place::Inline { .. } => Door::Inline,
            Place::Text { .. } => Door::Text,
        }
    }

    /// What the door itself found.
    pub(crate) fn findings(&self) -> &[Diag] {
        &self.findings
    }

    /// The Rust values, by handle.
    pub(crate) fn hosts(&self) -> &[Host] {
        &self.hosts
    }

    /// The text behind a text door.
    pub(crate) fn text(&self) -> Option<&TextPlace> {
        match &self.place {
            Place::Inline { .. } => None,
            Place::Text { text, .. } => Some(text),
        }
    }

    /// Where a run of tokens begins and ends.
    pub(crate) fn span(&self, span: span::Span) -> (Span, Span) {
        (self.ends(span.first).0, self.ends(span.last).1)
    }

    /// Where a token begins. Past the end: the end.
    pub(crate) fn token(&self, index: u32) -> Span {
        self.ends(index).0
    }

    fn ends(&self, index: u32) -> (Span, Span) {
        match &self.place {
            Place::Inline { spans, end, .. } => {
                spans.get(index as usize).or(spans.last()).copied().unwrap_or((*end, *end))
            }
            Place::Text { span, .. } => (*span, *span),
        }
    }

    /// The line of a token, for messages that name a second place.
    pub(crate) fn line(&self, index: u32) -> Option<usize> {
        match &self.place {
            // Editors' macro servers know no lines and say 1 or 0.
            Place::Inline { spans, .. } => {
                spans.get(index as usize).map(|(span, _)| span.start().line).filter(|line| 1 < *line)
            }
            Place::Text { text, .. } => {
                let range = text.ranges.get(index as usize)?;
                Some(1 + text.written.get(..range.start)?.matches('\n').count())
            }
        }
    }

    /// A Rust path as the user wrote it.
    pub(crate) fn path(&self, token: u32, text: &str) -> TokenStream {
        if let Place::Inline { paths, .. } = &self.place
            && let Ok(at) = paths.binary_search_by_key(&token, |(index, _)| *index)
        {
            return paths[at].1.clone();
        }
        // Resolved where the macro is called.
        text.parse().unwrap_or_default()
    }

    /// Makes the build depend on the rule file.
    pub(crate) fn tracking(&self) -> TokenStream {
        match &self.place {
            Place::Inline { .. } => TokenStream::new(),
            Place::Text { tracking, .. } => tracking.clone(),
        }
    }
}
