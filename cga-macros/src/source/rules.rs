//! The rules of one macro call as tokens, and where each token is.

use super::import::{self, Imported};
use cga_lang::compile::{Compiled, Dialect};
use cga_lang::diag::Diag;
use cga_lang::link::Unit;
use cga_lang::span;
use cga_lang::syntax::token::{Sym, Tok, Tokens};
#[cfg(feature = "live")]
use cga_source::rust::Header;
use cga_source::rust::{Host, InlineTokens, QuotedText, TextTokens};
use proc_macro2::{Span, TokenStream};

/// Rules as tokens, and what it takes to speak about them.
pub(crate) struct Source {
    pub(crate) tokens: Tokens,
    /// The diagnostics of reading the tokens.
    pub(crate) findings: Vec<Diag>,
    hosts: Vec<Host>,
    places: TokenPlaces,
    /// Imported files.
    imported: Vec<Imported>,
    /// The files of the program: the first of the tokens that spans count, and the number in `imported`; `None` for the
    /// rules themselves.
    files: Vec<(u32, Option<usize>)>,
}

/// The places of the tokens.
enum TokenPlaces {
    /// Inline: each token begins and ends somewhere, and a path has its own tokens.
    Inline { spans: Vec<(Span, Span)>, paths: Vec<(u32, TokenStream)>, end: Span },
    /// In a string or a file: every token has the place of the literal, and diagnostics quote the text.
    Text { span: Span, text: QuotedText, tracking: TokenStream },
}

impl Source {
    /// Rules inline in Rust. `end` is the place of diagnostics for rules without tokens.
    pub(crate) fn inline(rules: InlineTokens, end: Span) -> Self {
        let InlineTokens { tokens, found, spans, paths, hosts } = rules;
        Source::new(tokens, found, hosts, TokenPlaces::Inline { spans, paths, end })
    }

    /// Rules in text. `tracking` makes the build follow their file.
    pub(super) fn text(rules: TextTokens, tracking: TokenStream) -> Self {
        let TextTokens { tokens, found, span, quoted } = rules;
        Source::new(tokens, found, Vec::new(), TokenPlaces::Text { span, text: quoted, tracking })
    }

    fn new(tokens: Tokens, findings: Vec<Diag>, hosts: Vec<Host>, places: TokenPlaces) -> Self {
        Source { tokens, findings, hosts, places, imported: Vec::new(), files: Vec::new() }
    }

    /// Returns true for rules inline in Rust.
    pub(crate) fn is_inline(&self) -> bool {
        matches!(self.places, TokenPlaces::Inline { .. })
    }

    /// The rules as a file that others may be imported into.
    pub(crate) fn unit(&self) -> Unit {
        // Inline is strict, text is compatible.
        let dialect = match self.places {
            TokenPlaces::Inline { .. } => Dialect::Inline,
            TokenPlaces::Text { .. } => Dialect::Text,
        };
        // Paths in a string or inline count from the package's folder.
        let name = match &self.places {
            TokenPlaces::Text { text, tracking, .. } if !tracking.is_empty() => text.name.clone(),
            _ => String::new(),
        };
        Unit { name, tokens: self.tokens.clone(), dialect, found: self.findings.clone() }
    }

    /// The path of the file with the rules from the package's folder, and true if it is a Rust file. `None` for rules without a name, and
    /// where the file is not known.
    #[cfg(feature = "live")]
    pub(crate) fn origin(&self, header: &Header) -> Option<(String, bool)> {
        let name = header.name.as_ref()?;
        let file = self.unit().name;
        if file.is_empty() { Some((super::package::rust_file(name.span())?, true)) } else { Some((file, false)) }
    }

    /// The paths of the imported files from the package's folder.
    #[cfg(feature = "live")]
    pub(crate) fn imported(&self) -> impl Iterator<Item = &str> {
        self.imported.iter().map(|file| file.text.name.as_str())
    }

    /// Takes over what was imported.
    pub(crate) fn import(&mut self, compiled: &Compiled, imported: Vec<Imported>) {
        let number = |name: &str| imported.iter().position(|file| file.text.name == name);
        let files = compiled.files.iter().enumerate();
        let files = files.map(|(at, file)| (file.tokens.start, number(&file.name).filter(|_| at != 0)));
        self.files = files.collect();
        self.imported = imported;
    }

