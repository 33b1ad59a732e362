//! The stack of a run: parameters and locals of rules and functions, and intermediate values.
//!
//! Numbers and truth values are apart from other values, which are larger and have to be dropped. Types are checked when rules are
//! loaded, so a value that is missing or has another type cannot occur; it would count as 0 or empty.

use std::cell::RefCell;

use cga_lang::ir::Type;
use cga_runtime::rt::{Array, File, Files, Text, Value};

use crate::object::{Object, nothing};

/// The place of the parameters and locals of a rule or function, and its site.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Frame {
    /// The number of numbers below the parameters.
    pub(crate) numbers: usize,
    /// The number of objects below the parameters.
    pub(crate) objects: usize,
    /// The site of a shared rule or function.
    pub(crate) site: u32,
}

/// The values.
#[derive(Debug, Default)]
pub(crate) struct Stack {
    pub(crate) numbers: Vec<f64>,
    pub(crate) objects: Vec<Object>,
}

macro_rules! objects {
    ($($pop:ident $push:ident $ty:ty = $variant:ident;)*) => {$(
        /// Takes the last object.
        pub(crate) fn $pop(&mut self) -> $ty {
            match self.objects.pop() {
                Some(Object::$variant(value)) => value,
                _ => <$ty>::default(),
            }
        }

        /// Adds an object.
        pub(crate) fn $push(&mut self, value: $ty) {
            self.objects.push(Object::$variant(value));
        }
    )*};
}

impl Stack {
    /// Takes the last number.
    #[inline]
    pub(crate) fn float(&mut self) -> f64 {
        self.numbers.pop().unwrap_or_default()
    }

    /// Takes the last number as a truth value.
    #[inline]
    pub(crate) fn bool(&mut self) -> bool {
        self.float() != 0.0
    }

    /// Adds a number.
    #[inline]
    pub(crate) fn push_float(&mut self, value: f64) {
        self.numbers.push(value);
    }

    /// Adds a truth value.
    #[inline]
    pub(crate) fn push_bool(&mut self, value: bool) {
        self.numbers.push(f64::from(u8::from(value)));
    }

    objects! {
        text push_text Text = Text;
        floats push_floats Array<f64> = Floats;
        bools push_bools Array<bool> = Bools;
        texts push_texts Array<Text> = Texts;
    }

    /// Takes the last object, the name of a file.
    pub(crate) fn file(&mut self) -> File {
        match self.objects.pop() {
            Some(Object::File(file)) => *file,
            Some(Object::Text(name)) => File::new(name, Text::default()),
            _ => File::new(Text::default(), Text::default()),
        }
    }

    /// Takes the last object, the names of files.
    pub(crate) fn files(&mut self) -> Files {
        match self.objects.pop() {
            Some(Object::Files(files)) => *files,
            Some(Object::Texts(names)) => Files::new(names, Text::default()),
            _ => Files::new(Array::default(), Text::default()),
        }
    }

    /// Takes the last value of a type.
    pub(crate) fn value(&mut self, ty: Type) -> Value {
        match ty {
            Type::Float => Value::Float(self.float()),
            Type::Bool => Value::Bool(self.bool()),
            _ => self.objects.pop().and_then(Object::into_value).unwrap_or_else(|| nothing(ty)),
        }
    }

    /// A parameter or local, by its index among the numbers or the objects.
    pub(crate) fn local(&self, frame: Frame, at: u32, ty: Type) -> Value {
        let number = || self.numbers.get(frame.numbers + at as usize).copied().unwrap_or_default();
        match ty {
            Type::Float => Value::Float(number()),
            Type::Bool => Value::Bool(number() != 0.0),
            _ => {
                let object = self.objects.get(frame.objects + at as usize).cloned();
                object.and_then(Object::into_value).unwrap_or_else(|| nothing(ty))
            }
        }
    }

    /// The values of a frame from its beginning on.
    #[cold]
    pub(crate) fn values(&self, types: &[Type], frame: Frame) -> Vec<Value> {
        let (mut numbers, mut objects) =
            (self.numbers.iter().skip(frame.numbers), self.objects.iter().skip(frame.objects));
        let value = |ty: &Type| match ty {
            Type::Float => numbers.next().copied().map(Value::Float),
            Type::Bool => numbers.next().map(|number| Value::Bool(*number != 0.0)),
            _ => objects.next().cloned().and_then(Object::into_value),
        };
        types.iter().map(value).map(|value| value.unwrap_or(Value::Float(0.0))).collect()
    }

    /// Adds a value.
    pub(crate) fn push_value(&mut self, value: Value) {
        match value {
            Value::Float(number) => self.push_float(number),
            Value::Bool(truth) => self.push_bool(truth),
            Value::Text(text) => self.push_text(text),
            Value::Floats(array) => self.push_floats(array),
            Value::Bools(array) => self.push_bools(array),
            Value::Texts(array) => self.push_texts(array),
            // The language has no further types.
            _ => self.push_float(0.0),
        }
    }

    /// Adds a value that is 0, false or empty.
    pub(crate) fn push_nothing(&mut self, ty: Type) {
        self.push_value(nothing(ty));
    }

    /// Removes everything above the parameters of a frame, and the parameters.
    #[inline]
    pub(crate) fn truncate(&mut self, frame: Frame) {
        self.numbers.truncate(frame.numbers);
        if frame.objects < self.objects.len() {
            self.objects.truncate(frame.objects);
        }
    }

    /// A frame that begins here.
    #[inline]
    pub(crate) fn frame(&self, site: u32) -> Frame {
        Frame { numbers: self.numbers.len(), objects: self.objects.len(), site }
    }
}

/// The stack while rules run, which call each other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SharedStack<'s>(pub(crate) &'s RefCell<Stack>);

#[allow(dead_code, reason = "operations that come may need the others")]
impl SharedStack<'_> {
    /// Takes the last number.
    pub(crate) fn float(self) -> f64 {
        self.0.borrow_mut().float()
    }

    /// Takes the last number as a truth value.
    pub(crate) fn bool(self) -> bool {
        self.0.borrow_mut().bool()
    }

    /// Takes the last object, an array of numbers.
    pub(crate) fn floats(self) -> Array<f64> {
        self.0.borrow_mut().floats()
    }

    /// Takes the last object, an array of truth values.
    pub(crate) fn bools(self) -> Array<bool> {
        self.0.borrow_mut().bools()
    }

    /// Takes the last object, a text.
    pub(crate) fn text(self) -> Text {
        self.0.borrow_mut().text()
    }

    /// Takes the last object, an array of texts.
    pub(crate) fn texts(self) -> Array<Text> {
        self.0.borrow_mut().texts()
    }
}
