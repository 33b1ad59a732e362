//! Buffers: the exact output for leaves.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::sink_support::{Fill, color, front, mixed, plate, textured, tower, upright};
use cga_runtime::geometry::Axis;
use cga_runtime::geometry::cut::slabs;
use cga_runtime::material::Material;
use cga_runtime::output::buffers::{Buffers, Chunks};
use cga_runtime::output::stats::checksum;
use cga_runtime::run::sink::{Leaf, Sink};
use cga_runtime::shape::scope::Scope;
use cga_runtime::value::text::Text;
use glam::{DAffine3, DMat3, DVec3, dvec3};

fn point(vertex: &[f32; 6]) -> [f32; 3] {
    [vertex[0], vertex[1], vertex[2]]
}

/// Checks that every vertex's normal agrees with the winding of its triangles.
fn normals_follow_windings(buffers: &Buffers) {
    for triangle in buffers.indices().chunks_exact(3) {
        let corner = |i: usize| DVec3::from_array(point(&buffers.vertices()[triangle[i] as usize]).map(f64::from));
        let across = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalize();
        for &index in triangle {
            let v = buffers.vertices()[index as usize];
            let normal = dvec3(v[3].into(), v[4].into(), v[5].into());
            assert!(0.999 < normal.dot(across), "{normal} is not {across}");
        }
    }
}

#[test]
fn a_quad_is_four_vertices_and_two_triangles() {
    let mut fill = Fill(Buffers::new());
    fill.quad("Wall", &color(1.0, 0.0, 0.0), front(dvec3(1.0, 2.0, 3.0), 4.0, 5.0));
    let buffers = fill.0;
    assert_eq!(buffers.indices(), [0, 1, 2, 0, 2, 3]);
    let corners = [[1.0, 2.0], [5.0, 2.0], [5.0, 7.0], [1.0, 7.0]];
    assert_eq!(buffers.vertices(), corners.map(|[x, y]| [x, y, 3.0, 0.0, 0.0, 1.0]));
    assert!(buffers.uvs().is_empty());
}

#[test]
fn a_box_is_closed_and_looks_outwards() {
    let mut fill = Fill(Buffers::new());
    fill.cuboid("Box", &color(1.0, 0.0, 0.0), upright(dvec3(1.0, 2.0, 3.0), dvec3(4.0, 5.0, 6.0)));
    let buffers = fill.0;
    assert_eq!((buffers.vertices().len(), buffers.triangle_count()), (24, 12));
    normals_follow_windings(&buffers);
    assert_eq!(checksum(buffers.vertices(), buffers.indices()), 120.0);
    // Each edge of the twelve triangles occurs once in each direction, bit for bit.
    let edge = |t: &[u32], i: usize| [t[i], t[(i + 1) % 3]].map(|c| point(&buffers.vertices()[c as usize]));
    let edges: Vec<_> = buffers.indices().chunks_exact(3).flat_map(|t| [0, 1, 2].map(|i| edge(t, i))).collect();
    assert!(edges.iter().all(|[a, b]| edges.iter().filter(|&e| e == &[*b, *a]).count() == 1));
}

#[test]
fn a_mirrored_box_looks_inwards_with_its_winding() {
    let mut fill = Fill(Buffers::new());
    fill.cuboid("Box", &color(1.0, 0.0, 0.0), upright(DVec3::ZERO, dvec3(-4.0, 5.0, 6.0)));
    normals_follow_windings(&fill.0);
    assert_eq!(checksum(fill.0.vertices(), fill.0.indices()), -120.0);
}

#[test]
fn a_mesh_with_holes_keeps_its_volume() {
    let mut fill = Fill(Buffers::new());
    fill.mesh("Plate", &Arc::default(), &plate(), DAffine3::IDENTITY);
    let buffers = fill.0;
    // 8 + 2 - 2 triangles for each of the two faces with a hole, two for each of the other eight.
    assert_eq!((buffers.vertices().len(), buffers.triangle_count()), (48, 32));
    normals_follow_windings(&buffers);
    assert!((checksum(buffers.vertices(), buffers.indices()) - 10.0).abs() < 1e-5);
}

#[test]
fn a_mirrored_mesh_keeps_winding_and_normals_together() {
    let mut fill = Fill(Buffers::new());
    let mirror = DAffine3::from_scale(dvec3(-1.0, 2.0, 1.0));
    fill.mesh("Plate", &Arc::default(), &plate(), mirror);
    normals_follow_windings(&fill.0);
    assert!((checksum(fill.0.vertices(), fill.0.indices()) + 20.0).abs() < 1e-5);
}