    /// The imported file a token belongs to, if any, and the token's number there.
    fn locate(&self, token: u32) -> (Option<&Imported>, u32) {
        let after = self.files.partition_point(|(start, _)| *start <= token);
        match after.checked_sub(1).map(|at| self.files[at]) {
            Some((start, file)) => (file.map(|file| &self.imported[file]), token - start),
            None => (None, token),
        }
    }

    /// The Rust values, by handle.
    pub(crate) fn hosts(&self) -> &[Host] {
        &self.hosts
    }

    /// The text that contains a token, and the token's number in it; `None` for inline rules.
    pub(crate) fn text_of(&self, token: u32) -> Option<(&QuotedText, u32)> {
        match (self.locate(token), &self.places) {
            ((Some(Imported { text, .. }), token), _) | ((None, token), TokenPlaces::Text { text, .. }) => {
                Some((text, token))
            }
            ((None, _), TokenPlaces::Inline { .. }) => None,
        }
    }

    /// Where a run of tokens begins and ends; of an imported file the path that led to it.
    pub(crate) fn span(&self, span: span::Span) -> (Span, Span) {
        let path = self.locate(span.first).0.and_then(|file| self.path_of(file));
        path.unwrap_or_else(|| (self.ends(span.first).0, self.ends(span.last).1))
    }

    /// Where inline rules name the path that led to a file.
    fn path_of(&self, file: &Imported) -> Option<(Span, Span)> {
        let TokenPlaces::Inline { spans, .. } = &self.places else { return None };
        let is_import = |tokens: &[Tok]| match tokens {
            [import, _, Tok::Sym(Sym::Colon), Tok::Str(path)] => import.ident() == Some("import") && *path == file.path,
            _ => false,
        };
        let at = self.tokens.as_slice().windows(4).position(is_import)?;
        spans.get(at + 3).copied()
    }

    /// Where a token begins. Past the end: the end.
    pub(crate) fn token(&self, index: u32) -> Span {
        self.ends(index).0
    }

    fn ends(&self, index: u32) -> (Span, Span) {
        let (imported, index) = self.locate(index);
        match &self.places {
            TokenPlaces::Inline { end, .. } if imported.is_some() => (*end, *end),
            TokenPlaces::Inline { spans, end, .. } => {
                spans.get(index as usize).or(spans.last()).copied().unwrap_or((*end, *end))
            }
            TokenPlaces::Text { span, .. } => (*span, *span),
        }
    }

    /// The line of a token, for messages that name a second place: "line 3", "line 3 of lib.cga".
    pub(crate) fn line(&self, index: u32) -> Option<String> {
        if let Some((text, token)) = self.text_of(index) {
            let range = text.ranges.get(token as usize)?;
            let line = 1 + text.written.get(..range.start)?.matches('\n').count();
            let imported = self.locate(index).0.is_some();
            return Some(if imported { format!("line {line} of {}", text.name) } else { format!("line {line}") });
        }
        let TokenPlaces::Inline { spans, .. } = &self.places else { return None };
        let index = self.locate(index).1;
        // Editors' macro servers know no lines and say 1 or 0.
        let line = spans.get(index as usize).map(|(span, _)| span.start().line).filter(|line| 1 < *line)?;
        Some(format!("line {line}"))
    }

    /// A Rust path as the user wrote it.
    pub(crate) fn path(&self, token: u32, text: &str) -> TokenStream {
        let (imported, token) = self.locate(token);
        if let (TokenPlaces::Inline { paths, .. }, None) = (&self.places, imported)
            && let Ok(at) = paths.binary_search_by_key(&token, |(index, _)| *index)
        {
            return paths[at].1.clone();
        }
        // At the literal. Items are resolved where the macro is called, and rustc gives a call the location of the macro call
        // if the names in it are resolved in several ways.
        let place = Span::mixed_site().located_at(self.token(token));
        let path: TokenStream = text.parse().unwrap_or_default();
        path.into_iter()
            .map(|mut token| {
                token.set_span(place);
                token
            })
            .collect()
    }

    /// Makes the build depend on the rule file and what it imports.
    pub(crate) fn tracking(&self) -> TokenStream {
        let own = match &self.places {
            TokenPlaces::Inline { .. } => TokenStream::new(),
            TokenPlaces::Text { tracking, .. } => tracking.clone(),
        };
        own.into_iter().chain(import::follow(&self.imported)).collect()
    }
}
