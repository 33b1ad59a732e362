//! The known differences of runs with boxes and runs with meshes. The law holds in full when this list is empty.

/// A known difference.
struct Known {
    /// The part of a written line, or the name of what is compared, that is left out.
    name: &'static str,
    /// The reason.
    #[allow(dead_code, reason = "it is for readers")]
    why: &'static str,
}

/// Every known difference.
const KNOWN_DIFFERENCES: &[Known] = &[
    Known { name: "the caps", why: "a side of a cut box that `comp(f)` makes a rectangle loses its flag" },
    Known { name: "azimuth", why: "opposite faces of a tilted box are equally steep but for rounding" },
    Known { name: "trim", why: "the trim planes of a box's side have another order than those of a mesh's face" },
];

/// Whether a line has a known difference in it.
pub(crate) fn in_line(line: &str) -> bool {
    KNOWN_DIFFERENCES.iter().any(|known| line.contains(known.name))
}

/// Whether runs are known to differ in that.
pub(crate) fn is_known(name: &str) -> bool {
    KNOWN_DIFFERENCES.iter().any(|known| known.name == name)
}
