//! Models of entities: runs, replacement, events, without a renderer.

mod common;

use std::panic::panic_any;

use bevy_asset::{Assets, RenderAssetUsages};
use bevy_cga::*;
use bevy_ecs::prelude::*;
use bevy_math::Vec3;
use bevy_mesh::{Mesh, VertexAttributeValues};
use bevy_transform::components::{GlobalTransform, Transform};
use cga::sink::meshes::Granularity;
use cga::{Error, Shape, Value, Watch, cga};
use common::*;

/// The world positions of all vertices of an entity's model, in order.
fn positions(app: &bevy_app::App, entity: Entity) -> Vec<[f32; 3]> {
    let meshes = app.world().resource::<Assets<Mesh>>();
    let mut list = Vec::new();
    for (child, _, mesh, _) in parts(app, entity) {
        let place = app.world().get::<GlobalTransform>(child).expect("a place");
        let (positions, _) = collider_triangles(meshes.get(&mesh.0).expect("a mesh")).expect("its triangles");
        list.extend(positions.iter().map(|&point| place.transform_point(point).to_array()));
    }
    list
}

/// The lowest and the highest coordinates.
fn bounds(points: &[[f32; 3]]) -> (Vec3, Vec3) {
    let all = points.iter().map(|&point| Vec3::from_array(point));
    all.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), point| (low.min(point), high.max(point)))
}

#[test]
fn every_kind_of_change_makes_a_new_model() {
    let mut app = app();
    let entity = shown(&mut app, yard());
    let first = positions(&app, entity);
    assert_eq!(bounds(&first), (Vec3::ZERO, Vec3::new(20.0, 6.0, 10.0)));

    change(&mut app, entity, |cga| cga.grammar.set("height", 9.0.into()).expect("a height"));
    assert_eq!(bounds(&positions(&app, entity)).1.y, 9.0);
    change(&mut app, entity, |cga| cga.shape = Shape::rectangle(30.0, 10.0));
    assert_eq!(bounds(&positions(&app, entity)).1.x, 30.0);

    let roof = |app: &bevy_app::App| parts(app, entity)[0].1.material.color();
    let before = roof(&app);
    let seeds = (1..20).any(|seed| {
        change(&mut app, entity, |cga| cga.shape = cga.shape.clone().seed(seed));
        roof(&app) != before
    });
    assert!(seeds, "one of many seeds gives the other roof");

    let meshes = parts(&app, entity).len();
    change(&mut app, entity, |cga| cga.granularity = Granularity::Leaf);
    assert!(meshes < parts(&app, entity).len());
    change(&mut app, entity, |cga| cga.settings.start = Some("Trees".into()));
    assert!(parts(&app, entity).iter().all(|(_, part, ..)| part.rule.as_deref() == Some("Tree")));
    change(&mut app, entity, |cga| *cga = Cga::new(Field::default(), Shape::rectangle(5.0, 5.0)));
    assert_eq!(app.world().get::<CgaModel>(entity).expect("a model").model.rules(), ["Grass"]);
    assert!(log(&app).failed.is_empty());
}

#[test]
fn watertight_models_have_the_corners_of_neighbours_in_their_edges() {
    cga! {
        /// Two bays above three.
        grammar Bays;
        Lot --> split(z) { ~1 : split(x) { { ~2 : Bay. }* } | ~1 : split(x) { { ~3 : Bay. }* } }
    }
    let mut app = app();
    let cga = Cga::new(Bays::default(), Shape::rectangle(12.0, 2.0));
    let [plain, tight] = [cga.clone(), cga.watertight()].map(|cga| {
        let entity = shown(&mut app, cga);
        let leaves = app.world().get::<CgaModel>(entity).expect("a model").model.len();
        (positions(&app, entity), leaves)
    });
    assert_eq!(bounds(&plain.0), bounds(&tight.0));
    assert!(plain.0.len() < tight.0.len(), "{} {}", plain.0.len(), tight.0.len());
    assert_eq!(plain.1, tight.1);
}

#[test]
fn an_update_without_a_change_starts_no_run() {
    let mut app = app();
    shown(&mut app, yard());
    (0..10).for_each(|_| settle(&mut app));
    assert_eq!(log(&app).generated.len(), 1);
}

