//! Materials and textures, without a renderer.
#![cfg(feature = "pbr")]

mod common;

use bevy_app::App;
use bevy_asset::{AssetApp, AssetServer, Assets};
use bevy_camera::visibility::{InheritedVisibility, Visibility};
use bevy_cga::*;
use bevy_color::{Color, ColorToComponents, LinearRgba};
use bevy_ecs::prelude::*;
use bevy_image::Image;
use bevy_material::AlphaMode;
use bevy_mesh::{Mesh, UvChannel, VertexAttributeValues};
use bevy_pbr::{MeshMaterial3d, StandardMaterial};
use cga::sink::meshes::Granularity;
use cga::{Shape, cga};
use common::*;

cga! {
    /// Two walls with equal materials from different rules, and others with each property.
    @Allow(missing_asset)
    pub grammar Sampler;
    attr bricks = "/walls/bricks.png"
    Lot   --> split(x) {
        1 : color("#c08040") A. | 1 : color("#c08040") B. | 1 : color("#c08040") set(material.opacity, 0.25) Glass. |
        1 : set(material.doubleSided, false) set(material.metallic, 0.75) set(material.roughness, 0.5) Metal. |
        1 : setupProjection(0, scope.xz, 2, 4) texture(bricks) projectUV(0) Bricks. |
        1 : setupProjection(0, scope.xz, 2, 4) texture("leaf.png") set(material.opacitymap, "leaf.png")
            set(material.opacitymap.mode, "mask") set(material.opacitymap.cutoff, 0.25) projectUV(0) Leaf. |
        1 : setupProjection(0, scope.xz, 2, 4) set(material.normalmap, "bumps.png")
            set(material.colormap.su, 3) texture("/walls/bricks.png") projectUV(0) Bumps. |
        1 : set(material.emissive.r, 1) set(material.emissive.g, 0.5) Lamp.
    }
}

fn pbr_app() -> App {
    let mut app = app();
    app.init_asset::<StandardMaterial>().init_asset::<Image>();
    app
}

fn sampler() -> Cga {
    Cga::new(Sampler::default(), Shape::rectangle(8.0, 4.0)).granularity(Granularity::Rule)
}

/// The material of a rule.
fn material(app: &App, entity: Entity, rule: &str) -> (MeshMaterial3d<StandardMaterial>, StandardMaterial) {
    let list = parts(app, entity);
    let (child, ..) = list.iter().find(|(_, part, ..)| part.rule.as_deref() == Some(rule)).expect("a rule");
    let handle = app.world().get::<MeshMaterial3d<StandardMaterial>>(*child).expect("a material").clone();
    let material = app.world().resource::<Assets<StandardMaterial>>().get(&handle.0).expect("an asset").clone();
    (handle, material)
}

