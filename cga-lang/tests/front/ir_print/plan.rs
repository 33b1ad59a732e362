//! Decisions on how rules run: in brackets after what they concern, or one line an item.

use super::Printer;
use cga_lang::ir::{FunctionId, GlobalId, RuleId};

impl Printer<'_> {
    /// The stack that a function requests.
    pub(super) fn function_request(&mut self, id: FunctionId) {
        if let Some(bytes) = self.plan.function_stack.request(id) {
            self.line(&format!("  requests {bytes} bytes"));
        }
    }

    /// The word for a lazy attribute or constant, with the stack that its first read requests.
    pub(super) fn lazy(&self, id: GlobalId) -> String {
        format!("lazy [{} bytes]", self.plan.lazy_stack(id))
    }

    /// The decisions on a call from the rule that is printed: the stack that it requests.
    pub(super) fn call(&self, to: RuleId) -> String {
        let mut parts = Vec::new();
        if let Some(request) = self.plan.rule_stack.request(self.rule, to) {
            parts.push(format!("requests {} KB", request.stack));
            if request.levels != 0 {
                parts.push(format!("level {}", request.levels));
            }
        }
        bracketed(&parts)
    }
}

fn bracketed(parts: &[String]) -> String {
    if parts.is_empty() { String::new() } else { format!(" [{}]", parts.join(", ")) }
}
