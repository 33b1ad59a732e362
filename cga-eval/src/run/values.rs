//! The values of a run: attributes and constants, evaluated for one initial shape.

use std::cell::RefCell;
use std::sync::Arc;

use cga_runtime::rt::{Evaluated, Lazy, Origin, Value};

use crate::object::Object;
use crate::program::Program;
use crate::stack::Stack;

/// The attributes and constants of a run, and its stack.
#[derive(Debug)]
pub struct Values {
    pub(crate) program: Arc<Program>,
    pub(crate) numbers: Vec<f64>,
    pub(crate) objects: Vec<Object>,
    /// The ones that are computed on their first read.
    pub(crate) lazy: Vec<Lazy<LazyValue>>,
    /// The shape on which they are computed.
    pub(crate) origin: Origin,
    pub(crate) style: u32,
    /// The values of the fields, `None` where the default is computed.
    pub(crate) fields: Arc<[Option<Value>]>,
    pub(crate) stack: RefCell<Stack>,
}

/// A value that is computed on its first read; `None` after an error.
#[derive(Clone, Debug, Default)]
pub(crate) struct LazyValue(pub(crate) Option<Value>);

impl Evaluated for LazyValue {
    fn value(&self) -> Option<Value> {
        self.0.clone()
    }
}

impl Values {
    /// Values before any is computed.
    pub(crate) fn new(program: Arc<Program>, fields: Arc<[Option<Value>]>, style: u32) -> Self {
        let slots = program.slots;
        Values {
            numbers: vec![0.0; slots.numbers as usize],
            objects: vec![Object::empty(cga_lang::ir::Type::Text); slots.objects as usize],
            lazy: vec![Lazy::default(); slots.lazy as usize],
            origin: Origin::default(),
            style,
            fields,
            stack: RefCell::default(),
            program,
        }
    }

    /// A copy on which lazy values can be opened again.
    pub(crate) fn reopened(&self) -> Self {
        Values {
            program: self.program.clone(),
            numbers: self.numbers.clone(),
            objects: self.objects.clone(),
            lazy: self.lazy.clone(),
            origin: self.origin.clone(),
            style: self.style,
            fields: self.fields.clone(),
            stack: RefCell::default(),
        }
    }
}
