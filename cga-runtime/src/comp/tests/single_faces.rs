//! Faces that take each other's place in memory.

use std::ops::ControlFlow;

use super::{arm, ball, models, parts};
use crate::comp::select::Word;
use crate::comp::{Align, Arm, AssignedComponents, Components, Mode, never};
use crate::op::{self, Length};
use crate::output::model::Model;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::run::template::Templates;
use crate::shape::Shape;

/// The arms and the shapes of the parts, in which nothing but every `keep`-th shape stays in memory.
fn successors(shape: &Shape, arms: &[Arm], keep: usize) -> Vec<(u32, String)> {
    let (env, mut sink, mut templates) = (&mut Env::for_tests(), Model::new(), Templates::<()>::default());
    let parts = AssignedComponents::of(env, shape, Components::Faces, Align::ZUp, arms, never);
    let ControlFlow::Continue(parts) = parts else { panic!("no limit is near") };
    let (mut out, mut kept) = (Vec::new(), Vec::new());
    let mut cx = Cx::new(env, &mut sink, &mut templates);
    let _: Flow = parts.each_successor(&mut cx, &mut |cx, arm, shape| {
        let whole = cx.env.leaf_tables.whole(shape);
        out.push((arm, format!("{whole:?}")));
        if out.len() % keep == 0 {
            kept.push((out.len() - 1, whole));
        }
        Flow::Continue(())
    });
    // The shapes that were kept have not changed since.
    assert!(kept.iter().all(|(number, whole)| out[*number].1 == format!("{whole:?}")));
    out
}

#[test]
fn faces_that_follow_each_other_are_the_same_as_faces_alone() {
    let env = &mut Env::for_tests();
    let mut shapes = models();
    // Trim planes of another component, texture coordinates, and a part of a ball with a cap.
    shapes.push(parts(&Shape::mesh(ball()), Components::Faces, Align::ZUp, &[arm(Word::Top, Mode::Each)]).remove(9).2);
    let mut grown = shapes[shapes.len() - 1].clone();
    op::extrude(env, &mut grown, Length::Absolute(2.0));
    let mut textured = Shape::mesh_axis_aligned(ball());
    let size = cga_split::Size::absolute(0.3);
    op::setup_projection(env, &mut textured, 0.0, op::ProjectionAxes::ScopeXy, size, size);
    op::project_uv(env, &mut textured, 0.0);
    shapes.extend([grown, textured]);
    for shape in shapes {
        let arms = [arm(Word::Top, Mode::Each), arm(Word::Side, Mode::Together), arm(Word::All, Mode::Each)];
        let alone = parts(&shape, Components::Faces, Align::ZUp, &arms);
        let alone: Vec<(u32, String)> = alone.iter().map(|(arm, _, shape)| (*arm, format!("{shape:?}"))).collect();
        for keep in [1, 2, 3, usize::MAX] {
            assert_eq!(successors(&shape, &arms, keep), alone);
        }
    }
}
