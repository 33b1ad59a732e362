//! Meshes, places and leaves in the types of Bevy.

use bevy_asset::RenderAssetUsages;
use bevy_math::{Mat3, Quat, Vec3};
use bevy_mesh::{Indices, Mesh, PrimitiveTopology};
use bevy_transform::components::Transform;
use cga::Scope;
use cga::glam::{DAffine3, DVec3};
use cga::sink::meshes::TriangleMesh;

use crate::channel::Channels;

/// A mesh with its channels of texture coordinates. Takes the lists out of `mesh`.
pub(crate) fn mesh(mesh: &mut TriangleMesh, channels: &mut Channels, usages: RenderAssetUsages) -> Mesh {
    let mut made = Mesh::new(PrimitiveTopology::TriangleList, usages);
    made.insert_attribute(Mesh::ATTRIBUTE_POSITION, std::mem::take(&mut mesh.positions));
    made.insert_attribute(Mesh::ATTRIBUTE_NORMAL, std::mem::take(&mut mesh.normals));
    if !mesh.tangents.is_empty() {
        made.insert_attribute(Mesh::ATTRIBUTE_TANGENT, std::mem::take(&mut mesh.tangents));
    }
    for (attribute, coordinates) in
        [Mesh::ATTRIBUTE_UV_0, Mesh::ATTRIBUTE_UV_1].into_iter().zip(channels.coordinates.drain(..))
    {
        made.insert_attribute(attribute, coordinates);
    }
    made.insert_indices(Indices::U32(std::mem::take(&mut mesh.indices)));
    made
}

/// The place of a mesh that is shown several times. It has neither shear nor mirroring.
pub(crate) fn place(place: &DAffine3) -> Transform {
    let (scale, rotation, translation) = place.to_scale_rotation_translation();
    Transform {
        translation: vector(translation),
        rotation: Quat::from_array(rotation.as_quat().to_array()),
        scale: vector(scale),
    }
}

/// The low corner and the axes of a scope, relative to `origin`.
pub(crate) fn corner(scope: &Scope, origin: DVec3) -> Transform {
    let axes = Mat3::from_cols_array(&scope.axes.as_mat3().to_cols_array());
    Transform {
        translation: vector(scope.origin - origin),
        rotation: Quat::from_mat3(&axes).normalize(),
        scale: Vec3::ONE,
    }
}

/// A vector in 32 bits.
pub(crate) fn vector(vector: DVec3) -> Vec3 {
    Vec3::from_array(vector.as_vec3().to_array())
}

/// The positions and the triangles of a mesh, for a collider: the arguments of `Collider::trimesh` of Rapier and Avian.
/// Positions are relative to the entity with the mesh. `None` if the mesh is not held in the main world, see
/// [`Cga::usages`](crate::Cga::usages).
///
/// ```
/// use bevy_cga::collider_triangles;
/// # use bevy_asset::{Assets, RenderAssetUsages};
/// # use bevy_ecs::prelude::*;
/// # use bevy_mesh::{Mesh, Mesh3d};
/// # #[derive(Component)]
/// # struct Collider;
/// # impl Collider {
/// #     fn trimesh(_: Vec<bevy_math::Vec3>, _: Vec<[u32; 3]>) -> Self { Collider }
/// # }
/// use bevy_cga::CgaMesh;
///
/// fn add_colliders(new: Query<(Entity, &Mesh3d), Added<CgaMesh>>, meshes: Res<Assets<Mesh>>, mut commands: Commands) {
///     for (entity, mesh) in &new {
///         if let Some((positions, triangles)) = meshes.get(&mesh.0).and_then(collider_triangles) {
///             commands.entity(entity).insert(Collider::trimesh(positions, triangles));
///         }
///     }
/// }
/// # let mut world = World::new();
/// # world.insert_resource(Assets::<Mesh>::default());
/// # world.register_system(add_colliders);
/// ```
pub fn collider_triangles(mesh: &Mesh) -> Option<(Vec<Vec3>, Vec<[u32; 3]>)> {
    let positions = mesh.try_attribute_option(Mesh::ATTRIBUTE_POSITION).ok()??.as_float3()?;
    let positions = positions.iter().map(|&position| Vec3::from_array(position)).collect();
    let Indices::U32(indices) = mesh.try_indices_option().ok()?? else { return None };
    Some((positions, indices.as_chunks().0.to_vec()))
}
