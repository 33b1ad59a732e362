//! `splitString`.

use crate::fault::FaultKind;
use crate::run::env::Env;
use crate::value::array::Array;
use crate::value::pattern::{Regex, RegexSearch, TooLong};
use crate::value::shown::shown;
use crate::value::text::Text;

/// The parts of a text between delimiters, in one row; a delimiter that begins with `$` is a regular expression
/// (*splitString function*).
///
/// An empty delimiter matches before every character and at the end. An empty text has one part: itself (*CGA changelog
/// 2020.1*). A pattern with an error, or one that takes too long, leaves a fault and the text in one part. The page
/// does not specify the notation of patterns. Here it is Perl's: `.` matches everything except line ends, `(?i)`,
/// `(?m)` and `(?s)` are allowed at the beginning, and back references are not supported.
pub fn split_string(env: &mut Env, text: Text, delimiter: Text) -> Array<Text> {
    if text.is_empty() {
        return Array::from([text]);
    }
    let Some(pattern) = delimiter.strip_prefix('$') else {
        return env.copy_all(text.split(delimiter.as_str()));
    };
    let pattern = match Regex::new(pattern) {
        Ok(pattern) => pattern,
        Err(error) => {
            env.fault(FaultKind::Value, format!("the pattern `{}`: {error}; the text is not split", shown(pattern)));
            return Array::from([text]);
        }
    };
    split_by_pattern(env, &pattern, &text).unwrap_or_else(|TooLong| {
        let pattern = shown(&delimiter[1..]);
        env.fault(FaultKind::Value, format!("the pattern `{pattern}`: it takes too long; the text is not split"));
        Array::from([text])
    })
}

fn split_by_pattern(env: &mut Env, pattern: &Regex, text: &str) -> Result<Array<Text>, TooLong> {
    let text: Vec<char> = text.chars().collect();
    let mut search = RegexSearch::new(pattern, &text)?;
    let (mut parts, mut part_start, mut from) = (Vec::new(), 0, 0);
    while let Some((start, end)) = if from <= text.len() { search.find(from)? } else { None } {
        from = end + usize::from(start == end);
        // An empty match right after a delimiter does not count.
        if start == end && start == part_start && !parts.is_empty() {
            continue;
        }
        parts.push(&text[part_start..start]);
        part_start = end;
        if !env.may_grow(parts.len() + 1) {
            return Ok(Array::default());
        }
    }
    parts.push(&text[part_start..]);
    let bytes = parts.iter().flat_map(|part| part.iter()).map(|c| c.len_utf8()).sum();
    if !(env.may_hold(parts.len()) && env.may_write(bytes)) {
        return Ok(Array::default());
    }
    Ok(parts.into_iter().map(|part| Text::from(part.iter().collect::<String>())).collect())
}

#[cfg(test)]
mod tests {
    use super::super::tests::{Random, env, faults, limit, small_env, text};
    use super::*;
    use crate::fault::LimitKind;

    fn split(whole: &str, delimiter: &str) -> String {
        split_string(&mut env(), text(whole), text(delimiter)).to_string()
    }

    #[test]
    fn text_is_split_at_delimiters() {
        // *splitString function*, the table.
        assert_eq!(split("a.b.c", "."), "(3)[a,b,c]");
        assert_eq!(split(".b.", "."), "(3)[,b,]");
        assert_eq!(split("a.b\nc.d", "\n"), "(2)[a.b,c.d]");
        assert_eq!(split("a\\b\\c", "\\"), "(3)[a,b,c]");
        assert_eq!(split("abc", ""), "(5)[,a,b,c,]");
        assert_eq!(
            (split("", "").as_str(), split("", ".").as_str(), split("", "$x*").as_str()),
            ("(1)[]", "(1)[]", "(1)[]")
        );
        assert_eq!(split("aaa", "aa"), "(2)[,a]");
        assert_eq!(split("ü✓ü", "✓"), "(2)[ü,ü]");
    }

    #[test]
    fn text_is_split_at_patterns() {
        // *splitString function*, the table.
        assert_eq!(split("a;b;c", "$;"), "(3)[a,b,c]");
        assert_eq!(split("a.b.c", "$\\."), "(3)[a,b,c]");
        assert_eq!(split("a\t\tb\tc", "$\t+"), "(3)[a,b,c]");
        assert_eq!(split("a b  c", "$\\s+"), "(3)[a,b,c]");
        assert_eq!(split("a$b$c", "$\\$"), "(3)[a,b,c]");
        assert_eq!(split("abc", "$\\B"), "(3)[a,b,c]");
        assert_eq!(split("abacba", "$(?<=a)b(?=a)"), "(2)[a,acba]");
        // *index operator*, "Parsing text file".
        assert_eq!(split("a;b;c\nd;e;f\ng;h;i", "$;|\n"), "(9)[a,b,c,d,e,f,g,h,i]");
    }

    #[test]
    fn delimiters_of_nothing_stand_everywhere() {
        assert_eq!(split("abc", "$"), split("abc", ""));
        assert_eq!(split("axb", "$x*"), "(4)[,a,b,]");
        assert_eq!(split("xx", "$x+"), "(2)[,]");
    }

    #[test]
    fn what_cannot_be_done_leaves_the_text_whole() {
        let env = &mut env();
        let whole = Array::from([text("a(b")]);
        assert_eq!(split_string(env, text("a(b"), text("$(")), whole);
        assert_eq!(split_string(env, text("a(b"), text("$(b)\\1")), whole);
        let long = text(&("a".repeat(30_000) + "c"));
        assert_eq!(split_string(env, long, text("$a(?=.*c)b|a")).len(), 1);
        assert_eq!(faults(env), 3);
    }

    #[test]
    fn parts_have_a_limit() {
        for delimiter in [",", "$,", "", "$"] {
            let env = &mut small_env(5, 1000);
            assert!(split_string(env, text(",,,,,"), text(delimiter)).is_empty());
            assert_eq!(limit(env), Some(LimitKind::Array), "{delimiter}");
        }
        assert_eq!(split_string(&mut small_env(6, 0), text(",,,,,"), text("$,")).len(), 6);
    }

    #[test]
    fn parts_and_delimiters_make_up_the_text() {
        let mut random = Random(86);
        for _ in 0..5_000 {
            let letters = |random: &mut Random, count: usize| -> String {
                (0..count).map(|_| ['a', 'b', 'ü', ';'][random.below(4)]).collect()
            };
            let count = random.below(9);
            let whole = letters(&mut random, count);
            let count = random.below(3);
            let delimiter = letters(&mut random, count);
            let env = &mut env();
            let plain = split_string(env, text(&whole), text(&delimiter));
            let parts: Vec<&str> = plain.into_iter().map(Text::as_str).collect();
            assert_eq!(parts.join(&delimiter), whole);
            assert!(delimiter.is_empty() || parts.iter().all(|part| !part.contains(&delimiter)));
            let same = split_string(env, text(&whole), text(&format!("${delimiter}")));
            assert_eq!(same, plain, "{whole} {delimiter}");
        }
    }
}