#[test]
fn the_old_model_stays_until_the_newest_replaces_it() {
    let mut app = app();
    let entity = shown(&mut app, yard());
    let old = app.world().get::<CgaModel>(entity).expect("a model").root;
    let gate = Gate::default();
    change_only(&mut app, entity, |cga| {
        cga.settings.watch = Some(gate.watch());
        cga.grammar.set("height", 10.0.into()).expect("a height");
    });
    for height in 11_u8..20 {
        app.update();
        assert_eq!(app.world().get::<CgaModel>(entity).expect("a model").root, old);
        assert!(app.world().get::<Children>(old).is_some_and(|children| !children.is_empty()));
        change_only(&mut app, entity, |cga| cga.grammar.set("height", f64::from(height).into()).expect("a height"));
    }
    gate.open();
    settle(&mut app);
    assert_eq!(bounds(&positions(&app, entity)).1.y, 19.0);
    assert!(app.world().get_entity(old).is_err());
    // The first model, the one that was under way, and the newest; those between were never shown.
    let newest: Vec<bool> = log(&app).generated.iter().map(|event| event.is_newest).collect();
    assert_eq!(newest, [true, false, true]);
}

#[test]
fn despawning_during_a_run_is_harmless() {
    let mut app = app();
    let gate = Gate::default();
    let mut cga = yard();
    cga.settings.watch = Some(gate.watch());
    let entities: Vec<Entity> = (0..4).map(|_| app.world_mut().spawn(cga.clone()).id()).collect();
    app.update();
    app.world_mut().despawn(entities[0]);
    app.world_mut().entity_mut(entities[1]).remove::<Cga>();
    app.world_mut().entity_mut(entities[2]).remove::<CgaRun>();
    gate.open();
    settle(&mut app);
    let log = log(&app);
    assert_eq!(log.generated.iter().map(|event| event.entity).collect::<Vec<_>>(), [entities[3]]);
    assert!(app.world().get::<CgaModel>(entities[1]).is_none() && app.world().get::<CgaRun>(entities[1]).is_none());
}

#[test]
fn a_clone_gets_a_model_of_its_own() {
    let mut app = app();
    let entity = shown(&mut app, yard());
    let before = positions(&app, entity);
    let copy = app.world_mut().entity_mut(entity).clone_and_spawn();
    assert!(app.world().get::<CgaModel>(copy).is_none());
    settle(&mut app);
    app.update();
    assert_eq!(positions(&app, copy), before);
    app.world_mut().despawn(copy);
    app.update();
    assert_eq!(positions(&app, entity), before);
}

#[test]
fn an_entity_that_loses_its_grammar_loses_its_model() {
    let mut app = app();
    app.update();
    let empty = app.world().entities().count_spawned();
    let entity = shown(&mut app, yard());
    app.world_mut().entity_mut(entity).remove::<Cga>();
    app.update();
    assert!(app.world().get::<CgaModel>(entity).is_none());
    assert_eq!(app.world().entities().count_spawned(), empty + 1);
    let entity = shown(&mut app, yard());
    app.world_mut().despawn(entity);
    app.update();
    assert_eq!(app.world().entities().count_spawned(), empty + 1);
}

#[test]
fn a_hundred_changes_leave_nothing_behind() {
    let mut app = app();
    let entity = shown(&mut app, yard().leaf_events(LeafEvents::Rules(vec!["Tree".into()])));
    app.add_observer(|leaf: On<CgaLeaf>, mut commands: Commands| {
        commands.spawn((Name::new("nest"), leaf.transform, ChildOf(leaf.root)));
    });
    change(&mut app, entity, |cga| cga.grammar.set("height", 5.0.into()).expect("a height"));
    let count = |app: &mut bevy_app::App| {
        app.update();
        (app.world().entities().count_spawned(), app.world().resource::<Assets<Mesh>>().len())
    };
    let before = count(&mut app);
    for step in 0_u8..100 {
        change(&mut app, entity, |cga| cga.grammar.set("height", f64::from(1 + step % 40).into()).expect("a height"));
    }
    assert_eq!(count(&mut app), before);
    assert_eq!(log(&app).generated.len(), 102);
    app.world_mut().despawn(entity);
    app.update();
    assert_eq!(count(&mut app).1, 0);
}

