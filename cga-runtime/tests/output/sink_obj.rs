//! OBJ text, read back.

use std::sync::Arc;

use crate::sink_support::{Fill, color, front, hash, mixed, plate, steady, textured, upright};
use cga_runtime::material::{Channel, Layer, Material, MaterialNumber, MaterialText};
use cga_runtime::output::model::Model;
use glam::{DAffine3, DVec3, dvec3};

/// Points, and faces as indices of points.
fn read(text: &str) -> (Vec<DVec3>, Vec<Vec<usize>>) {
    let mut points = Vec::new();
    let mut faces = Vec::new();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let p: Vec<f64> = words.map(|word| word.parse().expect("a number")).collect();
                points.push(dvec3(p[0], p[1], p[2]));
            }
            Some("f") => {
                let index =
                    |word: &str| word.split('/').next().and_then(|i| i.parse::<usize>().ok()).expect("an index");
                faces.push(words.map(|word| index(word) - 1).collect());
            }
            _ => {}
        }
    }
    (points, faces)
}

fn volume((points, faces): &(Vec<DVec3>, Vec<Vec<usize>>)) -> f64 {
    let fan = |face: &Vec<usize>| -> f64 {
        let p = |i: usize| points[face[i]];
        (1..face.len() - 1).map(|i| p(0).dot(p(i).cross(p(i + 1)))).sum()
    };
    faces.iter().map(fan).sum::<f64>() / 6.0
}

#[test]
fn polygons_stay_polygons_and_faces_with_holes_become_triangles() {
    let mut fill = Fill(Model::new());
    fill.quad("Wall", &color(1.0, 0.0, 0.0), front(DVec3::ZERO, 1.0, 1.0));
    fill.mesh("Plate", &Arc::default(), &plate(), DAffine3::IDENTITY);
    let obj = read(&fill.0.to_obj("x.mtl").0);
    let quads = obj.1.iter().filter(|face| face.len() == 4).count();
    assert_eq!((quads, obj.1.len()), (9, 9 + 16));
}

#[test]
fn what_is_read_back_has_the_same_volume() {
    let mut fill = Fill(Model::new());
    fill.cuboid("Box", &color(1.0, 0.0, 0.0), upright(dvec3(0.1, 0.2, 0.3), dvec3(1.1, 2.2, 3.3)));
    fill.cuboid("Box", &color(1.0, 0.0, 0.0), upright(dvec3(0.1, 0.2, 0.3), dvec3(-1.0, 1.0, 1.0)));
    fill.mesh("Plate", &Arc::default(), &plate(), DAffine3::from_scale(dvec3(1.0 / 3.0, 1.0, 1.0)));
    let obj = read(&fill.0.to_obj("x.mtl").0);
    assert!((volume(&obj) - fill.0.volume()).abs() < 1e-12);
}

#[test]
fn coordinates_are_read_back_bit_for_bit() {
    let mut fill = Fill(Model::new());
    let origin = dvec3(1.0 / 3.0, -1e-7, 5_400_000.000_000_1);
    fill.quad("Wall", &color(1.0, 0.0, 0.0), front(origin, 0.0, 1.0));
    let (points, _) = read(&fill.0.to_obj("x.mtl").0);
    assert_eq!(points[0], origin);
}

#[test]
fn a_run_of_one_rule_and_material_is_one_group() {
    let (red, blue) = (color(1.0, 0.0, 0.0), color(0.0, 0.0, 1.0));
    let mut fill = Fill(Model::new());
    for (rule, material) in [("A", &red), ("A", &red), ("A", &blue), ("B", &blue)] {
        fill.quad(rule, material, front(DVec3::ZERO, 1.0, 1.0));
    }
    let (text, library) = fill.0.to_obj("x.mtl");
    let heads: Vec<&str> = text.lines().filter(|line| line.starts_with(['g', 'u', 'm'])).collect();
    assert_eq!(
        heads,
        ["mtllib x.mtl", "g A", "usemtl color_ff0000", "g A", "usemtl color_0000ff", "g B", "usemtl color_0000ff"]
    );
    assert!(library.contains("newmtl color_0000ff\nKd 0 0 1\n"));
}

