use super::*;
use crate::func::tests::Random;

/// All matches in order, including empty ones.
fn matches(pattern: &str, text: &str) -> Vec<String> {
    let pattern = Regex::new(pattern).unwrap_or_else(|error| panic!("{pattern}: {error}"));
    let text: Vec<char> = text.chars().collect();
    let mut search = RegexSearch::new(&pattern, &text).unwrap();
    let (mut list, mut from) = (Vec::new(), 0);
    while let Some((start, end)) = search.find(from).unwrap() {
        list.push(text[start..end].iter().collect());
        from = if start < end { end } else { end + 1 };
    }
    list
}

#[test]
fn patterns_match_as_in_perl() {
    let cases: &[(&str, &str, &[&str])] = &[
        ("a", "banana", &["a", "a", "a"]),
        ("a|an", "banana", &["a", "a", "a"]),
        ("an|a", "banana", &["an", "an", "a"]),
        ("a.", "ab a\na", &["ab"]),
        ("(?s)a.", "a\n", &["a\n"]),
        ("[^a-y]+", "abzz☃c", &["zz☃"]),
        (r"[\d.]+", "a1.5b", &["1.5"]),
        (r"[^\W_]+", "a_b c", &["a", "b", "c"]),
        ("[]a]+", "x]a]", &["]a]"]),
        ("[a-]+", "b-a", &["-a"]),
        (r"\w+\s*=\s*(\w+)", "k =v;a=b", &["k =v", "a=b"]),
        ("a*", "baa", &["", "aa", ""]),
        ("a+?", "aa", &["a", "a"]),
        ("<.*>", "<a><b>", &["<a><b>"]),
        ("<.*?>", "<a><b>", &["<a>", "<b>"]),
        ("a{2}", "aaaaa", &["aa", "aa"]),
        ("a{2,}", "a aaaaa", &["aaaaa"]),
        ("a{1,2}", "aaa", &["aa", "a"]),
        ("a{1,2}?b", "aaab", &["aab"]),
        ("a{,2}", "a{,2}", &["a{,2}"]),
        ("{a}", "{a}", &["{a}"]),
        ("(?:ab)+c", "ababc", &["ababc"]),
        ("^a|a$", "aaa", &["a", "a"]),
        ("(?m)^b", "a\nb", &["b"]),
        ("(?i)ÄB[c-d]", "äbD", &["äbD"]),
        (r"\bcat\b", "cat concat cat", &["cat", "cat"]),
        (r"\x41\x{1F600}\u00e9", "A😀é", &["A😀é"]),
        (r"\(\[\.\*", "([.*", &["([.*"]),
        ("(?<=a)b(?=a)", "abacbab", &["b"]),
        (r"(?<!\d)\d{2}(?!\d)", "123 45 6", &["45"]),
        (r"(?<=k\d*)v", "k12v k v kv", &["v", "v"]),
        ("(?<=(?<!x)a)b", "ab xab", &["b"]),
        ("(?:a*)*b", "aab", &["aab"]),
        ("(?:|a)+", "aa", &["aa", ""]),
        ("(?:a|b*)*c", "abbac", &["abbac"]),
        ("", "ab", &["", "", ""]),
    ];
    for (pattern, text, expected) in cases {
        assert_eq!(matches(pattern, text), *expected, "{pattern} in {text:?}");
    }
}

#[test]
fn wrong_patterns_are_refused() {
    let wrong = [
        "(a",
        "a)",
        "[a",
        "[",
        "*a",
        "a|*",
        "a**",
        "a++",
        r"\",
        r"(a)\1",
        r"\pL",
        "[z-a]",
        "[a-\\d]",
        "(?P<n>a)",
        "(?>a)",
        "a{3,2}",
        "a{2000}",
        "a{9999999999}",
        r"\x4",
        r"\u{110000}",
        r"\x{}",
        "[[:alpha:]]",
        "(?i",
        "(?",
    ];
    for pattern in wrong {
        assert!(Regex::new(pattern).is_err(), "{pattern}");
    }
    for huge in ["(((a{99}){99}){99})".to_owned(), "(".repeat(10_000), "((".to_owned() + &"a{1000}".repeat(100) + "))"]
    {
        assert!(Regex::new(&huge).is_err());
    }
}

#[test]
fn no_pattern_takes_for_ever() {
    let text = "a".repeat(20_000);
    for pattern in ["(a+)+b", "(a|a)*b", "(a*)*b", "(?:a?){50}a{50}b", "((a*)*)*b", "(?=(a+)+b)", "(?<=b(a+)+)c"] {
        let pattern = Regex::new(pattern).unwrap();
        let text: Vec<char> = text.chars().collect();
        let mut search = RegexSearch::new(&pattern, &text).unwrap();
        assert!(matches!(search.find(0), Ok(None) | Err(TooLong)));
    }
    // Each match looks ahead to the end of the text.
    let pattern = Regex::new("a(?=.*c)b|a").unwrap();
    let text: Vec<char> = text.chars().chain(['c']).collect();
    let mut search = RegexSearch::new(&pattern, &text).unwrap();
    let mut from = 0;
    while let Ok(Some((_, end))) = search.find(from) {
        from = end;
    }
    assert_eq!(search.find(text.len()), Err(TooLong));
    let nothing: Vec<char> = vec!['a'; 20_000_000];
    assert!(RegexSearch::new(&Regex::new("a*").unwrap(), &nothing).is_err());
    assert!(Regex::new("(?:(?:(?:){1000}){1000}){1000}").is_ok());
}

