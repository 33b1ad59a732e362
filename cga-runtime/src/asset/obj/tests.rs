//! Each test covers one pitfall of the format.

use glam::DVec2;

use super::*;
use crate::geometry::mesh::FaceTag;
use crate::material::Color;

fn read(text: &str) -> Result<ObjFile, ObjError> {
    read_obj(text.as_bytes(), &mut |name| {
        (name == "a.mtl").then(|| b"newmtl brick\nKd 0.8 0.2 0.1\nd 0.5\nmap_Kd brick.png\nPr 0.7\n".to_vec())
    })
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn marks_continuations_and_line_ends_are_understood() {
    let file = read("\u{feff}v 0 0 0\r\nv 1 0 0\r\nv 1 1 \\\r\n 0\r\n\tv 0 1 0 # corner\r\nf 1 2 \\\n3 4\n").unwrap();
    assert_eq!(file.mesh.face(0).outer(), [0, 1, 2, 3]);
    assert!(file.warnings.is_empty());
}

#[test]
fn lines_and_points_are_left_out_and_polygons_stay() {
    let file = read(&format!("{SQUARE}l 1 2 3\np 1\nf -4 -3 -2 -1\n")).unwrap();
    assert_eq!(file.mesh.face_count(), 1);
    assert_eq!(file.mesh.face(0).outer().len(), 4);
}

#[test]
fn groups_and_materials_are_tags_of_one_mesh() {
    let text = format!(
        "mtllib a.mtl\nmtllib a.mtl\nmtllib b.mtl\n{SQUARE}v 0 0 0\nv 0 0 1\ng wall\nusemtl brick\nf 1 2 3 4\n\
         g roof\nusemtl tile\nf 5 6 2\ng wall\nf 5 4 6\n"
    );
    let file = read(&text).unwrap();
    let mesh = &file.mesh;
    assert_eq!(mesh.points().len(), 5, "equal positions are one point");
    assert_eq!(mesh.groups(), ["wall", "roof"]);
    assert_eq!(mesh.faces().map(|f| f.tag().group).collect::<Vec<_>>(), [0, 1, 0]);
    assert_eq!(mesh.faces().map(|f| f.tag().material).collect::<Vec<_>>(), [0, 1, 1]);
    let brick = &mesh.materials::<Material>()[0];
    assert_eq!(brick.color, Some(Color { r: 0.8, g: 0.2, b: 0.1 }));
    assert_eq!((brick.opacity, brick.roughness), (Some(0.5), Some(0.7)));
    assert_eq!(brick.texture.as_deref(), Some("brick.png"));
    assert_eq!(mesh.materials::<Material>()[1].name.as_deref(), Some("tile"));
    assert_eq!(file.warnings.len(), 2, "{:?}", file.warnings);
}

#[test]
fn bad_numbers_and_indices_name_their_line() {
    let line = |text: &str| match read(text).unwrap_err() {
        ObjError::Line { line, .. } => line,
        other => panic!("{other}"),
    };
    assert_eq!(line("v 0 0 nan\n"), 1);
    assert_eq!(line("v 0 0 0\nv inf 0 0\n"), 2);
    assert_eq!(line("v 1 2\n"), 1);
    assert_eq!(line("v 1 \\\n2 \\\n3\nv 1 2\n"), 4);
    for face in ["f 1 2 9", "f 1 2 0", "f 1 2 -5", "f 1/1 2/1 3/1", "f 1 2 x", "f 1//-1 2 3", "f /1 2 3"] {
        assert_eq!(line(&format!("{SQUARE}{face}\n")), 5, "{face}");
    }
    assert_eq!(line(&format!("{SQUARE}f 1 2 -9223372036854775808\n")), 5);
}

#[test]
fn texture_coordinates_survive_only_when_consistent() {
    let uvs = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
    let file = read(&format!("{SQUARE}{uvs}f 1/1 2/2 3/3 4/4\n")).unwrap();
    assert_eq!(file.mesh.uvs()[2], DVec2::ONE);
    let file = read(&format!("{SQUARE}{uvs}f 1/1 2/2 3/3\nf 1 3 4\n")).unwrap();
    assert!(file.mesh.uvs().is_empty());
    assert_eq!(file.warnings.len(), 1);
}

#[test]
fn statements_of_a_library_that_make_no_sense_are_left_out() {
    let library = b"newmtl brick\nKd 0.5\nKs 1 2\nKa\nKe x y z\nNs\nd nan?\nillum 999\nmap_Kd\nmap_d  \nbump\nPr 0.7\n";
    let text = format!("mtllib a.mtl\n{SQUARE}usemtl brick\nf 1 2 3 4\n");
    let file = read_obj(text.as_bytes(), &mut |_| Some(library.to_vec())).unwrap();
    let look = &file.mesh.materials::<Material>()[0];
    assert_eq!((look.color, look.roughness), (Some(Color::new(0.5, 0.5, 0.5)), Some(0.7)));
    assert_eq!(file.warnings, ["line 3 of the material library `a.mtl` can't be read, and 8 more"]);
}

#[test]
fn comments_end_where_their_line_does() {
    let file = read(&format!("# C:\\models\\\n{SQUARE}f 1 2 3 4 # all \\\nf 1 2 3\n")).unwrap();
    assert_eq!(file.mesh.face_count(), 2);
    let text = format!(
        "mtllib a.mtl # lib\n{SQUARE}g foo # hi\nusemtl brick\t# red\nf 1 2 3 4 # x\ng #\nf 1 2 3\ng n#1\nf 1 3 4\n"
    );
    let file = read(&text).unwrap();
    assert_eq!(file.mesh.groups(), ["foo", "n#1"]);
    assert_eq!(file.mesh.face(1).tag().group, FaceTag::NONE);
    assert_eq!(file.mesh.materials::<Material>()[0].name.as_deref(), Some("brick"));
    assert!(file.mesh.materials::<Material>()[0].color.is_some() && file.warnings.is_empty(), "{:?}", file.warnings);
}

#[test]
fn lone_carriage_returns_marks_and_capitals_are_understood() {
    let text = format!("mtllib a.mtl\n{SQUARE}usemtl brick\nf 1 2 3 4\n");
    let plain = read(&text).unwrap();
    let odd = [text.replace('\n', "\r"), format!("\u{feff}\u{feff}{text}"), text.replace("\nv ", "\nV "), {
        text.replace("\nf ", "\nF ").replace("mtllib", "MTLLIB").replace("usemtl", "UseMtl")
    }];
    for text in odd {
        let file = read(&text).unwrap();
        assert_eq!((file.mesh.points(), file.mesh.corners()), (plain.mesh.points(), plain.mesh.corners()), "{text:?}");
        assert_eq!(file.mesh.materials::<Material>(), plain.mesh.materials::<Material>());
        assert!(file.warnings.is_empty(), "{:?}", file.warnings);
    }
    let library = b"NEWMTL brick\rKD 0.5 0.25 0 # dark\rMAP_KD a.png # old\r";
    let file = read_obj(text.as_bytes(), &mut |_| Some(library.to_vec())).unwrap();
    let look = &file.mesh.materials::<Material>()[0];
    assert_eq!((look.color, look.texture.as_deref()), (Some(Color::new(0.5, 0.25, 0.0)), Some("a.png")));
}

#[test]
fn what_can_not_be_an_obj_file_is_said() {
    let wide: Vec<u8> = SQUARE.encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(read_obj(&wide, &mut |_| None).unwrap_err().to_string(), "line 1: this is UTF-16; it must be UTF-8");
    let text = format!("mtllib a.mtl\n{SQUARE}f 1 2 3\n");
    let file = read_obj(text.as_bytes(), &mut |_| Some(wide.clone())).unwrap();
    assert_eq!(file.warnings, ["the material library `a.mtl` can't be read: this is UTF-16; it must be UTF-8"]);
    let file = read("solid cube\nfacet normal 0 0 1\nendsolid\n").unwrap();
    let said = ["line 1: `solid` is not a statement of an OBJ file, and 2 more", "the file has no faces"];
    assert_eq!(file.warnings, said);
}

#[test]
fn corners_without_what_others_have_are_said() {
    let file = read(&format!("{SQUARE}vt 0 0\nf 1/1 2 3/1\n")).unwrap();
    assert!(file.mesh.uvs().is_empty());
    assert_eq!(file.warnings, ["only 0 of 1 faces have texture coordinates at every corner: all were dropped"]);
}

#[test]
fn a_library_is_asked_for_once() {
    let mut text = String::from("mtllib a.mtl\tb b.mtl \t c.mtl d.mtl\nmtllib b b.mtl\n");
    (0..1_000).for_each(|_| text.push_str("mtllib a.mtl\nmtllib c.mtl d.mtl\n"));
    text.push_str(SQUARE);
    text.push_str("f 1 2 3 4\n");
    let mut asked = Vec::new();
    let file = read_obj(text.as_bytes(), &mut |name| {
        asked.push(name.to_owned());
        ["a.mtl", "b b.mtl", "d.mtl"].contains(&name).then(|| b"newmtl m\n".to_vec())
    });
    assert_eq!(asked, ["a.mtl", "b b.mtl", "c.mtl d.mtl", "c.mtl", "d.mtl"]);
    assert_eq!(file.unwrap().warnings, ["the material library `c.mtl` was not found"]);
}

#[test]
fn look_ups_and_warnings_have_a_limit() {
    let mut text = String::from("mtllib a.mtl\n");
    for i in 0..30_000 {
        text.push_str(&format!("mtllib a.mtl\nmtllib a.mtl {i}\nmtllib {i}.mtl\nusemtl {i}\nf 1 2\n"));
    }
    text.push_str(&format!("mtllib {}\n", "x".repeat(1_000_000)));
    text.push_str(SQUARE);
    text.push_str("usemtl brick\nf 1 2 3 4\n");
    let text = text.replacen("f 1 2\n", &format!("{SQUARE}f 1 2\n"), 1);
    let mut asked = Vec::new();
    let file = read_obj(text.as_bytes(), &mut |name| {
        asked.push(name.to_owned());
        (name == "a.mtl").then(|| b"newmtl brick\nKd 1 0 0\n".to_vec())
    });
    let file = file.unwrap();
    let names_of_one = asked.iter().filter(|name| !name.contains(' ')).count();
    assert_eq!((names_of_one, asked.len()), (16, 16 + 16));
    let warnings = &file.warnings;
    assert_eq!(warnings.len(), 100);
    assert!(warnings.iter().all(|warning| warning.len() < 200));
    // Libraries that were not found, faces with two corners, materials without a library, and the look-ups that were
    // not made.
    let all = 15 + 30_000 + 30_000 + 1;
    assert_eq!(warnings[99], format!("there are {} more warnings", all - 99));
    assert_eq!(file.mesh.materials::<Material>().last().and_then(|brick| brick.color), Some(Color::new(1.0, 0.0, 0.0)));
}

#[test]
fn look_ups_beyond_the_limit_are_counted() {
    let names: Vec<String> = (0..40).map(|i| format!("{i}.mtl")).collect();
    let text = format!("mtllib {}\nmtllib 3.mtl 39.mtl\n{SQUARE}f 1 2 3 4\n", names.join(" "));
    let mut asked = 0;
    let library = &mut |name: &str| {
        asked += 1;
        (!name.contains(' ')).then(|| b"newmtl m\n".to_vec())
    };
    let warnings = read_obj(text.as_bytes(), library).unwrap().warnings;
    assert_eq!(warnings, ["the file names more than 16 material libraries: 25 more names were not looked up"]);
    assert_eq!(asked, 18);
}
