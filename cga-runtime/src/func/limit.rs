//! Limits on the results of functions: elements of arrays, bytes of text.

use std::fmt::{self, Write};

use crate::fault::LimitKind;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::value::array::Array;
use crate::value::text::Text;

/// The bytes of a value up to which it does not count for [`Limits::bytes`](crate::run::settings::Limits::bytes).
const SHORT: usize = 256;

/// The bytes that an element of an array counts for.
pub(super) const ELEMENT: usize = 16;

impl Env {
    /// Returns true if an array of `elements` elements may be made, and counts it. If not, the run ends.
    pub(crate) fn may_hold(&mut self, elements: usize) -> bool {
        self.may_grow(elements) && self.count_value(elements.saturating_mul(ELEMENT))
    }

    /// Returns true if an array that is being made may have `elements` elements. If not, the run ends.
    pub(crate) fn may_grow(&mut self, elements: usize) -> bool {
        let limit = self.settings.limits.array;
        self.within(LimitKind::Array, elements, limit)
    }

    /// Returns true if a text of `bytes` bytes may be made, and counts it. If not, the run ends.
    pub(crate) fn may_write(&mut self, bytes: usize) -> bool {
        self.may_print(bytes) && self.count_value(bytes)
    }

    /// Returns true if texts that are being made may have `bytes` bytes. If not, the run ends.
    pub(crate) fn may_print(&mut self, bytes: usize) -> bool {
        let limit = self.settings.limits.text;
        self.within(LimitKind::Text, bytes, limit)
    }

    /// Returns true if the run goes on and the count is within the limit.
    fn within(&mut self, what: LimitKind, count: usize, limit: u64) -> bool {
        if limit < count as u64 {
            let _: Flow = self.limit(what, limit);
        }
        let flow: Flow = self.spend(count);
        flow.is_continue() && !self.ended()
    }

    /// Counts a value that a function makes for [`Limits::bytes`](crate::run::settings::Limits::bytes). Short values do not
    /// count: rules make very many, and hold few. Returns true if the run goes on.
    fn count_value(&mut self, bytes: usize) -> bool {
        if SHORT < bytes {
            let _: Flow = self.count_bytes(bytes as u64);
        }
        !self.ended()
    }

    /// Counts a result of a Rust function. If it passes a limit, the run ends.
    pub(super) fn count_result(&mut self, bytes: usize) {
        let _: Flow = self.spend(bytes);
        self.count_value(bytes);
    }

    /// A part of a text, as a text of its own. If it is longer than the limit, the run ends and the text is empty.
    pub(super) fn copy(&mut self, part: &str) -> Text {
        if self.may_write(part.len()) { Text::from(part) } else { Text::default() }
    }

