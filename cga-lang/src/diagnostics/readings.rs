//! Findings that hold in every reading of a place.
//!
//! A file is read once for each style and import, and a declaration once for each further tuple of types. What the checks
//! know differs from reading to reading; what is said of the text must hold in all of them.

use crate::diag::Diag;
use crate::link::Program;
use crate::span::Span;
use std::collections::HashMap;

/// A file, by number, and a token of it.
pub(crate) type Place = (usize, u32);

/// Where a token was written.
pub(crate) fn written(program: &Program, token: u32) -> Place {
    let at = program.pieces.partition_point(|piece| piece.tokens.start <= token).saturating_sub(1);
    program.pieces.get(at).map_or((0, token), |piece| (piece.file, token - piece.tokens.start + piece.from))
}

/// Findings by the declaration they are about.
#[derive(Default)]
pub(crate) struct Readings {
    by_place: HashMap<Place, Vec<Vec<Diag>>>,
}

impl Readings {
    /// Adds what was found in one reading of a declaration, by the token of its name.
    pub(crate) fn add(&mut self, program: &Program, name: u32, list: Vec<Diag>) {
        self.by_place.entry(written(program, name)).or_default().push(list);
    }

    /// What all readings agree on.
    pub(crate) fn agreed(self, program: &Program) -> Vec<Diag> {
        let place = |span: Span| (written(program, span.first), written(program, span.last));
        let same = |a: &Diag, b: &Diag| a.code == b.code && place(a.span) == place(b.span);
        let mut all = Vec::new();
        for mut readings in self.by_place.into_values() {
            let Some(first) = readings.pop() else { continue };
            all.extend(
                first
                    .into_iter()
                    .filter(|diag| readings.iter().all(|others| others.iter().any(|other| same(diag, other)))),
            );
        }
        all
    }
}
