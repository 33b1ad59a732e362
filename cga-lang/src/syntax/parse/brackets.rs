//! Pairs of brackets.

use crate::syntax::token::{Sym, Tok};

/// The open brackets and their number for each kind. The counts avoid a search for a closing bracket without a
/// partner.
#[derive(Default)]
pub(super) struct OpenBrackets {
    list: Vec<(Sym, usize)>,
    counts: [usize; 3],
}

impl OpenBrackets {
    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Passes over a symbol and records the bracket that it closes. Brackets opened in between stay unclosed.
    pub(super) fn pass(&mut self, sym: Sym, position: usize, close: &mut [Option<usize>]) {
        match sym {
            Sym::LParen | Sym::LBracket | Sym::LBrace => {
                self.counts[kind(sym)] += 1;
                self.list.push((sym, position));
            }
            Sym::RParen | Sym::RBracket | Sym::RBrace if 0 < self.counts[kind(sym)] => {
                while let Some((opener, start)) = self.list.pop() {
                    self.counts[kind(opener)] -= 1;
                    if kind(opener) == kind(sym) {
                        close[start] = Some(position);
                        break;
                    }
                }
            }
            _ => {}
        }
    }
}

fn kind(sym: Sym) -> usize {
    match sym {
        Sym::LParen | Sym::RParen => 0,
        Sym::LBracket | Sym::RBracket => 1,
        _ => 2,
    }
}

/// Returns the closing bracket of each bracket. Declarations are ignored, except for the words that never occur in
/// brackets.
pub(super) fn pairs<'t>(tokens: impl Iterator<Item = &'t Tok>, length: usize) -> Vec<Option<usize>> {
    let (mut open, mut close) = (OpenBrackets::default(), vec![None; length]);
    let mut word = false;
    for (position, token) in tokens.enumerate() {
        // The name after such a word.
        if token.is(Sym::At) || (word && token.ident().is_some()) {
            open = OpenBrackets::default();
        }
        word = matches!(token.ident(), Some("attr" | "const" | "import"));
        if let Tok::Sym(sym) = token {
            open.pass(*sym, position, &mut close);
        }
    }
    close
}