    /// Parts of a text in one row. If they are too many or too long, the run ends and the array is empty.
    pub(super) fn copy_all<'t>(&mut self, parts: impl Iterator<Item = &'t str> + Clone) -> Array<Text> {
        // Counts first, so that a text with many parts is refused before they are made.
        let (count, bytes) = parts.clone().fold((0, 0), |(count, bytes), part| (count + 1, bytes + part.len()));
        if self.may_hold(count) && self.may_write(bytes) { parts.map(Text::from).collect() } else { Array::default() }
    }

    /// An array with `each` applied to every element. If the run has ended or ends, the array is empty.
    pub(super) fn map<T, R>(&mut self, array: &Array<T>, each: impl FnMut(&T) -> R) -> Array<R> {
        if self.may_hold(array.len()) { array.map(each) } else { Array::default() }
    }

    /// The value as text. If it is longer than the limit, the run ends and the text is empty.
    pub(super) fn write(&mut self, text: impl fmt::Display) -> Text {
        if self.ended() {
            return Text::default();
        }
        let mut out = Bounded { text: String::new(), longest: self.settings.limits.text };
        match write!(out, "{text}") {
            Ok(()) => {
                let _: Flow = self.spend(out.text.len());
                if self.count_value(out.text.len()) { Text::from(out.text) } else { Text::default() }
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
    use crate::func;
    use crate::run::settings::{Limits, Settings};
    use crate::shape::Shape;

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

    #[test]
    fn long_values_count_for_the_limit_of_bytes() {
        let bytes = 1_000_000 + Limits::BYTES_A_SHAPE;
        let most = |make: &dyn Fn(&mut Env) -> bool| {
            let settings = Settings { limits: Limits { bytes, ..Limits::default() }, ..Settings::default() };
            let env = &mut Env::with_names(&settings, &[], &Shape::rectangle(1.0, 1.0), "");
            env.shapes = 1;
            let made = (0..10_000).take_while(|_| make(env)).count();
            assert!(made == 10_000 || limit(env) == Some(LimitKind::Bytes));
            made as u64
        };
        assert_eq!(most(&|env| env.may_write(1000)), bytes / 1000);
        assert_eq!(most(&|env| !env.write("x".repeat(1000)).is_empty()), bytes / 1000);
        assert_eq!(most(&|env| env.may_hold(100)), bytes / 1600);
        let parts: [fn(&mut Env, Text) -> bool; 9] = [
            |env, text| !func::list_first(env, text).is_empty(),
            |env, text| !func::list_last(env, text).is_empty(),
            |env, text| !func::list_item(env, text, 0.0).is_empty(),
            |env, text| !func::list_random(env, &mut Shape::rectangle(1.0, 1.0), text).is_empty(),
            |env, text| !func::file_name(env, text).is_empty(),
            |env, text| !func::file_basename(env, text).is_empty(),
            |env, text| !func::list_to_array(env, text).is_empty(),
            |env, text| !func::split_string(env, text, "/".into()).is_empty(),
            |env, text| !func::split_string(env, text, "$/".into()).is_empty(),
        ];
        for (number, part) in parts.into_iter().enumerate() {
            assert_eq!(most(&|env| part(env, "x".repeat(1000).into())), bytes / 1000, "{number}");
        }
        let extension = |env: &mut Env| !func::file_extension(env, format!(".{}", "x".repeat(1000)).into()).is_empty();
        assert_eq!(most(&extension), bytes / 1000);
        let directory = |env: &mut Env| !func::file_directory(env, format!("{}/", "x".repeat(999)).into()).is_empty();
        assert_eq!(most(&directory), bytes / 1000);
        let arrays: [fn(&mut Env, Array<f64>) -> bool; 11] = [
            |env, array| !func::each_minus(env, array).is_empty(),
            |env, array| !func::each_not(env, array.map(|_| true)).is_empty(),
            |env, array| !func::each_add(env, array, 1.0).is_empty(),
            |env, array| !func::each_concat(env, array, Text::default()).is_empty(),
            |env, array| !func::clamp_each(env, array.clone(), array.clone(), array).is_empty(),
            |env, array| !func::transpose(env, array).is_empty(),
            |env, array| !func::sort_indices(env, array).is_empty(),
            |env, array| !func::sort_row_indices(env, array).is_empty(),
            |env, array| !func::floor_each(env, array).is_empty(),
            |env, array| !func::bools_from_floats(env, array).is_empty(),
            |env, array| !func::isnull_float_each(env, array).is_empty(),
        ];
        for (number, array) in arrays.into_iter().enumerate() {
            assert_eq!(most(&|env| array(env, Array::new(vec![1.0; 100], 100, 1))), bytes / 1600, "{number}");
        }
        // Short values do not count, and values in the making count once.
        assert_eq!(most(&|env| env.may_write(256) && env.may_hold(16)), 10_000);
        assert_eq!(most(&|env| env.may_print(1000) && env.may_grow(100)), 10_000);
    }

    #[test]
    fn a_run_that_has_ended_makes_no_texts_and_arrays() {
        let env = &mut small_env(3, 5);
        assert!(!env.may_write(6) && env.ended());
        assert!(!env.may_write(1) && !env.may_hold(1) && !env.may_print(1) && !env.may_grow(1));
        assert!(env.write("a").is_empty());
    }
}
