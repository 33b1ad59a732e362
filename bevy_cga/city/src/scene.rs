//! Light, camera, ground and buildings.

use std::sync::Arc;

use bevy::camera::Hdr;
use bevy::camera_controller::free_camera::FreeCamera;
use bevy::light::{CascadeShadowConfigBuilder, DirectionalLightShadowMap};
use bevy::pbr::{DistanceFog, FogFalloff};
use bevy::prelude::*;
use bevy_cga::{Cga, CgaLotOf, CgaScene};
use cga::{Assets, Shape};

use crate::district::House;
use crate::lots::{self, Outline};
use crate::rules::{self, Ground};

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
        Transform::from_xyz(-128.0, 78.0, 172.0).looking_at(Vec3::new(2.0, 0.0, 22.0), Vec3::Y),
        FreeCamera { walk_speed: 40.0, run_speed: 150.0, ..FreeCamera::default() },
        DistanceFog { color: SKY, falloff: FogFalloff::Linear { start: 300.0, end: 1000.0 }, ..DistanceFog::default() },
    ));
}

pub(crate) fn district(mut commands: Commands) -> Result {
    let assets = Arc::new(Assets::new().with("crown", rules::crown()?));
    let district = lots::district();
    let ground = |outline: &Outline, height: f64, start: &str| -> Result<Cga> {
        let shape = Shape::footprint(&outline.outer, &outline.holes)?.at([0.0, height, 0.0]);
        Ok(Cga::new(Ground::default(), shape).settings(rules::settings(&assets, start)))
    };
    commands.spawn(ground(&district.meadow, -0.2, "Meadow")?);
    commands.spawn(ground(&district.asphalt, 0.0, "Asphalt")?);
    for sidewalk in &district.sidewalks {
        commands.spawn(ground(sidewalk, 0.0, "Sidewalk")?);
    }
    for (number, garden) in district.gardens.iter().enumerate() {
        let mut garden = ground(garden, 0.17, "Garden")?;
        garden.shape = garden.shape.seed(number as u64);
        commands.spawn(garden);
    }
    // Houses ask about the houses and the streets around them.
    let scene = commands.spawn(CgaScene::default()).id();
    for street in &district.streets {
        commands.spawn((ground(street, 0.0, "Street")?, CgaLotOf(scene)));
    }
    for (number, house) in district.houses.iter().enumerate() {
        let shape = Shape::footprint(&house.outer, &house.holes)?.at([0.0, 0.15, 0.0]).seed(number as u64);
        let house = House { neighbours: true, ..House::default() };
        commands.spawn((Cga::new(house, shape), Building(number), CgaLotOf(scene)));
    }
    Ok(())
}
