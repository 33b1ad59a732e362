//! `i(file, …)`, and the fit of inserted geometry to a scope.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::asset::{AssetError, CUBES, File, MISSING};
use crate::geometry::Axis;
use crate::geometry::cleanup::without_short_edges;
use crate::geometry::mesh::{Mesh, Variant};
use crate::material::layer;
use crate::material::{Layer, Material};
use crate::op::create::insert_fit::{centre, face_outwards, fit, put};
use crate::op::create::primitive::fill_with_cube;
use crate::op::settle;
use crate::run::env::Env;
use crate::shape::filled_scope::Cuboid;
use crate::shape::{Geometry, Placed, Shape};

/// The up axis of an asset or of an aligned scope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpAxis {
    /// y.
    YUp,
    /// z. An asset is turned by -90 degrees about x.
    ZUp,
}

/// The fit of an asset to the scope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InsertMode {
    /// The asset is fitted to the scope.
    AlignSizeAndPosition,
    /// The size and position from the file, relative to the origin of the scope, as in a scope without sizes.
    KeepSizeAndPosition,
    /// The size from the file, in the middle of the scope's xz plane and on its floor.
    KeepSizeAlignPosition,
}

/// The clean-up of an asset. On import equal points become one and repeated corners go in any case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CleanupMode {
    /// Very short edges go: the ends of an edge below 1 mm in the file become one. Panes and wires that thin stay as they are.
    NumericalCleanup,
    /// Nothing else changes.
    NoCleanup,
}

/// The length of the shortest edge that *numericalCleanup* leaves, in metres of the file. *i operation* gives no number; published
/// results have edges of 1.02 mm and none of 0.67 mm. Small angles stay, as cuts handle them.
const SHORT_EDGE: f64 = 0.001;

/// `i(file)`: replaces the geometry by an asset, fitted to the scope (*i operation*). For a missing asset it leaves a
/// fault and a small box at its place.
pub fn insert(env: &mut Env, shape: &mut Shape, file: File) {
    insert_with(env, shape, file, UpAxis::YUp, InsertMode::AlignSizeAndPosition, CleanupMode::NumericalCleanup);
}

/// `i(file, yUp | zUp, insertMode, cleanupMode)` (*i operation*).
pub fn insert_with(env: &mut Env, shape: &mut Shape, file: File, up: UpAxis, mode: InsertMode, cleanup: CleanupMode) {
    // Old rule files often insert it.
    if CUBES.contains(&file.name.as_str()) {
        let is_textured = !file.name.as_str().ends_with(":notex");
        return insert_box(env, shape, mode, is_textured);
    }
    let found = asset(env, &file);
    if let Ok(mesh) = &found
        && env.settings.assets.has_folder()
    {
        check_images(env, mesh);
    }
    match found {
        Ok(mesh) => {
            let mesh = match cleanup {
                CleanupMode::NumericalCleanup => {
                    mesh.variant(Variant::Cleaned, |mesh| without_short_edges(mesh, SHORT_EDGE))
                }
                CleanupMode::NoCleanup => mesh,
            };
            let mesh = match up {
                UpAxis::YUp => mesh,
                UpAxis::ZUp => mesh.variant(Variant::Raised, |mesh| Some(mesh.raised())),
            };
            place(env, shape, mesh, mode);
        }
        Err(_) if file.name.is_empty() => {
            env.asset_fault("`i` has no file: its name is empty; a small box marks the place".to_owned());
            mark(env, shape, mode);
        }
        Err(why) => {
            env.asset_fault(format!("`{file}` cannot be inserted: {why}; a small box marks the place"));
            mark(env, shape, mode);
        }
    }
}

/// The mesh of a file, with faces.
pub(in crate::op) fn asset(env: &Env, file: &File) -> Result<Arc<Mesh>, AssetError> {
    env.settings.assets.mesh_of(file).and_then(|mesh| match mesh.is_empty() {
        true => Err(AssetError::Broken("it has no faces".to_owned())),
        false => Ok(mesh),
    })
}

/// Leaves a fault for each image of a mesh that is missing or broken.
fn check_images(env: &mut Env, mesh: &Mesh) {
    for material in mesh.materials::<Material>() {
        for layer in Layer::ALL {
            if let Some(name) = layer::image(material, layer) {
                crate::op::image(env, layer, name.clone());
            }
        }
    }
}

fn insert_box(env: &mut Env, shape: &mut Shape, mode: InsertMode, is_textured: bool) {
    arrange(env, shape, DVec3::ZERO, DVec3::ONE, mode);
    fill_with_cube(env, shape, is_textured);
}

/// The edges of the marker of a missing asset: in metres, and at least as a share of the scope, as rounding would
/// lose 0.1 m on a very large scope.
const MARKER: (f64, f64) = (0.1, 1e-6);