#[test]
fn caps_of_both_sides_of_a_cut_have_the_same_triangles() {
    let bounds = plate().bounds();
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        let offset = (0.5 * (bounds.low + bounds.high))[axis.index()];
        let parts = slabs(&plate(), axis, &[offset]).parts;
        let [below, above] = [0, 1].map(|side| {
            let mut fill = Fill(Buffers::new());
            fill.mesh("Part", &Arc::default(), parts[side].as_ref().unwrap(), DAffine3::IDENTITY);
            let corners = |t: &[u32]| [t[0], t[1 + side], t[2 - side]].map(|i| point(&fill.0.vertices()[i as usize]));
            let is_cap = |t: &[[f32; 3]; 3]| t.iter().all(|p| p[axis.index()] == offset as f32);
            fill.0.indices().chunks_exact(3).map(corners).filter(is_cap).collect::<Vec<_>>()
        });
        assert!(4 <= below.len());
        assert_eq!(below, above);
    }
}

#[test]
fn texture_coordinates_are_there_for_all_or_none() {
    let mut fill = Fill(Buffers::new());
    let plain = Arc::new(Material::UNSET);
    fill.quad("Wall", &plain, front(DVec3::ZERO, 1.0, 1.0));
    fill.mesh("Sign", &plain, &textured(), DAffine3::from_mat3(DMat3::from_rotation_z(0.5)));
    fill.quad("Wall", &plain, front(DVec3::ZERO, 1.0, 1.0));
    let uvs = fill.0.uvs();
    assert_eq!(uvs.len(), 11);
    assert_eq!(uvs[4..7], [[0.0, 0.0], [1.0, 0.0], [0.0, 0.25]]);
    assert!(uvs[..4].iter().chain(&uvs[7..]).all(|uv| *uv == [0.0, 0.0]));
    let leaning = fill.0.vertices()[4];
    let turned = DMat3::from_rotation_z(0.5) * dvec3(0.6, 0.0, 0.8);
    assert!((dvec3(leaning[3].into(), leaning[4].into(), leaning[5].into()) - turned).length() < 1e-6);
}

#[test]
fn submeshes_are_runs_of_one_rule_and_material() {
    let (red, blue) = (color(1.0, 0.0, 0.0), color(0.0, 0.0, 1.0));
    let mut fill = Fill(Buffers::new());
    let quad = front(DVec3::ZERO, 1.0, 1.0);
    for (rule, material) in [("A", &red), ("A", &red), ("A", &blue), ("B", &blue), ("A", &red)] {
        fill.quad(rule, material, quad);
    }
    fill.quad("A", &color(1.0, 0.0, 0.0), quad);
    let submeshes: Vec<_> = fill.0.submeshes().map(|p| (p.rule, p.material, p.indices, p.vertices)).collect();
    let run = |rule, material, from: usize, to: usize| (rule, material, 6 * from..6 * to, 4 * from..4 * to);
    assert_eq!(submeshes, [run(0, 0, 0, 2), run(0, 1, 2, 3), run(1, 1, 3, 4), run(0, 0, 4, 6)]);
    assert_eq!((fill.0.rules().join(" "), fill.0.materials().len()), ("A B".to_owned(), 2));
}

#[test]
fn faces_of_a_mesh_show_their_own_materials_unless_the_shape_sets_one() {
    let mut fill = Fill(Buffers::new());
    fill.mesh("Plate", &Arc::default(), &plate(), DAffine3::IDENTITY);
    // Both faces with holes, then outer and inner sides in turn.
    assert_eq!(fill.0.submeshes().count(), 9);
    fill.0.clear();
    fill.mesh("Plate", &color(0.1, 0.2, 0.3), &plate(), DAffine3::IDENTITY);
    assert_eq!(fill.0.submeshes().count(), 1);
}

#[test]
fn a_full_buffer_ends_the_run_and_says_so() {
    let mut buffers = Buffers::new().with_limit(27);
    let (material, scope) = (Arc::new(Material::UNSET), Scope::new(DVec3::ONE));
    let name = Text::fixed("Box");
    let leaf = Leaf::new(&name, &material, &scope);
    let cuboid = upright(DVec3::ZERO, DVec3::ONE);
    assert_eq!(buffers.cuboid(&leaf, &cuboid), ControlFlow::Continue(()));
    assert!(buffers.check().is_ok());
    assert_eq!(buffers.quad(&leaf, &cuboid.faces()[0]), ControlFlow::Break(()));
    assert_eq!(buffers.check().unwrap_err().to_string(), "too large: more than 27 vertices");
    assert_eq!((buffers.vertices().len(), buffers.submeshes().count()), (24, 1));
    buffers.clear();
    assert!(buffers.check().is_ok() && buffers.quad(&leaf, &cuboid.faces()[0]).is_continue());
}

