//! The queries of file searches (*fileSearch / filesSearch functions*).
//!
//! A file must match all terms, which are separated by space. A term is a pattern for the path, or a property, `=` and
//! a pattern: `Name=`, `Ext=`, `Path=`, `Project=`. A pattern matches a whole text; `*` matches any characters and `?`
//! matches one. A pattern that begins with `$` is a regular expression. Space between single quotes is part of a term.

use std::cell::Cell;

use crate::value::pattern;
use crate::value::shown::shown;

/// The limit on character comparisons in one search, over all files.
const MOST_STEPS: u64 = 100_000_000;

/// A parsed query.
#[derive(Debug)]
pub(crate) struct Query {
    terms: Vec<Term>,
    /// The remaining part of [`MOST_STEPS`].
    steps: Cell<u64>,
    wrong: Option<String>,
}

#[derive(Debug)]
struct Term {
    property: Property,
    pattern: FilePattern,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Path,
    Name,
    Ext,
    Project,
}

const PROPERTIES: [(&str, Property); 4] =
    [("Name=", Property::Name), ("Ext=", Property::Ext), ("Project=", Property::Project), ("Path=", Property::Path)];

#[derive(Debug)]
enum FilePattern {
    /// A pattern with `*` and `?`.
    Plain(Vec<char>),
    /// A regular expression, written after `$`.
    Regular(pattern::Regex),
    /// An invalid regular expression, which matches no file.
    Nothing,
}

impl Query {
    pub(crate) fn new(text: &str) -> Self {
        let mut query = Query { terms: Vec::new(), steps: Cell::new(MOST_STEPS), wrong: None };
        for word in words(text) {
            let known = PROPERTIES.iter().find_map(|(name, property)| Some((word.strip_prefix(name)?, *property)));
            let (pattern, property) = known.unwrap_or((&word, Property::Path));
            let pattern = match pattern.strip_prefix('$').map(pattern::Regex::whole) {
                None => FilePattern::Plain(pattern.chars().collect()),
                Some(Ok(expression)) => FilePattern::Regular(expression),
                Some(Err(error)) => {
                    query.wrong.get_or_insert(format!("the pattern `{}`: {error}", shown(pattern)));
                    FilePattern::Nothing
                }
            };
            query.terms.push(Term { property, pattern });
        }
        query
    }

    /// The reason why results may be missing, if any: part of the query is invalid or took too long.
    pub(crate) fn trouble(&self) -> Option<String> {
        let slow = || (self.steps.get() == 0).then(|| "it takes too long".to_owned());
        self.wrong.clone().or_else(slow)
    }

    /// Returns true if the query matches a file. `path` is relative to the asset folder, with forward slashes. An empty
    /// query matches no file.
    pub(crate) fn finds(&self, project: &str, path: &str) -> bool {
        !self.terms.is_empty() && self.terms.iter().all(|term| term.holds(&self.steps, project, path))
    }
}

impl Term {
    fn holds(&self, steps: &Cell<u64>, project: &str, path: &str) -> bool {
        let holds = |text: &str| self.pattern.holds(steps, text);
        let name = path.rsplit('/').next().unwrap_or(path);
        match self.property {
            // The path relative to the folder `assets`, relative to the asset folder, and as an absolute name.
            Property::Path => {
                path.strip_prefix("assets/").is_some_and(holds) || holds(path) || holds(&format!("/{path}"))
            }
            Property::Name => holds(name),
            Property::Ext => holds(name.rsplit_once('.').map_or("", |(_, end)| end)),
            Property::Project => holds(project),
        }
    }
}

impl FilePattern {
    /// Returns true if the pattern matches a whole text. Uses up `steps`; without steps left the result is false.
    fn holds(&self, steps: &Cell<u64>, text: &str) -> bool {
        if steps.get() == 0 {
            return false;
        }
        let (holds, taken) = match self {
            FilePattern::Plain(pattern) => plain(pattern, text),
            FilePattern::Regular(expression) => expression.matches(text),
            FilePattern::Nothing => (false, 0),
        };
        steps.set(steps.get().saturating_sub(taken));
        holds
    }
}

/// Words separated by space. Space between single quotes does not separate.
fn words(text: &str) -> Vec<String> {
    let mut words = Vec::new();
    let (mut word, mut quoted) = (String::new(), false);
    for c in text.chars() {
        match c {
            '\'' => quoted = !quoted,
            c if c.is_whitespace() && !quoted => words.push(std::mem::take(&mut word)),
            c => word.push(c),
        }
    }
    words.push(word);
    words.retain(|word| !word.is_empty());
    words
}

