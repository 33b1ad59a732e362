//! Text functions. Lengths and positions count characters, from 0.

use super::whole;
use crate::run::env::Env;
use crate::value::array::Element;
use crate::value::text::Text;

/// `a` followed by `b`.
pub fn concat(env: &mut Env, a: Text, b: Text) -> Text {
    if env.may_write(a.len().saturating_add(b.len())) {
        Text::from([a.as_str(), b.as_str()].concat())
    } else {
        Text::default()
    }
}

/// The number of characters (*len function*).
pub fn len(text: Text) -> f64 {
    text.chars().count() as f64
}

/// The position of the character at a byte; -1 for `None`.
fn place(text: &str, byte: Option<usize>) -> f64 {
    byte.and_then(|byte| text.get(..byte)).map_or(-1.0, |before| before.chars().count() as f64)
}

/// The byte position of the `n`th occurrence. Occurrences do not overlap (*CGA changelog 2020.0*). An empty part occurs
/// before every character and at the end.
fn occurrence(text: &str, part: &str, n: f64) -> Option<usize> {
    text.match_indices(part).nth(whole(n)?).map(|(byte, _)| byte)
}

/// The position of the `n`th occurrence, counted from 0; -1 without one (*find function*).
pub fn find(env: &mut Env, text: Text, part: Text, n: f64) -> f64 {
    let n = env.finite(n, "the number of an occurrence");
    place(&text, occurrence(&text, &part, n))
}

/// The number of occurrences, which do not overlap (*count function*).
pub fn count(text: Text, part: Text) -> f64 {
    text.matches(part.as_str()).count() as f64
}

/// The characters from `start` to before `end`; both are clamped to the text (*substring function*).
pub fn substring(env: &mut Env, text: Text, start: f64, end: f64) -> Text {
    let start = whole(env.finite(start, "the start of a substring")).unwrap_or(0);
    let end = whole(env.finite(end, "the end of a substring")).unwrap_or(0);
    let byte = |place: usize| text.char_indices().nth(place).map_or(text.len(), |(byte, _)| byte);
    if end <= start { Text::default() } else { env.copy(&text[byte(start)..byte(end)]) }
}

/// The text with every occurrence of `old` replaced (*replace*). An empty `old` does not occur. `new` may be a number
/// or truth value.
pub fn replace<T: Element>(env: &mut Env, text: Text, old: Text, new: T) -> Text {
    if old.is_empty() {
        return text;
    }
    let mut with = String::new();
    // Writing to a string cannot fail.
    let _ = new.print(&mut with);
    let occurrences = text.matches(old.as_str()).count();
    let length = (text.len() - occurrences * old.len()).saturating_add(occurrences.saturating_mul(with.len()));
    match occurrences {
        0 => text,
        _ if env.may_write(length) => Text::from(text.replace(old.as_str(), &with)),
        _ => Text::default(),
    }
}

/// The position of the first occurrence; -1 without one (*findFirst (utility library)*).
pub fn find_first(text: Text, part: Text) -> f64 {
    place(&text, text.find(part.as_str()))
}

/// The position of the last occurrence; -1 without one (*findLast*).
pub fn find_last(text: Text, part: Text) -> f64 {
    place(&text, text.rfind(part.as_str()))
}

/// The text before the first occurrence; the whole text without one (*getPrefix*).
pub fn get_prefix(env: &mut Env, text: Text, part: Text) -> Text {
    match text.split_once(part.as_str()) {
        Some((before, _)) => env.copy(before),
        None => text,
    }
}

/// The text after the last occurrence; the whole text without one (*getSuffix*).
pub fn get_suffix(env: &mut Env, text: Text, part: Text) -> Text {
    match text.rsplit_once(part.as_str()) {
        Some((_, behind)) => env.copy(behind),
        None => text,
    }
}