#[test]
fn an_origin_keeps_far_coordinates_fine() {
    let far = dvec3(512_345.125, 0.0, 5_400_000.5);
    let mut fill = Fill(Buffers::new().with_origin(far));
    fill.quad("Wall", &color(1.0, 0.0, 0.0), front(far + dvec3(0.001, 0.0, 0.0), 1.0, 1.0));
    assert!((fill.0.vertices()[0][0] - 0.001).abs() < 1e-6);
}

#[test]
fn buffers_and_stats_agree() {
    for model in [tower(6), mixed()] {
        let mut buffers = Buffers::with_capacity(100, 100);
        assert!(model.replay(&mut buffers).is_continue());
        let stats = model.stats();
        let total = stats.total();
        assert_eq!(total.vertices as usize, buffers.vertices().len());
        assert_eq!(total.triangles as usize, buffers.triangle_count());
        let sum = checksum(buffers.vertices(), buffers.indices());
        assert!((sum - stats.checksum()).abs() <= 1e-5 * stats.checksum().abs().max(1.0));
    }
}

#[test]
fn buffers_are_equal_if_their_lists_are() {
    let (mut one, mut same) = (Buffers::new(), Buffers::with_capacity(100, 100));
    assert!(mixed().replay(&mut one).is_continue() && mixed().replay(&mut same).is_continue());
    assert!(one == same && one == one.clone());
    assert!(one != Buffers::new().with_origin(DVec3::X));
    assert!(mixed().replay(&mut same).is_continue());
    assert!(one != same);
}

/// Adds quads until the sink ends the run, and returns the number of quads that it took.
fn quads(sink: &mut impl Sink, most: usize) -> usize {
    let (paint, scope) = (color(1.0, 0.0, 0.0), Scope::new(dvec3(1.0, 1.0, 0.0)));
    let mut quad = || sink.quad(&Leaf::new(&Text::fixed("Wall"), &paint, &scope), &front(DVec3::ZERO, 1.0, 1.0));
    (0..most).take_while(|_| quad().is_continue()).count()
}

#[test]
fn the_error_of_a_chunk_ends_the_run_and_arrives() {
    let mut seen = 0;
    let mut chunks = Chunks::new(24, |_: &Buffers| {
        seen += 1;
        if seen == 2 { Err(format!("chunk {seen}")) } else { Ok(()) }
    });
    // Six quads are a chunk; the thirteenth passes on the second chunk.
    assert_eq!(quads(&mut chunks, 100), 12);
    assert_eq!((quads(&mut chunks, 100), chunks.handed_out()), (0, 2), "it has ended");
    assert!(chunks.finish().is_break());
    assert_eq!(chunks.into_result(), Err(String::from("chunk 2")));
    assert_eq!(seen, 2);
}

#[test]
fn the_last_chunk_is_passed_on_and_its_result_arrives() {
    let mut sizes = Vec::new();
    let mut chunks = Chunks::new(24, |chunk: &Buffers| {
        sizes.push(chunk.triangle_count());
        if sizes.len() == 2 { Err("the last one") } else { Ok(()) }
    });
    assert_eq!(quads(&mut chunks, 8), 8);
    assert_eq!(chunks.into_result(), Err("the last one"));
    assert_eq!(sizes, [12, 4]);
    let nothing = Chunks::new(24, |_: &Buffers| Err("no chunk"));
    assert_eq!(nothing.into_result(), Ok(()));
}

#[test]
fn chunks_go_on_and_end_with_a_flow() {
    let mut count = 0;
    let mut chunks = Chunks::new(24, |_: &Buffers| {
        count += 1;
        ControlFlow::Continue(())
    });
    assert_eq!(quads(&mut chunks, 20), 20);
    assert!(chunks.into_result().is_continue());
    assert_eq!(count, 4);
    let mut chunks = Chunks::new(24, |_: &Buffers| ControlFlow::Break(()));
    assert_eq!(quads(&mut chunks, 20), 6);
    assert!(chunks.into_result().is_break());
}
