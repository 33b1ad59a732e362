//! Tags of components, and the queries that find them (*Geometry tagging*).

use std::sync::Arc;

use crate::value::text::Text;

/// Tags of a face: sorted, none twice. Names are in parts, as in `extrude.side.outer`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TagSet(Arc<[Text]>);

impl TagSet {
    /// Of some names.
    pub fn new(names: impl IntoIterator<Item = Text>) -> Self {
        let mut names: Vec<Text> = names.into_iter().collect();
        names.sort_unstable();
        names.dedup();
        TagSet(names.into())
    }

    /// The names.
    pub fn names(&self) -> &[Text] {
        &self.0
    }

    /// Whether a query finds one of them.
    pub fn matches(&self, query: &str) -> bool {
        self.0.iter().any(|name| matches(query, name))
    }

    /// These without those below a name, and with another one: what an operation that tags its faces leaves.
    pub(crate) fn renewed(&self, below: &str, name: &str) -> Self {
        let others = self.0.iter().filter(|name| !matches(below, name)).cloned();
        TagSet::new(others.chain([Text::from(name)]))
    }
}

/// Whether a query finds a tag: its parts are the first ones of the tag, where `?` stands for any part and `*` for one or
/// more (*Geometry tagging*, tag queries).
pub(crate) fn matches(query: &str, tag: &str) -> bool {
    let parts: Vec<&str> = tag.split('.').collect();
    // Which numbers of parts the query up to here may have taken.
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
    }

    #[test]
    fn a_set_is_renewed() {
        let set = TagSet::new(["roof.top", "extrude.top", "roof.top"].map(Text::from));
        assert_eq!(set.names().len(), 2);
        let set = set.renewed("extrude", "extrude.side.outer");
        assert!(set.matches("extrude.side") && set.matches("roof") && !set.matches("extrude.top"));
    }
}