/// The text between the first occurrence of `left` and the last one of `right` (*getRange*). Empty if these overlap;
/// the whole text if one of them does not occur.
pub fn get_range(env: &mut Env, text: Text, left: Text, right: Text) -> Text {
    match text.find(left.as_str()).zip(text.rfind(right.as_str())) {
        Some((start, end)) => env.copy(text.get(start + left.len()..end).unwrap_or_default()),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{Random, env, faults, limit, small_env, text};
    use super::*;
    use crate::fault::LimitKind;

    #[test]
    fn a_substring_ends_before_its_end() {
        let env = &mut env();
        let mut part = |start: f64, end: f64| substring(env, text("0123456789"), start, end);
        assert_eq!(part(0.0, 5.0), text("01234"));
        assert_eq!(part(2.0, 5.0), text("234"));
        assert_eq!(part(-20.0, 5.0), text("01234"));
        assert_eq!(part(0.0, 20.0), text("0123456789"));
        assert_eq!(part(5.0, 0.0), text(""));
        assert_eq!((part(3.9, 4.1), part(12.0, 1e300), part(-5.0, -1.0)), (text("3"), text(""), text("")));
        assert_eq!(substring(env, text("größe✓"), 2.0, 4.0), text("öß"));
        assert_eq!(faults(env), 0);
        assert_eq!(substring(env, text("abc"), f64::NAN, 2.0), text("ab"));
        assert_eq!(faults(env), 1);
    }

    #[test]
    fn find_counts_characters() {
        // *find function*, *count function*, *len function*.
        let env = &mut env();
        let zones = "CE_Zero CE_One CE_Two";
        assert_eq!([0.0, 1.0, 2.0, 3.0].map(|n| find(env, text(zones), text("CE"), n)), [0.0, 8.0, 15.0, -1.0]);
        assert_eq!(find(env, text(zones), text("asdf"), 1.0), -1.0);
        assert_eq!([-1.0, 1e300].map(|n| find(env, text(zones), text("CE"), n)), [-1.0, -1.0]);
        assert_eq!(find(env, text("äöü ü"), text("ü"), 1.0), 4.0);
        assert_eq!([0.0, 2.0, 3.0].map(|n| find(env, text("ab"), text(""), n)), [0.0, 2.0, -1.0]);
        assert_eq!(find(env, text(""), text("a"), 0.0), -1.0);
        assert_eq!((count(text("cityengine"), text("e")), count(text("aaa"), text("aa"))), (2.0, 1.0));
        assert_eq!((count(text("ab"), text("")), count(text(""), text("x"))), (3.0, 0.0));
        assert_eq!((len(text("cityengine")), len(text("größe")), len(text(""))), (10.0, 5.0, 0.0));
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn occurrences_do_not_overlap() {
        assert_eq!(find(&mut env(), text("ababa"), text("aba"), 1.0), -1.0);
    }

    #[test]
    fn prefix_suffix_and_range_are_cut_at_occurrences() {
        let env = &mut env();
        // *getPrefix*, *getSuffix*, *getRange*, *findFirst (utility library)*, *findLast*.
        let rule = || text("rule your city with cityengine");
        assert_eq!(get_prefix(env, rule(), text("city")), text("rule your "));
        assert_eq!(get_prefix(env, text("myTexture.has.prefix.jpg"), text(".")), text("myTexture"));
        assert_eq!(get_suffix(env, rule(), text("city")), text("engine"));
        assert_eq!(get_range(env, rule(), text("y"), text("city")), text("our city with "));
        let file = || text("myTexture.hasName.001.jpg");
        assert_eq!(get_range(env, file(), text("hasName."), text(".jpg")), text("001"));
        assert_eq!(get_range(env, file(), text("."), text(".")), text("hasName.001"));
        assert_eq!(get_range(env, text("CityEngine"), text("CityEn"), text("tyEngine")), text(""));
        assert_eq!((find_first(rule(), text("city")), find_last(rule(), text("city"))), (10.0, 20.0));
        assert_eq!((find_first(rule(), text("x")), find_last(rule(), text("x"))), (-1.0, -1.0));
        for missing in [get_prefix(env, rule(), text("x")), get_suffix(env, rule(), text("x"))] {
            assert_eq!(missing, rule());
        }
        assert_eq!(
            (get_range(env, rule(), text("x"), text("city")), get_range(env, rule(), text("y"), text("x"))),
            (rule(), rule())
        );
        assert_eq!((get_prefix(env, rule(), text("")), get_suffix(env, rule(), text(""))), (text(""), text("")));
    }

    #[test]
    fn text_is_replaced() {
        // *replace*.
        let env = &mut env();
        let rule = text("rule your city with cityengine");
        assert_eq!(replace(env, rule, text("your city"), text("designs")), text("rule designs with cityengine"));
        assert_eq!(replace(env, text("myTexture.#.jpg"), text("#"), text("1")), text("myTexture.1.jpg"));
        assert_eq!(replace(env, text("#-#"), text("#"), 1.5), text("1.5-1.5"));
        assert_eq!(replace(env, text("#"), text("#"), true), text("true"));
        assert_eq!(replace(env, text("aaa"), text("aa"), text("")), text("a"));
        assert_eq!(replace(env, text("abc"), text(""), text("x")), text("abc"));
        assert_eq!(replace(env, text("abc"), text("x"), text("y")), text("abc"));
        assert!(!env.ended());
    }

    #[test]
    fn text_has_a_limit() {
        let env = &mut small_env(0, 5);
        assert_eq!((concat(env, text("ab"), text("cde")), env.ended()), (text("abcde"), false));
        assert_eq!(concat(env, text("abc"), text("cde")), text(""));
        assert_eq!(limit(env), Some(LimitKind::Text));
        let env = &mut small_env(0, 5);
        assert_eq!(replace(env, text("aaa"), text("a"), text("bb")), text(""));
        assert_eq!(limit(env), Some(LimitKind::Text));
    }

    #[test]
    fn parts_add_up_to_the_text() {
        let mut random = Random(84);
        for _ in 0..5_000 {
            let env = &mut env();
            let whole: String = (0..random.below(8)).map(|_| ['a', 'b', 'ü', '✓', '😀'][random.below(5)]).collect();
            let at = random.below(10) as f64 - 1.0;
            let (left, right) = (substring(env, text(&whole), 0.0, at), substring(env, text(&whole), at, 99.0));
            assert_eq!(concat(env, left, right), text(&whole));
            let part: String = (0..random.below(3)).map(|_| ['a', 'b', 'ü'][random.below(3)]).collect();
            let found = count(text(&whole), text(&part));
            for n in 0..12 {
                let place = find(env, text(&whole), text(&part), f64::from(n));
                assert_eq!(f64::from(n) < found, 0.0 <= place);
                if 0.0 <= place {
                    let end = place + len(text(&part));
                    assert_eq!(substring(env, text(&whole), place, end), text(&part));
                }
            }
        }
    }
}
