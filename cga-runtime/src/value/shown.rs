//! Text from rules, files and the host in messages.

use crate::geometry::obj::escaped;
use crate::value::text::shortened;

/// The text, shortened and [escaped](escaped) for a message.
pub(crate) fn shown(text: &str) -> String {
    escaped(&shortened(text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_text_is_cut_before_it_is_escaped() {
        assert_eq!(shown(&"\n".repeat(100)), format!("{}…", "\\n".repeat(80)));
    }
}
