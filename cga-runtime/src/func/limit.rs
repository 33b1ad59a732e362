//! Limits on the results of functions: elements of arrays, bytes of text.

use std::fmt::{self, Write};

use crate::fault::LimitKind;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::value::text::Text;

impl Env {
    /// Returns true if an array may have `elements` elements. If not, the run ends.
    pub(crate) fn may_hold(&mut self, elements: usize) -> bool {
        let limit = self.settings.limits.array;
        self.within(LimitKind::Array, elements, limit)
    }

    /// Returns true if a text may have `bytes` bytes. If not, the run ends.
    pub(crate) fn may_write(&mut self, bytes: usize) -> bool {
        let limit = self.settings.limits.text;
        self.within(LimitKind::Text, bytes, limit)
    }

    fn within(&mut self, what: LimitKind, count: usize, limit: u64) -> bool {
        let _: Flow = self.spend(count);
        let fits = count as u64 <= limit;
        if !fits {
            let _: Flow = self.limit(what, limit);
        }
        fits
    }

    /// The value as text. If it is longer than the limit, the run ends and the text is empty.
    pub(super) fn write(&mut self, text: impl fmt::Display) -> Text {
        let mut out = Bounded { text: String::new(), longest: self.settings.limits.text };
        match write!(out, "{text}") {
            Ok(()) => {
                let _: Flow = self.spend(out.text.len());
                Text::from(out.text)
            }
            Err(_) => {
                let _: Flow = self.limit(LimitKind::Text, out.longest);
                Text::default()
            }
        }
    }
}

/// Text with a maximum length in bytes. Writing beyond it is an error.
struct Bounded {
    text: String,
    longest: u64,
}

impl Write for Bounded {
    fn write_str(&mut self, more: &str) -> fmt::Result {
        if self.longest < (self.text.len() + more.len()) as u64 {
            return Err(fmt::Error);
        }
        self.text.push_str(more);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{limit, small_env};
    use super::*;

    #[test]
    fn what_is_too_large_ends_the_run() {
        let mut env = small_env(3, 5);
        assert!(env.may_hold(3) && env.may_write(5) && env.write("äaüb").is_empty());
        assert_eq!(limit(&env), Some(LimitKind::Text));
        let mut env = small_env(3, 5);
        assert_eq!(env.write("abcde").as_str(), "abcde");
        assert!(!env.may_hold(4) && env.ended());
        assert_eq!(limit(&env), Some(LimitKind::Array));
    }
}
