//! A grammar as text, one line a step.

mod block;
mod facts;
mod plan;

use cga_lang::ir::facts::RuleFacts;
use cga_lang::ir::plan::RunPlan;
use cga_lang::ir::{
    Arg, AttrInfo, Binary, Childless, ChoiceValues, Choices, EachUnary, Expr, ExprKind, Function, FunctionId, Global,
    GlobalId, Grammar, Init, Param, Prefix, Presentation, Renew, Renewal, Rule, RuleId, Size, Start, Step, StepKind,
    Target, Type, Value,
};
use cga_lang::span::Span;
use cga_lang::syntax::token::{Tok, Tokens};
use std::fmt::Write;

/// The text of a grammar.
pub(crate) fn print(grammar: &Grammar) -> String {
    let plan = RunPlan::new(grammar);
    let mut out = Printer { grammar, plan: &plan, rule: RuleId(0), params: &[], out: String::new(), depth: 0 };
    out.grammar();
    out.out
}

struct Printer<'g> {
    grammar: &'g Grammar,
    plan: &'g RunPlan<'g>,
    /// The rule that is printed.
    rule: RuleId,
    params: &'g [Param],
    out: String,
    depth: usize,
}

impl<'g> Printer<'g> {
    fn line(&mut self, text: &str) {
        for _ in 0..self.depth {
            self.out.push_str("    ");
        }
        self.out.push_str(text);
        self.out.push('\n');
    }

