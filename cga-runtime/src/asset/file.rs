//! The name of a file, as rules have it.

use std::fmt;

use crate::value::text::Text;

/// The name of a file, and the folder of the rule file that names it: relative names are looked for from there (*Asset
/// search*).
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct File {
    /// As the rules have it.
    pub(crate) name: Text,
    /// A path from the package or the asset folder, empty for rules that are in no file.
    pub(crate) folder: &'static str,
}

impl File {
    /// A name that stands in a rule file of some folder.
    #[inline]
    pub fn new(name: Text, folder: &'static str) -> Self {
        File { name, folder }
    }
}

impl From<&str> for File {
    fn from(name: &str) -> Self {
        File::new(name.into(), "")
    }
}

impl fmt::Display for File {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}
