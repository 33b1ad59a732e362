//! All operations, on all meshes, with all numbers.

use std::sync::Arc;

use cga_geometry::along_uv::{AlongUv, HeightAlignment, HeightDirection, insert_along_uv};
use cga_geometry::boolean::{BooleanOp, combine};
use cga_geometry::cleanup::{Parts, cleanup, without_short_edges};
use cga_geometry::cut::{Plane, above, halves, iso_bands, slabs};
use cga_geometry::derive::{CornerValues, Derivation};
use cga_geometry::envelope::{EnvelopeSide, envelopes};
use cga_geometry::extract::extract;
use cga_geometry::extrude::{Extrude, extrude};
use cga_geometry::glam::{DAffine3, DMat3, DVec2, DVec3};
use cga_geometry::inner_rectangle::RectangleSides;
use cga_geometry::inner_rectangle::face::cut_rectangle;
use cga_geometry::mesh::{Mesh, UvAxis};
use cga_geometry::offset::each_edge::set_back;
use cga_geometry::offset::{OffsetFaces, offset};
use cga_geometry::roof::{Rise, RoofForm, roof_over};
use cga_geometry::{Axis, Frame, conform, convexify, footprint, holes, obj, primitive, rectify, reduce};

use crate::inputs::{NUMBERS, call, meshes, vectors};

fn list(parts: Vec<Option<Arc<Mesh>>>) -> Vec<Mesh> {
    parts.into_iter().flatten().map(|part| Mesh::clone(&part)).collect()
}

#[test]
fn operations_without_numbers() {
    for (name, mesh) in meshes() {
        let at = &[mesh.points().first(), mesh.points().last()];
        let of = |what: &'static str| move || format!("{what} of {name} at {at:?}");
        call(of("footprint"), || footprint::footprint(&mesh).into_iter().collect());
        call(of("holes"), || holes::without_holes(&mesh).into_iter().collect());
        call(of("conform"), || {
            let found = conform::conform(&mesh, DVec3::Y);
            vec![mesh.turned(|face| found.turned[face])]
        });
        call(of("measures"), || {
            let _ = (mesh.area(), mesh.volume(), mesh.bounds(), mesh.is_closed(), mesh.uv_range(0));
            let _ = (mesh.uv_extent(0, DVec3::ONE), mesh.adjacency().edge_count());
            vec![mesh.reversed(), mesh.raised(), mesh.without_materials(), Mesh::clone(&mesh).in_group("group")]
        });
        call(of("extract"), || vec![extract(&mesh, &[0, 7, u32::MAX, 0], &Frame::WORLD)]);
        call(of("obj"), || {
            let mut text = Vec::new();
            obj::write(&mesh, &mut text).unwrap();
            obj::read(&text).into_iter().map(|read| read.mesh).collect()
        });
        call(of("frame"), || {
            for face in 0..mesh.face_count() {
                let _ = cga_geometry::face_frame::face_frame(&mesh, face);
            }
            vec![]
        });
        for op in [BooleanOp::Unify, BooleanOp::Union, BooleanOp::Subtract, BooleanOp::Intersect] {
            let cube = primitive::cube();
            call(of("combine"), || {
                let operands = [std::slice::from_ref(&*mesh), std::slice::from_ref(&cube)];
                combine(op, operands, 0.0).into_iter().collect()
            });
        }
        for sides in [RectangleSides::Axes, RectangleSides::Edges] {
            call(of("rectangle"), || {
                let mut made = Derivation::new(&mesh, CornerValues::All, 0);
                mesh.faces().for_each(|face| _ = cut_rectangle(&face, sides, true, &mut made));
                vec![made.finish_by_use()]
            });
        }
    }
}

