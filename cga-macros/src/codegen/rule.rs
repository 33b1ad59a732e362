//! One function a rule, one function a function.

use cga_lang::ir::facts::LeftShapes;
use cga_lang::ir::plan::{ChangeForm, SlimChange, reads_first_scope};
use cga_lang::ir::{
    Block, BlockParts, Childless, Expr, Function, FunctionId, Param, Rule, RuleId, Step, StepKind, Target,
};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{quote, quote_spanned};

use super::access::Access;
use super::{Generator, hygienic, inner_type, local, site};

pub(super) fn rules(cx: &Generator<'_>) -> TokenStream {
    let rules = cx.grammar.rules.iter().zip(0..);
    rules.map(|(rule, number)| cx.at(rule.span, || cx.rule_function(RuleId(number), rule))).collect()
}

pub(super) fn functions(cx: &Generator<'_>) -> TokenStream {
    let functions = cx.grammar.functions.iter().zip(0..);
    functions.map(|(own, number)| cx.at(own.span, || cx.function(FunctionId(number), own))).collect()
}

/// The rule that contains the steps.
#[derive(Clone, Copy)]
struct InRule<'a> {
    id: RuleId,
    rule: &'a Rule,
}

/// The statements at the end of each path through a rule.
#[derive(Default)]
struct Tail {
    /// On a path without a step that makes children.
    childless: TokenStream,
    /// On the other paths.
    otherwise: TokenStream,
}