#[test]
fn leaves_have_events() {
    let mut app = app();
    let entity = shown(&mut app, yard().leaf_events(LeafEvents::All));
    let model = app.world().get::<CgaModel>(entity).expect("a model").clone();
    let events = &log(&app).leaves;
    assert_eq!(events.len(), model.model.len());
    assert_eq!(model.model.len(), 10);
    for (index, (event, leaf)) in events.iter().zip(model.model.leaves()).enumerate() {
        assert_eq!((event.entity, event.root, event.leaf), (entity, model.root, index));
        assert_eq!(event.rule(), leaf.rule());
        assert_eq!(event.size.to_array(), leaf.size().as_vec3().to_array());
        let [far, expected] = [event.transform.transform_point(event.size), {
            let scope = leaf.scope();
            Vec3::from_array((scope.origin + scope.axes * scope.size).as_vec3().to_array())
        }];
        assert!(far.distance(expected) < 1e-5, "{far} {expected}");
        assert!(event.centre().distance(Vec3::from_array(leaf.scope().centre().as_vec3().to_array())) < 1e-5);
        assert_eq!(event.model.reported("walls").expect("a report").summary().sum, 760.0);
    }
    change(&mut app, entity, |cga| cga.leaf_events = LeafEvents::Rules(vec!["Roof".into(), "Tree".into()]));
    assert_eq!(
        log(&app).leaves[10..].iter().map(CgaLeaf::rule).collect::<Vec<_>>(),
        ["Roof"].into_iter().chain(["Tree"; 5]).collect::<Vec<_>>()
    );
}

#[test]
fn an_observer_may_despawn_the_entity() {
    let mut app = app();
    app.add_observer(|leaf: On<CgaLeaf>, mut commands: Commands| commands.entity(leaf.entity).despawn());
    app.update();
    let before = app.world().entities().count_spawned();
    shown(&mut app, yard().leaf_events(LeafEvents::All));
    assert_eq!((log(&app).leaves.len(), log(&app).generated.len()), (1, 0));
    assert_eq!(app.world().entities().count_spawned(), before);
}

#[test]
fn an_asset_at_several_places_is_one_mesh() {
    let mut app = app();
    for granularity in [Granularity::Material, Granularity::Rule, Granularity::Leaf] {
        let entity = shown(&mut app, yard().granularity(granularity));
        let model = app.world().get::<CgaModel>(entity).expect("a model").model.clone();
        let list = parts(&app, entity);
        let is_tree = |part: &CgaMesh| {
            let mut rules = part.leaves.iter().filter_map(|leaf| model.leaves().nth(leaf.leaf)).map(|leaf| leaf.rule());
            rules.all(|rule| rule == "Tree")
        };
        let trees: Vec<_> = list.iter().filter(|(_, part, ..)| is_tree(part)).collect();
        assert_eq!(trees.len(), 5);
        assert!(trees.iter().all(|(_, _, mesh, _)| mesh == &trees[0].2), "one handle");
        for (number, (child, _, _, place)) in trees.iter().enumerate() {
            assert_eq!(
                *place,
                Transform::from_xyz(1.0 + 4.0 * number as f32, 0.0, 4.0).with_scale(Vec3::new(2.0, 3.0, 2.0))
            );
            assert_eq!(
                app.world().get::<GlobalTransform>(*child).map(GlobalTransform::translation),
                Some(place.translation)
            );
        }
        let others = list.len() - trees.len();
        assert_eq!(
            others,
            match granularity {
                Granularity::Leaf => 5,
                _ => 2,
            }
        );
    }
}

