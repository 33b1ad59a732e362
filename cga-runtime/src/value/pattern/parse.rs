//! The parser for patterns.

use super::set::Set;

/// The greatest nesting depth of groups.
const DEEPEST: usize = 50;
/// The largest number in a repetition.
const MOST_REPEATED: u32 = 1000;

/// A pattern as a tree.
#[derive(Debug, PartialEq)]
pub(super) enum RegexNode {
    Set(Set),
    At(Assertion),
    Sequence(Vec<RegexNode>),
    /// Alternatives: the first one that leads to a match.
    Either(Vec<RegexNode>),
    /// As often as possible, or as rarely as possible (`lazy`).
    Repeat {
        node: Box<RegexNode>,
        least: u32,
        most: Option<u32>,
        lazy: bool,
    },
    /// An assertion: must match here, or must not, and is not part of the match.
    Look {
        node: Box<RegexNode>,
        ahead: bool,
        negated: bool,
    },
}

/// A position in a text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Assertion {
    TextStart,
    TextEnd,
    LineStart,
    LineEnd,
    WordEdge,
    NoWordEdge,
}

/// `(?i)`, `(?m)`, `(?s)` at the beginning.
#[derive(Clone, Copy, Default)]
struct Flags {
    fold: bool,
    lines: bool,
    dot_line_ends: bool,
}

struct RegexParser<'p> {
    pattern: &'p [char],
    at: usize,
    flags: Flags,
    depth: usize,
}

/// The tree of a pattern, or a description of its error.
pub(super) fn parse(pattern: &str) -> Result<RegexNode, String> {
    let pattern: Vec<char> = pattern.chars().collect();
    let mut parser = RegexParser { pattern: &pattern, at: 0, flags: Flags::default(), depth: 0 };
    parser.flags();
    let node = parser.either()?;
    match parser.peek() {
        None => Ok(node),
        Some(_) => Err("a `)` without a `(`".to_owned()),
    }
}