#[test]
fn operations_with_a_number() {
    for (name, mesh) in meshes() {
        for number in NUMBERS {
            let at = &[mesh.points().first(), mesh.points().last()];
            let of = |what: &'static str| move || format!("{what} of {name} at {at:?} with {number:e}");
            for axis in [Axis::X, Axis::Y, Axis::Z] {
                call(of("slabs"), || list(slabs(&mesh, axis, &[number, 0.5, number]).parts));
            }
            call(of("iso_bands"), || iso_bands(&mesh, 0, UvAxis::U, &[number, 0.5], 1000).map_or(Vec::new(), list));
            for vector in [DVec3::splat(number), DVec3::new(0.0, number, 0.0), DVec3::new(1.0, 0.5, 0.0)] {
                let plane = Plane { point: DVec3::splat(number), normal: vector };
                call(of("halves"), || list(halves(&mesh, &plane, number).parts));
                let plane = Plane { point: DVec3::splat(0.5), normal: vector };
                call(of("halves"), || list(halves(&mesh, &plane, 0.0).parts));
                call(of("above"), || list(vec![above(&mesh, &plane, 0.0)]));
            }
            for keep in [OffsetFaces::All, OffsetFaces::Inside, OffsetFaces::Border] {
                call(of("offset"), || vec![offset(&mesh, number, keep).0]);
            }
            for along in [
                Extrude::FaceNormal,
                Extrude::VertexNormal,
                Extrude::Vector(DVec3::Y),
                Extrude::Vector(DVec3::splat(number)),
                Extrude::FlatTop(DVec3::Y),
                Extrude::FlatTop(DVec3::splat(number)),
            ] {
                call(of("extrude"), || vec![extrude(&mesh, along, number)]);
            }
            let forms = [
                RoofForm::Hip { overhang: 0.0, even: true },
                RoofForm::Hip { overhang: number, even: false },
                RoofForm::Gable { across: number, along: 0.2, even: false, edge: None },
                RoofForm::Gable { across: 0.2, along: number, even: true, edge: Some(i64::MIN) },
                RoofForm::Pyramid,
                RoofForm::Shed { edge: i64::MAX },
                RoofForm::Shed { edge: i64::MIN },
                RoofForm::Ridge,
            ];
            for form in forms {
                for rise in [Rise::Slope(number), Rise::Height(number), Rise::Slope(0.5)] {
                    call(of("roof"), || vec![roof_over(&mesh, form, rise).mesh]);
                }
            }
            for (base, angle, height) in [(number, 45.0, 3.0), (1.0, number, 3.0), (1.0, 30.0, number)] {
                let sides = vec![EnvelopeSide { base, angle }; mesh.corners().len()];
                call(of("envelope"), || vec![envelopes(&mesh, &sides, height, None).0]);
                call(of("envelope"), || vec![envelopes(&mesh, &sides, height, Some(DVec3::splat(number))).0]);
            }
            call(of("convexify"), || convexify::convexify(&mesh, number).made.into_iter().map(|made| made.0).collect());
            for parts in [Parts { vertices: true, edges: true, faces: true }, Parts::default()] {
                call(of("cleanup"), || cleanup(&mesh, parts, number).into_iter().collect());
            }
            call(of("short"), || without_short_edges(&mesh, number).into_iter().collect());
            call(of("rectify"), || rectify::rectify(&mesh, number).ok().flatten().into_iter().collect());
            call(of("reduce"), || reduce::reduce(&mesh, number).into_iter().collect());
            call(of("softened"), || vec![mesh.softened(number)]);
            call(of("along"), || {
                let options = AlongUv {
                    set: 0,
                    height: number,
                    direction: HeightDirection::VertexNormal,
                    alignment: HeightAlignment::AlignPosition,
                    rounding: number,
                };
                insert_along_uv(&mesh, &primitive::cube(), &options, 1000)
                    .into_iter()
                    .chain(insert_along_uv(&primitive::cylinder(8), &mesh, &options, 1000))
                    .collect()
            });
            call(of("uv"), || {
                let uvs = vec![DVec2::splat(number); mesh.corners().len()];
                let mapped = mesh.with_uv_set(0, uvs);
                let _ = (mapped.uv_extent(0, DVec3::ONE), mapped.uv_extent(0, DVec3::splat(number)));
                vec![mapped]
            });
            call(of("set back"), || {
                let mut made = Derivation::new(&mesh, CornerValues::All, 0);
                for face in mesh.faces() {
                    let _ = set_back(&face, &[(0, number)], &[&[number; 3], &[0.1, number]], true, &mut made);
                }
                vec![made.finish_by_use()]
            });
        }
    }
}

#[test]
fn operations_with_a_vector() {
    for (name, mesh) in meshes() {
        for vector in vectors() {
            let at = &[mesh.points().first(), mesh.points().last()];
            let of = |what: &'static str| move || format!("{what} of {name} at {at:?} with {vector}");
            call(of("conform"), || {
                let found = conform::conform(&mesh, vector);
                vec![mesh.turned(|face| found.turned[face])]
            });
            call(of("map"), || {
                vec![mesh.map(&DAffine3 { matrix3: DMat3::from_diagonal(vector), translation: vector })]
            });
            call(of("stretched"), || {
                mesh.faces().for_each(|face| _ = face.stretched_normal(vector));
                vec![]
            });
            call(of("combine"), || {
                let other = mesh.map(&DAffine3::from_translation(vector));
                let operands = [std::slice::from_ref(&*mesh), std::slice::from_ref(&other)];
                combine(BooleanOp::Union, operands, vector.x).into_iter().collect()
            });
            let frame = Frame { origin: vector, axes: DMat3::from_diagonal(vector) };
            call(of("extract"), || vec![extract(&mesh, &[0], &frame)]);
        }
    }
}
