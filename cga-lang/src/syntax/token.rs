//! Tokens, the form in which all sources deliver rules.
//!
//! Nothing here depends on white space between two tokens, because a macro cannot always know it. Signs that Rust
//! does not glue are therefore separate tokens (`:=`, `=:`, `.+`). The parser derives the meaning of a dot from the
//! tokens around it:
//!
//! - before an operator in an expression, it makes the operator work element by element: `a .+ b`, `.![true]`;
//! - between two names in an expression, it joins them: `scope.sx`;
//! - between two names in a rule, it joins them if the first is an import of the grammar: `lib.Wall`;
//! - after any other name in a rule, it makes a leaf: `Wall.`.
//!
//! The name of a rule is one exception: only white space distinguishes `foo.Tile -->` without an import `foo` from a
//! leaf `foo.` before `Tile -->`. If a source knows that there is no white space, the dot is a [`Tok::Joint`].
//!
//! Numbers are the other exception, as in CGA. `.5` has no space inside and does not directly follow a name. The dot
//! of `1.==1` belongs to the operator, the dot of `1. == 1` to the number.

use crate::diag::RELATIVE;
use crate::span::Span;
use std::hash::{Hash, Hasher};

/// One token.
#[derive(Clone, Debug, PartialEq)]
pub enum Tok {
    /// A name or keyword, without dots.
    Ident(String),
    /// A number; the sign is a token of its own.
    Number(f64),
    /// A string, without its quotes and with its escapes resolved.
    Str(String),
    /// `#name` or `#(…)`: a Rust value, as a handle of the source. Only inline rules have it.
    Host(u32),
    /// A Rust path with at least one `::`, like `crate::noise`.
    Path(String),
    /// A doc comment (`/// …`), without the slashes. It only counts before a declaration.
    Doc(String),
    /// Punctuation.
    Sym(Sym),
    /// A dot between two names, without white space on either side. It counts as [`Sym::Dot`].
    Joint,
    /// Text that the source could not read and has reported. The parser passes over it.
    Bad,
}

macro_rules! symbols {
    ($($name:ident $text:literal $about:literal,)*) => {
        /// Punctuation.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Sym { $(#[doc = $about] $name,)* }

        impl Sym {
            /// All symbols; those with more characters come first.
            pub const ALL: &'static [Sym] = &[$(Sym::$name,)*];

            /// The spelling in CGA text.
            pub const fn text(self) -> &'static str {
                match self { $(Sym::$name => $text,)* }
            }
        }
    };
}

symbols! {
    Arrow "-->" "`-->`: begins the body of a rule.",
    EqEq "==" "`==`",
    NotEq "!=" "`!=`",
    LessEq "<=" "`<=`",
    GreaterEq ">=" "`>=`",
    AndAnd "&&" "`&&`",
    OrOr "||" "`||`",
    LParen "(" "`(`",
    RParen ")" "`)`",
    LBracket "[" "`[`",
    RBracket "]" "`]`",
    LBrace "{" "`{`",
    RBrace "}" "`}`",
    Comma "," "`,`",
    Colon ":" "`:`",
    Semi ";" "`;`: between the rows of an array.",
    Bar "|" "`|`: between slots.",
    Dot "." "`.`: in a dotted name, or after a leaf.",
    Plus "+" "`+`",
    Minus "-" "`-`",
    Star "*" "`*`: times, or repeat.",
    Slash "/" "`/`",
    Percent "%" "`%`: remainder, or percentage.",
    Bang "!" "`!`",
    Less "<" "`<`",
    Greater ">" "`>`",
    Assign "=" "`=`",
    Tilde "~" "`~`: floating size.",
    Quote "'" "`'` or `^`: relative size.",
    At "@" "`@`: begins an annotation.",
}

impl Sym {
    /// Returns true for an operator, which has an operand after it and may have a dot before it.
    pub(crate) fn is_operator(self) -> bool {
        use Sym::{
            AndAnd, Bang, EqEq, Greater, GreaterEq, Less, LessEq, Minus, NotEq, OrOr, Percent, Plus, Slash, Star,
        };
        [AndAnd, Bang, EqEq, Greater, GreaterEq, Less, LessEq, Minus, NotEq, OrOr, Percent, Plus, Slash, Star]
            .contains(&self)
    }
}

impl Tok {
    /// Returns true if the token is the symbol.
    pub fn is(&self, sym: Sym) -> bool {
        match self {
            Tok::Sym(own) => *own == sym,
            Tok::Joint => sym == Sym::Dot,
            _ => false,
        }
    }

    /// The text of a name.
    pub fn ident(&self) -> Option<&str> {
        match self {
            Tok::Ident(name) => Some(name),
            _ => None,
        }
    }

    /// The description in messages: `` `}` ``, a string.
    pub(crate) fn describe(&self) -> String {
        match self {
            Tok::Ident(name) => format!("`{name}`"),
            Tok::Number(value) => format!("`{value}`"),
            Tok::Str(_) => "a string".into(),
            Tok::Host(_) => "a Rust value".into(),
            Tok::Path(path) => format!("`{path}`"),
            Tok::Doc(_) => "a doc comment".into(),
            Tok::Sym(Sym::Quote) => format!("`{RELATIVE}`"),
            Tok::Sym(sym) => format!("`{}`", sym.text()),
            Tok::Joint => format!("`{}`", Sym::Dot.text()),
            Tok::Bad => "something unreadable".into(),
        }
    }

