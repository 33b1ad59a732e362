//! *assetsSortSize function*, *assetsSortRatio function*, *imagesSortRatio function*, the functions of the utility library that choose a
//! file, *assetMetadata function* and *readMaterial function*.

use std::collections::BTreeMap;
use std::sync::Arc;

use cga::sink::picture::Picture;
use cga::{Assets, Mesh, Model, Settings, Shape, Value, cga};

fn block(size: [f64; 3]) -> Arc<Mesh> {
    let [width, height, depth] = size;
    Shape::cuboid(width, height, depth).to_mesh()
}

/// Cubes with sides of 1, 2 and 4 m, and a long one.
fn assets() -> Assets {
    let sides =
        [("small.obj", [1.0; 3]), ("middle.obj", [2.0; 3]), ("large.obj", [4.0; 3]), ("long.obj", [9.0, 1.0, 3.0])];
    sides.into_iter().fold(Assets::new(), |assets, (name, size)| assets.with(name, block(size)))
}

fn lines(model: &Model) -> Vec<String> {
    assert_eq!(model.faults().len(), 0, "{:?}", model.faults());
    model.prints().iter().map(|line| line.value.to_string()).collect()
}

/// Small cells get small assets and large cells large ones; a long cell gets a long asset.
#[test]
fn cells_get_assets_of_their_size() {
    let rules = cga! {
        @StartRule
        Lot --> extrude(2) split(x) { 4.2 : Cell | 1.2 : split(z) { 1.1 : Cell } | 2 : Cell | ~1 : Cell }
        Cell --> print(assetBestSize("*.obj", "xz")) print(assetBestRatio("*.obj", "xz")) i(assetBestSize("*.obj", "xz")) Asset.
    };
    let settings = Settings { assets: Arc::new(assets()), ..Settings::default() };
    let model = rules.generate_with(&Shape::rectangle(10.0, 2.0), &settings).expect("a model");
    let sizes = ["large.obj", "small.obj", "middle.obj", "middle.obj"];
    let ratios = ["long.obj", "large.obj", "large.obj", "large.obj"];
    let expected: Vec<&str> = sizes.into_iter().zip(ratios).flat_map(|(size, ratio)| [size, ratio]).collect();
    assert_eq!(lines(&model), expected);
    assert_eq!(model.leaves().len(), 4);
}

#[test]
fn lists_and_arrays_are_sorted_and_chosen_from() {
    let rules = cga! {
        Lot -->
            extrude(4)
            print(assetsSortSize(fileSearch("*.obj"), xyz, 0))
            print(assetsSortSize(filesSearch("*.obj"), x, 0.1))
            print(assetsSortSize("small.obj;large.obj;", y, 0.5))
            print(assetsSortRatio(["long.obj", "small.obj"], xyz))
            print(assetsSortRatio("long.obj;small.obj;", xz))
            print(assetApproxSize("*.obj", "x", 1) == assetBestSize("*.obj", "x"))
            print(assetApproxRatio("*.obj", "xz", 1) == assetBestRatio("*.obj", "xz"))
            print(assetFitSize("*.obj", "xyz", 0.05))
            print(assetFitSize("l*.obj", "xyz", 0.05) == "large.obj")
            X.
    };
    let settings = Settings { assets: Arc::new(assets()), ..Settings::default() };
    let model = rules.generate_with(&Shape::rectangle(4.0, 4.1), &settings).expect("a model");
    let expected = [
        "large.obj;middle.obj;long.obj;small.obj;",
        "(1)[large.obj]",
        "large.obj;",
        "(2)[small.obj,long.obj]",
        "small.obj;long.obj;",
        "true",
        "true",
        "large.obj",
        "true",
    ];
    assert_eq!(lines(&model), expected);
}

#[test]
fn files_hold_images_materials_and_metadata() {
    cga! { grammar Block; Lot --> extrude(2) color("#ff0000") Block. }
    let model = Block::default().generate(&Shape::rectangle(1.0, 1.0)).expect("a model");
    let picture = |width, height| Picture::new(width, height).render(&model).to_png().expect("a picture");
    let tree = br#"{
        "asset": {"version": "2.0", "extras": {"species": "oak"}},
        "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "extras": {"height": 12.5, "crown": [1, 4]}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5121, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 9}],
        "buffers": [{"uri": "data:application/octet-stream;base64,AAAAAQAAAAEA", "byteLength": 9}]
    }"#;
    let files = BTreeMap::from([
        ("walls/wide.png", picture(8, 4)),
        ("walls/high.png", picture(4, 8)),
        ("looks/red.cgamat", b"color.r,1\ncolor.g,0\ncolor.b,0\ncolormap,../walls/wide.png\n".to_vec()),
        ("looks/blue.mtl", b"newmtl Blue\nKd 0 0 1\n".to_vec()),
        ("tree.gltf", tree.to_vec()),
    ]);
    cga! {
        @Allow(missing_asset)
        grammar Contents;

        @StartRule
        Lot -->
            print(imagesSortRatio(filesSearch("*.png"), xz)) print(imageBestRatio("*.png", "zx"))
            print(imageApproxRatio("*.png", "xz", 1))
            print(assetMetadata("tree.gltf", "species", "ash")) print(assetMetadata("tree.gltf", "height", 1) + 1)
            print(assetMetadata("tree.gltf", "crown", [0])) print(assetMetadata("tree.gltf", "height", "unknown"))
            print(readMaterial("looks/blue.mtl")) Red Blue
        Red --> setMaterial(readMaterial("looks/red.cgamat")) print(material.colormap) Red.
        Blue --> setMaterial(readMaterial("looks/blue.mtl")) print(material.color.rgb) Blue.
    }
    let settings = Settings { assets: Arc::new(Assets::from_source(files)), ..Settings::default() };
    let model = Contents::default().generate_with(&Shape::rectangle(6.0, 3.0), &settings).expect("a model");
    let expected = [
        "(2)[walls/wide.png,walls/high.png]",
        "walls/high.png",
        "walls/wide.png",
        "oak",
        "13.5",
        "(2)[1,4]",
        "unknown",
        "(4x2)\n   color.b      1\n   color.g      0\n   color.r      0\n      name   Blue",
        "/walls/wide.png",
        "#0000ff",
    ];
    assert_eq!(lines(&model), expected);
    assert!(matches!(model.prints()[4].value, Value::Float(_)));
}
