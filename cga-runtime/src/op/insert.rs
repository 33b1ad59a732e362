//! `i(file, …)`, and how inserted geometry meets a scope.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::primitive::fill_plainly;
use super::settle;
use crate::asset::{AssetError, CUBES};
use crate::env::Env;
use crate::fault::FaultKind;
use crate::mesh::Mesh;
use crate::shape::{Geometry, Inserted, Placed, ShapeRef};
use crate::text::Text;
use crate::unit::UnitMesh;

/// Which axis of an asset, or of an aligned scope, is its height.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpAxis {
    /// y.
    YUp,
    /// z. An asset is turned by -90 degrees about x.
    ZUp,
}

/// How an asset meets the scope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InsertMode {
    /// Fitted to the scope.
    AlignSizeAndPosition,
    /// As large as in its file and where it is there, from the origin of the scope: as with a scope of no size.
    KeepSizeAndPosition,
    /// As large as in its file, in the middle of the scope's xz plane and on its floor.
    KeepSizeAlignPosition,
}

/// What is cleaned up in an asset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CleanupMode {
    /// What the importer does to every asset: equal points become one, and corners that repeat the one before them go.
    NumericalCleanup,
    /// The same: edges and angles are never so small that cutting needs them gone, so nothing else is removed anyway.
    NoCleanup,
}

/// `i(file)`: replaces the geometry by an asset, fitted to the scope (*i operation*). A missing asset leaves a fault and
/// a box in its place.
pub fn insert(env: &mut Env, shape: &mut ShapeRef<'_>, file: Text) {
    insert_with(env, shape, file, UpAxis::YUp, InsertMode::AlignSizeAndPosition, CleanupMode::NumericalCleanup);
}

/// `i(file, yUp | zUp, insertMode, cleanupMode)` (*i operation*). Both modes of cleaning up give the same geometry; see
/// [`CleanupMode`].
pub fn insert_with(env: &mut Env, shape: &mut ShapeRef<'_>, file: Text, up: UpAxis, mode: InsertMode, _: CleanupMode) {
    // Old rule files are full of it.
    if CUBES.contains(&file.as_str()) {
        return insert_box(env, shape, mode);
    }
    let assets = Arc::clone(&env.settings.assets);
    let found = assets.mesh(&file).and_then(|mesh| match mesh.is_empty() {
        true => Err(AssetError::Broken("it has no faces".to_owned())),
        false => Ok(mesh),
    });
    match found {
        Ok(mesh) if up == UpAxis::YUp => place(env, shape, mesh, mode),
        Ok(mesh) => {
            if let Some(mesh) = env.raised(mesh) {
                place(env, shape, mesh, mode);
            }
        }
        Err(why) => {
            env.fault(FaultKind::Asset, format!("`{file}` cannot be inserted: {why}; a box stands in its place"));
            insert_box(env, shape, mode);
        }
    }
}

/// The mesh with its z axis up and its y axis to the back.
pub(crate) fn z_up(mesh: &Mesh) -> Mesh {
    mesh.map(&glam::DAffine3 { matrix3: DMat3::from_cols(DVec3::X, DVec3::NEG_Z, DVec3::Y), translation: DVec3::ZERO })
}

fn insert_box(env: &mut Env, shape: &mut ShapeRef<'_>, mode: InsertMode) {
    arrange(env, shape, DVec3::ZERO, DVec3::ONE, mode);
    fill_plainly(env, shape, Geometry::Box(UnitMesh::cube()));
}

fn place(env: &mut Env, shape: &mut ShapeRef<'_>, mesh: Arc<Mesh>, mode: InsertMode) {
    let (low, size) = (mesh.bounds().low, mesh.bounds().size());
    arrange(env, shape, low, size, mode);
    shape.geometry = Geometry::Mesh(Arc::new(Placed { low, size, mesh, inserted: Inserted::Asset, mirrored: false }));
    super::inserted(env, shape);
    super::trim(env, shape);
}