#[test]
fn a_triangle_leads_to_its_leaf() {
    let mut app = app();
    for granularity in [Granularity::Material, Granularity::Rule, Granularity::Leaf] {
        let entity = shown(&mut app, yard().granularity(granularity));
        let model = app.world().get::<CgaModel>(entity).expect("a model").model.clone();
        let mut found = vec![0; model.len()];
        for (_, part, mesh, place) in parts(&app, entity) {
            let mesh = app.world().resource::<Assets<Mesh>>().get(&mesh.0).expect("a mesh").clone();
            let (positions, triangles) = collider_triangles(&mesh).expect("its triangles");
            for (number, triangle) in triangles.iter().enumerate() {
                let leaf = part.leaf_of_triangle(number).expect("a leaf");
                let bounds = model.leaves().nth(leaf).expect("a leaf").bounds();
                for at in triangle {
                    let point = place.transform_point(positions[*at as usize]).as_dvec3().to_array();
                    for (axis, at) in point.into_iter().enumerate() {
                        assert!(bounds.low[axis] - 1e-5 <= at && at <= bounds.high[axis] + 1e-5);
                    }
                }
                found[leaf] += 1;
            }
            assert_eq!(part.leaf_of_triangle(triangles.len()), None);
            assert_eq!(part.leaf_of_triangle(usize::MAX), None);
        }
        assert_eq!(found, [2, 2, 2, 2, 2, 4, 4, 4, 4, 4]);
    }
}

#[test]
fn errors_are_events_and_the_old_model_stays() {
    let mut app = app();
    let entity = shown(&mut app, yard());
    let root = app.world().get::<CgaModel>(entity).expect("a model").root;
    change(&mut app, entity, |cga| {
        let attributes = cga.grammar.attributes();
        let index = attributes.iter().position(|attribute| attribute.name == "height").expect("an attribute");
        cga.grammar.attribute_set(index, Value::Float(500.0));
    });
    change(&mut app, entity, |cga| {
        cga.grammar.reset("height").expect("an attribute");
        cga.shape = Shape::rectangle(f64::NAN, 3.0);
    });
    change(&mut app, entity, |cga| {
        cga.shape = Shape::rectangle(20.0, 10.0);
        cga.settings.limits.shapes = 3;
    });
    let stopped = Watch::new();
    stopped.stop();
    change(&mut app, entity, |cga| {
        cga.settings = settings();
        cga.settings.watch = Some(stopped);
    });
    change(&mut app, entity, |cga| cga.settings.watch = Some(Watch::every(1, |_| panic_any("a broken watch"))));
    let errors: Vec<&CgaError> = log(&app).failed.iter().map(|event| &event.error).collect();
    assert!(log(&app).failed.iter().all(|event| event.entity == entity));
    let [attribute, shape, limit, CgaError::Stopped, CgaError::Panic(message)] = errors[..] else {
        panic!("{errors:?}")
    };
    assert!(matches!(attribute, CgaError::Run(Error::Attribute { name, .. }) if name.is("height")), "{attribute}");
    assert!(matches!(shape, CgaError::Run(Error::Shape(_))), "{shape}");
    assert!(matches!(limit, CgaError::Run(Error::Limit { limit: 3, .. })), "{limit}");
    assert_eq!(message, "a broken watch");
    assert_eq!(app.world().get::<CgaModel>(entity).expect("a model").root, root);
    change(&mut app, entity, |cga| cga.settings = settings());
    assert_eq!(log(&app).generated.len(), 2, "it recovers");
}

#[test]
fn faults_come_with_the_model() {
    let mut app = app();
    let entity = shown(&mut app, Cga::new(Yard::default(), Shape::rectangle(20.0, 10.0)));
    let event = &log(&app).generated[0];
    assert_eq!(event.entity, entity);
    assert_eq!(event.model.faults().len(), 1, "{:?}", event.model.faults());
    assert!(event.model.faults()[0].message.contains("tree"));
}

#[test]
fn a_model_without_leaves_has_no_meshes() {
    let mut app = app();
    let entity = shown(&mut app, Cga::new(Nothing::default(), Shape::rectangle(4.0, 4.0)));
    assert_eq!((log(&app).generated.len(), parts(&app, entity).len()), (1, 0));
    // Faces without an area.
    let mut cga = yard();
    cga.shape = Shape::rectangle(0.0, 0.0);
    let entity = shown(&mut app, cga);
    assert_eq!((log(&app).generated.len(), log(&app).failed.len()), (2, 0));
    assert!(positions(&app, entity).iter().flatten().all(|part| part.is_finite()));
}

