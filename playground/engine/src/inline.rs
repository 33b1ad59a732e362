//! The rules of grammars that are written in Rust code, as the text of a rule file.

/// The rules of the grammar with a name in a Rust source file: without its header, with `'` for relative sizes, and without the
/// indentation.
pub(crate) fn rules_of(source: &str, name: &str) -> Option<String> {
    let header = format!("grammar {name};");
    let at = source.match_indices(&header).map(|(at, _)| at).find(|&at| is_header(&source[..at]))?;
    let rules = &source[at + header.len()..];
    let (rules, _) = rules.split_once("\n}\n")?;
    let lines = as_text(rules);
    let lines = lines.lines().map(|line| line.strip_prefix("    ").unwrap_or(line));
    Some(lines.collect::<Vec<_>>().join("\n").trim_start_matches('\n').to_owned() + "\n")
}

/// Returns true if a header of a grammar can follow.
fn is_header(before: &str) -> bool {
    before.rfind('\n').is_some_and(|end| before[end..].trim() == "pub")
}

/// The rules with the sign of relative sizes that rule files have. Strings and comments stay.
fn as_text(rules: &str) -> String {
    let mut text = String::with_capacity(rules.len());
    let (mut is_string, mut is_comment) = (false, false);
    let mut characters = rules.chars().peekable();
    while let Some(character) = characters.next() {
        match character {
            '\\' if is_string => {
                text.push(character);
                text.extend(characters.next());
                continue;
            }
            '"' if !is_comment => is_string = !is_string,
            '/' if !is_string && characters.peek() == Some(&'/') => is_comment = true,
            '\n' => is_comment = false,
            _ => {}
        }
        text.push(if character == '^' && !is_string && !is_comment { '\'' } else { character });
    }
    text
}

#[cfg(test)]
mod tests {
    use super::rules_of;

    #[test]
    fn rules_are_the_text_of_a_file() {
        let source = "use cga::cga;\ncga! {\n    /// About.\n    pub grammar A;\n\n    // ^1 stays\n    Lot --> s(^1, '1, \"^\\\"^\")\n      A.\n}\n\ncga! {\n    pub grammar B;\n    Lot --> B.\n}\n";
        assert_eq!(rules_of(source, "A").as_deref(), Some("// ^1 stays\nLot --> s('1, '1, \"^\\\"^\")\n  A.\n"));
        assert_eq!(rules_of(source, "B").as_deref(), Some("Lot --> B.\n"));
        assert_eq!(rules_of(source, "C"), None);
    }
}
