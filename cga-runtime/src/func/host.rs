//! Rust in rules: values (`#name`) and operations (`path::call(…)`).

use crate::fault::{Fault, FaultKind};
use crate::func;
use crate::func::limit::ELEMENT;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::value::Value;
use crate::value::array::Array;
use crate::value::text::Text;

/// A Rust value that a rule can use as a number.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number that a rule can use",
    label = "the rule needs a number here"
)]
pub trait ToFloat {
    /// The value as a 64-bit float.
    fn to_float(&self) -> f64;
}

macro_rules! floats {
    ($($ty:ty)*) => {$(
        impl ToFloat for $ty {
            fn to_float(&self) -> f64 {
                *self as f64
            }
        }

        impl Show for $ty {
            fn show(&self) -> Text {
                func::float_to_text(*self as f64)
            }
        }
    )*};
}

floats! { f64 f32 i8 i16 i32 i64 isize u8 u16 u32 u64 usize }

#[diagnostic::do_not_recommend]
impl<T: ToFloat + ?Sized> ToFloat for &T {
    fn to_float(&self) -> f64 {
        (**self).to_float()
    }
}

/// A Rust value that a rule can use as a truth value.
#[diagnostic::on_unimplemented(message = "`{Self}` is not a `bool`", label = "the rule needs a `bool` here")]
pub trait ToBool {
    /// The value as a bool.
    fn to_bool(&self) -> bool;
}

impl ToBool for bool {
    fn to_bool(&self) -> bool {
        *self
    }
}

#[diagnostic::do_not_recommend]
impl<T: ToBool + ?Sized> ToBool for &T {
    fn to_bool(&self) -> bool {
        (**self).to_bool()
    }
}

/// A Rust value that a rule can use as text.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not text that a rule can use",
    label = "the rule needs text here"
)]
pub trait ToText {
    /// The value as text.
    fn to_text(&self) -> Text;
}

impl ToText for str {
    fn to_text(&self) -> Text {
        Text::from(self)
    }
}

impl ToText for String {
    fn to_text(&self) -> Text {
        Text::from(self.as_str())
    }
}

impl ToText for Text {
    fn to_text(&self) -> Text {
        self.clone()
    }
}

#[diagnostic::do_not_recommend]
impl<T: ToText + ?Sized> ToText for &T {
    fn to_text(&self) -> Text {
        (**self).to_text()
    }
}

macro_rules! to_arrays {
    ($($(#[$doc:meta])* $name:ident, $method:ident, $item:ty, $one:ident, $convert:ident;)*) => {$(
        $(#[$doc])*
        #[diagnostic::on_unimplemented(
            message = "`{Self}` is not an array that a rule can use",
            label = "the rule needs an array here"
        )]
        pub trait $name {
            /// The value as an array.
            fn $method(&self) -> Array<$item>;
        }

        impl $name for Array<$item> {
            fn $method(&self) -> Array<$item> {
                self.clone()
            }
        }

        impl<T: $one> $name for [T] {
            fn $method(&self) -> Array<$item> {
                self.iter().map(|value| value.$convert()).collect()
            }
        }

        impl<T: $one> $name for Vec<T> {
            fn $method(&self) -> Array<$item> {
                self.as_slice().$method()
            }
        }

        impl<T: $one, const N: usize> $name for [T; N] {
            fn $method(&self) -> Array<$item> {
                self.as_slice().$method()
            }
        }

        #[diagnostic::do_not_recommend]
        impl<T: $name + ?Sized> $name for &T {
            fn $method(&self) -> Array<$item> {
                (**self).$method()
            }
        }
    )*};
}

to_arrays! {
    /// A Rust value that a rule can use as an array of numbers.
    ToFloats, to_floats, f64, ToFloat, to_float;
    /// A Rust value that a rule can use as an array of truth values.
    ToBools, to_bools, bool, ToBool, to_bool;
    /// A Rust value that a rule can use as an array of texts.
    ToTexts, to_texts, Text, ToText, to_text;
}

/// A Rust value that a rule joins with text: text, or a number or truth value that is converted to text.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot become text in a rule",
    label = "the rule needs text, a number or a `bool` here"
)]
pub trait Show {
    /// The value as text.
    fn show(&self) -> Text;
}

impl Show for bool {
    fn show(&self) -> Text {
        func::bool_to_text(*self)
    }
}

