//! Files from memory: a source gives the same models as a folder with the same files.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

use cga::sink::picture::Picture;
use cga::{AssetSource, Assets, Model, Settings, Shape, cga};

cga! {
    @Allow(missing_asset)
    grammar Square = r#"
        Lot --> Tree Box Sign Texts
        Tree --> s(2, 3, 2) i("trees/oak.obj") Tree.
        Box --> t(3, 0, 0) s(1, 1, 1) i("box.glb") Box.
        Sign --> t(6, 0, 0) extrude(2) comp(f) { front : setupProjection(0, scope.xy, '1, '1) texture("images/sign.png") projectUV(0) Sign. }
        Texts -->
            print(readTextFile("notes.txt")) print(readFloatTable("lots.csv")) print(fileSearch("*.obj"))
            print(filesSearch("Name=$.*[kn][.].*")) print(fileExists("trees/oak.mtl")) print(fileExists("trees/ash.obj"))
            print(assetInfo("trees/oak.obj", sy)) print(imageInfo("images/sign.png", sx)) print(fileRandom("trees/*.obj"))
            i("trees/ash.obj") Ash.
    "#;
}

/// The files of the square.
fn files() -> BTreeMap<String, Vec<u8>> {
    cga! { grammar Block; Lot --> extrude(2) color("#ff0000") Block. }
    let block = Block::default().generate(&Shape::rectangle(1.0, 1.0)).expect("a model");
    let (glb, png) = (block.to_glb().expect("a file"), Picture::new(6, 4).render(&block).to_png().expect("a picture"));
    let oak = "mtllib oak.mtl\nv 0 0 0\nv 1 0 0\nv 0 4 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl bark\nf 1/1 2/2 3/3\n";
    let material = "newmtl bark\nKd 1 1 1\nmap_Kd ../images/sign.png\n";
    BTreeMap::from([
        ("trees/oak.obj".to_owned(), oak.into()),
        ("trees/oak.mtl".to_owned(), material.into()),
        ("images/sign.png".to_owned(), png),
        ("box.glb".to_owned(), glb),
        ("notes.txt".to_owned(), b"No parking".to_vec()),
        ("lots.csv".to_owned(), b"1,2\n3,4\n".to_vec()),
    ])
}

fn run(assets: Assets) -> Model {
    let settings = Settings { assets: Arc::new(assets), ..Settings::default() };
    Square::default().generate_with(&Shape::rectangle(2.0, 2.0), &settings).expect("a model")
}

fn said(model: &Model) -> Vec<String> {
    let faults = model.faults().iter().map(ToString::to_string);
    model.prints().iter().map(ToString::to_string).chain(faults).collect()
}

#[test]
fn a_source_is_as_good_as_a_folder() {
    let folder = std::env::temp_dir().join(format!("cga-source-{}", std::process::id()));
    for (name, bytes) in files() {
        let path = folder.join(name);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("folders");
        std::fs::write(path, bytes).expect("a file");
    }
    let below = run(Assets::below(&folder));
    let expected = (said(&below), below.to_glb().expect("a file"));
    std::fs::remove_dir_all(&folder).expect("it is gone");

    let model = run(Assets::from_source(files()));
    let lines = said(&model);
    assert_eq!(lines[0], "No parking");
    assert_eq!(
        lines[2..8],
        ["trees/oak.obj;", "(3)[images/sign.png,trees/oak.mtl,trees/oak.obj]", "true", "false", "4", "6"]
            .map(String::from)
    );
    assert_eq!(lines.len(), 10, "one fault, for the ash: {lines:?}");
    let message = |line: &String| line.split("cannot be inserted").next().map(str::to_owned);
    assert_eq!(lines.iter().map(message).collect::<Vec<_>>(), expected.0.iter().map(message).collect::<Vec<_>>());
    assert!(model.to_glb().expect("a file") == expected.1, "the same bytes, images included");
}

#[test]
fn lists_and_own_types_are_sources() {
    struct Packed;
    impl AssetSource for Packed {
        fn bytes(&self, name: &str) -> Option<Cow<'_, [u8]>> {
            let file = files().remove(name)?;
            Some(Cow::Owned(file))
        }

        fn names(&self) -> Vec<String> {
            files().into_keys().rev().collect()
        }
    }
    let first = run(Assets::from_source(files()));
    let list: Vec<(String, Vec<u8>)> = files().into_iter().collect();
    for assets in [Assets::from_source(list), Assets::from_source(Packed)] {
        let model = run(assets);
        assert_eq!(said(&model), said(&first));
        assert!(model.to_glb().expect("a file") == first.to_glb().expect("a file"));
    }
}

#[test]
fn no_name_leads_out_of_a_source() {
    let oak = "mtllib ../../secret.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl bark\nf 1 2 3\n";
    let assets = Assets::from_source([("oak.obj", oak), ("secret.mtl", "newmtl bark\nKd 1 0 0\n")]);
    let mesh = assets.mesh("oak.obj").expect("the mesh without its material");
    assert_ne!(
        mesh.materials::<cga::Material>().first().map(|material| material.color()),
        Some(cga::Color::new(1.0, 0.0, 0.0))
    );
    assert!(assets.mesh("../oak.obj").is_err() && assets.mesh("/oak.obj").is_ok());
    // A mesh of the program comes first.
    let given = assets.with("oak.obj", (*mesh).clone());
    assert_eq!(given.mesh("oak.obj").expect("the mesh").face_count(), 1);
}
