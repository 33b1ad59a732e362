//! Light, camera, ground and buildings.

use bevy::camera::Hdr;
use bevy::camera_controller::free_camera::FreeCamera;
use bevy::light::{CascadeShadowConfigBuilder, DirectionalLightShadowMap};
use bevy::pbr::{DistanceFog, FogFalloff};
use bevy::prelude::*;
use bevy_cga::{Cga, CgaLotOf, CgaScene};
use cga::Shape;
use cga::sink::meshes::Granularity;

use crate::lots::{self, Outline};
use crate::rules::{self, Ground, House};

const SKY: Color = Color::srgb(0.78, 0.91, 1.0);

/// A building that can be picked, with its number.
#[derive(Component)]
pub(crate) struct Building(pub(crate) usize);

/// The sun, with shadows, and the light of the sky.
pub(crate) fn light(mut commands: Commands) {
    commands.insert_resource(ClearColor(SKY));
    commands.insert_resource(GlobalAmbientLight {
        color: Color::srgb(0.78, 0.87, 1.0),
        brightness: 650.0,
        ..GlobalAmbientLight::default()
    });
    commands.insert_resource(DirectionalLightShadowMap { size: 4096 });
    commands.spawn((
        DirectionalLight {
            color: Color::srgb(1.0, 0.94, 0.82),
            illuminance: 9_500.0,
            shadow_maps_enabled: true,
            ..DirectionalLight::default()
        },
        CascadeShadowConfigBuilder {
            num_cascades: 3,
            first_cascade_far_bound: 120.0,
            maximum_distance: 620.0,
            ..CascadeShadowConfigBuilder::default()
        }
        .build(),
        Transform::from_xyz(-0.9, 0.85, 0.25).looking_at(Vec3::ZERO, Vec3::Y),
    ));
}

/// A camera that flies with W, A, S, D, E, Q, and turns while the right button is held.
pub(crate) fn camera(mut commands: Commands) {
    commands.spawn((
        Camera3d::default(),
        // With it, the sky is tone mapped as the fog is.
        Hdr,
        IsDefaultUiCamera,
        // In the middle of a street, at eye level.
        Transform::from_xyz(21.9, 2.6, 57.0).looking_at(Vec3::new(19.5, 6.2, 0.0), Vec3::Y),
        Projection::from(PerspectiveProjection { fov: 1.0, ..PerspectiveProjection::default() }),
        FreeCamera { walk_speed: 40.0, run_speed: 150.0, ..FreeCamera::default() },
        DistanceFog { color: SKY, falloff: FogFalloff::Linear { start: 300.0, end: 1000.0 }, ..DistanceFog::default() },
    ));
}

pub(crate) fn district(mut commands: Commands) -> Result {
    let district = lots::district();
    let ground = |outline: &Outline, height: f64, start: &str| -> Result<Cga> {
        let shape = Shape::footprint(&outline.outer, &outline.holes)?.at([0.0, height, 0.0]).start(start);
        Ok(Cga::new(Ground::default(), shape).settings(rules::settings()).granularity(Granularity::Rule))
    };
    let seeded = |mut cga: Cga, number: usize| {
        cga.shape = cga.shape.seed(number as u64);
        cga
    };
    commands.spawn(ground(&district.meadow, -0.2, "Meadow")?);
    commands.spawn(ground(&district.asphalt, 0.0, "Asphalt")?);
    for (number, sidewalk) in district.sidewalks.iter().enumerate() {
        commands.spawn(seeded(ground(sidewalk, 0.0, "Sidewalk")?, number));
    }
    for (number, garden) in district.gardens.iter().enumerate() {
        commands.spawn(seeded(ground(garden, 0.17, "Garden")?, number));
    }
    // Houses ask about the houses and the streets around them.
    let scene = commands.spawn(CgaScene::default()).id();
    for (number, street) in district.streets.iter().enumerate() {
        commands.spawn((seeded(ground(street, 0.0, "Street")?, number), CgaLotOf(scene)));
    }
    for (number, house) in district.houses.iter().enumerate() {
        let shape = Shape::footprint(&house.outer, &house.holes)?.at([0.0, 0.15, 0.0]).seed(number as u64);
        let house = Cga::new(House::default(), shape).settings(rules::settings()).granularity(Granularity::Rule);
        commands.spawn((house.watertight(), Building(number), CgaLotOf(scene)));
    }
    Ok(())
}