    fn name(&self, global: GlobalId) -> &'g str {
        &self.grammar.global(global).name
    }

    fn attr(&self, id: GlobalId, own: &Global, attr: &AttrInfo) -> String {
        let mut text = format!("attr {}: {} = {}", own.name, own.ty.word(), self.expr(&own.value));
        if let Some(range) = attr.range {
            let _ = write!(text, ", range {} to {}", range.min, range.max);
            if range.step != 0.0 {
                let _ = write!(text, " by {}", range.step);
            }
            if !range.restricted {
                text.push_str(" unrestricted");
            }
        }
        if let Some(choices) = &attr.choices {
            let _ = write!(text, ", one of {}", self.choices(choices));
        }
        match &attr.presentation {
            Presentation::Plain => {}
            Presentation::File(extensions) => _ = write!(text, ", shown as file {extensions:?}"),
            other => _ = write!(text, ", shown as {other:?}"),
        }
        if let Some(name) = &attr.display_name {
            let _ = write!(text, ", named {name:?}");
        }
        if !attr.group.names.is_empty() {
            let _ = write!(text, ", group {}", attr.group.names.join("/"));
        }
        if let Some(order) = attr.group.order {
            let _ = write!(text, " order {order}");
        }
        if let Some(order) = attr.order {
            let _ = write!(text, ", order {order}");
        }
        let lazy = self.lazy(id);
        for (flag, word) in
            [(attr.hidden, "hidden"), (own.is_set, "set"), (own.lazy, &lazy), (own.known.is_none(), "computed")]
        {
            if flag {
                let _ = write!(text, ", {word}");
            }
        }
        if !attr.doc.is_empty() {
            let _ = write!(text, ", doc {:?}", attr.doc);
        }
        text
    }

    fn choices(&self, choices: &Choices) -> String {
        let mut text = match &choices.values {
            ChoiceValues::Floats(values) => format!("{values:?}"),
            ChoiceValues::Texts(values) => format!("{values:?}"),
            ChoiceValues::Attr(id) => self.name(*id).to_owned(),
        };
        if !choices.labels.is_empty() {
            let _ = write!(text, " called {:?}", choices.labels);
        }
        if !choices.restricted {
            text.push_str(" unrestricted");
        }
        text
    }

    fn grammar(&mut self) {
        let grammar = self.grammar;
        if !grammar.about.is_empty() {
            let text = format!("about {:?}", grammar.about);
            self.line(&text);
        }
        for (number, global) in grammar.globals.iter().enumerate() {
            let id = GlobalId(number as u32);
            let text = match &global.attr {
                Some(attr) => self.attr(id, global, attr),
                None => self.constant(id, global),
            };
            self.line(&text);
        }
        for (number, function) in grammar.functions.iter().enumerate() {
            self.function(function);
            self.uses(self.plan.facts.function(FunctionId(number as u32)));
            self.function_request(FunctionId(number as u32));
        }
        for renewal in &grammar.renewals {
            let text = self.renewal(renewal);
            self.line(&text);
        }
        let name = |init: &Init| grammar.global(init.global).name.clone();
        let init = |init: &Init| match &init.styles {
            Some(styles) => format!("{} in {styles:?}", name(init)),
            None => name(init),
        };
        if !grammar.init.is_empty() {
            let text = format!("init {}", grammar.init.iter().map(init).collect::<Vec<_>>().join(", "));
            self.line(&text);
        }
        for (index, host) in grammar.hosts.iter().enumerate() {
            let text = format!("host {index}: {} from {}", host.ty.word(), host.handle);
            self.line(&text);
        }
        if !grammar.starts.is_empty() {
            let names: Vec<String> = grammar.starts.iter().map(start).collect();
            self.line(&format!("start {}", names.join(", ")));
        }
        let leaves = self.plan.leaves.names();
        if !leaves.is_empty() {
            self.line(&format!("leaves {}", leaves.join(", ")));
        }
        for (number, rule) in grammar.rules.iter().enumerate() {
            self.rule = RuleId(number as u32);
            self.rule(rule, self.plan.facts.rule(self.rule));
        }
    }

    fn constant(&self, id: GlobalId, own: &Global) -> String {
        let set = if own.is_set { ", set" } else { "" };
        let lazy = if own.lazy { format!(", {}", self.lazy(id)) } else { String::new() };
        format!("const {}: {} = {}{set}{lazy}", own.name, own.ty.word(), self.expr(&own.value))
    }

    fn function(&mut self, function: &'g Function) {
        self.params = &function.params;
        let recursive = if function.recursive { ", recursive" } else { "" };
        let head = format!("{}{}: {}", function.name, params(&function.params), function.ty.word());
        let shared = if function.sites == 0 { String::new() } else { format!(", {} sites", function.sites) };
        let text = format!("function {head} = {}{recursive}{shared}", self.expr(&function.body));
        self.line(&text);
        self.locals(&function.params, &function.locals);
    }

    fn rule(&mut self, rule: &'g Rule, facts: &RuleFacts) {
        self.params = &rule.params;
        let leaf = match rule.leaf {
            Childless::Always => ", leaf",
            Childless::Never => "",
            Childless::Depends => ", perhaps a leaf",
        };
        let cycle = rule.cycle.map(|cycle| format!(", cycle {cycle}")).unwrap_or_default();
        let scope = self.first_scope(&rule.body);
        self.line(&format!("rule {}{}{leaf}{cycle}{scope}", rule.name, params(&rule.params)));
        if let [_, others @ ..] = &rule.sites[..] {
            let names: Vec<&str> = others.iter().map(|site| site.name.as_str()).collect();
            self.line(&format!("  also {}", names.join(", ")));
        }
        self.rule_facts(facts);
        self.locals(&rule.params, &rule.locals);
        self.steps(&rule.body);
    }

    fn locals(&mut self, params: &'g [Param], locals: &'g [Expr]) {
        let names = params.iter().skip(params.len().saturating_sub(locals.len()));
        for (param, value) in names.zip(locals) {
            let text = format!("  with {} = {}", param.name, self.expr(value));
            self.line(&text);
        }
    }

    fn steps(&mut self, steps: &'g [Step]) {
        self.depth += 1;
        for (step, note) in steps.iter().zip(self.changes(steps)) {
            self.step(step, &note);
        }
        self.depth -= 1;
    }

    fn headed(&mut self, head: &str, steps: &'g [Step]) {
        self.line(head);
        self.steps(steps);
    }

    fn step(&mut self, step: &'g Step, note: &str) {
        match &step.kind {
            StepKind::Do(row, args) => {
                let args: Vec<String> = args.iter().map(|arg| self.arg(arg)).collect();
                self.line(&format!("{}({}){note}", row.run, args.join(", ")));
            }
            StepKind::SetAttr(id, value) => {
                let text = format!("set {} = {}{note}", self.name(*id), self.expr(value));
                self.line(&text);
            }
            StepKind::SetShape(row, value) => {
                let text = format!("set {} = {}{note}", row.name, self.expr(value));
                self.line(&text);
            }
            StepKind::Rust(path, args) => {
                let text = format!("rust {path}{}{note}", self.args(args));
                self.line(&text);
            }
            StepKind::Give(target) => {
                let text = format!("give {}", self.target(target));
                self.line(&text);
            }
            StepKind::Block(block) => self.block(block),
            StepKind::Push(steps) => self.headed(&format!("push{}", self.first_scope(steps)), steps),
            StepKind::Renew(call) => self.renew(call),
            StepKind::Case { arms, otherwise } => {
                for (condition, steps) in arms {
                    let head = match condition.kind {
                        ExprKind::Chance { percent, .. } => format!("chance {percent}%"),
                        _ => format!("case {}", self.expr(condition)),
                    };
                    self.headed(&head, steps);
                }
                self.headed("else", otherwise);
            }
        }
    }

    /// Their defaults and values are shown elsewhere.
    fn renewal(&self, renewal: &Renewal) -> String {
        let mut text = format!("renewal {}:", renewal.import);
        for global in &renewal.globals {
            let _ = write!(text, " {}", self.name(*global));
        }
        text
    }

    fn renew(&mut self, call: &'g Renew) {
        self.line(&format!("renew {}", self.grammar.renewals[call.renewal.0 as usize].import));
        self.depth += 1;
        for (id, value) in &call.given {
            let text = format!("given {} = {}", self.name(*id), self.expr(value));
            self.line(&text);
        }
        let text = format!("give {}", self.target(&call.target));
        self.line(&text);
        self.depth -= 1;
    }

    /// A successor, with the decisions on it.
    fn target(&self, target: &Target) -> String {
        self.named(target) + &self.call(target)
    }

    fn named(&self, target: &Target) -> String {
        match target {
            Target::Rule { rule, sites, args, .. } => {
                let args = if args.is_empty() { String::new() } else { self.args(args) };
                format!("{}{}{args}", self.grammar.rules[rule.0 as usize].name, passed(sites))
            }
            Target::Leaf(name) => format!("leaf {name}"),
            Target::Nil => "nil".into(),
        }
    }

    fn arg(&self, arg: &Arg) -> String {
        match arg {
            Arg::Value(value) => self.expr(value),
            Arg::Length(size) => self.size(size),
            Arg::Word(word) => (*word).to_owned(),
        }
    }

    fn size(&self, size: &Size) -> String {
        let sign = match size.prefix {
            Prefix::Absolute => "",
            Prefix::Relative => "'",
            Prefix::Floating => "~",
        };
        format!("{sign}{}", self.expr(&size.value))
    }

    fn args(&self, args: &[Expr]) -> String {
        let args: Vec<String> = args.iter().map(|arg| self.expr(arg)).collect();
        format!("({})", args.join(", "))
    }

    fn expr(&self, expr: &Expr) -> String {
        match &expr.kind {
            ExprKind::Value(known) => value(known),
            ExprKind::Param(index) => {
                self.params.get(*index as usize).map_or_else(|| format!("param {index}"), |param| param.name.clone())
            }
            ExprKind::Global(id) => self.name(*id).to_owned(),
            ExprKind::Host(id) => format!("#{}", id.0),
            ExprKind::Call(id, sites, args) => {
                format!("{}{}{}", self.grammar.functions[id.0 as usize].name, passed(sites), self.args(args))
            }
            ExprKind::Builtin(row, args) => format!("{}{}", row.run, self.args(args)),
            ExprKind::Rust(path, args) => format!("{path}{}", self.args(args)),
            ExprKind::Shape(row) => row.name.to_owned(),
            ExprKind::Comp(comp) => self.comp_value(comp),
            ExprKind::Word(word) => (*word).to_owned(),
            ExprKind::Style(styles) => format!("style {styles:?}"),
            ExprKind::Site(sites) => format!("site {sites:?}"),
            ExprKind::Array(rows) => {
                let row = |row: &Vec<Expr>| row.iter().map(|entry| self.expr(entry)).collect::<Vec<_>>().join(", ");
                format!("[{}]", rows.iter().map(row).collect::<Vec<_>>().join("; "))
            }
            ExprKind::Range(base, step, limit) => {
                format!("{} : {} : {}", self.expr(base), self.expr(step), self.expr(limit))
            }
            ExprKind::Index(array, indices) => {
                let indices: Vec<String> = indices.iter().map(|index| self.expr(index)).collect();
                format!("{}[{}]", self.expr(array), indices.join(", "))
            }
            ExprKind::EachUnary(EachUnary::Neg, operand) => format!(".-{}", self.expr(operand)),
            ExprKind::EachUnary(EachUnary::Not, operand) => format!(".!{}", self.expr(operand)),
            ExprKind::Each(op, a, b) => format!("({} .{} {})", self.expr(a), sign(*op, expr.ty), self.expr(b)),
            ExprKind::Neg(operand) => format!("-{}", self.expr(operand)),
            ExprKind::Not(operand) => format!("!{}", self.expr(operand)),
            ExprKind::Chain(first, links) => {
                let link = |(op, operand): &(Binary, Expr)| format!(" {} {}", sign(*op, expr.ty), self.expr(operand));
                format!("({}{})", self.expr(first), links.iter().map(link).collect::<String>())
            }
            ExprKind::Binary(op, a, b) => format!("({} {} {})", self.expr(a), sign(*op, expr.ty), self.expr(b)),
            ExprKind::ToText(operand) => format!("text({})", self.expr(operand)),
            ExprKind::File(name, folder) if folder.is_empty() => self.expr(name),
            ExprKind::File(name, folder) => format!("file({}, in {folder:?})", self.expr(name)),
            ExprKind::Case(arms, otherwise) => {
                let arm = |(test, value): &(Expr, Expr)| match test.kind {
                    ExprKind::Chance { percent, .. } => format!("{percent}% : {} ", self.expr(value)),
                    _ => format!("case {} : {} ", self.expr(test), self.expr(value)),
                };
                format!("({}else : {})", arms.iter().map(arm).collect::<String>(), self.expr(otherwise))
            }
            ExprKind::Chance { percent, .. } => format!("{percent}%"),
        }
    }
}