/// Sets the scope for geometry with that low corner and size.
fn arrange(env: &mut Env, shape: &mut ShapeRef<'_>, low: DVec3, size: DVec3, mode: InsertMode) {
    let before = shape.scope;
    match mode {
        InsertMode::AlignSizeAndPosition => fit(shape, low, size),
        InsertMode::KeepSizeAndPosition => {
            shape.scope.size = DVec3::ZERO;
            fit(shape, low, size);
        }
        InsertMode::KeepSizeAlignPosition => {
            let room = (shape.scope.size - size) * DVec3::new(0.5, 0.0, 0.5);
            shape.scope.origin += shape.scope.axes * room;
            shape.scope.size = size;
        }
    }
    settle(env, shape, &before, "`i`");
}

/// Sets the scope for geometry with that low corner and size (*i operation*, zero sizes):
/// with three sizes the geometry is fitted; the sizes that are zero follow from the others.
pub(crate) fn fit(shape: &mut ShapeRef<'_>, low: DVec3, size: DVec3) {
    let scope = &mut shape.scope;
    let zero: Vec3Mask = scope.size.cmpeq(DVec3::ZERO).into();
    // A flat asset has no scale along its flat axis.
    let scale = |axis: usize| if size[axis] == 0.0 { 0.0 } else { scope.size[axis] / size[axis] };
    match zero.iter().filter(|zero| **zero).count() {
        3 => {
            scope.size = size;
            scope.origin += scope.axes * low;
        }
        2 => {
            let kept = zero.iter().position(|zero| !zero).unwrap_or(0);
            let scale = scale(kept);
            let open = DVec3::from_array(zero.map(|zero| if zero { 1.0 } else { 0.0 }));
            scope.size += open * size * scale;
            scope.origin += scope.axes * (open * low * scale);
        }
        1 => {
            let flat = zero.iter().position(|zero| *zero).unwrap_or(0);
            let mean = (scale((flat + 1) % 3) + scale((flat + 2) % 3)) * 0.5;
            scope.size[flat] = mean * size[flat];
        }
        _ => {}
    }
}