#[cfg(feature = "obj")]
#[test]
fn what_an_old_material_file_can_say_is_said() {
    let mut fill = Fill(Model::new());
    let material = Material::with(|look| {
        look.set_number(MaterialNumber::Specular(Channel::G), 0.5);
        look.set_number(MaterialNumber::Emissive(Channel::R), 0.25);
        look.set_number(MaterialNumber::Shininess, 30.0);
        look.set_text(MaterialText::Map(Layer::Opacity), "holes.png");
    });
    fill.quad("A", &Arc::new(material), front(DVec3::ZERO, 1.0, 1.0));
    let (_, library) = fill.0.to_obj("a.mtl");
    for line in ["Ks 0 0.5 0", "Ke 0.25 0 0", "Ns 30", "map_d holes.png"] {
        assert!(library.lines().any(|other| other == line), "{library}");
    }
    assert!(!library.contains("Ka"));
    let back = cga_runtime::asset::obj::read_obj(
        b"mtllib a.mtl\nusemtl color_ffffff\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        &mut |_| Some(library.clone().into_bytes()),
    );
    let mesh = back.expect("it was written by us").mesh;
    let look = &mesh.materials::<Material>()[0];
    assert_eq!(look.number(MaterialNumber::Specular(Channel::G)), Some(0.5));
    assert_eq!(look.number(MaterialNumber::Emissive(Channel::R)), Some(0.25));
    assert_eq!(look.number(MaterialNumber::Shininess), Some(30.0));
    assert_eq!(look.text(MaterialText::Map(Layer::Opacity)).map(|text| text.as_str()), Some("holes.png"));
}

#[test]
fn material_names_are_plain_and_distinct() {
    let named = |name: &str, opacity: f64| {
        Arc::new(Material::with(|look| (look.name, look.opacity) = (Some(name.into()), Some(opacity))))
    };
    let mut fill = Fill(Model::new());
    for material in [named("old brick", 1.0), named("old_brick", 0.5), named("old/brick", 0.25)] {
        fill.quad("A", &material, front(DVec3::ZERO, 1.0, 1.0));
    }
    let (_, library) = fill.0.to_obj("x.mtl");
    let names: Vec<&str> = library.lines().filter_map(|line| line.strip_prefix("newmtl ")).collect();
    assert_eq!(names, ["old_brick", "old_brick_1", "old_brick_2"]);
}

#[test]
fn texture_coordinates_and_normals_are_written() {
    let mut fill = Fill(Model::new());
    fill.mesh("Sign", &Arc::default(), &textured(), DAffine3::IDENTITY);
    let (text, library) = fill.0.to_obj("x.mtl");
    assert!(text.contains("vt 0 0.25\n") && text.contains("vn 0.6 0 0.8\n") && text.contains("f 1/1/1 2/2/2 3/3/3\n"));
    assert!(library.contains("map_Kd maps/brick wall.png\n"));
}

#[test]
fn the_same_model_gives_the_same_text() {
    assert_eq!(mixed().to_obj("mixed.mtl"), mixed().to_obj("mixed.mtl"));
    let (text, library) = steady().to_obj("steady.mtl");
    assert_eq!((text.len(), hash(text.as_bytes())), (19793, 0x13db_68c6_90b3_e77c));
    assert_eq!((library.len(), hash(library.as_bytes())), (287, 0x69ca_0fc9_9576_4415));
}