impl Generator<'_> {
    fn rule_function(&self, id: RuleId, rule: &Rule) -> TokenStream {
        self.name_params(&rule.params);
        let name = self.rule(id, self.source.token(rule.span.first));
        let site = site::param(rule.sites.len());
        let (names, types): (Vec<_>, Vec<_>) = site.into_iter().chain(self.given(&rule.params, &rule.locals)).unzip();
        let locals = self.locals(&rule.params, &rule.locals, &Access::rule());
        let doc = (!rule.source.is_empty()).then(|| {
            let source = &rule.source;
            code!(#[doc = #source])
        });
        let base = base(&rule.body);
        let flag = (rule.leaf == Childless::Depends).then(|| code!(let mut childless = true;));
        let label = site::of_site(&self.plan.leaves.implicit(rule));
        // A block was not counted as a shape, so its leaf is one more.
        let (leaf, any_leaf) = match rule.block {
            true => (code!(symbol), code!(any_symbol)),
            false => (code!(leaf), code!(any_leaf)),
        };
        let leaf = code!(cx.#leaf(shape, #label)?;);
        let tail = match rule.leaf {
            Childless::Always => Tail { childless: leaf.clone(), otherwise: leaf },
            Childless::Depends => {
                let otherwise = code!(if childless { cx.#any_leaf(shape, #label)?; });
                Tail { childless: leaf, otherwise }
            }
            Childless::Never => Tail::default(),
        };
        let steps = self.steps(&rule.body, InRule { id, rule }, 0, &tail);
        let (enter, leave) = (self.enter(rule, id), self.leave(rule));
        code! {
            #doc
            #[inline(never)]
            fn #name(
                g: &CgaValues,
                cx: &mut cga_rt::Cx<'_, CgaCall>,
                shape: &cga_rt::ShapeRef<'_>,
                #(#names: #types,)*
            ) -> cga_rt::Flow {
                #enter
                #locals
                #base
                #flag
                #steps
                #leave
            }
        }
    }

    fn function(&self, id: FunctionId, function: &Function) -> TokenStream {
        self.name_params(&function.params);
        let name = self.names.function(id, self.source.token(function.span.first));
        let params = self.given(&function.params, &function.locals);
        let site = site::param(function.sites as usize);
        let (names, types): (Vec<_>, Vec<_>) = site.into_iter().chain(params).unzip();
        let ty = inner_type(function.ty);
        let locals = self.locals(&function.params, &function.locals, &Access::function());
        let body = self.expr(&function.body, &Access::function());
        let body = code!({ #locals #body });
        let shape = match self.plan.function_needs_whole(id) {
            true => code!(cga_rt::Shape),
            false => code!(impl cga_rt::View),
        };
        let body = if let Some(stack) = self.plan.function_stack.request(id) {
            let stack = Literal::u32_unsuffixed(stack);
            code! {
                if !env.call(#stack) {
                    return ::core::default::Default::default();
                }
                let value = #body;
                env.called(#stack);
                value
            }
        } else {
            body
        };
        code! {
            fn #name(g: &CgaValues, env: &mut cga_rt::Env, shape: &mut #shape, #(#names: #types,)*) -> #ty {
                #body
            }
        }
    }

    /// The parameters that are given, with their types.
    fn given(&self, params: &[Param], locals: &[Expr]) -> impl Iterator<Item = (Ident, TokenStream)> {
        given(params, locals).enumerate().map(|(number, ty)| (self.param(number), ty))
    }

    /// Adds a rule to the trail; a block is a part of its rule.
    fn enter(&self, rule: &Rule, id: RuleId) -> TokenStream {
        if rule.block {
            return if self.tells_parts { code!(cx.enter_block();) } else { TokenStream::new() };
        }
        let numbers: Vec<u32> = self.plan.trails.of(id).collect();
        let number = site::of_site(&numbers);
        let enter = code!(cx.enter(#number, shape)?;);
        // A derivation for queries leaves out the rules that leave nothing for them.
        match self.left_shapes.get(id.0 as usize) {
            Some(LeftShapes { labels: false, solids_of_faces }) => {
                code!(#enter if cx.leaves_nothing(shape, #solids_of_faces) { return cx.leave(); })
            }
            _ => enter,
        }
    }

    fn leave(&self, rule: &Rule) -> TokenStream {
        match (rule.block, self.tells_parts) {
            (false, _) => code!(cx.leave()),
            (true, true) => code!(cx.leave_block()),
            (true, false) => code!(cga_rt::Flow::Continue(())),
        }
    }

    /// The values of locals: they are the last parameters.
    fn locals(&self, params: &[Param], locals: &[Expr], at: &Access) -> TokenStream {
        let first = params.len() - locals.len();
        let locals = locals.iter().enumerate().map(|(number, value)| {
            self.at(value.span, || {
                let (name, value) = (self.param(first + number), self.expr(value, at));
                code!(let #name = #value;)
            })
        });
        locals.collect()
    }

    /// The statements of steps. `number` counts the children made so far, and `tail` follows on every path.
    fn steps(&self, steps: &[Step], body: InRule<'_>, mut number: u32, tail: &Tail) -> TokenStream {
        let mut code = TokenStream::new();
        let mut rest = steps;
        while let Some((step, behind)) = rest.split_first() {
            let count = rest.iter().take_while(|step| step.changes_shape()).count();
            if 0 < count {
                let (changes, behind) = rest.split_at(count);
                code.extend(self.at(step.span, || self.changed(changes)));
                rest = behind;
                continue;
            }
            rest = behind;
            if let StepKind::Case { arms, otherwise } = &step.kind {
                debug_assert!(rest.is_empty(), "a case takes in everything behind it");
                code.extend(self.at(step.span, || self.branches((arms, otherwise), body, number, tail)));
                return code;
            }
            code.extend(self.at(step.span, || self.step(step, body, number, rest.is_empty())));
            number += step.children();
        }
        code.extend(if number == 0 { tail.childless.clone() } else { tail.otherwise.clone() });
        code
    }

    /// Steps that change the current shape.
    fn changed(&self, steps: &[Step]) -> TokenStream {
        if let ChangeForm::Slim(changes) = self.plan.change_form(steps) {
            let (mut code, mut rest) = (TokenStream::new(), steps);
            for change in &changes {
                let (own, behind) = rest.split_at(change.steps());
                code.extend(self.slim(own, change));
                rest = behind;
            }
            let bases = code!(let bases = cga_rt::Bases::new(););
            return if changes.iter().any(|change| *change != SlimChange::Nothing) {
                quote!(#bases #code)
            } else {
                code
            };
        }
        let code: TokenStream = steps.iter().map(|step| self.at(step.span, || self.change(step))).collect();
        code! {
            let changed = {
                let mut whole = cx.env.whole(shape);
                {
                    let shape = &mut whole;
                    #code
                }
                cx.env.base(whole)
            };
            let shape = &changed.shape();
        }
    }

    /// Steps on the slim shape.
    fn slim(&self, steps: &[Step], change: &SlimChange) -> TokenStream {
        let Some(first) = steps.first() else { return TokenStream::new() };
        if let SlimChange::Material(change) = change {
            let code = steps.iter().map(|step| self.at(step.span, || self.change(step))).collect();
            return self.at(first.span, || self.change_material(change, code));
        }
        self.at(first.span, || self.slim_step(first, change))
    }

    /// A step on the slim shape that does not change the material.
    fn slim_step(&self, step: &Step, change: &SlimChange) -> TokenStream {
        match (change, &step.kind) {
            (SlimChange::Nothing, StepKind::Do(operation, args)) => {
                let none = TokenStream::new();
                let (lets, call) = self.operation_on(operation, args, &Access::rule(), &none);
                code!({ #lets let shape = &mut { shape }; cga_rt::op::#call })
            }
            (SlimChange::Scope, StepKind::Do(operation, args)) => {
                let further = code!(&bases, &mut own,);
                let (lets, call) = self.operation_on(operation, args, &Access::rule(), &further);
                code! {
                    let mut own = ::core::option::Option::None;
                    let shape = {
                        #lets
                        cga_rt::slim::#call
                    };
                }
            }
            _ => TokenStream::new(),
        }
    }

    fn change(&self, step: &Step) -> TokenStream {
        let at = Access::whole();
        match &step.kind {
            StepKind::Do(operation, args) => self.operation(operation, args),
            StepKind::SetAttr(id, expr) => {
                let (value, set) = (self.expr(expr, &at), self.set(*id, expr.ty, &local("a", 0)));
                code!({ let a0 = #value; #set })
            }
            StepKind::SetShape(attr, expr) => {
                let Some(set) = attr.set else { return TokenStream::new() };
                let (set, value) = (hygienic(set), self.image(expr, &at));
                code!({
                    let a0 = #value;
                    cga_rt::set::#set(cx.env, shape, a0);
                })
            }
            StepKind::Rust(path, args) => {
                let path = self.source.path(step.span.first, path);
                let here = self.at_path(step.span);
                let call = self.with_rust_args(args, &at, |args| {
                    quote_spanned!(here=> cga_rt::host::operate(cx.env, shape, |shape| #path(shape, #(#args),*)))
                });
                code!(#call;)
            }
            _ => TokenStream::new(),
        }
    }

    /// The branches of a rule, each with the steps that follow.
    fn branches(
        &self,
        (arms, otherwise): (&[(Expr, Vec<Step>)], &[Step]),
        body: InRule<'_>,
        number: u32,
        tail: &Tail,
    ) -> TokenStream {
        let at = Access::rule();
        let conditions = arms.iter().map(|(condition, _)| self.expr(condition, &at));
        let bodies = arms.iter().map(|(_, steps)| self.steps(steps, body, number, tail));
        let otherwise = self.steps(otherwise, body, number, tail);
        code!(#(if #conditions { #bodies } else)* { #otherwise })
    }

    /// A step that makes children. After the last one nothing reads the shape.
    fn step(&self, step: &Step, body: InRule<'_>, number: u32, is_last: bool) -> TokenStream {
        let made = (body.rule.leaf == Childless::Depends).then(|| code!(childless = false;));
        let child = Literal::u32_unsuffixed(number);
        match &step.kind {
            StepKind::Give(target) => {
                let successor = if is_last { self.last_successor(target, number) } else { successor(number) };
                let code = self.give(target, body.id, &TokenStream::new(), &successor);
                code!(#code #made)
            }
            StepKind::Renew(call) => {
                let (given, copy) = self.renew(call, &child);
                let code = self.give(&call.target, body.id, &copy, &successor(0));
                code!({ #given #code } #made)
            }
            StepKind::Block(block @ Block { parts: BlockParts::Slots(slots), .. }) => {
                let code = self.split(block, slots, body.id, number);
                match body.rule.leaf {
                    Childless::Depends => code! {
                        let has_parts = #code;
                        childless &= !has_parts;
                    },
                    _ => code!(#code;),
                }
            }
            StepKind::Block(block @ Block { parts: BlockParts::Arms(arms), .. }) => {
                let code = self.divided(block, arms, body.id, number);
                code!({ #code } #made)
            }
            StepKind::Block(block @ Block { parts: BlockParts::Sections(parts), .. }) => {
                let code = self.sections(block, parts, body.id, number);
                code!({ #code } #made)
            }
            StepKind::Block(block @ Block { parts: BlockParts::Each(target), .. }) => {
                let code = self.each(block, target, body.id, number);
                code!({ #code } #made)
            }
            StepKind::Block(block @ Block { parts: BlockParts::Operands(targets), .. }) => {
                self.derived(block, targets, body.id, number)
            }
            StepKind::Push(steps) => {
                let (base, steps) = (base(steps), self.steps(steps, body, 0, &Tail::default()));
                code!({
                    let shape = &cga_rt::push(shape, #child);
                    #base
                    #steps
                })
            }
            StepKind::Do(..)
            | StepKind::SetAttr(..)
            | StepKind::SetShape(..)
            | StepKind::Rust(..)
            | StepKind::Case { .. } => TokenStream::new(),
        }
    }

    /// The last successor of a rule is the current shape itself, with the seed of child number `number`.
    fn last_successor(&self, target: &Target, number: u32) -> TokenStream {
        let number = Literal::u32_unsuffixed(number);
        let draws = matches!(target, Target::Rule { rule, .. } if self.plan.draws(*rule));
        let seed = draws.then(|| code!(cga_rt::become_successor(shape, #number);));
        code!(#seed let part = shape;)
    }

    /// Hands the current shape to a successor, which `successor` makes. `copy` comes after the arguments, which are evaluated on the
    /// shape before it.
    pub(super) fn give(
        &self,
        target: &Target,
        from: RuleId,
        copy: &TokenStream,
        successor: &TokenStream,
    ) -> TokenStream {
        match target {
            Target::Leaf(name) => {
                let name = self.leaf(name);
                code!(#copy cx.symbol(shape, #name)?;)
            }
            Target::Nil if self.plan.vanishes(target, from) => code!(#copy cx.vanish(shape)?;),
            Target::Nil => TokenStream::new(),
            Target::Rule { rule, sites, args, span } => self.at(*span, || {
                let call = self.call(from, (*rule, sites), args.len(), self.source.token(span.first));
                let names: Vec<Ident> = (0..args.len()).map(|number| local("a", number)).collect();
                let values = args.iter().map(|arg| self.expr(arg, &Access::rule()));
                code!({
                    #(let #names = #values;)*
                    #copy
                    #successor
                    let flow: cga_rt::Flow = #call;
                    flow?;
                })
            }),
        }
    }

    /// Calls a rule on `part`, with arguments in `a0`, `a1`, …; of type `Flow`. Where the stack may grow long the call may wait, and
    /// while a template is made it may be left out.
    pub(super) fn call(&self, from: RuleId, (rule, sites): (RuleId, &[u32]), args: usize, span: Span) -> TokenStream {
        let name = self.rule(rule, span);
        let args = (0..args).map(|number| local("a", number)).map(|name| quote!(#name));
        let args: Vec<TokenStream> = site::passed(sites).into_iter().chain(args).collect();
        let direct = code!(CgaRules::#name(g, cx, part, #(#args),*));
        let request = self.plan.rule_stack.request(from, rule);
        let (levels, stack) = request.map_or((0, 0), |request| (request.levels, request.stack));
        let (levels, stack) = (Literal::u32_unsuffixed(levels), Literal::u32_unsuffixed(stack));
        let variant = local("Rule", rule.0 as usize);
        let hole = self
            .plan
            .holes
            .is_hole(from, rule)
            .then(|| code!(if cx.records() { cx.hole(part, #levels, #stack, CgaCall::#variant(#(#args),*)) } else));
        if request.is_none() {
            return match hole {
                Some(hole) => code!(#hole { #direct }),
                None => direct,
            };
        }
        code! {
            #hole if cx.descend(#levels, #stack) {
                let flow = #direct;
                cx.ascend(#levels, #stack);
                flow
            } else {
                cx.defer(part, #levels, #stack, CgaCall::#variant(#(#args),*))
            }
        }
    }

    /// A part that goes straight to a rule is the successor itself, with the seed of one.
    pub(super) fn hand_on(&self, rule: RuleId) -> Option<TokenStream> {
        self.plan.reseeds(rule).then(|| code!(cga_rt::hand_on(part);))
    }

    /// The successor of a part of a split or comp; of type `Flow`.
    pub(super) fn part(&self, target: &Target, from: RuleId) -> TokenStream {
        match target {
            Target::Nil if self.plan.vanishes(target, from) => code!(cx.vanish(part)),
            Target::Nil => code!(cga_rt::Flow::Continue(())),
            Target::Leaf(name) => {
                let name = self.leaf(name);
                code!(cx.symbol(part, #name))
            }
            Target::Rule { rule, sites, args, span } => self.at(*span, || {
                let call = self.call(from, (*rule, sites), args.len(), self.source.token(span.first));
                let names: Vec<Ident> = (0..args.len()).map(|number| local("a", number)).collect();
                let values = args.iter().map(|arg| self.expr(arg, &Access::part()));
                let hand_on = self.hand_on(*rule);
                code!({
                    #(let #names = #values;)*
                    #hand_on
                    #call
                })
            }),
        }
    }
}

/// A copy of the current shape, as child number `number`.
pub(super) fn successor(number: u32) -> TokenStream {
    let number = Literal::u32_unsuffixed(number);
    code!(let part = &cga_rt::successor(shape, #number);)
}

/// The types of the parameters that are given; locals are not.
pub(super) fn given<'r>(params: &'r [Param], locals: &[Expr]) -> impl Iterator<Item = TokenStream> + use<'r> {
    params.iter().take(params.len() - locals.len()).map(|param| inner_type(param.ty))
}

/// Remembers the scope for operations that look at where they began.
fn base(steps: &[Step]) -> TokenStream {
    if reads_first_scope(steps) { code!(let base = shape.scope();) } else { TokenStream::new() }
}
