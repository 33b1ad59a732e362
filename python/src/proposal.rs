//! Names that may be meant in place of a column that does not exist.

use cga_split::suggest::nearest;

/// The most names of a message.
const MOST: usize = 30;

/// Returns the end of the message about an unknown name: the nearest name, and the names of all. `kind` is their kind in the plural, such as `columns`.
pub(crate) fn proposal<'n>(name: &str, kind: &str, known: impl IntoIterator<Item = &'n str>) -> String {
    let known: Vec<&str> = known.into_iter().collect();
    let shown = known[..known.len().min(MOST)].join(", ");
    let more = if MOST < known.len() { format!(" and {} more", known.len() - MOST) } else { String::new() };
    match nearest(name, known) {
        Some(near) => format!("did you mean `{near}`? The {kind} are {shown}{more}"),
        None if shown.is_empty() => format!("it has no {kind}"),
        None => format!("the {kind} are {shown}{more}"),
    }
}