/// The site that a call passes to a shared rule or function.
fn passed(sites: &[u32]) -> String {
    if sites.is_empty() { String::new() } else { format!("@{sites:?}") }
}

fn value(known: &Value) -> String {
    match known {
        Value::Float(number) => number.to_string(),
        Value::Bool(truth) => truth.to_string(),
        Value::Text(text) => {
            let token: Tokens = std::iter::once(Tok::Str(text.clone())).collect();
            token.text(Span::one(0), usize::MAX, '\'')
        }
        Value::Array(rows) => {
            let row = |row: &Vec<Value>| row.iter().map(value).collect::<Vec<_>>().join(", ");
            format!("[{}]", rows.iter().map(row).collect::<Vec<_>>().join("; "))
        }
    }
}

fn params(params: &[Param]) -> String {
    if params.is_empty() {
        return String::new();
    }
    let list: Vec<String> = params.iter().map(|param| format!("{}: {}", param.name, param.ty.word())).collect();
    format!("({})", list.join(", "))
}

fn sign(op: Binary, ty: Type) -> &'static str {
    let is_text = matches!(ty, Type::Text | Type::Texts);
    if op == Binary::Add && is_text { "++" } else { op.text() }
}

fn start(start: &Start) -> String {
    let mut text = start.name.clone();
    for (flag, word) in [(start.marked, " (marked)"), (start.hidden, " (hidden)")] {
        if flag {
            text.push_str(word);
        }
    }
    if !start.doc.is_empty() {
        let _ = write!(text, " {:?}", start.doc);
    }
    text
}
