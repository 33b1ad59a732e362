//! Calls of operations that make primitives, roofs and envelopes.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::{Change, Known as _, words};
use cga_lang::ir::Arg;
use cga_runtime::rt::op;

/// The call of an operation of this form, by the key of its row.
pub(crate) fn call(key: &str, known: &[Arg]) -> Option<Change> {
    Some(match key {
        "cone(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::cone(env, shape, a0)
        }),
        "cone_sized(float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::cone_sized(env, shape, a0, a1, a2)
        }),
        "cube()" => Change::new(move |_, env, shape, _| op::cube(env, shape)),
        "cube_sized(float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::cube_sized(env, shape, a0, a1, a2)
        }),
        "cylinder()" => Change::new(move |_, env, shape, _| op::cylinder(env, shape)),
        "cylinder_sides(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::cylinder_sides(env, shape, a0)
        }),
        "cylinder_sized(float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::cylinder_sized(env, shape, a0, a1, a2)
        }),
        "disk(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::disk(env, shape, a0)
        }),
        "disk_sized(float, float)" => Change::new(move |stack, env, shape, _| {
            let a1 = stack.float();
            let a0 = stack.float();
            op::disk_sized(env, shape, a0, a1)
        }),
        "envelope_all(EnvelopeAlong, float, float, float, float, float, float, float, float, float)" => {
            let a0 = words::op_envelope_along(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a9 = stack.float();
                let a8 = stack.float();
                let a7 = stack.float();
                let a6 = stack.float();
                let a5 = stack.float();
                let a4 = stack.float();
                let a3 = stack.float();
                let a2 = stack.float();
                let a1 = stack.float();
                op::envelope_all(env, shape, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9)
            })
        }
        "envelope_edges(EnvelopeAlong, float, floats, floats)" => {
            let a0 = words::op_envelope_along(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a3 = stack.floats();
                let a2 = stack.floats();
                let a1 = stack.float();
                op::envelope_edges(env, shape, a0, a1, a2, a3)
            })
        }
        "envelope_front(EnvelopeAlong, float, float, float)" => {
            let a0 = words::op_envelope_along(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a3 = stack.float();
                let a2 = stack.float();
                let a1 = stack.float();
                op::envelope_front(env, shape, a0, a1, a2, a3)
            })
        }
        "envelope_front_back(EnvelopeAlong, float, float, float, float, float)" => {
            let a0 = words::op_envelope_along(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a5 = stack.float();
                let a4 = stack.float();
                let a3 = stack.float();
                let a2 = stack.float();
                let a1 = stack.float();
                op::envelope_front_back(env, shape, a0, a1, a2, a3, a4, a5)
            })
        }
        "envelope_old_all(float, float, float, float, float, float, float, float, float)" => {
            Change::new(move |stack, env, shape, _| {
                let a8 = stack.float();
                let a7 = stack.float();
                let a6 = stack.float();
                let a5 = stack.float();
                let a4 = stack.float();
                let a3 = stack.float();
                let a2 = stack.float();
                let a1 = stack.float();
                let a0 = stack.float();
                op::envelope_old_all(env, shape, a0, a1, a2, a3, a4, a5, a6, a7, a8)
            })
        }
        "envelope_old_front(float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::envelope_old_front(env, shape, a0, a1, a2)
        }),
        "envelope_old_front_back(float, float, float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a4 = stack.float();
            let a3 = stack.float();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::envelope_old_front_back(env, shape, a0, a1, a2, a3, a4)
        }),
        "envelope_old_sides(float, float, float, float, float, float, float)" => {
            Change::new(move |stack, env, shape, _| {
                let a6 = stack.float();
                let a5 = stack.float();
                let a4 = stack.float();
                let a3 = stack.float();
                let a2 = stack.float();
                let a1 = stack.float();
                let a0 = stack.float();
                op::envelope_old_sides(env, shape, a0, a1, a2, a3, a4, a5, a6)
            })
        }
        "envelope_sides(EnvelopeAlong, float, float, float, float, float, float, float)" => {
            let a0 = words::op_envelope_along(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a7 = stack.float();
                let a6 = stack.float();
                let a5 = stack.float();
                let a4 = stack.float();
                let a3 = stack.float();
                let a2 = stack.float();
                let a1 = stack.float();
                op::envelope_sides(env, shape, a0, a1, a2, a3, a4, a5, a6, a7)
            })
        }
        "quad()" => Change::new(move |_, env, shape, _| op::quad(env, shape)),
        "quad_sized(float, float)" => Change::new(move |stack, env, shape, _| {
            let a1 = stack.float();
            let a0 = stack.float();
            op::quad_sized(env, shape, a0, a1)
        }),
        "roof_gable(float, float, float, bool)" => Change::new(move |stack, env, shape, _| {
            let a3 = stack.bool();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::roof_gable(env, shape, a0, a1, a2, a3)
        }),
        "roof_gable_along(float, float, float, bool, float)" => Change::new(move |stack, env, shape, _| {
            let a4 = stack.float();
            let a3 = stack.bool();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::roof_gable_along(env, shape, a0, a1, a2, a3, a4)
        }),
        "roof_gable_by(RoofValue, float, float, float, bool)" => {
            let a0 = words::op_roof_value(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a4 = stack.bool();
                let a3 = stack.float();
                let a2 = stack.float();
                let a1 = stack.float();
                op::roof_gable_by(env, shape, a0, a1, a2, a3, a4)
            })
        }
        "roof_hip(float, float, bool)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.bool();
            let a1 = stack.float();
            let a0 = stack.float();
            op::roof_hip(env, shape, a0, a1, a2)
        }),
        "roof_hip_by(RoofValue, float, float, bool)" => {
            let a0 = words::op_roof_value(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a3 = stack.bool();
                let a2 = stack.float();
                let a1 = stack.float();
                op::roof_hip_by(env, shape, a0, a1, a2, a3)
            })
        }
        "roof_pyramid(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::roof_pyramid(env, shape, a0)
        }),
        "roof_pyramid_by(RoofValue, float)" => {
            let a0 = words::op_roof_value(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a1 = stack.float();
                op::roof_pyramid_by(env, shape, a0, a1)
            })
        }
        "roof_ridge_by(RoofValue, float)" => {
            let a0 = words::op_roof_value(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a1 = stack.float();
                op::roof_ridge_by(env, shape, a0, a1)
            })
        }
        "roof_shed(float, float)" => Change::new(move |stack, env, shape, _| {
            let a1 = stack.float();
            let a0 = stack.float();
            op::roof_shed(env, shape, a0, a1)
        }),
        "roof_shed_by(RoofValue, float, float)" => {
            let a0 = words::op_roof_value(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a2 = stack.float();
                let a1 = stack.float();
                op::roof_shed_by(env, shape, a0, a1, a2)
            })
        }
        "sphere()" => Change::new(move |_, env, shape, _| op::sphere(env, shape)),
        "sphere_sides(float, float)" => Change::new(move |stack, env, shape, _| {
            let a1 = stack.float();
            let a0 = stack.float();
            op::sphere_sides(env, shape, a0, a1)
        }),
        "sphere_sized(float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::sphere_sized(env, shape, a0, a1, a2)
        }),
        _ => return None,
    })
}
