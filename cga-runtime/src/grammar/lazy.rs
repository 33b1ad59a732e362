//! Attributes and constants on a cycle of declarations. Each is computed on the first read, so conditions may keep a
//! run from closing the cycle (*attribute*, *const*).

use std::cell::{Cell, OnceCell};

use super::support::global;
use crate::op::set;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::value::text::Text;

/// A value that is computed on the first read.
#[derive(Clone, Debug)]
pub struct Lazy<T> {
    value: OnceCell<T>,
    /// True while it is being computed: a read then closes the cycle.
    is_open: Cell<bool>,
}

impl<T> Default for Lazy<T> {
    fn default() -> Self {
        Lazy { value: OnceCell::new(), is_open: Cell::new(false) }
    }
}

impl<T> Lazy<T> {
    /// A value that is already known.
    pub fn known(value: T) -> Self {
        Lazy { value: OnceCell::from(value), ..Lazy::default() }
    }

    /// The value, if it is known.
    pub(super) fn found(&self) -> Option<&T> {
        self.value.get()
    }

    /// The value from the host program, if it gave one.
    pub fn given(value: Option<T>) -> Self {
        value.map_or_else(Lazy::default, Lazy::known)
    }
}

impl<T: Clone + Default> Lazy<T> {
    /// The value. The first read computes it and reserves `stack` bytes for functions. If the computation reads the
    /// value itself, the run ends with an error that names the cycle. If the stack has no room, the run ends with the
    /// error of a limit.
    #[inline]
    pub fn get(&self, env: &mut Env, name: Text, stack: u32, mut compute: impl FnMut(&mut Env) -> T) -> T {
        match self.value.get() {
            Some(value) => value.clone(),
            None => self.first(env, name, stack, &mut compute),
        }
    }

    #[cold]
    fn first(&self, env: &mut Env, name: Text, stack: u32, compute: &mut dyn FnMut(&mut Env) -> T) -> T {
        if self.is_open.get() {
            env.close_cycle(&name);
            return T::default();
        }
        if !env.call(stack) {
            return T::default();
        }
        self.is_open.set(true);
        env.calls.open.push(name);
        let value = compute(env);
        env.calls.open.pop();
        self.is_open.set(false);
        env.called(stack);
        self.value.get_or_init(|| value).clone()
    }
}

/// Marks a place in generated code where a value is computed for other declarations.
pub fn computed<T>(_value: T) {}

/// The shape on which such values are computed: the initial shape, or the shape on which an import starts again.
#[derive(Clone, Debug)]
pub struct Origin(Shape);

impl Default for Origin {
    fn default() -> Self {
        Origin(Shape::point([0.0; 3]))
    }
}

impl Origin {
    /// The initial shape.
    pub fn initial(shape: &Shape) -> Self {
        Origin(shape.clone())
    }

    /// A shape on which an import starts again, without the values that `set` gave these attributes and constants on
    /// it.
    pub fn renewed(shape: &Shape, numbers: &[u32]) -> Self {
        let mut own = shape.clone();
        set::forget(&mut own, numbers);
        Origin(own)
    }

    /// The shape with the random stream of one attribute or constant.
    pub fn global(&self, number: u32) -> Shape {
        global(&self.0, number)
    }
}
