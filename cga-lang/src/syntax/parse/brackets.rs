//! Which bracket closes which.

use crate::syntax::token::{Sym, Tok};

pub(super) const NONE: u32 = u32::MAX;

/// Brackets that are open, with how many there are of each kind: a bracket that closes none must not look for one.
#[derive(Default)]
pub(super) struct Open {
    list: Vec<(Sym, usize)>,
    counts: [usize; 3],
}

impl Open {
    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Passes over a symbol; where it closes a bracket that is noted. What was opened in between stays open for ever.
    pub(super) fn pass(&mut self, sym: Sym, position: usize, close: &mut [u32]) {
        match sym {
            Sym::LParen | Sym::LBracket | Sym::LBrace => {
                self.counts[kind(sym)] += 1;
                self.list.push((sym, position));
            }
            Sym::RParen | Sym::RBracket | Sym::RBrace if 0 < self.counts[kind(sym)] => {
                while let Some((opener, start)) = self.list.pop() {
                    self.counts[kind(opener)] -= 1;
                    if kind(opener) == kind(sym) {
                        close[start] = position as u32;
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

/// Which bracket closes which, without a notion of declarations but for the words that never stand in brackets.
pub(super) fn pairs<'t>(tokens: impl Iterator<Item = &'t Tok>, length: usize) -> Vec<u32> {
    let (mut open, mut close) = (Open::default(), vec![NONE; length]);
    let mut word = false;
    for (position, token) in tokens.enumerate() {
        // Behind such a word its name.
        if token.is(Sym::At) || (word && token.ident().is_some()) {
            open = Open::default();
        }
        word = matches!(token.ident(), Some("attr" | "const" | "import"));
        if let Tok::Sym(sym) = token {
            open.pass(*sym, position, &mut close);
        }
    }
    close
}
