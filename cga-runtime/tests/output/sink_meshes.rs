//! Triangle meshes of models.

use std::sync::Arc;

use crate::sink_support::{Fill, color, front, mixed, plate, steady, textured, upright};
use cga_runtime::geometry::uv_map::UvMap;
use cga_runtime::material::{Layer, Material, MaterialText};
use cga_runtime::output::meshes::{Granularity, MeshLeaf, TriangleMesh};
use cga_runtime::output::model::Model;
use cga_runtime::run::sink::{Leaf, Quad, Sink};
use cga_runtime::shape::scope::Scope;
use cga_runtime::value::text::Text;
use glam::{DAffine3, DMat3, DVec3, DVec4, dvec3};

/// The area of some triangles at a place.
fn area(mesh: &TriangleMesh, indices: &[u32], place: &DAffine3) -> f64 {
    let point = |at: u32| {
        let [x, y, z] = mesh.positions[at as usize].map(f64::from);
        place.transform_point3(dvec3(x, y, z))
    };
    let triangles = indices.as_chunks::<3>().0.iter();
    triangles.map(|&[a, b, c]| (point(b) - point(a)).cross(point(c) - point(a)).length() / 2.0).sum()
}

/// The leaves of a model, with a leaf without faces before each.
fn with_placements(model: &Model) -> Model {
    let mut all = Model::new();
    for leaf in model {
        assert!(all.placement(&Leaf::new(&Text::fixed("Lamp"), leaf.material(), &leaf.scope())).is_continue());
        assert!(leaf.replay(&mut all).is_continue());
    }
    all
}

#[test]
fn every_leaf_has_its_area_at_every_granularity() {
    for model in [mixed(), steady(), with_placements(&mixed())] {
        for granularity in [Granularity::Material, Granularity::Rule, Granularity::Leaf] {
            let meshes = model.meshes(granularity);
            let mut areas = vec![0.0; model.len()];
            for mesh in &meshes {
                assert_eq!(mesh.positions.len(), mesh.normals.len());
                assert!(mesh.uvs.iter().all(|list| list.is_empty() || list.len() == mesh.positions.len()));
                assert!(mesh.places.is_empty() || mesh.places.len() == mesh.leaves.len());
                for (at, MeshLeaf { leaf, indices }) in mesh.leaves.iter().enumerate() {
                    let place = mesh.places.get(at).copied().unwrap_or_default();
                    areas[*leaf] += area(mesh, &mesh.indices[indices.clone()], &place);
                    let view = model.leaves().nth(*leaf).expect("a leaf");
                    assert!(mesh.rule.as_ref().is_none_or(|rule| *rule == view.rule()));
                    assert_eq!(mesh.rule.is_none(), granularity == Granularity::Material);
                }
            }
            for (found, leaf) in areas.iter().zip(&model) {
                assert!((found - leaf.area()).abs() < 1e-5 * leaf.area().max(1.0), "{} {found}", leaf.rule());
            }
        }
    }
}

#[test]
fn normals_are_those_of_the_triangles() {
    for mesh in &mixed().meshes(Granularity::Material) {
        for &[a, b, c] in mesh.indices.as_chunks::<3>().0 {
            let point = |at: u32| DVec3::from_array(mesh.positions[at as usize].map(f64::from));
            let flat = (point(b) - point(a)).cross(point(c) - point(a)).normalize();
            let normal = DVec3::from_array(mesh.normals[a as usize].map(f64::from));
            // The normals of the textured triangle lean.
            assert!(flat.dot(normal) > 0.79, "{flat} {normal}");
        }
    }
}

#[test]
fn granularity_decides_the_number_of_meshes() {
    let mut fill = Fill(Model::new());
    for at in 0..3 {
        fill.quad("A", &color(1.0, 0.0, 0.0), front(DVec3::X * f64::from(at), 1.0, 1.0));
        fill.quad("B", &color(1.0, 0.0, 0.0), front(DVec3::Y * f64::from(at), 1.0, 1.0));
        fill.cuboid("B", &color(0.0, 1.0, 0.0), upright(DVec3::Z * f64::from(at), DVec3::ONE));
    }
    let count = |granularity| fill.0.meshes(granularity).list.len();
    assert_eq!([Granularity::Material, Granularity::Rule, Granularity::Leaf].map(count), [2, 3, 9]);
    let first = &fill.0.meshes(Granularity::Material).list[0];
    let leaves: Vec<_> = first.leaves.iter().map(|leaf| (leaf.leaf, leaf.indices.clone())).collect();
    assert_eq!(leaves, [(0, 0..6), (1, 6..12), (3, 12..18), (4, 18..24), (6, 24..30), (7, 30..36)]);
}

#[test]
fn an_asset_at_several_places_is_one_mesh_a_material() {
    let (asset, wood) = (plate(), Arc::new(Material::UNSET));
    let mut fill = Fill(Model::new());
    for x in 0..5 {
        fill.instance("Bench", &wood, &asset, DAffine3::from_translation(DVec3::X * f64::from(x)));
    }
    // A node cannot mirror without turning faces over.
    fill.instance("Bench", &wood, &asset, DAffine3::from_scale(dvec3(-1.0, 1.0, 1.0)));
    let meshes = fill.0.meshes(Granularity::Leaf);
    let (shared, single): (Vec<_>, Vec<_>) = meshes.into_iter().partition(|mesh| !mesh.places.is_empty());
    // The asset has two materials, and faces without any.
    assert_eq!((shared.len(), single.len()), (3, 3));
    for mesh in shared {
        assert_eq!(mesh.leaves.iter().map(|leaf| leaf.leaf).collect::<Vec<_>>(), [0, 1, 2, 3, 4]);
        assert_eq!(mesh.places[4].translation, DVec3::X * 4.0);
    }
    assert!(single.iter().all(|mesh| mesh.leaves.len() == 1 && mesh.leaves[0].leaf == 5));
}