/// The texture coordinates of a rule.
fn coordinates(app: &App, entity: Entity, rule: &str, channel: u8) -> Vec<[f32; 2]> {
    let list = parts(app, entity);
    let (_, _, mesh, _) = list.iter().find(|(_, part, ..)| part.rule.as_deref() == Some(rule)).expect("a rule");
    let attribute = if channel == 0 { Mesh::ATTRIBUTE_UV_0 } else { Mesh::ATTRIBUTE_UV_1 };
    match app.world().resource::<Assets<Mesh>>().get(&mesh.0).expect("a mesh").attribute(attribute) {
        Some(VertexAttributeValues::Float32x2(list)) => list.clone(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn equal_materials_are_one_asset() {
    let mut app = pbr_app();
    let (one, two) = (shown(&mut app, sampler()), shown(&mut app, sampler()));
    assert_eq!(material(&app, one, "A").0.0, material(&app, one, "B").0.0);
    assert_eq!(material(&app, one, "A").0.0, material(&app, two, "A").0.0);
    assert_ne!(material(&app, one, "A").0.0, material(&app, one, "Glass").0.0);
    assert_eq!(app.world().resource::<Assets<StandardMaterial>>().len(), 7);
}

#[test]
fn materials_have_the_properties_that_rules_set() {
    let mut app = pbr_app();
    let entity = shown(&mut app, sampler());
    let of = |rule| material(&app, entity, rule).1;
    let plain = of("A");
    let [r, g, b] = [0xc0_u8, 0x80, 0x40].map(|byte| f32::from(byte) / 255.0);
    assert_eq!(plain.base_color, Color::srgba(r, g, b, 1.0));
    assert!((plain.base_color.to_linear().to_f32_array()[1] - 0.2158605).abs() < 1e-5, "sRGB");
    assert_eq!((plain.alpha_mode, plain.metallic, plain.perceptual_roughness), (AlphaMode::Opaque, 0.0, 1.0));
    assert!(plain.double_sided && plain.cull_mode.is_none() && plain.base_color_texture.is_none());

    let glass = of("Glass");
    assert_eq!((glass.base_color, glass.alpha_mode), (Color::srgba(r, g, b, 0.25), AlphaMode::Blend));
    let metal = of("Metal");
    assert_eq!((metal.metallic, metal.perceptual_roughness), (0.75, 0.5));
    assert!(!metal.double_sided && metal.cull_mode.is_some());
    assert_eq!(of("Lamp").emissive, LinearRgba::from(Color::srgb(1.0, 0.5, 0.0)));
    assert_eq!(of("Leaf").alpha_mode, AlphaMode::Mask(0.25));
}

#[test]
fn images_are_assets_of_the_folder() {
    let mut app = pbr_app();
    let entity = shown(&mut app, sampler());
    let path = |image: &Option<bevy_asset::Handle<Image>>| {
        let server = app.world().resource::<AssetServer>();
        image.as_ref().and_then(|image| server.get_path(image.id())).map(|path| path.to_string())
    };
    let bricks = material(&app, entity, "Bricks").1;
    assert_eq!(path(&bricks.base_color_texture).as_deref(), Some("walls/bricks.png"));
    let leaf = material(&app, entity, "Leaf").1;
    assert_eq!(path(&leaf.base_color_texture).as_deref(), Some("leaf.png"));
    let bumps = material(&app, entity, "Bumps").1;
    assert_eq!(path(&bumps.normal_map_texture).as_deref(), Some("bumps.png"));
    assert_eq!(bumps.base_color_texture, bricks.base_color_texture, "one image");
}

#[test]
fn coordinates_are_those_of_bevy() {
    let mut app = pbr_app();
    let entity = shown(&mut app, sampler());
    // The image covers 2 by 4 metres from the corner of its rectangle, one metre wide and four deep. Seen from above, v
    // grows to the north; Bevy's grows downwards.
    let bricks = coordinates(&app, entity, "Bricks", 0);
    let list = parts(&app, entity);
    let (_, part, mesh, _) = list.iter().find(|(_, part, ..)| part.rule.as_deref() == Some("Bricks")).expect("a rule");
    let mesh = app.world().resource::<Assets<Mesh>>().get(&mesh.0).expect("a mesh");
    let Some(VertexAttributeValues::Float32x3(points)) = mesh.attribute(Mesh::ATTRIBUTE_POSITION) else { panic!() };
    let model = app.world().get::<CgaModel>(entity).expect("a model").model.clone();
    let meshes = model.meshes(Granularity::Rule);
    let ours = meshes.list.iter().find(|mesh| mesh.rule.as_deref() == Some("Bricks")).expect("a mesh");
    assert_eq!(points, &ours.positions);
    for (bevy, [u, v]) in bricks.iter().zip(&ours.uvs[0]) {
        assert_eq!(bevy, &[*u, 1.0 - v]);
    }
    let span = |part: usize| {
        let parts = bricks.iter().map(|at| at[part]);
        parts.clone().fold(f32::MIN, f32::max) - parts.fold(f32::MAX, f32::min)
    };
    assert_eq!((span(0), span(1)), (0.5, 1.0));
    assert_eq!(part.channel(cga::Layer::Color), Some(0));

    // A second placement of the same set is a second channel; the placement is part of the coordinates.
    let bumps = material(&app, entity, "Bumps").1;
    assert_eq!((bumps.base_color_channel.clone(), bumps.normal_map_channel.clone()), (UvChannel::Uv0, UvChannel::Uv1));
    let (color, normal) = (coordinates(&app, entity, "Bumps", 0), coordinates(&app, entity, "Bumps", 1));
    assert!(color.iter().zip(&normal).all(|(color, normal)| color == &[3.0 * normal[0], normal[1]]));
    assert!(mesh.attribute(Mesh::ATTRIBUTE_TANGENT).is_none());
    let (_, _, mesh, _) = list.iter().find(|(_, part, ..)| part.rule.as_deref() == Some("Bumps")).expect("a rule");
    let mesh = app.world().resource::<Assets<Mesh>>().get(&mesh.0).expect("a mesh");
    assert!(mesh.attribute(Mesh::ATTRIBUTE_TANGENT).is_some());
}

#[test]
fn materials_without_meshes_disappear() {
    let mut app = pbr_app();
    let entity = shown(&mut app, yard());
    let count = |app: &mut App| {
        app.update();
        app.world().resource::<Assets<StandardMaterial>>().len()
    };
    let before = count(&mut app);
    for step in 0..200 {
        let color = format!("#{step:02x}8040");
        change(&mut app, entity, |cga| cga.grammar.set("wall", color.as_str().into()).expect("a colour"));
    }
    assert_eq!(count(&mut app), before);
    app.world_mut().despawn(entity);
    assert_eq!(count(&mut app), 0);
}

#[test]
fn children_inherit_visibility() {
    let mut app = pbr_app();
    let entity = shown(&mut app, yard());
    let root = app.world().get::<CgaModel>(entity).expect("a model").root;
    for entity in [entity, root] {
        assert_eq!(app.world().get::<Visibility>(entity), Some(&Visibility::Inherited));
        assert!(app.world().get::<InheritedVisibility>(entity).is_some());
    }
}

#[test]
fn names_that_are_no_files_are_left_out() {
    let mut app = pbr_app();
    for name in ["builtin:uvtest.png", "tree.glb#image0", "../outside.png", "a://b#c", "/", "#"] {
        let mut cga = sampler();
        cga.grammar.set("bricks", name.into()).expect("a name");
        let entity = shown(&mut app, cga);
        let image = material(&app, entity, "Bricks").1.base_color_texture;
        let is_left_out = name.starts_with("builtin:") || name.contains('#');
        assert_eq!(image.is_none(), is_left_out, "{name}");
    }
    assert!(log(&app).failed.is_empty());
}

#[test]
fn without_plugins_for_materials_meshes_have_none() {
    let mut app = app();
    let entity = shown(&mut app, yard());
    let list = parts(&app, entity);
    assert!(!list.is_empty());
    assert!(list.iter().all(|(child, ..)| app.world().get::<MeshMaterial3d<StandardMaterial>>(*child).is_none()));
}
