//! The picked building: chosen by a click, marked by a pin.

use bevy::picking::mesh_picking::ray_cast::{MeshRayCast, MeshRayCastSettings};
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_cga::{CgaMesh, CgaModel};

use crate::scene::Building;

/// The picked building.
#[derive(Resource, Default)]
pub(crate) struct Picked {
    pub(crate) building: Option<Entity>,
    /// The rule of the leaf that was hit.
    pub(crate) rule: Option<String>,
}

/// The pin above the picked building.
#[derive(Component)]
pub(crate) struct Pin;

/// Picks the building below the cursor after a click.
#[expect(clippy::too_many_arguments, reason = "each parameter of a system is one access to the world")]
pub(crate) fn pick(
    buttons: Res<ButtonInput<MouseButton>>,
    window: Single<&Window, With<PrimaryWindow>>,
    camera: Single<(&Camera, &GlobalTransform)>,
    mut rays: MeshRayCast,
    meshes: Query<&CgaMesh>,
    parents: Query<&ChildOf>,
    buildings: Query<&CgaModel, With<Building>>,
    mut picked: ResMut<Picked>,
) {
    if !buttons.just_pressed(MouseButton::Left) {
        return;
    }
    let (camera, place) = *camera;
    let ray = window.cursor_position().and_then(|at| camera.viewport_to_world(place, at).ok());
    let Some(ray) = ray else { return };
    let is_mesh = |entity| meshes.contains(entity);
    let settings = MeshRayCastSettings::default().with_filter(&is_mesh);
    let Some((entity, hit)) = rays.cast_ray(ray, &settings).first() else { return };
    *picked = Picked::default();
    let Some(building) = parents.iter_ancestors(*entity).find(|&ancestor| buildings.contains(ancestor)) else { return };
    picked.building = Some(building);
    let leaf = meshes.get(*entity).ok().and_then(|mesh| mesh.leaf_of_triangle(hit.triangle_index?));
    let model = buildings.get(building).ok().map(|shown| &shown.model);
    picked.rule = leaf.and_then(|leaf| Some(model?.leaves().nth(leaf)?.rule().to_owned()));
}

/// Adds the pin, hidden.
pub(crate) fn add_pin(
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
    mut commands: Commands,
) {
    commands.spawn((
        Pin,
        Mesh3d(meshes.add(Cone::new(2.2, 6.0))),
        MeshMaterial3d(materials.add(StandardMaterial {
            base_color: Color::srgb(0.95, 0.35, 0.12),
            emissive: LinearRgba::rgb(0.5, 0.1, 0.02),
            ..StandardMaterial::default()
        })),
        Visibility::Hidden,
    ));
}

/// Puts the pin above the picked building, after a click or a new model of the building: bounds go through all leaves.
pub(crate) fn mark(
    picked: Res<Picked>,
    models: Query<Ref<CgaModel>>,
    pin: Single<(&mut Transform, &mut Visibility), With<Pin>>,
) {
    let (mut place, mut visibility) = pin.into_inner();
    let Some(shown) = picked.building.and_then(|building| models.get(building).ok()) else {
        visibility.set_if_neq(Visibility::Hidden);
        return;
    };
    if !picked.is_changed() && !shown.is_changed() {
        return;
    }
    let bounds = shown.model.bounds();
    let middle = ((bounds.low + bounds.high) * 0.5).as_vec3();
    let above = Vec3::new(middle.x, bounds.high.y as f32 + 5.0, middle.z);
    *place = Transform::from_translation(above).with_rotation(Quat::from_rotation_x(std::f32::consts::PI));
    *visibility = Visibility::Inherited;
}