#[test]
fn coordinates_and_tangents_are_there_where_a_material_needs_them() {
    let material = Arc::new(Material::with(|look| {
        look.set_text(MaterialText::Map(Layer::Color), "a.png");
        look.set_text(MaterialText::Map(Layer::Normal), "b.png");
    }));
    let quad = Quad::new(DVec3::ZERO, DVec3::X * 2.0, DVec3::Y);
    let map = UvMap { u: DVec4::X * 0.5, v: DVec4::Y };
    let scope = Scope::new(dvec3(2.0, 1.0, 0.0));
    let mut model = Model::new();
    let sets = [cga_runtime::geometry::uv_map::SetMap { set: 0, maps: map.into() }];
    assert!(model.quad(&Leaf::new(&Text::fixed("Sign"), &material, &scope).with_uvs(&sets), &quad).is_continue());
    let meshes = model.meshes(Granularity::Material);
    let mesh = &meshes.list[0];
    assert_eq!(mesh.uvs[0], [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    assert_eq!(mesh.tangents, [[1.0, 0.0, 0.0, 1.0]; 4]);
    assert_eq!([Layer::Color, Layer::Normal].map(|layer| mesh.set_of(layer)), [Some(0); 2]);
    let mut fill = Fill(Model::new());
    fill.mesh("Sign", &Arc::default(), &textured(), DAffine3::IDENTITY);
    let mesh = &fill.0.meshes(Granularity::Material).list[0];
    assert_eq!((mesh.uvs[0][2], mesh.tangents.len()), ([0.0, 0.25], 0));
    assert_eq!(mesh.material.texture.as_ref().map(|name| name.as_str()), Some("maps/brick wall.png"));
}

#[test]
fn a_model_far_away_keeps_its_millimetres() {
    let far = dvec3(500_000.0, 0.0, 5_400_000.0);
    let mut fill = Fill(Model::new());
    fill.cuboid("Box", &color(1.0, 1.0, 1.0), upright(far, dvec3(0.001, 2.0, 1.0)));
    let turned = DAffine3::from_mat3_translation(DMat3::from_rotation_y(0.5), far);
    fill.instance("Bench", &color(0.5, 0.5, 0.5), &plate(), turned);
    fill.instance("Bench", &color(0.5, 0.5, 0.5), &plate(), turned * DAffine3::from_translation(DVec3::X));
    let meshes = fill.0.meshes(Granularity::Material);
    assert!(meshes.origin.distance(far) < 100.0);
    let width =
        |mesh: &TriangleMesh| mesh.positions.iter().fold(0.0f32, |most, p| most.max(p[0] - mesh.positions[0][0]).abs());
    assert!((width(&meshes.list[0]) - 0.001).abs() < 1e-6, "{}", width(&meshes.list[0]));
    assert!(meshes.list.iter().flat_map(|mesh| &mesh.places).all(|place| place.translation.length() < 100.0));
}

/// Up to 8,192 m from the origin of the world, 32 bits are fine enough.
#[test]
fn coordinates_begin_at_the_origin_of_the_world_unless_one_of_them_is_large() {
    let white = color(1.0, 1.0, 1.0);
    for [x, y, z] in
        [[8191.0, 0.0, 0.0], [8000.0, 0.0, -8000.0], [-8192.5, 0.0, 3.0], [0.0, 8191.5, 0.0], [5.0, 2.0, 8190.9]]
    {
        let at = dvec3(x, y, z);
        let placed = DAffine3::from_mat3_translation(DMat3::from_rotation_y(0.3), at);
        for kind in 0..3 {
            let mut fill = Fill(Model::new());
            match kind {
                0 => fill.cuboid("Box", &white, upright(at, dvec3(1.0, 1.0, 1.0))),
                1 => fill.instance("Bench", &white, &plate(), placed),
                _ => fill.mesh("Bench", &white, &plate(), placed),
            }
            let bounds = fill.0.bounds();
            let is_near = bounds.low.abs().max(bounds.high.abs()).max_element() <= 8192.0;
            let origin = fill.0.meshes(Granularity::Material).origin;
            assert_eq!(origin == DVec3::ZERO, is_near, "{at}, {kind}: {origin}");
            assert!(is_near || origin.distance(at) < 10.0, "{at}, {kind}: {origin}");
        }
    }
}

#[test]
fn appended_models_keep_leaves_in_order() {
    let (mut sum, one, two) = (Model::new(), mixed(), steady());
    sum.append(&one);
    sum.append(&two);
    assert_eq!(sum.len(), one.len() + two.len());
    let rules = |model: &Model| model.leaves().map(|leaf| leaf.rule().to_owned()).collect::<Vec<_>>();
    assert_eq!(rules(&sum), [rules(&one), rules(&two)].concat());
    assert!((sum.area() - one.area() - two.area()).abs() < 1e-9);
    assert_eq!(sum.leaves().next_back().map(|leaf| leaf.rule()), two.leaves().next_back().map(|leaf| leaf.rule()));
}
