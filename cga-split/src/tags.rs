//! Names of component tags and queries for them (*Geometry tagging*).

/// Returns true if a query matches a tag: the parts of the query match the first parts of the tag, where `?` matches
/// any part and `*` one or more (*Geometry tagging*, tag queries).
pub fn matches(query: &str, tag: &str) -> bool {
    let parts: Vec<&str> = tag.split('.').collect();
    // For each number of parts, whether the query so far can match exactly these parts.
    let mut taken = vec![false; parts.len() + 1];
    taken[0] = true;
    for part in query.split('.') {
        let mut next = vec![false; parts.len() + 1];
        for at in 0..parts.len() {
            next[at + 1] = match part {
                "*" => taken[at] || next[at],
                "?" => taken[at],
                _ => taken[at] && part == parts[at],
            };
        }
        taken = next;
    }
    taken.contains(&true)
}

/// The wildcards of queries, which names do not have.
pub const WILDCARDS: [char; 2] = ['?', '*'];

/// The name of a tag that rules give: the text without wildcards (*tag operation*).
pub fn name(text: &str) -> String {
    text.replace(WILDCARDS, "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn queries_match_as_documented() {
        assert!(matches("Facade", "Facade") && matches("Facade", "Facade.TypeA.Side.Left"));
        assert!(!matches("Facade", "Facades") && !matches("Facade.Front", "Facade"));
        assert!(matches("?.Front", "Facade.Front") && !matches("?.Front", "Front"));
        assert!(!matches("?.Front", "A.B.Front"));
        assert!(matches("Facade.*.Left", "Facade.A.Left") && matches("Facade.*.Left", "Facade.A.B.Left.C"));
        assert!(!matches("Facade.*.Left", "Facade.Left"));
        assert!(matches("*", "anything") && matches("envelope.side", "envelope.side.slope"));
        assert!(!matches("", "a") && matches("", "") && matches("*", ""));
    }

    #[test]
    fn names_have_no_wildcards() {
        assert_eq!((name("a?.*b"), name("*"), name("a.b")), ("a.b".into(), String::new(), "a.b".into()));
    }
}