/// The matches of a pattern by the simplest algorithm: all possible ends from a position, in order of preference.
/// Exponential, for small cases.
mod plain {
    /// The patterns that this algorithm supports.
    #[derive(Clone, Debug)]
    pub(super) enum Plain {
        Letter(char),
        Both(Box<Plain>, Box<Plain>),
        Either(Box<Plain>, Box<Plain>),
        Many(Box<Plain>),
        Maybe(Box<Plain>),
        Before(Box<Plain>),
        Behind(Box<Plain>),
    }

    impl Plain {
        pub(super) fn pattern(&self) -> String {
            match self {
                Plain::Letter(c) => c.to_string(),
                Plain::Both(a, b) => format!("{}{}", a.pattern(), b.pattern()),
                Plain::Either(a, b) => format!("(?:{}|{})", a.pattern(), b.pattern()),
                Plain::Many(a) => format!("(?:{})*", a.pattern()),
                Plain::Maybe(a) => format!("(?:{})??", a.pattern()),
                Plain::Before(a) => format!("(?={})", a.pattern()),
                Plain::Behind(a) => format!("(?<={})", a.pattern()),
            }
        }

        pub(super) fn ends(&self, text: &[char], at: usize) -> Vec<usize> {
            match self {
                Plain::Letter(c) => text.get(at).filter(|other| *other == c).map(|_| at + 1).into_iter().collect(),
                Plain::Both(a, b) => a.ends(text, at).into_iter().flat_map(|at| b.ends(text, at)).collect(),
                Plain::Either(a, b) => a.ends(text, at).into_iter().chain(b.ends(text, at)).collect(),
                Plain::Many(a) => {
                    let further = a.ends(text, at).into_iter().filter(|end| *end != at);
                    further.flat_map(|at| self.ends(text, at)).chain([at]).collect()
                }
                Plain::Maybe(a) => [at].into_iter().chain(a.ends(text, at)).collect(),
                Plain::Before(a) => (!a.ends(text, at).is_empty()).then_some(at).into_iter().collect(),
                Plain::Behind(a) => {
                    let found = (0..=at).any(|start| a.ends(text, start).contains(&at));
                    found.then_some(at).into_iter().collect()
                }
            }
        }
    }
}

#[test]
fn matches_agree_with_a_plain_matcher() {
    use plain::Plain;
    fn make(random: &mut Random, depth: usize) -> Plain {
        if depth == 0 {
            return Plain::Letter(['a', 'b'][random.below(2)]);
        }
        let mut inner = || Box::new(make(random, depth - 1));
        let (a, b) = (inner(), inner());
        match random.below(8) {
            0 | 1 => Plain::Both(a, b),
            2 | 3 => Plain::Either(a, b),
            4 => Plain::Many(a),
            5 => Plain::Maybe(a),
            6 => Plain::Before(a),
            _ => Plain::Behind(a),
        }
    }
    let mut random = Random(86);
    for _ in 0..3_000 {
        let depth = random.below(4);
        let plain = make(&mut random, depth);
        let text: Vec<char> = (0..random.below(7)).map(|_| ['a', 'b', 'c'][random.below(3)]).collect();
        let pattern = Regex::new(&plain.pattern()).unwrap();
        let mut search = RegexSearch::new(&pattern, &text).unwrap();
        for from in 0..=text.len() {
            let expected = (from..=text.len()).find_map(|start| Some((start, *plain.ends(&text, start).first()?)));
            let found = search.find(from).unwrap();
            assert_eq!(found.map(|(start, _)| start), expected.map(|(start, _)| start), "{} {text:?}", plain.pattern());
            assert_eq!(found, expected, "{} {text:?} from {from}", plain.pattern());
        }
    }
}

#[test]
fn nothing_is_left_over() {
    let matches = |pattern, text| Regex::whole(pattern).expect("a pattern").matches(text).0;
    assert!(matches("a|ab", "ab") && matches("a|ab", "a") && matches("(?i)A.", "ab") && matches("", ""));
    assert!(!matches("a|ab", "abc") && !matches("b", "ab") && !matches("", "a") && !matches("a|b", "ab"));
    assert!(Regex::whole("(").is_err());
    assert!(!matches("(?=(a|b)+c)*x", &"ab".repeat(10)));
}
