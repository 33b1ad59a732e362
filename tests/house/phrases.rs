//! Phrases that comments, pages and messages avoid. The test names the line, and what to write instead.

use std::fs;

use cga_tests::tree::{files, root};

/// Two words that are not written one after the other.
struct Phrase {
    words: [&'static str; 2],
    /// Words before or after the phrase that make it plain English.
    with: &'static [&'static str],
    instead: &'static str,
}

/// Phrases in comments and on pages.
const PROSE: &[Phrase] = &[
    Phrase { words: ["that", "of"], with: &["so", "such"], instead: "repeat the noun: `the area of`" },
    Phrase { words: ["those", "of"], with: &[], instead: "repeat the noun: `the edges of`" },
];

/// Phrases in messages.
const MESSAGES: &[Phrase] = &[
    Phrase { words: ["is", "no"], with: &["there", "longer"], instead: "`is not a`, or a verb: `does not take`" },
    Phrase { words: ["are", "no"], with: &["there", "longer"], instead: "`are not`" },
    Phrase { words: ["is", "none"], with: &["there"], instead: "`is not`" },
    Phrase { words: ["are", "none"], with: &["there"], instead: "`are not`" },
];

/// Lines of a text with their numbers.
type Lines<'t> = Vec<(usize, &'t str)>;

/// The phrases in a text of numbered lines, each with its line. A phrase may continue in the next line.
fn found<'p>(lines: &[(usize, &str)], phrases: &'p [Phrase]) -> Vec<(usize, &'p Phrase)> {
    let is_sign = |c: char| !c.is_alphanumeric();
    let words = lines.iter().flat_map(|(line, text)| text.split_whitespace().map(|word| (*line, word.to_lowercase())));
    let words: Vec<(usize, String)> = words.filter(|(_, word)| !word.chars().all(is_sign)).collect();
    // Signs may touch a word: `format!("there` ends with `there`.
    let ends = |(_, text): &(usize, String), word: &str| text.rsplit(is_sign).find(|it| !it.is_empty()) == Some(word);
    let starts = |(_, text): &(usize, String), word: &str| text.split(is_sign).find(|it| !it.is_empty()) == Some(word);
    let mut list = Vec::new();
    for (at, pair) in words.windows(2).enumerate() {
        // A sign between the words ends a clause or marks a name, and a line between them ends a paragraph.
        if pair[0].1.ends_with(is_sign) || pair[1].1.starts_with(is_sign) || pair[0].0 + 1 < pair[1].0 {
            continue;
        }
        let (before, after) = (at.checked_sub(1).map(|at| &words[at]), words.get(at + 2));
        let is_here = |phrase: &&Phrase| {
            let [first, second] = phrase.words;
            let is_plain =
                |word: &&str| before.is_some_and(|it| ends(it, word)) || after.is_some_and(|it| starts(it, word));
            ends(&pair[0], first) && starts(&pair[1], second) && !phrase.with.iter().any(is_plain)
        };
        list.extend(phrases.iter().find(is_here).map(|phrase| (pair[0].0, phrase)));
    }
    list
}

/// The lines of Rust source, by number: the part before `//`, and the comment after it.
fn code_and_comments(text: &str) -> (Lines<'_>, Lines<'_>) {
    (1..)
        .zip(text.lines())
        .map(|(line, text)| {
            let (code, comment) = text.split_at(text.find("//").unwrap_or(text.len()));
            ((line, code), (line, comment))
        })
        .unzip()
}

#[test]
fn comments_and_pages_repeat_the_noun_and_messages_say_what_to_write() {
    let mut refused = Vec::new();
    let all = [files(".rs"), files(".md")].concat();
    for path in all.iter().filter(|path| !path.ends_with("house/phrases.rs")) {
        let text = fs::read_to_string(path).expect("text");
        let place = path.strip_prefix(root()).expect("a file of the workspace");
        let (code, prose) = match path.extension().is_some_and(|end| end == "md") {
            true => (Vec::new(), (1..).zip(text.lines()).collect()),
            false => code_and_comments(&text),
        };
        let mut list = found(&prose, PROSE);
        // Rust itself has none of these words beside each other, so they are in a literal.
        if place.iter().any(|folder| folder == "src") {
            list.extend(found(&code, MESSAGES));
        }
        for (line, Phrase { words: [first, second], instead, .. }) in list {
            refused.push(format!("{}:{line}: instead of `{first} {second}`, {instead}", place.display()));
        }
    }
    assert!(refused.is_empty(), "{}", refused.join("\n"));
}

#[test]
fn phrases_are_found_in_one_line_and_across_two() {
    let lines = |text: &str, phrases: &[Phrase]| {
        let (code, comments) = code_and_comments(text);
        let list = if phrases[0].words[0] == "is" { code } else { comments };
        found(&list, phrases).into_iter().map(|(line, phrase)| (line, phrase.words)).collect::<Vec<_>>()
    };
    let comment = "/// The area is that of the face. Those\n/// of holes count.\nlet that = of;";
    assert_eq!(lines(comment, PROSE), [(1, ["that", "of"]), (1, ["those", "of"])]);
    for fine in [
        "/// Those.\n/// Of all faces.",
        "// those\n\n// of",
        "// so that of two edges",
        "// that offset",
        "// that `of` takes",
        "those of",
    ] {
        assert_eq!(lines(fine, PROSE), [], "{fine}");
    }
    let message = "format!(\"`{word}` is no \\\n    level, and there are none\"); // is no";
    assert_eq!(lines(message, MESSAGES), [(1, ["is", "no"])]);
    for fine in ["\"there is no rule `A`\"", "\"it is no longer set\"", "\"it is not\"", "value.is_none()"] {
        assert_eq!(lines(fine, MESSAGES), [], "{fine}");
    }
}