#[test]
fn far_from_the_origin_places_stay_exact() {
    let mut app = app();
    let far = [3_512_345.25, 480.5, -5_403_210.75];
    app.insert_resource(CgaOrigin(cga::glam::DVec3::from_array(far)));
    let mut cga = yard().leaf_events(LeafEvents::All);
    let near = shown(&mut app, cga.clone());
    cga.shape = cga.shape.at(far);
    let entity = shown(&mut app, cga);
    let (low, high) = bounds(&positions(&app, entity));
    assert!(low.distance(Vec3::ZERO) < 1e-3 && high.distance(Vec3::new(20.0, 6.0, 10.0)) < 1e-3, "{low} {high}");
    let root = app.world().get::<CgaModel>(entity).expect("a model").root;
    let corner = |app: &bevy_app::App, leaf: &CgaLeaf| {
        let root = app.world().get::<Transform>(leaf.root).expect("a place");
        root.transform_point(leaf.transform.translation)
    };
    let leaf = log(&app).leaves.last().expect("an event").clone();
    assert_eq!(leaf.root, root);
    assert!(corner(&app, &leaf).distance(Vec3::new(17.0, 0.0, 4.0)) < 1e-3);

    app.insert_resource(CgaOrigin(cga::glam::DVec3::from_array(far) - cga::glam::DVec3::X));
    app.update();
    assert_eq!(bounds(&positions(&app, entity)).0.x, low.x + 1.0);
    assert_eq!(log(&app).generated.len(), 2, "no run is needed");
    assert!(bounds(&positions(&app, near)).0.x < -3e6);
}

#[test]
fn the_own_transform_of_the_entity_is_kept() {
    let mut app = app();
    let entity = app.world_mut().spawn((yard(), Transform::from_xyz(100.0, 2.0, 3.0))).id();
    settle(&mut app);
    assert_eq!(bounds(&positions(&app, entity)), (Vec3::new(100.0, 2.0, 3.0), Vec3::new(120.0, 8.0, 13.0)));
    assert_eq!(app.world().get::<Transform>(entity), Some(&Transform::from_xyz(100.0, 2.0, 3.0)));
}

#[test]
fn a_mesh_that_only_the_renderer_holds_has_no_triangles_for_colliders() {
    let mut app = app();
    let entity = shown(&mut app, yard().usages(RenderAssetUsages::RENDER_WORLD));
    let (.., mesh, _) = parts(&app, entity).swap_remove(0);
    let mut meshes = app.world_mut().resource_mut::<Assets<Mesh>>();
    let mut mesh = meshes.get_mut(&mesh.0).expect("a mesh");
    assert_eq!(mesh.asset_usage, RenderAssetUsages::RENDER_WORLD);
    assert!(collider_triangles(&mesh).is_some());
    // As the renderer takes it.
    let _ = mesh.take_gpu_data().expect("the lists");
    assert_eq!(collider_triangles(&mesh), None);
}

#[test]
fn two_apps_make_the_same_meshes() {
    let all = [0, 1].map(|_| {
        let mut app = app();
        let entities: Vec<Entity> = (0..20)
            .map(|seed| {
                let mut cga = yard();
                cga.shape = cga.shape.seed(seed);
                app.world_mut().spawn(cga).id()
            })
            .collect();
        settle(&mut app);
        let meshes = app.world().resource::<Assets<Mesh>>();
        let part = |entity| {
            let list = parts(&app, entity).into_iter();
            let each = list.map(|(child, part, mesh, place)| {
                let mesh = meshes.get(&mesh.0).expect("a mesh");
                let Some(VertexAttributeValues::Float32x3(points)) = mesh.attribute(Mesh::ATTRIBUTE_POSITION) else {
                    panic!("positions")
                };
                let name = app.world().get::<Name>(child).expect("a name").to_string();
                (name, format!("{:?}", part.material), points.clone(), place)
            });
            each.collect::<Vec<_>>()
        };
        entities.into_iter().map(part).collect::<Vec<_>>()
    });
    assert_eq!(all[0], all[1]);
    let names: Vec<&str> = all[0][0].iter().map(|(name, ..)| name.as_str()).collect();
    assert_eq!((names.len(), names[1], names[2]), (7, "#c08040", "#408040"));
}
