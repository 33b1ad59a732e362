//! A grammar as text, one line a step: for snapshots and traces.

mod block;
mod facts;

use crate::ir::facts::{Facts, RuleFacts};
use crate::ir::{
    Arg, Attr, Binary, Childless, ChoiceValues, Choices, Const, EachUnary, Expr, ExprKind, Function, FunctionId,
    Global, Grammar, Init, Param, Prefix, Presentation, Renew, Renewal, Rule, RuleId, Size, Start, Step, Target, Value,
};
use crate::syntax::token::push_quoted;
use std::fmt::Write;

/// The text of a grammar.
pub fn print(grammar: &Grammar) -> String {
    let facts = Facts::new(grammar);
    let mut out = Printer { grammar, facts: Some(&facts), params: &[], out: String::new(), depth: 0 };
    out.grammar();
    out.out
}

/// The text of an expression.
pub(crate) fn expr(grammar: &Grammar, expr: &Expr) -> String {
    Printer::plain(grammar).expr(expr)
}

/// The text of a function.
pub(crate) fn function(grammar: &Grammar, function: &Function) -> String {
    let mut out = Printer::plain(grammar);
    out.function(function);
    out.out
}

/// The text of a rule without facts, which follow from other rules.
pub(crate) fn rule(grammar: &Grammar, rule: &Rule) -> String {
    let mut out = Printer::plain(grammar);
    out.rule(rule, None);
    out.out
}

struct Printer<'g> {
    grammar: &'g Grammar,
    facts: Option<&'g Facts>,
    params: &'g [Param],
    out: String,
    depth: usize,
}

impl<'g> Printer<'g> {
    fn plain(grammar: &'g Grammar) -> Self {
        Printer { grammar, facts: None, params: &[], out: String::new(), depth: 0 }
    }

    fn line(&mut self, text: &str) {
        for _ in 0..self.depth {
            self.out.push_str("    ");
        }
        self.out.push_str(text);
        self.out.push('\n');
    }

    fn attr(&self, attr: &Attr) -> String {
        let info = &attr.info;
        let mut text = format!("attr {}: {} = {}", attr.name, attr.ty.word(), self.expr(&attr.default));
        if let Some(range) = info.range {
            let _ = write!(text, ", range {} to {}", range.min, range.max);
            if range.step != 0.0 {
                let _ = write!(text, " by {}", range.step);
            }
            if !range.restricted {
                text.push_str(" unrestricted");
            }
        }
        if let Some(choices) = &info.choices {
            let _ = write!(text, ", one of {}", self.choices(choices));
        }
        match &info.presentation {
            Presentation::Plain => {}
            Presentation::File(extensions) => _ = write!(text, ", shown as file {extensions:?}"),
            other => _ = write!(text, ", shown as {other:?}"),
        }
        if let Some(name) = &info.display_name {
            let _ = write!(text, ", named {name:?}");
        }
        if !info.group.names.is_empty() {
            let _ = write!(text, ", group {}", info.group.names.join("/"));
        }
        if let Some(order) = info.group.order {
            let _ = write!(text, " order {order}");
        }
        if let Some(order) = info.order {
            let _ = write!(text, ", order {order}");
        }
        for (flag, word) in
            [(info.hidden, "hidden"), (attr.is_set, "set"), (attr.lazy, "lazy"), (attr.known.is_none(), "computed")]
        {
            if flag {
                let _ = write!(text, ", {word}");
            }
        }
        if !info.doc.is_empty() {
            let _ = write!(text, ", doc {:?}", info.doc);
        }
        text
    }

