//! *insert operation* and *insertAlongUV operation*: sizes and places of inserted assets.

use std::f64::consts::PI;

use cga::glam::DVec3;
use cga::{LeafView, Model};

use cga_tests::pages::assets::settings;
use cga_tests::pages::example::Example;
use cga_tests::pages::inserting::*;
use cga_tests::pages::meshes;

fn model(example: &Example) -> Model {
    let model = example.model(&settings());
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    model
}

fn points(leaf: &LeafView<'_>) -> Vec<DVec3> {
    let (mesh, placement) = leaf.mesh();
    mesh.points().iter().map(|point| placement.transform_point3(*point)).collect()
}

#[track_caller]
fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() < tolerance, "{found}, not {expected}");
}

#[test]
fn windows_fill_the_scopes_of_their_parts() {
    let [plain, inserted] = [&facade::EXAMPLE, &windows::EXAMPLE].map(model);
    // 5 floors with 7 windows on the long sides and 4 on the short ones.
    assert_eq!([plain.count("Window"), inserted.count("Window")], [5 * 2 * (7 + 4); 2]);
    for (part, window) in plain.leaves_of("Window").zip(inserted.leaves_of("Window")) {
        let (flat, deep) = (part.scope(), window.scope());
        near(flat.origin.distance(deep.origin), 0.0, 1e-9);
        near(deep.size.x, flat.size.x, 1e-9);
        near(deep.size.y, flat.size.y, 1e-9);
        // The depth of 0.2 m is scaled by the mean of width and height.
        near(deep.size.z, 0.1 * (deep.size.x / 1.2 + deep.size.y / 1.6), 1e-9);
        let into = points(&window).into_iter().map(|point| deep.frame().to_local(point));
        assert!(into.into_iter().all(|at| (at.cmpge(DVec3::splat(-1e-9)) & at.cmple(deep.size + 1e-9)).all()));
    }
}

#[test]
fn trim_planes_keep_cylinders_in_their_quarters() {
    let section = 0.5 * 16.0 * 25.0 * libm::sin(PI / 8.0);
    let [cut, whole] = [&trimmed::EXAMPLE, &not_trimmed::EXAMPLE].map(model);
    assert_eq!([cut.len(), whole.len()], [4, 4]);
    whole.leaves().for_each(|leaf| near(leaf.volume(), 40.0 * section, 1e-6));
    let middle = cut.bounds().low.midpoint(cut.bounds().high);
    for leaf in cut.leaves() {
        // The planes go through the middle, at 45 degrees to the side. The cuts stay open.
        let out = leaf.scope().axes.z_axis;
        let mut on_planes = 0;
        for point in points(&leaf) {
            let from = point - middle;
            let along = from.dot(out);
            let aside = (from - out * along).with_y(0.0).length();
            assert!(aside <= along + 1e-6, "{from} along {out}");
            on_planes += usize::from((aside - along).abs() < 1e-6);
        }
        assert!(4 <= on_planes && leaf.area() < whole.leaves().next().expect("a cylinder").area(), "{on_planes}");
    }
}

#[test]
fn barriers_and_rails_follow_the_street() {
    let model_of_barriers = model(&barriers::EXAMPLE);
    let lengths: Vec<f64> = model_of_barriers
        .leaves_of("InsertBarrier")
        .map(|leaf| {
            near(leaf.bounds().low.y, 0.0, 1e-9);
            near(leaf.bounds().high.y, 1.0, 1e-9);
            // The area of the profile.
            leaf.volume() / (0.8 * 0.1 + 0.5 * (0.8 + 0.3) * 0.3 + 0.5 * (0.3 + 0.2) * 0.6)
        })
        .collect();
    assert_eq!(lengths.len(), 3);
    // The middles of the barriers are 0.4 m inside the borders of the road, 5 m from its line, and on the line.
    let mut lengths = lengths;
    lengths.sort_by(f64::total_cmp);
    for (length, radius) in lengths.into_iter().zip([RADIUS - 4.6, RADIUS, RADIUS + 4.6]) {
        near(length / (PI * radius), 1.0, 0.02);
    }
    let rails = model(&guardrails::EXAMPLE);
    assert_eq!(rails.len(), 2);
    for rail in rails.leaves() {
        near(rail.bounds().low.y, 0.0, 1e-9);
        near(rail.bounds().high.y, 0.9, 1e-9);
    }
}

#[test]
fn an_asset_is_repeated_in_each_unit_of_the_coordinates() {
    let [split, along] = [&spheres::EXAMPLE, &spheres_along::EXAMPLE].map(model);
    assert_eq!((split.count("Sphere"), along.len()), (16, 1));
    split.leaves().for_each(|leaf| near(leaf.size().y, 2.5, 1e-9));
    // The coordinates map a sphere of width 1 to cells of the face: their area on the ground times the height.
    let unit = meshes::sphere(16, 8, 0.5).volume();
    let volume: f64 = along.leaves().map(|leaf| leaf.volume()).sum();
    near(volume / (10.0 * 10.0 * 2.5 * unit), 1.0, 0.02);
    let forest = model(&trees::EXAMPLE);
    assert_eq!(forest.counts(), [("Texture", 1), ("Foliage", 1), ("Trunk", 1)]);
    for leaf in forest.leaves().filter(|leaf| leaf.rule() != "Texture") {
        let (mesh, _) = leaf.mesh();
        assert!(mesh.is_closed());
    }
    // Each trunk is an eighth of 10 m wide and half as high as the tree.
    let trunks = forest.leaves_of("Trunk").next().expect("trunks");
    near(trunks.volume(), 16.0 * 1.25 * 1.25 * 12.5, 1e-6);
    near(forest.bounds().high.y, 25.0, 1e-9);
    assert_eq!(forest.leaves_of("Foliage").next().expect("crowns").material().opacity, Some(0.1));
}

#[test]
fn assets_bend_around_cylinders_and_spheres() {
    let tower = model(&curved_windows::EXAMPLE);
    assert!(3 < tower.count("Window"), "{:?}", tower.counts());
    let ends: Vec<DVec3> = tower.leaves_of("Endcaps").flat_map(|leaf| points(&leaf)).collect();
    let axis = ends.iter().sum::<DVec3>() / ends.len() as f64;
    for point in tower.leaves_of("Window").flat_map(|leaf| points(&leaf)) {
        let radius = (point - axis).with_y(0.0).length();
        // Half of its depth is in the wall, whose faces are up to 0.01 m nearer to the axis than their edges.
        assert!((1.889..2.101).contains(&radius), "{radius}");
    }
    // The sphere of 16 sides fills its box, so its corners are 10.2 m from the middle.
    let ball = model(&sphere::EXAMPLE);
    let start = (sphere::EXAMPLE.start)();
    let middle = start.scope().frame().to_world(0.5 * start.scope().size);
    for (rule, low, high) in [("Pyramids", 9.4, 10.7), ("Circles2D", 9.4, 10.2), ("Circles3D", 8.9, 10.2)] {
        let leaf = ball.leaves_of(rule).next().expect("a part");
        let radii: Vec<f64> = points(&leaf).iter().map(|point| point.distance(middle)).collect();
        let [least, most] =
            [radii.iter().copied().fold(f64::INFINITY, f64::min), radii.iter().copied().fold(0.0, f64::max)];
        assert!(low < least && most < high, "{rule}: {least} to {most}");
        assert!(leaf.material().color.is_some());
    }
}
