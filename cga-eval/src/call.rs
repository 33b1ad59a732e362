//! Calls of rules that run later: they wait for stack, or a template leaves them out.

use crate::object::Object;
use crate::stack::{Frame, Stack};

/// A call with its arguments.
#[derive(Clone, Debug)]
pub struct Call {
    pub(crate) rule: usize,
    site: u32,
    numbers: Box<[f64]>,
    objects: Box<[Object]>,
}

impl Call {
    /// The call whose arguments are on the stack from `frame` on. They are taken off.
    pub(crate) fn take(rule: usize, stack: &mut Stack, frame: Frame) -> Self {
        let numbers = stack.numbers.drain(frame.numbers.min(stack.numbers.len())..).collect();
        let objects = stack.objects.drain(frame.objects.min(stack.objects.len())..).collect();
        Call { rule, site: frame.site, numbers, objects }
    }

    /// Puts the arguments on the stack.
    pub(crate) fn give(self, stack: &mut Stack) -> Frame {
        let frame = stack.frame(self.site);
        stack.numbers.extend_from_slice(&self.numbers);
        stack.objects.extend(self.objects);
        frame
    }
}