    fn choices(&self, choices: &Choices) -> String {
        let mut text = match &choices.values {
            ChoiceValues::Floats(values) => format!("{values:?}"),
            ChoiceValues::Texts(values) => format!("{values:?}"),
            ChoiceValues::Attr(id) => self.grammar.attrs[id.0 as usize].name.clone(),
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
        for attr in &grammar.attrs {
            let text = self.attr(attr);
            self.line(&text);
        }
        for own in &grammar.consts {
            let text = self.constant(own);
            self.line(&text);
        }
        for (number, function) in grammar.functions.iter().enumerate() {
            self.function(function);
            if let Some(facts) = self.facts {
                self.uses(facts.function(FunctionId(number as u32)));
            }
        }
        for renewal in &grammar.renewals {
            let text = self.renewal(renewal);
            self.line(&text);
        }
        let name = |global: &Global| match global {
            Global::Attr(id) => grammar.attrs[id.0 as usize].name.clone(),
            Global::Const(id) => grammar.consts[id.0 as usize].name.clone(),
        };
        let init = |init: &Init| match &init.styles {
            Some(styles) => format!("{} in {styles:?}", name(&init.global)),
            None => name(&init.global),
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
        for (number, rule) in grammar.rules.iter().enumerate() {
            self.rule(rule, self.facts.map(|facts| facts.rule(RuleId(number as u32))));
        }
    }

    fn constant(&self, own: &Const) -> String {
        let set = match (own.is_set, own.lazy) {
            (true, true) => ", set, lazy",
            (true, false) => ", set",
            (false, true) => ", lazy",
            (false, false) => "",
        };
        format!("const {}: {} = {}{set}", own.name, own.ty.word(), self.expr(&own.value))
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

    fn rule(&mut self, rule: &'g Rule, facts: Option<&RuleFacts>) {
        self.params = &rule.params;
        let leaf = match rule.leaf {
            Childless::Always => ", leaf",
            Childless::Never => "",
            Childless::Depends => ", perhaps a leaf",
        };
        let cycle = rule.cycle.map(|cycle| format!(", cycle {cycle}")).unwrap_or_default();
        self.line(&format!("rule {}{}{leaf}{cycle}", rule.name, params(&rule.params)));
        if let [_, others @ ..] = &rule.sites[..] {
            let names: Vec<&str> = others.iter().map(|site| site.name.as_str()).collect();
            self.line(&format!("  also {}", names.join(", ")));
        }
        if let Some(facts) = facts {
            self.rule_facts(facts);
        }
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
        for step in steps {
            self.step(step);
        }
        self.depth -= 1;
    }

    fn headed(&mut self, head: &str, steps: &'g [Step]) {
        self.line(head);
        self.steps(steps);
    }

    fn step(&mut self, step: &'g Step) {
        match step {
            Step::Do(row, args, _) => {
                let args: Vec<String> = args.iter().map(|arg| self.arg(arg)).collect();
                self.line(&format!("{}({})", row.run.now().unwrap_or(row.name), args.join(", ")));
            }
            Step::SetAttr(id, value, _) => {
                let text = format!("set {} = {}", self.grammar.attrs[id.0 as usize].name, self.expr(value));
                self.line(&text);
            }
            Step::SetShape(row, value, _) => {
                let text = format!("set {} = {}", row.name, self.expr(value));
                self.line(&text);
            }
            Step::Rust(path, args, _) => {
                let text = format!("rust {path}{}", self.args(args));
                self.line(&text);
            }
            Step::Give(target) => {
                let text = format!("give {}", self.target(target));
                self.line(&text);
            }
            Step::Block(block) => self.block(block),
            Step::Push(steps) => self.headed("push", steps),
            Step::Renew(call) => self.renew(call),
            Step::Case { arms, otherwise } => {
                for (condition, steps) in arms {
                    let head = format!("case {}", self.expr(condition));
                    self.headed(&head, steps);
                }
                self.headed("else", otherwise);
            }
            Step::Chance { arms, otherwise } => {
                for (percent, steps) in arms {
                    self.headed(&format!("chance {percent}%"), steps);
                }
                self.headed("else", otherwise);
            }
            Step::Later(what, _) => self.line(&format!("later {what}")),
        }
    }

    /// Their defaults and values are shown elsewhere.
    fn renewal(&self, renewal: &Renewal) -> String {
        let mut text = format!("renewal {}:", renewal.import);
        for global in &renewal.globals {
            let name = match global {
                Global::Attr(id) => &self.grammar.attrs[id.0 as usize].name,
                Global::Const(id) => &self.grammar.consts[id.0 as usize].name,
            };
            let _ = write!(text, " {name}");
        }
        text
    }

    fn renew(&mut self, call: &'g Renew) {
        self.line(&format!("anew {}", self.grammar.renewals[call.renewal.0 as usize].import));
        self.depth += 1;
        for (id, value) in &call.given {
            let text = format!("given {} = {}", self.grammar.attrs[id.0 as usize].name, self.expr(value));
            self.line(&text);
        }
        let text = format!("give {}", self.target(&call.target));
        self.line(&text);
        self.depth -= 1;
    }

    fn target(&self, target: &Target) -> String {
        match target {
            Target::Rule { rule, sites, args, .. } => {
                let args = if args.is_empty() { String::new() } else { self.args(args) };
                format!("{}{}{args}", self.grammar.rules[rule.0 as usize].name, passed(sites))
            }
            Target::Leaf(name, _) => format!("leaf {name}"),
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
            ExprKind::Attr(id) => self.grammar.attrs[id.0 as usize].name.clone(),
            ExprKind::Const(id) => self.grammar.consts[id.0 as usize].name.clone(),
            ExprKind::Host(id) => format!("#{}", id.0),
            ExprKind::Call(id, sites, args) => {
                format!("{}{}{}", self.grammar.functions[id.0 as usize].name, passed(sites), self.args(args))
            }
            ExprKind::Builtin(row, args) => format!("{}{}", row.run.now().unwrap_or(row.name), self.args(args)),
            ExprKind::Rust(path, args) => format!("{path}{}", self.args(args)),
            ExprKind::Shape(row) => row.name.to_owned(),
            ExprKind::Comp(comp) => self.comp_value(comp),
            ExprKind::Word(word) => (*word).to_owned(),
            ExprKind::Style(styles) => format!("style {styles:?}"),
            ExprKind::Site(sites) => format!("site {sites:?}"),
            ExprKind::Later(what) => format!("later {what}"),
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
            ExprKind::Each(op, a, b) => format!("({} .{} {})", self.expr(a), sign(*op), self.expr(b)),
            ExprKind::Neg(operand) => format!("-{}", self.expr(operand)),
            ExprKind::Not(operand) => format!("!{}", self.expr(operand)),
            ExprKind::Binary(op, a, b) => format!("({} {} {})", self.expr(a), sign(*op), self.expr(b)),
            ExprKind::ToText(operand) => format!("text({})", self.expr(operand)),
            ExprKind::File(name, folder) if folder.is_empty() => self.expr(name),
            ExprKind::File(name, folder) => format!("file({}, in {folder:?})", self.expr(name)),
            ExprKind::Case(arms, otherwise) => {
                let arms: String = arms
                    .iter()
                    .map(|(test, value)| format!("case {} : {} ", self.expr(test), self.expr(value)))
                    .collect();
                format!("({arms}else : {})", self.expr(otherwise))
            }
            ExprKind::Chance(arms, otherwise) => {
                let arms: String =
                    arms.iter().map(|(percent, value)| format!("{percent}% : {} ", self.expr(value))).collect();
                format!("({arms}else : {})", self.expr(otherwise))
            }
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
            let mut out = String::new();
            push_quoted(&mut out, text);
            out
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

fn sign(op: Binary) -> &'static str {
    match op {
        Binary::Add => "+",
        Binary::Sub => "-",
        Binary::Mul => "*",
        Binary::Div => "/",
        Binary::Rem => "%",
        Binary::Concat => "++",
        Binary::Eq => "==",
        Binary::Ne => "!=",
        Binary::Lt => "<",
        Binary::Le => "<=",
        Binary::Gt => ">",
        Binary::Ge => ">=",
        Binary::And => "&&",
        Binary::Or => "||",
    }
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
