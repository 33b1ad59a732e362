//! The rules of grammars that are written in Rust code, as CGA text.

/// A grammar of a source file.
#[derive(Clone, Debug)]
pub struct InlineGrammar {
    /// The name in its header; empty without one.
    pub name: String,
    /// The rules as text, with `'` for relative sizes and without the header.
    pub rules: String,
}

/// The grammars with rules in braces in a source file, in order.
pub fn grammars(source: &str) -> Vec<InlineGrammar> {
    let mut found = Vec::new();
    let mut rest = source;
    while let Some((_, after)) = rest.split_once("cga! {") {
        let end = block_end(after);
        found.push(grammar(&after[..end]));
        rest = &after[end..];
    }
    found
}

/// The grammar with a name.
///
/// # Panics
/// If there is none.
pub fn named(source: &str, name: &str) -> InlineGrammar {
    let found = grammars(source).into_iter().find(|grammar| grammar.name == name);
    found.unwrap_or_else(|| panic!("no grammar {name}"))
}

/// A grammar from the contents of its braces.
fn grammar(inside: &str) -> InlineGrammar {
    let text = as_text(inside);
    let header = text.find("grammar ").and_then(|at| {
        let name = text[at + "grammar ".len()..].split(|c: char| !c.is_alphanumeric() && c != '_').next()?;
        let end = at + text[at..].find(';')? + 1;
        text[at..end].contains(name).then(|| (name.to_owned(), end))
    });
    match header {
        Some((name, end)) if !text[..end].contains("-->") => InlineGrammar { name, rules: text[end..].to_owned() },
        _ => InlineGrammar { name: String::new(), rules: text },
    }
}

/// The end of a block whose opening brace is before the text.
fn block_end(text: &str) -> usize {
    let (mut depth, mut end) = (1, text.len());
    each_plain(text, |at, character| {
        match character {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 && end == text.len() {
            end = at;
        }
    });
    end
}

/// The rules as text.
fn as_text(text: &str) -> String {
    let mut bytes = text.as_bytes().to_vec();
    each_plain(text, |at, character| {
        if character == '^' {
            bytes[at] = b'\'';
        }
    });
    String::from_utf8(bytes).expect("the characters are exchanged one for one")
}

/// Visits all characters outside of strings and comments.
fn each_plain(text: &str, mut visit: impl FnMut(usize, char)) {
    let mut characters = text.char_indices().peekable();
    while let Some((at, character)) = characters.next() {
        match character {
            '"' => {
                while let Some((_, inside)) = characters.next() {
                    match inside {
                        '\\' => _ = characters.next(),
                        '"' => break,
                        _ => {}
                    }
                }
            }
            '/' if characters.peek().is_some_and(|(_, next)| *next == '/') => {
                characters.by_ref().find(|(_, inside)| *inside == '\n');
            }
            _ => visit(at, character),
        }
    }
}