/// Marks the place of a missing asset by a box of 0.1 m, or less along an axis where the scope is smaller, in the middle of
/// the scope's xz plane and on its floor. A box as large as the scope would hide other geometry; pictures show it
/// translucent, and know the mark by its group. The scope gets the size of an asset of 1 m, as rules expect. The box is not
/// trimmed, so it is visible.
fn mark(env: &mut Env, shape: &mut Shape, mode: InsertMode) {
    arrange(env, shape, DVec3::ZERO, DVec3::ONE, mode);
    let size = shape.scope.size.abs();
    let edges = (size * MARKER.1).max(DVec3::splat(MARKER.0)).min(size);
    // As shares of the scope: a mesh of a very small size cannot be stretched much.
    let share = DVec3::select(size.cmpgt(DVec3::ZERO), edges / size, DVec3::ONE);
    let origin = (DVec3::ONE - share) * DVec3::new(0.5, 0.0, 0.5);
    let mesh = Cuboid::new(origin, DMat3::from_diagonal(share)).to_mesh();
    let mesh = mesh.in_group(MISSING);
    if env.count_vertices(&mesh).is_continue() {
        let placed = Placed { low: DVec3::ZERO, size: DVec3::ONE, ..Placed::fitted(mesh) };
        shape.geometry = Geometry::Mesh(Arc::new(placed));
        // A size of zero flattens it.
        shape.resize(shape.scope.size);
        face_outwards(shape);
    }
}

fn place(env: &mut Env, shape: &mut Shape, mesh: Arc<Mesh>, mode: InsertMode) {
    arrange(env, shape, mesh.bounds().low, mesh.bounds().size(), mode);
    put(env, shape, mesh);
}

