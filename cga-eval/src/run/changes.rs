//! Steps that change the current shape.

use std::ops::ControlFlow;

use cga_runtime::rt::{self, Bases, Cx, Env, Read, Shape, ShapeRef, Value, host, set, slim};
use cga_runtime::shape::scope::Scope;

use super::values::Values;
use crate::call::Call;
use crate::code::HostOperation;
use crate::current::Current;
use crate::stack::Frame;
use crate::steps::{MaterialStep, OperandsStep, SlimStep, TargetCode, WholeStep};

impl Values {
    /// Steps on the slim shape.
    #[inline(never)]
    pub(super) fn slim<'b>(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'b>,
        bases: &'b Bases,
        steps: &[SlimStep],
        frame: Frame,
    ) -> ShapeRef<'b> {
        let mut shape = shape.clone();
        for step in steps {
            match step {
                SlimStep::Says(args, call) => {
                    self.eval(cx.env, &shape, args, frame);
                    (call.0)(&mut self.stack.borrow_mut(), cx.env, &mut Current::Slim(&shape));
                }
                SlimStep::Scope(args, call) => {
                    self.eval(cx.env, &shape, args, frame);
                    let mut own = None;
                    let changed = (call.0)(&mut self.stack.borrow_mut(), cx.env, &shape, bases, &mut own).clone();
                    shape = changed;
                }
                SlimStep::Material(step) => {
                    let mut own = None;
                    let changed = self.material(cx.env, &shape, bases, &mut own, step, frame).clone();
                    shape = changed;
                }
            }
        }
        shape
    }

    /// A change of the material that is made once for each material before it.
    fn material<'s, 'b>(
        &self,
        env: &mut Env,
        shape: &'s ShapeRef<'b>,
        bases: &'b Bases,
        own: &'s mut Option<ShapeRef<'b>>,
        step: &MaterialStep,
        frame: Frame,
    ) -> &'s ShapeRef<'b> {
        let place = step.places.get(frame.site as usize).unwrap_or(&step.places[0]);
        let change = |env: &mut Env, shape: &mut Shape| {
            for step in &step.steps {
                // A material has no more to do when the run has ended.
                let _: ControlFlow<()> = self.change(env, shape, None, step, frame);
            }
        };
        let params: Vec<Value> = {
            let stack = self.stack.borrow();
            step.params.iter().map(|(at, ty)| stack.local(frame, *at, *ty)).collect()
        };
        let reads: Vec<Read<'_>> = params.iter().map(Read::from).collect();
        if step.reaches_caps {
            slim::change_coordinates(env, shape, bases, own, *place, &reads, &change)
        } else {
            slim::change_material(env, shape, bases, own, *place, &reads, &change)
        }
    }

    /// Steps on a whole shape.
    #[inline(never)]
    pub(super) fn whole<'b>(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'b>,
        bases: &'b Bases,
        base: Option<&Scope>,
        steps: &[WholeStep],
        frame: Frame,
    ) -> ControlFlow<(), ShapeRef<'b>> {
        let mut whole = cx.env.whole(shape);
        for step in steps {
            if cx.env.ended() {
                return ControlFlow::Break(());
            }
            self.change(cx.env, &mut whole, base, step, frame)?;
        }
        ControlFlow::Continue(bases.keep(cx.env.base(whole)).shape())
    }

    /// A step on a whole shape.
    fn change(
        &self,
        env: &mut Env,
        shape: &mut Shape,
        base: Option<&Scope>,
        step: &WholeStep,
        frame: Frame,
    ) -> ControlFlow<()> {
        let stack = &mut *self.stack.borrow_mut();
        match step {
            WholeStep::Change { args, change, asks, bakes } => {
                self.run(stack, env, &mut Current::Whole(shape), args, frame);
                if *asks {
                    env.ask()?;
                }
                if *bakes {
                    rt::bake(shape);
                }
                let own = *shape.scope();
                (change.0)(stack, env, shape, base.unwrap_or(&own));
            }
            WholeStep::Says(args, call) => {
                self.run(stack, env, &mut Current::Whole(shape), args, frame);
                (call.0)(stack, env, &mut Current::Whole(shape));
            }
            WholeStep::Named(args, ty) => {
                self.run(stack, env, &mut Current::Whole(shape), args, frame);
                let value = stack.value(*ty);
                let name = stack.text();
                rt::op::set_by_name(env, shape, name, value);
            }
            WholeStep::Attribute(value, number, ty) => {
                self.run(stack, env, &mut Current::Whole(shape), value, frame);
                set::attribute(shape, *number, stack.value(*ty));
            }
            WholeStep::Host { args, types, operation } => {
                self.run(stack, env, &mut Current::Whole(shape), args, frame);
                let mut values: Vec<rt::Value> = types.iter().rev().map(|ty| stack.value(*ty)).collect();
                values.reverse();
                match &operation.0 {
                    HostOperation::Registered(operation) => {
                        host::operate(env, shape, |shape| operation(shape, &values))
                    }
                    HostOperation::Compiled(operation) => operation(env, shape, &values),
                }
            }
        }
        ControlFlow::Continue(())
    }

    /// An operation that makes a new current shape from the leaves of its operands.
    #[inline(never)]
    pub(super) fn operands<'b>(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'b>,
        bases: &'b Bases,
        step: &OperandsStep,
        frame: Frame,
    ) -> ControlFlow<(), ShapeRef<'b>> {
        self.eval(cx.env, shape, &step.args, frame);
        let leaves = if step.recomposes {
            let begun = cx.env.begin_recomposition(shape);
            self.operand_leaves(cx, &begun.shape(), step, frame)?
        } else {
            self.operand_leaves(cx, shape, step, frame)?
        };
        cx.env.ask()?;
        let mut whole = cx.env.whole(shape);
        (step.call.0)(&mut self.stack.borrow_mut(), cx.env, &mut whole, leaves);
        ControlFlow::Continue(bases.keep(cx.env.base(whole)).shape())
    }

    fn operand_leaves(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'_>,
        step: &OperandsStep,
        frame: Frame,
    ) -> ControlFlow<(), Vec<Vec<Shape>>> {
        let mut list = Vec::with_capacity(step.operands.len());
        for (target, number) in step.operands.iter().zip(step.number..) {
            list.push(rt::operand(
                cx,
                self,
                &mut |cx| match target {
                    TargetCode::Nil => ControlFlow::Continue(()),
                    TargetCode::Vanish => cx.vanish(shape),
                    TargetCode::Leaf(name) => cx.symbol(shape, *name),
                    TargetCode::Rule(call) => {
                        let called = self.called(cx, shape, call, frame);
                        self.call(cx, &rt::successor(shape, number), call, called)
                    }
                },
                Values::resume,
            )?);
        }
        ControlFlow::Continue(list)
    }
}