impl RegexParser<'_> {
    fn peek(&self) -> Option<char> {
        self.pattern.get(self.at).copied()
    }

    fn next(&mut self) -> Option<char> {
        let next = self.peek();
        self.at += usize::from(next.is_some());
        next
    }

    /// Consumes `text` if it is next.
    fn take(&mut self, text: &str) -> bool {
        let found = text.chars().enumerate().all(|(i, c)| self.pattern.get(self.at + i) == Some(&c));
        self.at += if found { text.chars().count() } else { 0 };
        found
    }

    fn flags(&mut self) {
        let rest = self.pattern.get(2..).unwrap_or_default();
        let length = rest.iter().take_while(|c| matches!(c, 'i' | 'm' | 's')).count();
        if self.pattern.starts_with(&['(', '?']) && 0 < length && rest.get(length) == Some(&')') {
            let given = |flag: char| rest.iter().take(length).any(|c| *c == flag);
            self.flags = Flags { fold: given('i'), lines: given('m'), dot_line_ends: given('s') };
            self.at = length + 3;
        }
    }

    fn either(&mut self) -> Result<RegexNode, String> {
        let mut nodes = vec![self.sequence()?];
        while self.take("|") {
            nodes.push(self.sequence()?);
        }
        Ok(if nodes.len() == 1 { nodes.swap_remove(0) } else { RegexNode::Either(nodes) })
    }

    fn sequence(&mut self) -> Result<RegexNode, String> {
        let mut nodes = Vec::new();
        while self.peek().is_some_and(|c| !matches!(c, '|' | ')')) {
            let node = self.atom()?;
            nodes.push(self.repeated(node)?);
        }
        Ok(RegexNode::Sequence(nodes))
    }

    fn repeated(&mut self, node: RegexNode) -> Result<RegexNode, String> {
        let Some((least, most)) = self.count()? else { return Ok(node) };
        let lazy = self.take("?");
        if self.peek() == Some('+') {
            return Err("`+` after a repetition is not supported".to_owned());
        }
        if self.count()?.is_some() {
            return Err("a repetition of a repetition".to_owned());
        }
        Ok(RegexNode::Repeat { node: Box::new(node), least, most, lazy })
    }

    /// `*`, `+`, `?`, `{2}`, `{2,}`, `{2,3}`.
    fn count(&mut self) -> Result<Option<(u32, Option<u32>)>, String> {
        let found = match self.peek() {
            Some('*') => (0, None),
            Some('+') => (1, None),
            Some('?') => (0, Some(1)),
            Some('{') => return self.braces(),
            _ => return Ok(None),
        };
        self.at += 1;
        Ok(Some(found))
    }

    /// A brace that is not a repetition is a character.
    fn braces(&mut self) -> Result<Option<(u32, Option<u32>)>, String> {
        let start = self.at;
        self.at += 1;
        let least = self.number();
        let most = if self.take(",") { self.number() } else { least };
        let open = self.pattern.get(self.at.wrapping_sub(1)) == Some(&',');
        let (Some(least), true) = (least, self.take("}")) else {
            self.at = start;
            return Ok(None);
        };
        let most = if open { None } else { most };
        match most {
            _ if MOST_REPEATED < most.unwrap_or(least).max(least) => {
                Err(format!("more than {MOST_REPEATED} repetitions"))
            }
            Some(most) if most < least => Err("a repetition whose largest number is below its smallest".to_owned()),
            most => Ok(Some((least, most))),
        }
    }

    fn number(&mut self) -> Option<u32> {
        let mut number = None;
        while let Some(digit) = self.peek().and_then(|c| c.to_digit(10)) {
            number = Some(number.unwrap_or(0u32).saturating_mul(10).saturating_add(digit));
            self.at += 1;
        }
        number
    }

    fn atom(&mut self) -> Result<RegexNode, String> {
        let lines = self.flags.lines;
        Ok(match self.next() {
            Some('(') => return self.group(),
            Some('[') => RegexNode::Set(self.bracket()?),
            Some('.') => RegexNode::Set(Set::any(self.flags.dot_line_ends)),
            Some('^') => RegexNode::At(if lines { Assertion::LineStart } else { Assertion::TextStart }),
            Some('$') => RegexNode::At(if lines { Assertion::LineEnd } else { Assertion::TextEnd }),
            Some('\\') => match self.peek() {
                Some('b') => self.place(Assertion::WordEdge),
                Some('B') => self.place(Assertion::NoWordEdge),
                Some('A') => self.place(Assertion::TextStart),
                Some('z') => self.place(Assertion::TextEnd),
                _ => {
                    RegexNode::Set(self.class().map_or_else(|| self.escaped().map(Set::one), Ok)?.fold(self.flags.fold))
                }
            },
            Some(c @ ('*' | '+' | '?')) => return Err(format!("nothing before `{c}` to repeat")),
            Some(c) => RegexNode::Set(Set::one(c).fold(self.flags.fold)),
            None => RegexNode::Sequence(Vec::new()),
        })
    }

    fn place(&mut self, place: Assertion) -> RegexNode {
        self.at += 1;
        RegexNode::At(place)
    }

    /// Parses a group, after its `(`.
    fn group(&mut self) -> Result<RegexNode, String> {
        if self.depth == DEEPEST {
            return Err(format!("more than {DEEPEST} groups inside each other"));
        }
        const LOOKS: [(&str, bool, bool); 4] =
            [("?=", true, false), ("?!", true, true), ("?<=", false, false), ("?<!", false, true)];
        let look = LOOKS.into_iter().find(|(mark, ..)| self.take(mark));
        if look.is_none() && !self.take("?:") && self.peek() == Some('?') {
            return Err("`(?` without `:`, `=`, `!`, `<=` or `<!`".to_owned());
        }
        self.depth += 1;
        let node = self.either()?;
        self.depth -= 1;
        if !self.take(")") {
            return Err("a `(` without a `)`".to_owned());
        }
        Ok(match look {
            Some((_, ahead, negated)) => RegexNode::Look { node: Box::new(node), ahead, negated },
            None => node,
        })
    }

    /// Parses a set, after its `[`.
    fn bracket(&mut self) -> Result<Set, String> {
        const OPEN: &str = "a `[` without a `]`";
        let negated = self.take("^");
        let mut set = Set::default();
        let mut first = true;
        loop {
            let from = match self.next().ok_or(OPEN)? {
                ']' if !first => return Ok(set.fold(self.flags.fold).negate(negated)),
                '[' if self.peek() == Some(':') => {
                    return Err("classes such as `[:alpha:]` are not supported".to_owned());
                }
                '\\' => match self.class() {
                    None => self.escaped_in_bracket()?,
                    Some(class) => {
                        set.add_class(class);
                        first = false;
                        continue;
                    }
                },
                c => c,
            };
            first = false;
            let to = match (self.peek(), self.pattern.get(self.at + 1)) {
                (Some('-'), Some(end)) if *end != ']' => {
                    self.at += 1;
                    match self.next().ok_or(OPEN)? {
                        '\\' if self.class().is_some() => return Err("a range that ends in a class".to_owned()),
                        '\\' => self.escaped_in_bracket()?,
                        c => c,
                    }
                }
                _ => from,
            };
            if to < from {
                return Err(format!("the range `{}-{}` is reversed", from.escape_debug(), to.escape_debug()));
            }
            set.add_range(from, to);
        }
    }

    /// Parses a class such as `\d`, after its `\`.
    fn class(&mut self) -> Option<Set> {
        let class = Set::class(self.peek()?)?;
        self.at += 1;
        Some(class)
    }

    /// Parses an escaped character in brackets, after its `\`.
    fn escaped_in_bracket(&mut self) -> Result<char, String> {
        if self.take("b") { Ok('\u{8}') } else { self.escaped() }
    }

    /// Parses an escaped character, after its `\`.
    fn escaped(&mut self) -> Result<char, String> {
        Ok(match self.next().ok_or("a `\\` at the end")? {
            't' => '\t',
            'n' => '\n',
            'r' => '\r',
            'f' => '\u{c}',
            'v' => '\u{b}',
            'x' => self.code(2)?,
            'u' => self.code(4)?,
            c if c.is_alphanumeric() => return Err(format!("`\\{c}` is not supported")),
            c => c,
        })
    }

    /// A character by its number: `digits` hexadecimal digits, or any number of them in braces.
    fn code(&mut self, digits: usize) -> Result<char, String> {
        let braces = self.take("{");
        let (mut code, mut count) = (0u32, 0);
        while let Some(digit) = self.peek().and_then(|c| c.to_digit(16)).filter(|_| braces || count < digits) {
            code = code.saturating_mul(16).saturating_add(digit);
            count += 1;
            self.at += 1;
        }
        let complete = if braces { 0 < count && self.take("}") } else { count == digits };
        char::from_u32(code).filter(|_| complete).ok_or_else(|| "a number that is not a character".to_owned())
    }
}