/// Sets the scope for geometry with that low corner and size.
fn arrange(env: &mut Env, shape: &mut Shape, low: DVec3, size: DVec3, mode: InsertMode) {
    let before = shape.scope;
    match mode {
        InsertMode::AlignSizeAndPosition => fit(shape, low, size),
        InsertMode::KeepSizeAndPosition => {
            shape.scope.size = DVec3::ZERO;
            fit(shape, low, size);
        }
        InsertMode::KeepSizeAlignPosition => {
            centre(shape, size, Axis::Y);
        }
    }
    settle(env, shape, &before, "`i`");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asset::Assets;
    use crate::geometry::extrude::{Extrude, extrude};
    use crate::geometry::primitive::cone;
    use crate::run::settings::Settings;
    use crate::shape::Inserted;
    use crate::shape::Shape;

    /// The asset of *i operation*, example 2: 2 by 4 by 6, away from the origin. Its tip is on top.
    const LOW: DVec3 = DVec3::new(12.3, 4.3, 7.2);
    const SIZE: DVec3 = DVec3::new(2.0, 4.0, 6.0);

    fn env() -> Env {
        let unit = cone(4);
        let scale = SIZE / unit.bounds().size();
        let to = glam::DAffine3 { matrix3: DMat3::from_diagonal(scale), translation: LOW - unit.bounds().low * scale };
        let assets = Assets::new().with("asset.obj", unit.map(&to));
        let settings = Settings { assets: Arc::new(assets), ..Settings::default() };
        Env::with_names(&settings, &["Lot"], &Shape::rectangle(1.0, 1.0), "Lot")
    }

    fn inserted(size: [f64; 3], up: UpAxis, mode: InsertMode) -> Shape {
        let mut shape = Shape::cuboid(1.0, 1.0, 1.0).at([1.0, 2.0, 3.0]);
        shape.resize(DVec3::from_array(size));
        let env = &mut env();
        insert_with(env, &mut shape, "asset.obj".into(), up, mode, CleanupMode::NoCleanup);
        assert!(env.take_faults().0.is_empty());
        // The geometry fills the scope.
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
    fn sizes_of_zero_follow_from_the_asset() {
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
        // Larger than the scope, which has no size.
        let kept = inserted([0.0; 3], UpAxis::YUp, InsertMode::KeepSizeAlignPosition);
        stands(&kept, [-1.0, 0.0, -3.0], SIZE.to_array());
    }

    #[test]
    fn an_asset_with_z_up_is_stood_up() {
        let lying = inserted([0.0; 3], UpAxis::ZUp, InsertMode::AlignSizeAndPosition);
        // y of the file becomes the direction to the back, z up.
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

    /// A prism over an octagon with sides of these lengths on one side, cut off at the corners of a square.
    fn chamfered(short: f64) -> Mesh {
        let cut = short / std::f64::consts::SQRT_2;
        let corners = [
            (cut, 0.0),
            (1.0 - cut, 0.0),
            (1.0, cut),
            (1.0, 1.0 - cut),
            (1.0 - cut, 1.0),
            (cut, 1.0),
            (0.0, 1.0 - cut),
            (0.0, cut),
        ];
        let outline = corners.map(|(x, z)| DVec3::new(x, 0.0, -z));
        extrude(&Mesh::from_polygon(&outline, &[]).expect("a polygon"), Extrude::FaceNormal, 1.0)
    }

    #[test]
    fn edges_below_a_millimetre_of_the_file_go() {
        for (short, mode, faces) in [
            (0.000_67, CleanupMode::NumericalCleanup, 6),
            (0.001_02, CleanupMode::NumericalCleanup, 10),
            (0.000_67, CleanupMode::NoCleanup, 10),
        ] {
            let assets = Assets::new().with("a.obj", chamfered(short));
            let env = &mut Env::with_names(
                &Settings { assets: Arc::new(assets), ..Settings::default() },
                &["Lot"],
                &Shape::rectangle(1.0, 1.0),
                "Lot",
            );
            // The scope stretches the asset afterwards.
            for size in [0.01, 1.0, 500.0] {
                for up in [UpAxis::YUp, UpAxis::ZUp] {
                    let shape = &mut Shape::cuboid(size, size, size);
                    insert_with(env, shape, "a.obj".into(), up, InsertMode::AlignSizeAndPosition, mode);
                    let mesh = shape.to_mesh();
                    assert_eq!((mesh.face_count(), mesh.is_closed(), mesh.check()), (faces, true, vec![]));
                    assert!((mesh.volume() / size.powi(3) - 1.0).abs() < 3e-3);
                }
            }
        }
    }

    #[test]
    fn a_missing_asset_leaves_a_small_box_in_its_place() {
        use InsertMode::{
            AlignSizeAndPosition as Align, KeepSizeAlignPosition as KeepSize, KeepSizeAndPosition as Keep,
        };
        // Scope, mode; lowest corner and size of the new scope; lowest corner and size of the box in it.
        for (scope, mode, [at, size], [low, edges]) in [
            ([2.0, 3.0, 4.0], Align, [[0.0; 3], [2.0, 3.0, 4.0]], [[0.95, 0.0, 1.95], [0.1; 3]]),
            ([2.0, -3.0, 0.05], Align, [[0.0; 3], [2.0, -3.0, 0.05]], [[0.95, -0.1, 0.0], [0.1, 0.1, 0.05]]),
            ([0.0, 5.0, 1.0], Align, [[0.0; 3], [3.0, 5.0, 1.0]], [[1.45, 0.0, 0.45], [0.1; 3]]),
            ([0.0; 3], Align, [[0.0; 3], [1.0; 3]], [[0.45, 0.0, 0.45], [0.1; 3]]),
            ([2.0, 3.0, 4.0], Keep, [[0.0; 3], [1.0; 3]], [[0.45, 0.0, 0.45], [0.1; 3]]),
            ([2.0, 3.0, 4.0], KeepSize, [[0.5, 0.0, 1.5], [1.0; 3]], [[0.45, 0.0, 0.45], [0.1; 3]]),
            ([2e8, 1.0, 1.0], Align, [[0.0; 3], [2e8, 1.0, 1.0]], [[1e8 - 100.0, 0.0, 0.45], [200.0, 0.1, 0.1]]),
        ] {
            let env = &mut env();
            let mut shape = Shape::cuboid(1.0, 1.0, 1.0).at([1.0, 2.0, 3.0]);
            shape.resize(DVec3::from_array(scope));
            insert_with(env, &mut shape, "none.obj".into(), UpAxis::ZUp, mode, CleanupMode::NoCleanup);
            assert_eq!(env.take_faults().0.len(), 1);
            stands(&shape, at, size);
            let (mesh, near) = (shape.to_mesh(), |a: DVec3, b: [f64; 3]| (a - DVec3::from_array(b)).length() < 1e-6);
            let bounds = mesh.bounds();
            assert!(mesh.is_closed() && near(bounds.low, low) && near(bounds.size(), edges), "{bounds:?}");
            insert_with(env, &mut shape, "builtin:cube".into(), UpAxis::YUp, mode, CleanupMode::NoCleanup);
            let is_box = matches!(shape.geometry, Geometry::Box(_));
            assert!(is_box == scope.iter().all(|&size| 0.0 <= size) && env.take_faults().0.is_empty());
        }
    }

    #[test]
    fn a_missing_asset_is_one_fault_with_a_count() {
        let (env, shape) = (&mut env(), &mut Shape::cuboid(2.0, 3.0, 4.0));
        for _ in 0..12 {
            insert(env, shape, "none.obj".into());
            insert(env, shape, "other.obj".into());
        }
        let (faults, left_out) = env.take_faults();
        assert_eq!((faults.iter().map(|fault| fault.count).collect::<Vec<_>>(), left_out), (vec![12, 12], 0));
        assert!(faults[0].to_string().ends_with("a small box marks the place (12 times)"), "{}", faults[0]);
        // Beyond the limit, faults are only counted.
        for number in 0..3000 {
            insert(env, shape, format!("{}.obj", number % 1500).as_str().into());
        }
        let (faults, left_out) = env.take_faults();
        assert_eq!((faults.len(), faults[0].count, left_out), (1000, 2, 1000));
    }
}
