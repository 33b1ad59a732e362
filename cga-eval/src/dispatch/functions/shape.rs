//! Calls of functions that read the current shape.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::current::{candidate, view, whole};
use crate::dispatch::{FunctionCall, Known as _, words};
use cga_lang::ir::Expr;
use cga_runtime::rt::func;

/// The call of a function of this group, by the key of its row.
pub(super) fn call(key: &str, known: &[Expr]) -> Option<FunctionCall> {
    Some(match key {
        "asset_approx_ratio(file, text, float)" => FunctionCall::new(move |stack, env, current| {
            let a2 = stack.float();
            let a1 = stack.text();
            let a0 = stack.file();
            let value = view!(env, current, |shape| func::asset_approx_ratio(env, shape, a0, a1, a2,));
            stack.push_text(value);
        }),
        "asset_approx_size(file, text, float)" => FunctionCall::new(move |stack, env, current| {
            let a2 = stack.float();
            let a1 = stack.text();
            let a0 = stack.file();
            let value = view!(env, current, |shape| func::asset_approx_size(env, shape, a0, a1, a2,));
            stack.push_text(value);
        }),
        "asset_best_ratio(file, text)" => FunctionCall::new(move |stack, env, current| {
            let a1 = stack.text();
            let a0 = stack.file();
            let value = view!(env, current, |shape| func::asset_best_ratio(env, shape, a0, a1,));
            stack.push_text(value);
        }),
        "asset_best_size(file, text)" => FunctionCall::new(move |stack, env, current| {
            let a1 = stack.text();
            let a0 = stack.file();
            let value = view!(env, current, |shape| func::asset_best_size(env, shape, a0, a1,));
            stack.push_text(value);
        }),
        "asset_fit_size(file, text, float)" => FunctionCall::new(move |stack, env, current| {
            let a2 = stack.float();
            let a1 = stack.text();
            let a0 = stack.file();
            let value = view!(env, current, |shape| func::asset_fit_size(env, shape, a0, a1, a2,));
            stack.push_text(value);
        }),
        "assets_sort_ratio(file, RatioAxes)" => {
            let a1 = words::func_ratio_axes(known.word(1)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a0 = stack.file();
                let value = view!(env, current, |shape| func::assets_sort_ratio(env, shape, a0, a1,));
                stack.push_text(value);
            })
        }
        "assets_sort_ratio_array(files, RatioAxes)" => {
            let a1 = words::func_ratio_axes(known.word(1)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a0 = stack.files();
                let value = view!(env, current, |shape| func::assets_sort_ratio_array(env, shape, a0, a1,));
                stack.push_texts(value);
            })
        }
        "assets_sort_size(file, SizeAxes, float)" => {
            let a1 = words::func_size_axes(known.word(1)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a2 = stack.float();
                let a0 = stack.file();
                let value = view!(env, current, |shape| func::assets_sort_size(env, shape, a0, a1, a2,));
                stack.push_text(value);
            })
        }
        "assets_sort_size_array(files, SizeAxes, float)" => {
            let a1 = words::func_size_axes(known.word(1)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a2 = stack.float();
                let a0 = stack.files();
                let value = view!(env, current, |shape| func::assets_sort_size_array(env, shape, a0, a1, a2,));
                stack.push_texts(value);
            })
        }
        "chance(float)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.float();
            let value = view!(env, current, |shape| func::chance(env, shape, a0,));
            stack.push_bool(value);
        }),
        "context_compare(QueryTarget, text, ContextComparison)" => {
            let a0 = words::func_query_target(known.word(0)?)?;
            let a2 = words::func_context_comparison(known.word(2)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a1 = stack.text();
                let value = view!(env, current, |shape| func::context_compare(env, shape, a0, a1, a2,));
                stack.push_float(value);
            })
        }
        "context_count(QueryTarget, text)" => {
            let a0 = words::func_query_target(known.word(0)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a1 = stack.text();
                let value = view!(env, current, |shape| func::context_count(env, shape, a0, a1,));
                stack.push_float(value);
            })
        }
        "convert(Axis, System, System, ConvertWhat, float, float, float)" => {
            let a0 = words::func_axis(known.word(0)?)?;
            let a1 = words::func_system(known.word(1)?)?;
            let a2 = words::func_system(known.word(2)?)?;
            let a3 = words::func_convert_what(known.word(3)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a6 = stack.float();
                let a5 = stack.float();
                let a4 = stack.float();
                let value = whole!(env, current, |shape| func::convert(env, shape, a0, a1, a2, a3, a4, a5, a6,));
                stack.push_float(value);
            })
        }
        "convert_array(System, System, ConvertWhat, floats)" => {
            let a0 = words::func_system(known.word(0)?)?;
            let a1 = words::func_system(known.word(1)?)?;
            let a2 = words::func_convert_what(known.word(2)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a3 = stack.floats();
                let value = whole!(env, current, |shape| func::convert_array(env, shape, a0, a1, a2, a3,));
                stack.push_floats(value);
            })
        }
        "edge_attr_bool(text)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.text();
            let value = whole!(env, current, |shape| func::edge_attr_bool(env, shape, a0,));
            stack.push_bool(value);
        }),
        "edge_attr_float(text)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.text();
            let value = whole!(env, current, |shape| func::edge_attr_float(env, shape, a0,));
            stack.push_float(value);
        }),
        "edge_attr_string(text)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.text();
            let value = whole!(env, current, |shape| func::edge_attr_string(env, shape, a0,));
            stack.push_text(value);
        }),
        "file_random(file)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.file();
            let value = view!(env, current, |shape| func::file_random(env, shape, a0,));
            stack.push_text(value);
        }),
        "geometry_angle(AngleType)" => {
            let a0 = words::func_angle_type(known.word(0)?)?;
            FunctionCall::new(move |stack, env, current| {
                let value = whole!(env, current, |shape| func::geometry_angle(shape, a0,));
                stack.push_float(value);
            })
        }
        "geometry_area(Word)" => {
            let a0 = words::func_word(known.word(0)?)?;
            FunctionCall::new(move |stack, env, current| {
                let value = whole!(env, current, |shape| func::geometry_area(env, shape, a0,));
                stack.push_float(value);
            })
        }
        "geometry_boundary_length()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_boundary_length(shape,));
            stack.push_float(value);
        }),
        "geometry_du(float, TextureSpace)" => {
            let a1 = words::func_texture_space(known.word(1)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a0 = stack.float();
                let value = whole!(env, current, |shape| func::geometry_du(env, shape, a0, a1,));
                stack.push_float(value);
            })
        }
        "geometry_dv(float, TextureSpace)" => {
            let a1 = words::func_texture_space(known.word(1)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a0 = stack.float();
                let value = whole!(env, current, |shape| func::geometry_dv(env, shape, a0, a1,));
                stack.push_float(value);
            })
        }
        "geometry_groups()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_groups(env, shape,));
            stack.push_texts(value);
        }),
        "geometry_has_tags()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_has_tags(shape,));
            stack.push_bool(value);
        }),
        "geometry_has_tags_of(text, TaggedComponents)" => {
            let a1 = words::func_tagged_components(known.word(1)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a0 = stack.text();
                let value = whole!(env, current, |shape| func::geometry_has_tags_of(shape, a0, a1,));
                stack.push_bool(value);
            })
        }
        "geometry_has_uv_set(float)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.float();
            let value = whole!(env, current, |shape| func::geometry_has_uv_set(env, shape, a0,));
            stack.push_bool(value);
        }),
        "geometry_has_uvs()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_has_uvs(env, shape,));
            stack.push_bool(value);
        }),
        "geometry_height()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_height(shape,));
            stack.push_float(value);
        }),
        "geometry_is_closed_surface()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_is_closed_surface(shape,));
            stack.push_bool(value);
        }),
        "geometry_is_concave()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_is_concave(shape,));
            stack.push_bool(value);
        }),
        "geometry_is_instanced()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_is_instanced(shape,));
            stack.push_bool(value);
        }),
        "geometry_is_oriented(Word)" => {
            let a0 = words::func_word(known.word(0)?)?;
            FunctionCall::new(move |stack, env, current| {
                let value = whole!(env, current, |shape| func::geometry_is_oriented(env, shape, a0,));
                stack.push_bool(value);
            })
        }
        "geometry_is_planar(float)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.float();
            let value = whole!(env, current, |shape| func::geometry_is_planar(env, shape, a0,));
            stack.push_bool(value);
        }),
        "geometry_is_rectangular(float)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.float();
            let value = whole!(env, current, |shape| func::geometry_is_rectangular(env, shape, a0,));
            stack.push_bool(value);
        }),
        "geometry_materials()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_materials(env, shape,));
            stack.push_texts(value);
        }),
        "geometry_n_edges()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_n_edges(shape,));
            stack.push_float(value);
        }),
        "geometry_n_faces()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_n_faces(shape,));
            stack.push_float(value);
        }),
        "geometry_n_holes()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_n_holes(shape,));
            stack.push_float(value);
        }),
        "geometry_n_vertices()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_n_vertices(shape,));
            stack.push_float(value);
        }),
        "geometry_tags()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_tags(env, shape,));
            stack.push_texts(value);
        }),
        "geometry_tags_of(text, TaggedComponents)" => {
            let a1 = words::func_tagged_components(known.word(1)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a0 = stack.text();
                let value = whole!(env, current, |shape| func::geometry_tags_of(env, shape, a0, a1,));
                stack.push_texts(value);
            })
        }
        "geometry_u_max(float)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.float();
            let value = whole!(env, current, |shape| func::geometry_u_max(env, shape, a0,));
            stack.push_float(value);
        }),
        "geometry_u_min(float)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.float();
            let value = whole!(env, current, |shape| func::geometry_u_min(env, shape, a0,));
            stack.push_float(value);
        }),
        "geometry_v_max(float)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.float();
            let value = whole!(env, current, |shape| func::geometry_v_max(env, shape, a0,));
            stack.push_float(value);
        }),
        "geometry_v_min(float)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.float();
            let value = whole!(env, current, |shape| func::geometry_v_min(env, shape, a0,));
            stack.push_float(value);
        }),
        "geometry_volume()" => FunctionCall::new(move |stack, env, current| {
            let value = whole!(env, current, |shape| func::geometry_volume(shape,));
            stack.push_float(value);
        }),
        "get_geo_coord(GeoCoordinate)" => {
            let a0 = words::func_geo_coordinate(known.word(0)?)?;
            FunctionCall::new(move |stack, env, current| {
                let value = view!(env, current, |shape| func::get_geo_coord(env, shape, a0,));
                stack.push_float(value);
            })
        }
        "get_material(MaterialSource, MaterialMode)" => {
            let a0 = words::func_material_source(known.word(0)?)?;
            let a1 = words::func_material_mode(known.word(1)?)?;
            FunctionCall::new(move |stack, env, current| {
                let value = whole!(env, current, |shape| func::get_material(env, shape, a0, a1,));
                stack.push_texts(value);
            })
        }
        "image_approx_ratio(file, text, float)" => FunctionCall::new(move |stack, env, current| {
            let a2 = stack.float();
            let a1 = stack.text();
            let a0 = stack.file();
            let value = view!(env, current, |shape| func::image_approx_ratio(env, shape, a0, a1, a2,));
            stack.push_text(value);
        }),
        "image_best_ratio(file, text)" => FunctionCall::new(move |stack, env, current| {
            let a1 = stack.text();
            let a0 = stack.file();
            let value = view!(env, current, |shape| func::image_best_ratio(env, shape, a0, a1,));
            stack.push_text(value);
        }),
        "images_sort_ratio(file, ImageAxes)" => {
            let a1 = words::func_image_axes(known.word(1)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a0 = stack.file();
                let value = view!(env, current, |shape| func::images_sort_ratio(env, shape, a0, a1,));
                stack.push_text(value);
            })
        }
        "images_sort_ratio_array(files, ImageAxes)" => {
            let a1 = words::func_image_axes(known.word(1)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a0 = stack.files();
                let value = view!(env, current, |shape| func::images_sort_ratio_array(env, shape, a0, a1,));
                stack.push_texts(value);
            })
        }
        "inside(QueryTarget, text)" => {
            let a0 = words::func_query_target(known.word(0)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a1 = stack.text();
                let value = view!(env, current, |shape| func::inside(env, shape, a0, a1,));
                stack.push_bool(value);
            })
        }
        "is_tagged(text)" => FunctionCall::new(move |stack, _, current| {
            let a0 = stack.text();
            let value = candidate!(current, |candidate| func::is_tagged(candidate, a0,));
            stack.push_bool(value);
        }),
        "is_tagged_at(text, Subcomponent)" => {
            let a1 = words::func_subcomponent(known.word(1)?)?;
            FunctionCall::new(move |stack, _, current| {
                let a0 = stack.text();
                let value = candidate!(current, |candidate| func::is_tagged_at(candidate, a0, a1,));
                stack.push_bool(value);
            })
        }
        "list_random(text)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.text();
            let value = view!(env, current, |shape| func::list_random(env, shape, a0,));
            stack.push_text(value);
        }),
        "minimum_distance(QueryTarget, text)" => {
            let a0 = words::func_query_target(known.word(0)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a1 = stack.text();
                let value = view!(env, current, |shape| func::minimum_distance(env, shape, a0, a1,));
                stack.push_float(value);
            })
        }
        "overlaps(QueryTarget, text)" => {
            let a0 = words::func_query_target(known.word(0)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a1 = stack.text();
                let value = view!(env, current, |shape| func::overlaps(env, shape, a0, a1,));
                stack.push_bool(value);
            })
        }
        "rand()" => FunctionCall::new(move |stack, env, current| {
            let value = view!(env, current, |shape| func::rand(shape,));
            stack.push_float(value);
        }),
        "rand_between(float, float)" => FunctionCall::new(move |stack, env, current| {
            let a1 = stack.float();
            let a0 = stack.float();
            let value = view!(env, current, |shape| func::rand_between(env, shape, a0, a1,));
            stack.push_float(value);
        }),
        "rand_to(float)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.float();
            let value = view!(env, current, |shape| func::rand_to(env, shape, a0,));
            stack.push_float(value);
        }),
        "touches(QueryTarget, text)" => {
            let a0 = words::func_query_target(known.word(0)?)?;
            FunctionCall::new(move |stack, env, current| {
                let a1 = stack.text();
                let value = view!(env, current, |shape| func::touches(env, shape, a0, a1,));
                stack.push_bool(value);
            })
        }
        _ => return None,
    })
}