/// Matches a pattern with `*` and `?` against a whole text. Returns the result and the number of comparisons. Only the
/// last `*` is ever retried, so the number is at most the product of the two lengths.
fn plain(pattern: &[char], text: &str) -> (bool, u64) {
    let (mut at, mut steps) = (0, 0);
    let mut rest = text.chars();
    // The position after the last star, and the text that the star has not consumed yet.
    let mut again: Option<(usize, std::str::Chars<'_>)> = None;
    loop {
        steps += 1;
        if pattern.get(at) == Some(&'*') {
            at += 1;
            again = Some((at, rest.clone()));
            continue;
        }
        match (pattern.get(at), rest.next()) {
            (None, None) => return (true, steps),
            (Some('?'), Some(_)) => at += 1,
            (Some(wanted), Some(c)) if *wanted == c => at += 1,
            _ => {
                let Some((star, left)) = &mut again else { return (false, steps) };
                if left.next().is_none() {
                    return (false, steps);
                }
                (at, rest) = (*star, left.clone());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The files of the reference's example `MyProject`, without other projects.
    const FILES: [&str; 7] = [
        "assets/textures/1.png",
        "assets/textures/2.png",
        "assets/textures/4.png",
        "assets/tower.obj",
        "assets/tower.png",
        "rules/rule.cga",
        "scenes/myScene.cej",
    ];

    fn found(query: &str) -> Vec<&'static str> {
        let query = Query::new(query);
        FILES.into_iter().filter(|path| query.finds("MyProject", path)).collect()
    }

    #[test]
    fn the_examples_of_the_reference_find_what_they_say() {
        assert_eq!(found("*.png"), [&FILES[..3], &[FILES[4]]].concat());
        assert_eq!(found("?.png"), [""; 0]);
        assert_eq!(found("*/?.png"), FILES[..3]);
        assert_eq!(found("textures/*"), FILES[..3]);
        assert_eq!(found("Name=1.png"), FILES[..1]);
        assert_eq!(found("Project=MyProject Ext=obj"), [FILES[3]]);
        assert_eq!(found("Project=OtherProject Ext=obj"), [""; 0]);
    }

    #[test]
    fn regular_expressions_of_the_reference_find_what_they_say() {
        assert_eq!(found("$[12].png"), [""; 0]);
        assert_eq!(found("$textures/[12].png"), FILES[..2]);
        assert_eq!(found("$.*/[12].png"), FILES[..2]);
        assert_eq!(found("$textures/[2-5].png"), FILES[1..3]);
        assert_eq!(found("$textures/[12].png|.*.obj"), [&FILES[..2], &[FILES[3]]].concat());
        assert_eq!(found("Name=$[a-t]ower[.]... Ext=obj"), [FILES[3]]);
        let spaced = Query::new("$a\\sb/c\\x20d[.]png");
        assert!(spaced.finds("", "a b/c d.png") && spaced.trouble().is_none());
    }

    #[test]
    fn what_cannot_be_read_or_takes_too_long_finds_nothing_and_says_so() {
        let query = Query::new("$(");
        assert!(!query.finds("", "(") && query.trouble().is_some_and(|why| why.starts_with("the pattern `$(`: ")));
        let slow = Query::new(&format!("*{}b", "a".repeat(5_000)));
        slow.steps.set(100_000);
        let path = "a".repeat(10_000);
        (0..1_000).for_each(|_| assert!(!slow.finds("", &path)));
        assert_eq!(slow.trouble().as_deref(), Some("it takes too long"));
    }

    #[test]
    fn terms_must_all_hold() {
        assert_eq!(found("*.png *2*"), [FILES[1]]);
        assert_eq!(found("Path=assets/*.png Name=tower*"), [FILES[4]]);
        assert_eq!(found("  "), [""; 0]);
        assert_eq!(found("/assets/tower.obj"), [FILES[3]]);
        assert_eq!(found("tower.*"), FILES[3..5]);
        let spaced = |query: &str| Query::new(query).finds("", "a b/c d.png");
        assert!(
            spaced("'a b/c *.png'") && spaced("Name='c d.png'") && !spaced("a b/c *.png") && spaced("'a b/c d.png")
        );
    }

    #[test]
    fn stars_and_question_marks() {
        let holds = |pattern: &str, text| plain(&pattern.chars().collect::<Vec<_>>(), text).0;
        assert!(holds("", "") && holds("*", "") && holds("**", "ab") && holds("a*", "a") && holds("é?", "éü"));
        assert!(holds("*a*b", "xaabab") && holds("?*?", "ab") && holds("*.o?j", "x.obj"));
        assert!(!holds("?", "") && !holds("a", "ab") && !holds("*a", "ab") && !holds("?*?", "a") && !holds("A", "a"));
        // Many stars that nearly match must not take long.
        let (stars, text) = ("*a".repeat(2000) + "b", "a".repeat(20_000));
        assert!(!holds(&stars, &text));
    }
}
