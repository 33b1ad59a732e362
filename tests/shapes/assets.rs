//! Files that rules name are looked for from the folder of the rule file, whichever rule needs them (*Asset search*).

use std::path::PathBuf;
use std::sync::Arc;

use cga::{Assets, Grammar, Model, Settings, Shape, cga};

/// A folder with some files, gone afterwards.
struct Temporary(PathBuf);

impl Temporary {
    fn new(name: &str, files: &[(&str, &str)]) -> Temporary {
        let files: Vec<(&str, &[u8])> = files.iter().map(|(name, text)| (*name, text.as_bytes())).collect();
        Temporary::with_bytes(name, &files)
    }

    fn with_bytes(name: &str, files: &[(&str, &[u8])]) -> Temporary {
        let folder = std::env::temp_dir().join(format!("cga-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&folder);
        for (name, text) in files {
            let path = folder.join("root").join(name);
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("folders");
            std::fs::write(path, text).expect("a file");
        }
        Temporary(folder)
    }

    fn run(&self, rules: &dyn Grammar, start: &str) -> Model {
        let assets = Arc::new(Assets::below(self.0.join("root")));
        let settings = Settings { assets, start: Some(start.into()), ..Settings::default() };
        rules.generate_with(&Shape::rectangle(1.0, 1.0), &settings).expect("no limit")
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// A triangle of that width, from the origin.
fn triangle(width: f64) -> String {
    format!("v 0 0 0\nv {width} 0 0\nv 0 1 0\nf 1 2 3\n")
}

fn printed(model: &Model) -> Vec<String> {
    model.prints().iter().map(|line| line.to_string()).collect()
}

cga! {
    @Allow(missing_asset)
    grammar City = r#"
        import imp : "rules/import/city/assets.cga" (Extended --> s(0, 0, 0) i("q.obj") Replaced.)
        Own --> s(0, 0, 0) i("q.obj") Own.
        Away --> s(0, 0, 0) i(imp.far) Away.
        Absolute --> s(0, 0, 0) i("/rules/import/city/q.obj") Absolute.
        Missing --> i("/q.obj") i("/rules/../q.obj") Missing.
        Sized --> imp.Sized
        Replaced --> imp.Replaced
        Painted --> texture("w.png") print(material.colormap) imp.Painted
        Searched --> print(fileSearch("Name=q.obj")) imp.Searched
        Said --> print(readTextFile("t.txt")) imp.Said
    "#;
}

#[test]
fn a_rule_finds_what_is_beside_its_file() {
    let (three, five) = (triangle(3.0), triangle(5.0));
    let folder = Temporary::new(
        "beside",
        &[
            ("assets/q.obj", &three),
            ("rules/import/city/q.obj", &five),
            ("assets/w.png", ""),
            ("rules/import/city/w.png", ""),
            ("assets/b.png", ""),
            ("t.txt", "root"),
            ("rules/t.txt", "above"),
            ("rules/t.csv", "a;b"),
            ("rules/import/city/assets/only.txt", ""),
        ],
    );
    let width = |start: &str| {
        let model = folder.run(&City::default(), start);
        assert!(model.report().faults().is_empty(), "{:?}", model.report().faults());
        model.leaves().map(|leaf| leaf.size().x).collect::<Vec<_>>()
    };
    for (start, wanted) in [("Own", 3.0), ("Away", 3.0), ("Absolute", 5.0), ("Sized", 5.0), ("Replaced", 3.0)] {
        assert_eq!(width(start), [wanted], "{start}");
    }
    let painted = printed(&folder.run(&City::default(), "Painted"));
    assert_eq!(painted, ["w.png", "rules/import/city/w.png", "b.png"]);
    let said = printed(&folder.run(&City::default(), "Said"));
    assert_eq!(said[..1], ["root"]);
    assert_eq!(said[1..2], ["above"]);
    assert_eq!(said[3..], ["root", "5", "true"], "{said:?}");
}

#[test]
fn what_a_search_finds_is_found_by_its_name() {
    let (three, five) = (triangle(3.0), triangle(5.0));
    let folder = Temporary::new("search", &[("assets/q.obj", &three), ("rules/assets/q.obj", &five)]);
    let model = folder.run(&City::default(), "Searched");
    let all = "assets/q.obj;rules/assets/q.obj;";
    assert_eq!(printed(&model), [all.to_owned(), format!("/{all}")]);
    assert_eq!(model.leaves().map(|leaf| leaf.size().x).collect::<Vec<_>>(), [3.0]);
}

#[test]
fn what_an_absolute_path_does_not_name_is_missing() {
    let folder = Temporary::new("absolute", &[("assets/q.obj", &triangle(1.0)), ("../q.obj", &triangle(1.0))]);
    let model = folder.run(&City::default(), "Missing");
    let faults: Vec<String> = model.report().faults().iter().map(|fault| fault.message.clone()).collect();
    assert_eq!(faults.len(), 2, "{faults:?}");
    assert!(faults[0].starts_with("`/q.obj` cannot be inserted"), "{}", faults[0]);
    assert!(faults[1].contains("below the asset folder only"), "{}", faults[1]);
}

#[test]
fn images_of_an_inserted_file_are_found_beside_it() {
    let object = format!("mtllib q.mtl\nusemtl wood\n{}", triangle(3.0));
    let library = "newmtl wood\nmap_Kd wood.png\nmap_d none.png\n";
    let files = [("assets/q.obj", &object[..]), ("assets/q.mtl", library), ("assets/wood.png", "")];
    let model = Temporary::new("beside-image", &files).run(&City::default(), "Own");
    let (mesh, _) = model.leaves().next().expect("a leaf").mesh();
    assert_eq!(
        mesh.materials::<cga::Material>()[0].texture.as_ref().map(|name| name.as_str()),
        Some("/assets/wood.png")
    );
    let faults: Vec<String> = model.faults().iter().map(|fault| fault.message.clone()).collect();
    assert_eq!(faults.len(), 2, "{faults:?}");
    assert!(
        faults[0].starts_with("`/assets/wood.png` cannot be shown: only PNG and JPEG images can be read"),
        "{faults:?}"
    );
    assert!(faults[1].starts_with("`none.png` cannot be shown"), "{faults:?}");
}

cga! {
    @Allow(missing_asset)
    grammar Painted = r#"
        Lot --> split(x) { ~1 : Wall }*
        Wall --> texture("none.png") X.
    "#;
}

#[test]
fn a_missing_texture_is_one_fault_in_each_run() {
    let folder = Temporary::new("texture", &[]);
    let assets = Arc::new(Assets::below(&folder.0));
    let settings = Settings { assets, ..Settings::default() };
    let grammar = Painted::default();
    let mut session = grammar.session(&settings).expect("a session");
    for _ in 0..2 {
        let model = session.generate(&Shape::rectangle(5.0, 1.0)).expect("a model");
        let faults: Vec<String> = model.faults().iter().map(|fault| fault.message.clone()).collect();
        assert!(faults.len() == 1 && faults[0].starts_with("`none.png` cannot be shown"), "{faults:?}");
        assert_eq!(model.leaves().count(), 5);
        let images = model.leaves().map(|leaf| leaf.material().texture.as_ref().map(|name| name.to_string()));
        assert!(images.into_iter().all(|name| name.as_deref() == Some("builtin:unknowntexture.png")));
    }
}

cga! {
    @Allow(missing_asset)
    grammar Mapped = r#"
        Lot --> setupProjection(0, scope.xy, 1, 1) projectUV(0)
            set(material.normalmap, "none.png") set(material.roughnessmap, "none.png") set(material.emissivemap, "glow.png") X.
    "#;
}

#[test]
fn a_missing_map_of_normals_or_roughness_is_left_out() {
    let (missing, broken) = (
        Temporary::new("no-maps", &[]),
        Temporary::new("broken-maps", &[("none.png", "no image"), ("glow.png", "no image")]),
    );
    for (assets, names) in [
        (Arc::new(Assets::below(&missing.0)), ["emissiveTexture", "\"images\":[{\"bufferView\""]),
        (Arc::new(Assets::below(&broken.0)), ["emissiveTexture", "\"images\":[{\"bufferView\""]),
        // Without a folder, files name their images.
        (Arc::default(), ["normalTexture", "\"uri\":\"none.png\""]),
    ] {
        let settings = Settings { assets, ..Settings::default() };
        let model = Mapped::default().generate_with(&Shape::rectangle(5.0, 1.0), &settings).expect("a model");
        let messages: Vec<&str> = model.faults().iter().map(|fault| fault.message.as_str()).collect();
        assert!(messages[0].ends_with("the shape is shown without it"), "{messages:?}");
        let glb = model.to_glb().expect("a file");
        let text = String::from_utf8_lossy(&glb);
        assert!(names.iter().all(|name| text.contains(name)), "{names:?}");
        assert_eq!(text.contains("normalTexture"), names[0] == "normalTexture");
    }
}

cga! {
    @Allow(missing_asset)
    grammar Glazed = r##"
        Source --> color("#80ff00") set(material.name, "Glass") setupProjection(0, scope.xy, 1, 1)
            texture("builtin:uvtest.png") projectUV(0) extrude(2) Pane.
        Lot --> s(0, 0, 0) i("window.glb") print(assetInfo("window.glb", sy)) print(fileExists("window.glb#0.png"))
            print(imageInfo("window.glb#0.png", sx)) Window.
        Broken --> i("broken.glb") X.
        Text --> i("text.gltf") X.
    "##;
}

#[test]
fn a_glb_file_that_was_written_is_an_asset() {
    let grammar = Glazed::default();
    let settings = Settings { start: Some("Source".into()), ..Settings::default() };
    let source = grammar.generate_with(&Shape::rectangle(3.0, 1.0), &settings).expect("no limit");
    let glb = source.to_glb().expect("a file");
    let folder = Temporary::with_bytes("glb", &[("window.glb", &glb)]);
    let model = folder.run(&grammar, "Lot");
    assert_eq!(model.faults().iter().map(|fault| fault.message.clone()).collect::<Vec<_>>(), [""; 0]);
    assert_eq!(printed(&model), ["2", "true", "512"]);
    let leaf = model.leaves().next().expect("a leaf");
    let (mesh, _) = leaf.mesh();
    assert_eq!((leaf.size().to_array(), mesh.is_closed(), mesh.face_count()), ([3.0, 2.0, 1.0], true, 12));
    assert!((mesh.area() - 22.0).abs() < 1e-12);
    let material = &mesh.materials::<cga::Material>()[0];
    assert_eq!(material.name.as_ref().map(|name| name.as_str()), Some("Glass"));
    assert_eq!(material.texture.as_ref().map(|name| name.as_str()), Some("/window.glb#0.png"));
    let color = material.color();
    assert!((color.r - 128.0 / 255.0).abs() < 1e-6 && color.g == 1.0 && color.b == 0.0);
    // The image goes into the next file, whether images are embedded or not: other programs cannot find it.
    let again = model.to_glb().expect("a file");
    let picture = again.windows(8).filter(|bytes| *bytes == b"\x89PNG\r\n\x1a\n").count();
    assert_eq!(picture, 1);
}

#[test]
fn a_gltf_file_that_cannot_be_read_is_one_fault_that_names_the_place() {
    let text = r#"{"asset": {"version": "2.0"}, "nodes": [{"mesh": 3}]}"#;
    let folder = Temporary::new("broken-glb", &[("broken.glb", "glTF"), ("text.gltf", text)]);
    for (start, message) in [("Broken", "the file ends early"), ("Text", "meshes[3]: it does not exist")] {
        let model = folder.run(&Glazed::default(), start);
        let faults: Vec<String> = model.faults().iter().map(|fault| fault.message.clone()).collect();
        assert!(faults.len() == 1 && faults[0].contains(message), "{faults:?}");
        assert_eq!(model.leaves().count(), 1);
    }
}

cga! {
    grammar Trees;
    @Allow(missing_asset)
    Lot --> case scope.sx > 3 : s(4, 2, 4) i("no-tree.obj") Tree. else : s(4, 2, 4) primitiveCube() Tree.
}

#[test]
fn a_picture_has_a_translucent_box_for_a_missing_asset() {
    use cga::sink::picture::{Image, Lines, Picture};
    let draw = |model: &Model| Picture { ground: false, lines: Lines::None, ..Picture::new(80, 60) }.render(model);
    let run = |width: f64| Trees {}.generate(&Shape::rectangle(width, 4.0)).expect("no limit");
    let (missing, there) = (draw(&run(4.0)), draw(&run(2.0)));
    let empty = draw(&Model::new());
    let seen = |image: &Image| {
        let pixels = image.rgba.chunks_exact(4).zip(empty.rgba.chunks_exact(4));
        pixels.map(|(here, empty)| here != empty).collect::<Vec<_>>()
    };
    // The outline of the box, whose mark is much smaller; the backdrop and the mark are seen through it.
    assert!(seen(&missing) == seen(&there) && seen(&there).iter().filter(|seen| **seen).count() > 80 * 60 / 8);
    assert_ne!(missing, there);
    assert!(run(4.0).bounds().size().max_element() < 0.2);
}

cga! {
    @Allow(missing_asset)
    grammar Without = r#"
        Unnamed --> i("") X.
        Cleared --> texture("") X.
        Reset --> set(material.colormap, "") X.
        Plain --> setupProjection(0, scope.xz, 1, 1) projectUV(0) X.
        Brick --> setupProjection(0, scope.xz, 1, 1) projectUV(0) texture("brick.png") X.
        Mesh --> i("out.obj") X.
        Image --> texture("up/out.png") X.
    "#;
}

fn messages(model: &Model) -> Vec<&str> {
    model.faults().iter().map(|fault| &*fault.message).collect()
}

#[test]
fn without_an_asset_folder_a_texture_is_a_fault_and_a_checker_pattern() {
    let run = |start: &str| Without::default().generate_from(start, &Shape::rectangle(2.0, 2.0)).expect("no limit");
    let (plain, brick) = (run("Plain"), run("Brick"));
    assert_eq!(
        messages(&brick),
        ["`brick.png` cannot be shown: no asset folder is set (`Settings::assets`); a checker pattern takes its place"]
    );
    let picture = cga::sink::picture::Picture::new(40, 40);
    let shown = |model: &Model| {
        let image = picture.render(model);
        // The squares of the pattern are magenta and grey.
        image.rgba.as_chunks::<4>().0.iter().filter(|[r, g, b, _]| 2 * u32::from(*g) < u32::from(*r.min(b))).count()
    };
    assert!(shown(&plain) == 0 && 100 < shown(&brick), "{} and {}", shown(&plain), shown(&brick));
    // The program may have the file elsewhere.
    let text = String::from_utf8_lossy(&brick.to_glb().expect("a file")).into_owned();
    assert!(text.contains("\"uri\":\"brick.png\""), "{text}");
}

#[test]
fn an_empty_name_is_a_fault() {
    let folder = Temporary::new("unnamed", &[("a.txt", "")]);
    for model in [
        folder.run(&Without::default(), "Unnamed"),
        Without::default().generate_from("Unnamed", &Shape::rectangle(1.0, 1.0)).expect("no limit"),
    ] {
        assert_eq!(messages(&model), ["`i` has no file: its name is empty; a small box marks the place"]);
    }
    let cleared = folder.run(&Without::default(), "Cleared");
    assert_eq!(
        messages(&cleared),
        [
            "`texture` has no file: its name is empty, and the shape has no texture; `set(material.colormap, \"\")` removes a \
          texture without this fault"
        ]
    );
    assert!(cleared.leaves().all(|leaf| leaf.material().texture.as_deref() == Some("")));
    assert_eq!(messages(&folder.run(&Without::default(), "Reset")), [""; 0]);
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_out_of_the_folder_is_not_called_missing() {
    let folder = Temporary::new("links", &[("a.txt", ""), ("../out.obj", &triangle(1.0)), ("../out.png", "")]);
    let link = |to: &str, name: &str| {
        std::os::unix::fs::symlink(folder.0.join(to), folder.0.join("root").join(name)).expect("a link");
    };
    link("out.obj", "out.obj");
    link("", "up");
    for (start, what) in [("Mesh", "`out.obj` cannot be inserted"), ("Image", "`up/out.png` cannot be shown")] {
        let model = folder.run(&Without::default(), start);
        let why = format!("{what}: a link leads out of the asset folder, and files outside are not read; ");
        assert!(matches!(&messages(&model)[..], [one] if one.starts_with(&why)), "{:?}", messages(&model));
    }
}