    fn push_text(&self, out: &mut String, relative: char) {
        match self {
            Tok::Ident(text) | Tok::Path(text) => out.push_str(text),
            Tok::Number(value) => out.push_str(&value.to_string()),
            Tok::Str(text) => push_quoted(out, text),
            Tok::Host(_) => out.push_str("#…"),
            Tok::Sym(Sym::Quote) => out.push(relative),
            Tok::Sym(sym) => out.push_str(sym.text()),
            Tok::Joint => out.push_str(Sym::Dot.text()),
            Tok::Doc(_) | Tok::Bad => {}
        }
    }
}

/// Equal tokens have equal hashes: numbers are never NaN, and zero has one sign.
impl Hash for Tok {
    fn hash<H: Hasher>(&self, state: &mut H) {
        std::mem::discriminant(self).hash(state);
        match self {
            Tok::Ident(text) | Tok::Str(text) | Tok::Path(text) | Tok::Doc(text) => text.hash(state),
            Tok::Number(value) => (value + 0.0).to_bits().hash(state),
            Tok::Host(handle) => handle.hash(state),
            Tok::Sym(sym) => sym.hash(state),
            Tok::Joint | Tok::Bad => {}
        }
    }
}

/// Appends a string in the syntax of CGA text.
pub(crate) fn push_quoted(out: &mut String, text: &str) {
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            c if (c as u32) < 0x20 => out.push_str(&format!("\\u{:04X}", c as u32)),
            c => out.push(c),
        }
    }
    out.push('"');
}

/// The tokens of a grammar.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tokens {
    list: Vec<Tok>,
}

impl Tokens {
    /// An empty list.
    pub fn new() -> Self {
        Self::default()
    }

    /// Appends a token and returns its index.
    pub fn push(&mut self, token: Tok) -> u32 {
        self.list.push(token);
        (self.list.len() - 1) as u32
    }

    /// Marks the dots between two names without white space. `is_close` returns true if the token at an index touches
    /// the tokens on both sides.
    pub fn join_names(&mut self, mut is_close: impl FnMut(usize) -> bool) {
        for dot in 1..self.list.len() {
            if let [Tok::Ident(_), Tok::Sym(Sym::Dot), Tok::Ident(_)] =
                self.list[dot - 1..].get(..3).unwrap_or_default()
                && is_close(dot)
            {
                self.list[dot] = Tok::Joint;
            }
        }
    }

    /// Appends other tokens, without a copy if the list is empty.
    pub(crate) fn append(&mut self, mut other: Tokens) {
        if self.list.is_empty() {
            self.list = other.list;
        } else {
            self.list.append(&mut other.list);
        }
    }

    /// The number of tokens.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Returns true if there are no tokens.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The tokens, in order.
    pub fn as_slice(&self) -> &[Tok] {
        &self.list
    }

    /// The tokens of a span as one line of CGA text, shortened to `limit` bytes. `relative` is the sign of relative
    /// sizes.
    pub fn text(&self, span: Span, limit: usize, relative: char) -> String {
        let mut out = String::new();
        let mut before: Option<&Tok> = None;
        // True if the previous token is the dot of an operator like `.+`.
        let mut dotted = false;
        let from = (span.first as usize).min(self.list.len());
        let to = (span.last as usize + 1).clamp(from, self.list.len());
        for (at, token) in self.list[from..to].iter().enumerate() {
            if matches!(token, Tok::Doc(_) | Tok::Bad) {
                continue;
            }
            let begins = token.is(Sym::Dot)
                && self.list[..to]
                    .get(from + at + 1)
                    .is_some_and(|next| matches!(next, Tok::Sym(sym) if sym.is_operator()));
            if begins || (!dotted && before.is_some_and(|before| spaced(before, token))) {
                out.push(' ');
            }
            dotted = begins;
            if limit < out.len() {
                out.push('…');
                break;
            }
            token.push_text(&mut out, relative);
            before = Some(token);
        }
        out
    }
}

impl FromIterator<Tok> for Tokens {
    fn from_iter<I: IntoIterator<Item = Tok>>(iter: I) -> Self {
        Tokens { list: iter.into_iter().collect() }
    }
}

/// Returns true if a space belongs between two tokens.
fn spaced(left: &Tok, right: &Tok) -> bool {
    use Sym::{At, Bang, Comma, Dot, LBrace, LParen, Quote, RParen, Star, Tilde};
    let (l, r) = (|sym| left.is(sym), |sym| right.is(sym));
    if l(LParen) || l(Tilde) || l(Quote) || l(Bang) || l(At) || r(RParen) || r(Comma) {
        return false;
    }
    if r(LParen) {
        return !matches!(left, Tok::Ident(_) | Tok::Path(_));
    }
    if l(Dot) {
        // A dotted name continues; other tokens after a leaf do not.
        return !right.ident().is_some_and(|name| name.starts_with(char::is_lowercase) && name != "else");
    }
    !(r(Dot) || (left.is(Sym::RBrace) && r(Star)) || (l(LBrace) && r(Sym::RBrace)))
}
