//! The whole of a grammar.

use std::cell::Cell;
use std::collections::HashMap;

use cga_lang::diag::Diag;
use cga_lang::ir::plan::RunPlan;
use cga_lang::ir::{ExprKind, FunctionId, Global, Grammar, RuleId};
use cga_runtime::rt::Text;

use super::expr::{Compiler, Locals, Steps, counts};
use super::problems::Problems;
use super::registered::Registered;
use crate::object::{constant, is_number};
use crate::program::{FieldCode, FunctionCode, GlobalCode, InitCode, Program, RenewalCode, Slot, SlotCounts};

/// Compiles a grammar.
///
/// # Errors
/// Rust functions that are not registered.
pub(crate) fn program(grammar: &Grammar, plan: &RunPlan<'_>, registered: &Registered) -> Result<Program, Vec<Diag>> {
    let mut counts = SlotCounts::default();
    let slots = grammar.globals.iter().map(|global| slot(global, &mut counts)).collect();
    let compiler = Compiler {
        grammar,
        plan,
        tells_parts: plan.tells_parts(),
        slots,
        registered,
        problems: Problems::default(),
        places: Cell::default(),
        changes: Cell::default(),
    };
    let fields = fields(grammar);
    let program = Program {
        rules: (0..).zip(&grammar.rules).map(|(id, rule)| compiler.rule(RuleId(id), rule)).collect(),
        functions: (0..grammar.functions.len() as u32).map(|id| compiler.function(FunctionId(id))).collect(),
        globals: (0..grammar.globals.len()).map(|number| compiler.global_code(number, &fields)).collect(),
        renewals: grammar
            .renewals
            .iter()
            .map(|renewal| {
                let is_lazy = |id: &cga_lang::ir::GlobalId| grammar.global(*id).lazy;
                let groups = renewal.globals.chunk_by(|a, b| is_lazy(a) && is_lazy(b));
                RenewalCode { groups: groups.map(|group| group.iter().map(|id| id.0 as usize).collect()).collect() }
            })
            .collect(),
        init: grammar
            .init
            .iter()
            .map(|init| InitCode { global: init.global.0 as usize, styles: init.styles.clone() })
            .collect(),
        slots: counts,
        fields: fields.into_iter().map(|(_, field)| field).collect(),
    };
    let problems = compiler.problems.finish();
    if problems.is_empty() { Ok(program) } else { Err(problems) }
}

fn slot(global: &Global, counts: &mut SlotCounts) -> Slot {
    let next = |count: &mut u32| {
        *count += 1;
        *count - 1
    };
    if global.lazy {
        Slot::Lazy(next(&mut counts.lazy))
    } else if is_number(global.ty) {
        Slot::Number(next(&mut counts.numbers))
    } else {
        Slot::Object(next(&mut counts.objects))
    }
}

/// The attributes that the host program may set, by name: one for each name, whatever the style.
fn fields(grammar: &Grammar) -> Vec<(&str, FieldCode)> {
    let mut fields: Vec<(&str, FieldCode)> = Vec::new();
    let mut numbers: HashMap<&str, usize> = HashMap::new();
    for global in grammar.globals.iter().filter(|global| global.public && global.attr.is_some()) {
        let known = global.known.as_ref();
        if let Some(&number) = numbers.get(global.name.as_str()) {
            let field = &mut fields[number].1;
            field.known = field.known.take().filter(|kept| known.map(constant).as_ref() == Some(kept));
            continue;
        }
        numbers.insert(&global.name, fields.len());
        fields.push((&global.name, FieldCode { known: known.map(constant), inits: Vec::new() }));
    }
    for (at, init) in grammar.init.iter().enumerate() {
        let global = grammar.global(init.global);
        if global.public
            && global.attr.is_some()
            && let Some(&number) = numbers.get(global.name.as_str())
        {
            fields[number].1.inits.push(at);
        }
    }
    fields
}

impl Compiler<'_> {
    fn function(&self, id: FunctionId) -> FunctionCode {
        let function = &self.grammar.functions[id.0 as usize];
        let locals = Locals::new(&function.params);
        let mut steps = Steps::default();
        function.locals.iter().chain([&function.body]).for_each(|expr| self.expr(expr, &locals, &mut steps));
        let given = function.params.len() - function.locals.len();
        FunctionCode {
            code: steps.finish(),
            args: counts(function.params.iter().take(given).map(|param| param.ty)),
            ty: function.ty,
            request: self.plan.function_stack.request(id),
        }
    }

    fn global_code(&self, number: usize, fields: &[(&str, FieldCode)]) -> GlobalCode {
        let global = &self.grammar.globals[number];
        let mut steps = Steps::default();
        self.expr(&global.value, &Locals::new(&[]), &mut steps);
        let field = fields.iter().position(|(name, _)| *name == global.name);
        GlobalCode {
            name: Text::from(global.name.as_str()),
            ty: global.ty,
            slot: self.slots[number],
            value: steps.finish(),
            known: global.known.as_ref().map(constant),
            is_literal: matches!(global.value.kind, ExprKind::Value(_)),
            is_set: global.is_set,
            is_attribute: global.attr.is_some(),
            stream: global.stream(),
            stack: self.plan.lazy_stack(cga_lang::ir::GlobalId(number as u32)),
            field: field.filter(|_| global.public),
            renewed_field: field.filter(|_| global.attr.is_some()),
        }
    }
}
