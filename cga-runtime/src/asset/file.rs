//! File names in rules.

use std::fmt;

use crate::geometry::obj::escaped;
use crate::value::array::Array;
use crate::value::text::Text;

/// The name of a file, with the folder of the rule file that names it. Relative names are looked up from that folder
/// (*Asset search*).
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct File {
    /// The name as written in the rules.
    pub(crate) name: Text,
    /// A path relative to the package or the asset folder. Empty for rules that are not in a file.
    pub(crate) folder: Text,
}

impl File {
    /// A name in a rule file in the folder `folder`.
    #[inline]
    pub fn new(name: Text, folder: Text) -> Self {
        File { name, folder }
    }
}

impl From<&str> for File {
    fn from(name: &str) -> Self {
        File::new(name.into(), Text::default())
    }
}

/// Names of files in an array, with the folder of the rule file that names them.
#[derive(Clone, Debug, PartialEq)]
pub struct Files {
    pub(crate) names: Array<Text>,
    pub(crate) folder: Text,
}

impl Files {
    /// Names in a rule file in the folder `folder`.
    #[inline]
    pub fn new(names: Array<Text>, folder: Text) -> Self {
        Files { names, folder }
    }
}

/// The name as written in the rules, escaped for messages.
impl fmt::Display for File {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&escaped(&self.name))
    }
}