type Vec3Mask = [bool; 3];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asset::Assets;
    use crate::mesh::primitive::cone;
    use crate::settings::Settings;
    use crate::shape::Shape;

    /// The asset of *i operation*, example 2: 2 by 4 by 6, away from the origin. Its tip shows which way is up.
    const LOW: DVec3 = DVec3::new(12.3, 4.3, 7.2);
    const SIZE: DVec3 = DVec3::new(2.0, 4.0, 6.0);

    fn env() -> Env {
        let unit = cone(4);
        let scale = SIZE / unit.bounds().size();
        let to = glam::DAffine3 { matrix3: DMat3::from_diagonal(scale), translation: LOW - unit.bounds().low * scale };
        let assets = Assets::new().with("asset.obj", unit.map(&to));
        let settings = Settings { assets: Arc::new(assets), ..Settings::default() };
        Env::new(&settings, &["Lot"], &Shape::rectangle(1.0, 1.0), "Lot")
    }

    fn inserted(size: [f64; 3], up: UpAxis, mode: InsertMode) -> Shape {
        let mut shape = Shape::cuboid(1.0, 1.0, 1.0).at([1.0, 2.0, 3.0]);
        shape.resize(DVec3::from_array(size));
        let env = &mut env();
        insert_with(env, &mut shape, "asset.obj".into(), up, mode, CleanupMode::NoCleanup);
        assert!(env.take_faults().0.is_empty());
        // What is there fills the scope.
        let bounds = shape.to_mesh().bounds();
        let (low, high) = (DVec3::ZERO.min(shape.scope.size), DVec3::ZERO.max(shape.scope.size));
        assert!((bounds.low - low).length() < 1e-12 && (bounds.high - high).length() < 1e-12);
        shape
    }

    #[track_caller]
    fn stands(shape: &Shape, origin: [f64; 3], size: [f64; 3]) {
        let near = |a: DVec3, b: [f64; 3]| (a - DVec3::from_array(b)).length() < 1e-12;
        assert!(near(shape.scope.origin - DVec3::new(1.0, 2.0, 3.0), origin), "{}", shape.scope.origin);
        assert!(near(shape.scope.size, size), "{}", shape.scope.size);
    }

    #[test]
    fn facts_64_to_66_sizes_of_zero_follow_from_the_asset() {
        use InsertMode::AlignSizeAndPosition as Align;
        stands(&inserted([9.0, 0.0, 0.0], UpAxis::YUp, Align), [0.0, 4.5 * 4.3, 4.5 * 7.2], [9.0, 18.0, 27.0]);
        stands(&inserted([9.0, 9.0, 0.0], UpAxis::YUp, Align), [0.0; 3], [9.0, 9.0, 20.25]);
        stands(&inserted([0.0; 3], UpAxis::YUp, Align), LOW.to_array(), SIZE.to_array());
        stands(&inserted([3.0, -1.0, 5.0], UpAxis::YUp, Align), [0.0; 3], [3.0, -1.0, 5.0]);
    }

    #[test]
    fn an_asset_may_keep_its_size_and_its_place() {
        let kept = inserted([9.0, 8.0, 7.0], UpAxis::YUp, InsertMode::KeepSizeAndPosition);
        stands(&kept, LOW.to_array(), SIZE.to_array());
        let kept = inserted([9.0, 8.0, 7.0], UpAxis::YUp, InsertMode::KeepSizeAlignPosition);
        stands(&kept, [3.5, 0.0, 0.5], SIZE.to_array());
        // Larger than the scope, which has no size at all.
        let kept = inserted([0.0; 3], UpAxis::YUp, InsertMode::KeepSizeAlignPosition);
        stands(&kept, [-1.0, 0.0, -3.0], SIZE.to_array());
    }

    #[test]
    fn an_asset_with_z_up_is_stood_up() {
        let lying = inserted([0.0; 3], UpAxis::ZUp, InsertMode::AlignSizeAndPosition);
        // y of the file goes to the back, z up.
        stands(&lying, [12.3, 7.2, -4.3 - 4.0], [2.0, 6.0, 4.0]);
        let tip = |shape: &Shape| shape.to_mesh().points()[4];
        assert!((tip(&lying) - DVec3::new(1.0, 3.0, 0.0)).length() < 1e-12);
        assert!(lying.to_mesh().is_closed() && 0.0 < lying.to_mesh().volume());
        let fitted = inserted([9.0, 8.0, 7.0], UpAxis::ZUp, InsertMode::AlignSizeAndPosition);
        stands(&fitted, [0.0; 3], [9.0, 8.0, 7.0]);
        let kept = inserted([9.0, 8.0, 7.0], UpAxis::ZUp, InsertMode::KeepSizeAlignPosition);
        stands(&kept, [3.5, 0.0, 1.5], [2.0, 6.0, 4.0]);
    }

    #[test]
    fn equal_assets_are_stood_up_once() {
        let env = &mut env();
        let mesh = |env: &mut Env| {
            let mut shape = Shape::cuboid(1.0, 1.0, 1.0);
            let mode = InsertMode::AlignSizeAndPosition;
            insert_with(env, &mut shape, "asset.obj".into(), UpAxis::ZUp, mode, CleanupMode::NumericalCleanup);
            match &shape.geometry {
                Geometry::Mesh(placed) if placed.inserted == Inserted::Asset => Arc::clone(&placed.mesh),
                other => panic!("{other:?}"),
            }
        };
        assert!(Arc::ptr_eq(&mesh(env), &mesh(env)));
    }

    #[test]
    fn a_missing_asset_leaves_a_box_in_its_place() {
        for (mode, size) in [
            (InsertMode::AlignSizeAndPosition, [2.0, 3.0, 4.0]),
            (InsertMode::KeepSizeAndPosition, [1.0; 3]),
            (InsertMode::KeepSizeAlignPosition, [1.0; 3]),
        ] {
            let (env, shape) = (&mut env(), &mut Shape::cuboid(2.0, 3.0, 4.0));
            insert_with(env, shape, "none.obj".into(), UpAxis::ZUp, mode, CleanupMode::NoCleanup);
            assert!(matches!(shape.geometry, Geometry::Box(_)) && env.take_faults().0.len() == 1);
            assert_eq!(shape.scope.size.to_array(), size);
            insert_with(env, shape, "builtin:cube".into(), UpAxis::YUp, mode, CleanupMode::NoCleanup);
            assert!(env.take_faults().0.is_empty());
        }
    }
}