/// The OBJ file refers to the library, so it is replaced last: after an error it still fits the files beside it.
#[test]
fn an_obj_file_stays_if_its_library_cannot_be_written() {
    let folder = std::env::temp_dir().join(format!("cga-obj-order-{}", std::process::id()));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(folder.join("house.mtl")).expect("a folder where the library goes");
    let path = folder.join("house.obj");
    std::fs::write(&path, "good").expect("a file");
    let mut fill = Fill(Model::default());
    fill.quad("Wall", &color(1.0, 0.0, 0.0), front(DVec3::ZERO, 2.0, 3.0));
    let refused = || {
        let error = fill.0.write_obj(&path).expect_err("no library").to_string();
        assert!(error.starts_with("cannot write `") && error.contains("house.mtl"), "{error}");
        assert_eq!(std::fs::read(&path).expect("a file"), b"good");
        assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 2, "a temporary file is left");
    };
    refused();
    #[cfg(target_os = "linux")]
    {
        std::fs::remove_dir(folder.join("house.mtl")).expect("it goes");
        std::os::unix::fs::symlink("/dev/full", folder.join("house.mtl")).expect("a link");
        refused();
    }
    std::fs::remove_dir_all(folder).expect("it goes");
}

#[test]
fn an_image_whose_name_begins_as_an_option_is_an_image() {
    let look = Arc::new(Material::with(|look| look.set_text(MaterialText::Map(Layer::Color), "-s 2 2 wall.png")));
    let mut fill = Fill(Model::default());
    fill.quad("Wall", &look, front(DVec3::ZERO, 2.0, 3.0));
    let library = fill.0.to_obj("house.mtl").1;
    assert!(library.contains("map_Kd ./-s 2 2 wall.png\n"), "{library}");
}

/// The format has no escapes, so a name gets other characters where its own would end the line.
#[test]
fn names_do_not_end_their_lines() {
    let look = Arc::new(Material::with(|look| {
        look.name = Some("red\nv 0 0 0".into());
        look.set_text(MaterialText::Map(Layer::Color), "a wall.png\nKd 1 1 1\u{2028}x\r");
    }));
    let mut fill = Fill(Model::default());
    fill.quad("Wall", &look, front(DVec3::ZERO, 2.0, 3.0));
    let (text, library) = fill.0.to_obj(" a house #2\nv 0 0 0.mtl");
    let lines = |text: &str, key: &str| text.lines().filter(|line| line.starts_with(key)).count();
    assert!(text.starts_with("mtllib _a house _2_v 0 0 0.mtl\ns off\n"), "{text}");
    assert_eq!((lines(&text, "v "), lines(&text, "usemtl red_v_0_0_0")), (4, 1), "{text}");
    assert_eq!(lines(&library, "Kd "), 1, "{library}");
    assert!(library.contains("map_Kd a wall.png_Kd 1 1 1_x_\n"), "{library}");
    // The file beside has the name that the line has.
    let folder = std::env::temp_dir().join(format!("cga-obj-names-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    fill.0.write_obj(folder.join("my house #2.obj")).expect("files");
    let text = std::fs::read_to_string(folder.join("my house #2.obj")).expect("a file");
    let library = text.lines().next().and_then(|line| line.strip_prefix("mtllib ")).expect("the name of a library");
    assert!(library.starts_with("my house _2_") && library.ends_with(".mtl"), "{library}");
    assert!(folder.join(library).is_file());
    std::fs::remove_dir_all(folder).expect("it goes");
}

#[test]
fn files_in_one_folder_have_libraries_of_their_own() {
    let folder = std::env::temp_dir().join(format!("cga-obj-libraries-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let long = "a".repeat(250);
    let names = ["a#", "a_", "a\u{85}", "_#", "#_", &format!("{long}#"), &format!("{long}_")];
    for name in names {
        Model::default().write_obj(folder.join(format!("{name}.obj"))).expect("files");
    }
    #[cfg(target_os = "linux")]
    for byte in [0xfe, 0xff] {
        use std::os::unix::ffi::OsStrExt as _;
        let name = [b'b', byte];
        Model::default().write_obj(folder.join(std::ffi::OsStr::from_bytes(&name))).expect("files");
    }
    let files = std::fs::read_dir(&folder).expect("a folder").count();
    assert_eq!(files, 2 * (names.len() + if cfg!(target_os = "linux") { 2 } else { 0 }));
    for library in ["a_.mtl", "a__0e24a29d.mtl"] {
        assert!(folder.join(library).is_file(), "{library}");
    }
    std::fs::remove_dir_all(folder).expect("it goes");
}