macro_rules! texts {
    ($($ty:ty)*) => {$(
        impl Show for $ty {
            fn show(&self) -> Text {
                self.to_text()
            }
        }
    )*};
}

texts! { str String Text }

#[diagnostic::do_not_recommend]
impl<T: Show + ?Sized> Show for &T {
    fn show(&self) -> Text {
        (**self).show()
    }
}

/// The return type of an operation written in Rust.
#[diagnostic::on_unimplemented(
    message = "an operation cannot return `{Self}`",
    label = "this operation must return `()` or `Result<(), cga::Fault>`"
)]
pub trait Outcome {
    /// The outcome as a result.
    fn outcome(self) -> Result<(), Fault>;
}

impl Outcome for () {
    fn outcome(self) -> Result<(), Fault> {
        Ok(())
    }
}

impl Outcome for Result<(), Fault> {
    fn outcome(self) -> Result<(), Fault> {
        self
    }
}

/// Runs an operation written in Rust on the current shape. After a fault the shape keeps the operation's changes,
/// unless they make it invalid.
pub fn operate<R: Outcome>(env: &mut Env, shape: &mut Shape, operation: impl FnOnce(&mut Shape) -> R) {
    let mut own = shape.clone();
    if let Err(fault) = operation(&mut own).outcome() {
        env.fault(fault.kind, fault.message);
    }
    match own.check() {
        Ok(()) => *shape = own,
        Err(_) => {
            env.fault(FaultKind::Value, "the operation made a size or position that is not finite; it is skipped")
        }
    }
}

/// Text for an argument of a Rust function.
pub fn as_str(text: &Text) -> &str {
    text.as_str()
}

/// A result of a Rust function that may be large.
pub trait Counted {
    /// The bytes that the value counts for in [`Limits::bytes`](crate::run::settings::Limits::bytes).
    fn bytes(&self) -> usize;
}

impl Counted for Text {
    fn bytes(&self) -> usize {
        self.len()
    }
}

impl Counted for Array<f64> {
    fn bytes(&self) -> usize {
        self.len().saturating_mul(ELEMENT)
    }
}

impl Counted for Array<bool> {
    fn bytes(&self) -> usize {
        self.len().saturating_mul(ELEMENT)
    }
}

impl Counted for Array<Text> {
    fn bytes(&self) -> usize {
        self.into_iter().map(|text| text.len() + ELEMENT).fold(0, usize::saturating_add)
    }
}

/// A result of a Rust function, which counts. The limits of texts and arrays do not apply: the program has made the value.
pub fn counted<T: Counted>(env: &mut Env, value: T) -> T {
    env.count_result(value.bytes());
    value
}

/// Counts a result of a Rust function that loaded rules call.
pub fn count(env: &mut Env, value: &Value) {
    env.count_result(match value {
        Value::Text(text) => text.bytes(),
        Value::Floats(array) => array.bytes(),
        Value::Bools(array) => array.bytes(),
        Value::Texts(array) => array.bytes(),
        _ => 0,
    });
}

/// The type of an argument of a Rust function.
pub trait Argument: Clone + Default {
    /// The value, if it has this type.
    fn of(value: &Value) -> Option<&Self>;
}

macro_rules! arguments {
    ($($ty:ty => $variant:ident,)*) => {$(
        impl Argument for $ty {
            fn of(value: &Value) -> Option<&Self> {
                if let Value::$variant(own) = value { Some(own) } else { None }
            }
        }
    )*};
}

arguments! { f64 => Float, bool => Bool, Text => Text, Array<f64> => Floats, Array<bool> => Bools, Array<Text> => Texts, }

/// An argument of a Rust function that loaded rules call. They check the types before.
pub fn argument<T: Argument>(args: &[Value], number: usize) -> T {
    args.get(number).and_then(T::of).cloned().unwrap_or_default()
}

/// The value of a function that the host program has registered. A value of another type than `other` is a fault, and counts as
/// `other`.
pub fn of_type(env: &mut Env, name: &str, value: Value, other: &Value) -> Value {
    if value.ty() == other.ty() {
        return value;
    }
    let (got, wanted) = (value.ty(), other.ty());
    env.fault(
        FaultKind::Value,
        format!("`{name}` returned {got}, but the rules need {wanted}; it counts as 0 or empty"),
    );
    other.clone()
}
