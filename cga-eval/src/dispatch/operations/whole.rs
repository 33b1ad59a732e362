//! Calls of operations that change a whole shape.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::{Change, Known as _, words};
use cga_lang::ir::Arg;
use cga_runtime::rt::op;

/// The call of an operation of this form, by the key of its row.
pub(crate) fn call(key: &str, known: &[Arg]) -> Option<Change> {
    Some(match key {
        "align_to_auto(UpAxis, AlignAuto)" => {
            let a0 = words::op_up_axis(known.word(0)?)?;
            let a1 = words::op_align_auto(known.word(1)?)?;
            Change::new(move |_, env, shape, _| op::align_to_auto(env, shape, a0, a1))
        }
        "align_to_axes(AlignAxes)" => {
            let a0 = words::op_align_axes(known.word(0)?)?;
            Change::new(move |_, env, shape, _| op::align_to_axes(env, shape, a0))
        }
        "align_to_box(BoxAxes)" => {
            let a0 = words::op_box_axes(known.word(0)?)?;
            Change::new(move |_, env, shape, _| op::align_to_box(env, shape, a0))
        }
        "align_to_edge(UpAxis, float, AlignEdge)" => {
            let a0 = words::op_up_axis(known.word(0)?)?;
            let a2 = words::op_align_edge(known.word(2)?)?;
            Change::new(move |stack, env, shape, _| {
                let a1 = stack.float();
                op::align_to_edge(env, shape, a0, a1, a2)
            })
        }
        "align_to_face(UpAxis, AlignFace, float)" => {
            let a0 = words::op_up_axis(known.word(0)?)?;
            let a1 = words::op_align_face(known.word(1)?)?;
            Change::new(move |stack, env, shape, _| {
                let a2 = stack.float();
                op::align_to_face(env, shape, a0, a1, a2)
            })
        }
        "align_to_first_edge(UpAxis, float)" => {
            let a0 = words::op_up_axis(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a1 = stack.float();
                op::align_to_first_edge(env, shape, a0, a1)
            })
        }
        "align_to_indices(UpAxis, float, float)" => {
            let a0 = words::op_up_axis(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a2 = stack.float();
                let a1 = stack.float();
                op::align_to_indices(env, shape, a0, a1, a2)
            })
        }
        "align_to_selected(UpAxis, AlignFace, AlignEdge)" => {
            let a0 = words::op_up_axis(known.word(0)?)?;
            let a1 = words::op_align_face(known.word(1)?)?;
            let a2 = words::op_align_edge(known.word(2)?)?;
            Change::new(move |_, env, shape, _| op::align_to_selected(env, shape, a0, a1, a2))
        }
        "center(CenterAxes)" => {
            let a0 = words::op_center_axes(known.word(0)?)?;
            Change::new(move |_, env, shape, base| op::center(env, shape, base, a0))
        }
        "cleanup_geometry(CleanupComponents, float)" => {
            let a0 = words::op_cleanup_components(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a1 = stack.float();
                op::cleanup_geometry(env, shape, a0, a1)
            })
        }
        "color_hex(text)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.text();
            op::color_hex(env, shape, a0)
        }),
        "color_rgb(float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::color_rgb(env, shape, a0, a1, a2)
        }),
        "color_rgba(float, float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a3 = stack.float();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::color_rgba(env, shape, a0, a1, a2, a3)
        }),
        "convexify()" => Change::new(move |_, env, shape, _| op::convexify(env, shape)),
        "convexify_within(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::convexify_within(env, shape, a0)
        }),
        "copy_uv(float, float)" => Change::new(move |stack, env, shape, _| {
            let a1 = stack.float();
            let a0 = stack.float();
            op::copy_uv(env, shape, a0, a1)
        }),
        "delete_holes()" => Change::new(move |_, env, shape, _| op::delete_holes(env, shape)),
        "delete_tags()" => Change::new(move |_, env, shape, _| op::delete_tags(env, shape)),
        "delete_tags_of(text, TaggedComponents)" => {
            let a1 = words::op_tagged_components(known.word(1)?)?;
            Change::new(move |stack, env, shape, _| {
                let a0 = stack.text();
                op::delete_tags_of(env, shape, a0, a1)
            })
        }
        "delete_uv(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::delete_uv(env, shape, a0)
        }),
        "extrude(length)" => {
            let length0 = known.length(0);
            Change::new(move |stack, env, shape, _| {
                let a0 = length0.of(stack.float());
                op::extrude(env, shape, a0)
            })
        }
        "extrude_along(ExtrudeAlong, length)" => {
            let a0 = words::op_extrude_along(known.word(0)?)?;
            let length1 = known.length(1);
            Change::new(move |stack, env, shape, _| {
                let a1 = length1.of(stack.float());
                op::extrude_along(env, shape, a0, a1)
            })
        }
        "extrude_axis(ExtrudeAxis, length)" => {
            let a0 = words::op_extrude_axis(known.word(0)?)?;
            let length1 = known.length(1);
            Change::new(move |stack, env, shape, _| {
                let a1 = length1.of(stack.float());
                op::extrude_axis(env, shape, a0, a1)
            })
        }
        "footprint()" => Change::new(move |_, env, shape, _| op::footprint(env, shape)),
        "inner_rect()" => Change::new(move |_, env, shape, _| op::inner_rect(env, shape)),
        "insert(file)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.file();
            op::insert(env, shape, a0)
        }),
        "insert_along_uv(float, file, float)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.float();
            let a1 = stack.file();
            let a0 = stack.float();
            op::insert_along_uv(env, shape, a0, a1, a2)
        }),
        "insert_along_uv_with(float, file, float, HeightDirection, HeightAlignment)" => {
            let a3 = words::op_height_direction(known.word(3)?)?;
            let a4 = words::op_height_alignment(known.word(4)?)?;
            Change::new(move |stack, env, shape, _| {
                let a2 = stack.float();
                let a1 = stack.file();
                let a0 = stack.float();
                op::insert_along_uv_with(env, shape, a0, a1, a2, a3, a4)
            })
        }
        "insert_with(file, UpAxis, InsertMode, CleanupMode)" => {
            let a1 = words::op_up_axis(known.word(1)?)?;
            let a2 = words::op_insert_mode(known.word(2)?)?;
            let a3 = words::op_cleanup_mode(known.word(3)?)?;
            Change::new(move |stack, env, shape, _| {
                let a0 = stack.file();
                op::insert_with(env, shape, a0, a1, a2, a3)
            })
        }
        "mirror(bool, bool, bool)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.bool();
            let a1 = stack.bool();
            let a0 = stack.bool();
            op::mirror(env, shape, a0, a1, a2)
        }),
        "mirror_scope(bool, bool, bool)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.bool();
            let a1 = stack.bool();
            let a0 = stack.bool();
            op::mirror_scope(env, shape, a0, a1, a2)
        }),
        "normalize_uv(float, NormalizeMode, NormalizeType)" => {
            let a1 = words::op_normalize_mode(known.word(1)?)?;
            let a2 = words::op_normalize_type(known.word(2)?)?;
            Change::new(move |stack, env, shape, _| {
                let a0 = stack.float();
                op::normalize_uv(env, shape, a0, a1, a2)
            })
        }
        "offset(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::offset(env, shape, a0)
        }),
        "offset_selected(float, OffsetFaces)" => {
            let a1 = words::op_offset_faces(known.word(1)?)?;
            Change::new(move |stack, env, shape, _| {
                let a0 = stack.float();
                op::offset_selected(env, shape, a0, a1)
            })
        }
        "opacity(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::opacity(env, shape, a0)
        }),
        "project_uv(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::project_uv(env, shape, a0)
        }),
        "rectify(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::rectify(env, shape, a0)
        }),
        "reduce_geometry(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::reduce_geometry(env, shape, a0)
        }),
        "reset_geometry()" => Change::new(move |_, env, shape, _| op::reset_geometry(env, shape)),
        "reset_material(MaterialTarget)" => {
            let a0 = words::op_material_target(known.word(0)?)?;
            Change::new(move |_, env, shape, _| op::reset_material(env, shape, a0))
        }
        "reverse_normals()" => Change::new(move |_, env, shape, _| op::reverse_normals(env, shape)),
        "rotate(float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::rotate(env, shape, a0, a1, a2)
        }),
        "rotate_about(RotateAbout, float, float, float)" => {
            let a0 = words::op_rotate_about(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a3 = stack.float();
                let a2 = stack.float();
                let a1 = stack.float();
                op::rotate_about(env, shape, a0, a1, a2, a3)
            })
        }
        "rotate_in(TransformMode, System, float, float, float)" => {
            let a0 = words::op_transform_mode(known.word(0)?)?;
            let a1 = words::op_system(known.word(1)?)?;
            Change::new(move |stack, env, shape, _| {
                let a4 = stack.float();
                let a3 = stack.float();
                let a2 = stack.float();
                op::rotate_in(env, shape, a0, a1, a2, a3, a4)
            })
        }
        "rotate_scope(float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::rotate_scope(env, shape, a0, a1, a2)
        }),
        "rotate_uv(float, float)" => Change::new(move |stack, env, shape, _| {
            let a1 = stack.float();
            let a0 = stack.float();
            op::rotate_uv(env, shape, a0, a1)
        }),
        "scale_uv(float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::scale_uv(env, shape, a0, a1, a2)
        }),
        "set_material(texts)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.texts();
            op::set_material(env, shape, a0)
        }),
        "set_normals(NormalsMode)" => {
            let a0 = words::op_normals_mode(known.word(0)?)?;
            Change::new(move |_, env, shape, _| op::set_normals(env, shape, a0))
        }
        "set_pivot(AxisMap, float)" => {
            let a0 = words::op_axis_map(known.word(0)?)?;
            Change::new(move |stack, env, shape, _| {
                let a1 = stack.float();
                op::set_pivot(env, shape, a0, a1)
            })
        }
        "set_tags_from_edge_attrs()" => Change::new(move |_, env, shape, _| op::set_tags_from_edge_attrs(env, shape)),
        "setup_projection(float, ProjectionAxes, size, size)" => {
            let a1 = words::op_projection_axes(known.word(1)?)?;
            let size2 = known.size(2);
            let size3 = known.size(3);
            Change::new(move |stack, env, shape, _| {
                let a3 = size3.of(stack.float());
                let a2 = size2.of(stack.float());
                let a0 = stack.float();
                op::setup_projection(env, shape, a0, a1, a2, a3)
            })
        }
        "setup_projection_at(float, ProjectionAxes, size, size, length, length, float)" => {
            let a1 = words::op_projection_axes(known.word(1)?)?;
            let size2 = known.size(2);
            let size3 = known.size(3);
            let length4 = known.length(4);
            let length5 = known.length(5);
            Change::new(move |stack, env, shape, _| {
                let a6 = stack.float();
                let a5 = length5.of(stack.float());
                let a4 = length4.of(stack.float());
                let a3 = size3.of(stack.float());
                let a2 = size2.of(stack.float());
                let a0 = stack.float();
                op::setup_projection_at(env, shape, a0, a1, a2, a3, a4, a5, a6)
            })
        }
        "setup_projection_uw(float, ProjectionAxes, size, size, float)" => {
            let a1 = words::op_projection_axes(known.word(1)?)?;
            let size2 = known.size(2);
            let size3 = known.size(3);
            Change::new(move |stack, env, shape, _| {
                let a4 = stack.float();
                let a3 = size3.of(stack.float());
                let a2 = size2.of(stack.float());
                let a0 = stack.float();
                op::setup_projection_uw(env, shape, a0, a1, a2, a3, a4)
            })
        }
        "setup_uv(float, float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a3 = stack.float();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::setup_uv(env, shape, a0, a1, a2, a3)
        }),
        "size(length, length, length)" => {
            let length0 = known.length(0);
            let length1 = known.length(1);
            let length2 = known.length(2);
            Change::new(move |stack, env, shape, _| {
                let a2 = length2.of(stack.float());
                let a1 = length1.of(stack.float());
                let a0 = length0.of(stack.float());
                op::size(env, shape, a0, a1, a2)
            })
        }
        "soften_normals(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::soften_normals(env, shape, a0)
        }),
        "tag(text, TagTarget)" => {
            let a1 = words::op_tag_target(known.word(1)?)?;
            Change::new(move |stack, env, shape, _| {
                let a0 = stack.text();
                op::tag(env, shape, a0, a1)
            })
        }
        "taper(float)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.float();
            op::taper(env, shape, a0)
        }),
        "texture(text)" => Change::new(move |stack, env, shape, _| {
            let a0 = stack.text();
            op::texture(env, shape, a0)
        }),
        "tile_uv(float, size, size)" => {
            let size1 = known.size(1);
            let size2 = known.size(2);
            Change::new(move |stack, env, shape, _| {
                let a2 = size2.of(stack.float());
                let a1 = size1.of(stack.float());
                let a0 = stack.float();
                op::tile_uv(env, shape, a0, a1, a2)
            })
        }
        "translate(length, length, length)" => {
            let length0 = known.length(0);
            let length1 = known.length(1);
            let length2 = known.length(2);
            Change::new(move |stack, env, shape, _| {
                let a2 = length2.of(stack.float());
                let a1 = length1.of(stack.float());
                let a0 = length0.of(stack.float());
                op::translate(env, shape, a0, a1, a2)
            })
        }
        "translate_in(TransformMode, System, float, float, float)" => {
            let a0 = words::op_transform_mode(known.word(0)?)?;
            let a1 = words::op_system(known.word(1)?)?;
            Change::new(move |stack, env, shape, _| {
                let a4 = stack.float();
                let a3 = stack.float();
                let a2 = stack.float();
                op::translate_in(env, shape, a0, a1, a2, a3, a4)
            })
        }
        "translate_uv(float, float, float)" => Change::new(move |stack, env, shape, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            op::translate_uv(env, shape, a0, a1, a2)
        }),
        "trim()" => Change::new(move |_, env, shape, _| op::trim(env, shape)),
        _ => return None,
    })
}
