//! Textures in files and buffers: images, sets of coordinates, and missing files.

use std::path::PathBuf;
use std::sync::{Arc, Mutex};

use crate::sink_support::{Fill, color, front, upright};
use cga_runtime::asset::Assets;
use cga_runtime::geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use cga_runtime::geometry::uv_map::{SetMap, UvMap};
use cga_runtime::material::{Layer, LayerPart, Material, MaterialNumber, MaterialText};
use cga_runtime::output::buffers::{Buffers, Chunks};
use cga_runtime::output::gltf::Glb;
use cga_runtime::output::model::Model;
use cga_runtime::output::picture::{Camera, Image, Lines, Picture};
use cga_runtime::run::sink::{Flow, Leaf, Sink};
use cga_runtime::shape::scope::Scope;
use cga_runtime::value::text::Text;
use glam::{DAffine3, DVec3, dvec2, dvec3, dvec4};

/// A separate folder for each test, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str, files: &[(&str, &[u8])]) -> Self {
        let path = std::env::temp_dir().join(format!("cga-textures-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(path.join("maps")).expect("a folder");
        files.iter().for_each(|(name, bytes)| std::fs::write(path.join(name), bytes).expect("a file"));
        Folder(path)
    }

    fn assets(&self) -> Arc<Assets> {
        Arc::new(Assets::below(&self.0))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn png(width: usize, height: usize, color: [u8; 4]) -> Vec<u8> {
    Image::filled(width, height, color).to_png().expect("a file")
}

/// A square of two metres in the front, with coordinates from 0 to 1 in some sets.
fn square(sets: &[usize]) -> Arc<Mesh> {
    let mut builder = MeshBuilder::new();
    let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let corners = points.map(|[x, y]| builder.point([2.0 * x, 2.0 * y, 0.0]));
    builder.face(&corners, &[], FaceTag::PLAIN);
    for &set in sets {
        builder.uv_set(set, &points.map(|[x, y]| dvec2(x, y) * (set + 1) as f64));
    }
    Arc::new(builder.build().expect("a square"))
}

fn look(change: impl FnOnce(&mut Material)) -> Arc<Material> {
    Arc::new(Material::with(change))
}

fn map(look: &mut Material, layer: Layer, name: &str) {
    look.set_text(MaterialText::Map(layer), name);
}

/// A model of squares, and the description of its file.
fn json(model: &Model) -> String {
    let file = model.to_glb().expect("a file");
    let length = u32::from_le_bytes([file[12], file[13], file[14], file[15]]) as usize;
    String::from_utf8(file[20..20 + length].to_vec()).expect("text")
}

fn shown(assets: &Arc<Assets>, material: &Arc<Material>, sets: &[usize]) -> Model {
    let mut fill = Fill(Model::new().with_assets(assets.clone()));
    fill.mesh("Square", material, &square(sets), DAffine3::IDENTITY);
    fill.0
}

/// u along x, v along y, with a factor for each set.
fn maps(sets: &[usize]) -> Vec<SetMap> {
    let along = |set: &usize| {
        let factor = (set + 1) as f64;
        UvMap { u: dvec4(factor, 0.0, 0.0, 0.25), v: dvec4(0.0, factor, 0.0, 0.0) }
    };
    sets.iter().map(|set| SetMap { set: *set, maps: along(set).into() }).collect()
}

/// Passes a rectangle and a box with maps to a sink; `as_meshes` converts them to meshes first.
fn fill(sink: &mut impl Sink, sets: &[usize], as_meshes: bool) {
    /// Passes on meshes only.
    struct Meshes<'a, S>(&'a mut S);
    impl<S: Sink> Sink for Meshes<'_, S> {
        fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
            self.0.mesh(leaf, mesh, placement)
        }
    }
    let (material, maps) = (look(|look| look.texture = Some("builtin:uvtest.png".into())), maps(sets));
    let (quad, cuboid) = (front(dvec3(1.0, 2.0, 3.0), 4.0, 5.0), upright(dvec3(7.0, 0.0, 0.0), dvec3(1.0, 2.0, 3.0)));
    let scopes = [dvec3(4.0, 5.0, 0.0), dvec3(1.0, 2.0, 3.0)].map(Scope::new);
    let name = Text::fixed("Leaf");
    let leaf = |at: usize| Leaf::new(&name, &material, &scopes[at]).with_uvs(&maps);
    let flow = if as_meshes {
        let mut sink = Meshes(sink);
        [sink.quad(&leaf(0), &quad), sink.cuboid(&leaf(1), &cuboid)]
    } else {
        [sink.quad(&leaf(0), &quad), sink.cuboid(&leaf(1), &cuboid)]
    };
    assert!(flow.iter().all(|flow| flow.is_continue()));
}

#[test]
fn rectangles_and_boxes_have_the_coordinates_of_their_meshes() {
    let sets = [0, 2, 9];
    let (mut direct, mut meshes) = (Buffers::new(), Buffers::new());
    fill(&mut direct, &sets, false);
    fill(&mut meshes, &sets, true);
    assert_eq!(direct.vertices().len(), 28);
    for buffers in [&direct, &meshes] {
        for set in 0..11 {
            let uvs = buffers.uv_set(set);
            assert_eq!(uvs.len(), if sets.contains(&set) { 28 } else { 0 });
            for ([x, y, ..], [u, v]) in buffers.vertices().iter().zip(uvs) {
                assert_eq!([*u, *v], [x * (set + 1) as f32 + 0.25, y * (set + 1) as f32]);
            }
        }
    }
    // The model keeps the maps, and passes them on as coordinates and as meshes.
    let mut model = Model::new();
    fill(&mut model, &sets, false);
    let mut replayed = Buffers::new();
    assert!(model.replay(&mut replayed).is_continue());
    assert_eq!((replayed.uvs(), replayed.uv_set(9)), (direct.uvs(), direct.uv_set(9)));
    for leaf in model.leaves() {
        assert_eq!(leaf.uvs(), maps(&sets));
        assert_eq!(leaf.mesh().0.uv_set(2).len(), leaf.mesh().0.corners().len());
    }
    let glb = |as_meshes| {
        let mut glb = Glb::new();
        fill(&mut glb, &sets, as_meshes);
        glb.into_bytes().expect("a file").len()
    };
    assert_eq!(glb(false), glb(true));
    let mut obj = Vec::new();
    let mut writer = cga_runtime::output::obj::Obj::new(&mut obj, "x.mtl");
    fill(&mut writer, &[2], false);
    writer.finish().expect("a library");
    let text = String::from_utf8(obj).expect("text");
    assert_eq!(text.lines().filter(|line| line.starts_with("vt ")).count(), 28);
    assert!(text.contains("vt 3.25 6\n"), "{text}");
}

#[test]
fn sets_that_a_vertex_does_not_have_are_0_and_chunks_have_the_same() {
    let mut buffers = Buffers::new();
    let plain = color(1.0, 0.0, 0.0);
    let play = |sink: &mut dyn Sink| {
        let mut sink = Fill(sink);
        sink.quad("A", &plain, front(DVec3::ZERO, 1.0, 1.0));
        sink.mesh("B", &plain, &square(&[3]), DAffine3::IDENTITY);
        sink.cuboid("C", &plain, upright(DVec3::X, DVec3::ONE));
        sink.mesh("D", &plain, &square(&[0]), DAffine3::IDENTITY);
    };
    play(&mut buffers);
    assert_eq!((buffers.uvs().len(), buffers.uv_set(3).len()), (36, 36));
    assert!(buffers.uvs()[..32].iter().chain(&buffers.uv_set(3)[..4]).all(|uv| *uv == [0.0; 2]));
    assert_eq!((buffers.uv_set(3)[6], buffers.uvs()[34], buffers.uv_set(3)[34]), ([4.0; 2], [1.0; 2], [0.0; 2]));
    let (mut zero, mut third) = (Vec::new(), Vec::new());
    let mut chunks = Chunks::new(24, |chunk: &Buffers| {
        for (set, list) in [(0, &mut zero), (3, &mut third)] {
            match chunk.uv_set(set) {
                [] => list.resize(list.len() + chunk.vertices().len(), [0.0; 2]),
                uvs => list.extend_from_slice(uvs),
            }
        }
        Flow::Continue(())
    });
    play(&mut chunks);
    assert!(chunks.finish().is_continue());
    drop(chunks);
    assert_eq!((&zero[..], &third[..]), (buffers.uvs(), buffers.uv_set(3)));
}

#[test]
fn each_map_uses_its_own_set_or_set_0() {
    let folder = Folder::new("sets", &[("a.png", &png(2, 2, [9, 8, 7, 255])), ("b.png", &png(4, 4, [1, 2, 3, 255]))]);
    let assets = folder.assets();
    let material = look(|look| {
        map(look, Layer::Color, "a.png");
        map(look, Layer::Emissive, "b.png");
        map(look, Layer::Occlusion, "b.png");
        map(look, Layer::Dirt, "a.png");
    });
    let text = json(&shown(&assets, &material, &[0, 2, 5, 6]));
    for part in [
        "\"baseColorTexture\":{\"index\":0}",
        "\"emissiveTexture\":{\"index\":1,\"texCoord\":1}",
        "\"occlusionTexture\":{\"index\":1}",
    ] {
        assert!(text.contains(part), "{part} in {text}");
    }
    // Sets that no map uses are left out, and the other sets are renumbered.
    assert!(text.contains("TEXCOORD_1") && !text.contains("TEXCOORD_2"));
    assert_eq!(text.matches("\"mimeType\":\"image/png\"").count(), 2);
    // Without set 0 only the map with its own set is left.
    let text = json(&shown(&assets, &material, &[6]));
    assert!(text.contains("\"emissiveTexture\":{\"index\":0}") && !text.contains("baseColor\"Texture"), "{text}");
    assert!(!text.contains("occlusionTexture") && text.contains("TEXCOORD_0") && !text.contains("TEXCOORD_1"));
    let text = json(&shown(&assets, &material, &[]));
    assert!(!text.contains("Texture\"") && !text.contains("images"), "{text}");
}

#[test]
fn two_images_become_one_where_the_format_has_one() {
    let files: [(&str, &[u8]); 4] = [
        ("a.png", &png(2, 2, [9, 8, 7, 100])),
        ("same.png", &png(2, 2, [9, 8, 7, 100])),
        ("grey.png", &png(8, 4, [0, 77, 0, 77])),
        ("b.jpg", &[0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff, 0xc2, 0, 11, 8, 0, 2, 0, 3, 1, 1, 0x11, 0, 0xff, 0xd9]),
    ];
    let folder = Folder::new("joined", &files);
    let assets = folder.assets();
    // The file's bytes are unchanged, and stored once.
    let material = look(|look| {
        map(look, Layer::Color, "a.png");
        map(look, Layer::Opacity, "a.png");
        map(look, Layer::Emissive, "same.png");
    });
    let model = shown(&assets, &material, &[0]);
    let text = json(&model);
    assert!(text.contains("\"alphaMode\":\"BLEND\"") && text.matches("\"source\"").count() == 1, "{text}");
    let (file, image) = (model.to_glb().expect("a file"), png(2, 2, [9, 8, 7, 100]));
    assert!(file.windows(image.len()).any(|part| part == image));
    // The opacity of another, larger image.
    let material = look(|look| {
        map(look, Layer::Color, "a.png");
        map(look, Layer::Opacity, "grey.png");
        look.set_text(MaterialText::OpacityMode, "mask");
        look.set_number(MaterialNumber::Cutoff, 0.25);
    });
    let model = shown(&assets, &material, &[0]);
    assert!(json(&model).contains("\"alphaMode\":\"MASK\",\"alphaCutoff\":0.25"));
    let (file, image) = (model.to_glb().expect("a file"), png(8, 4, [9, 8, 7, 77]));
    assert!(file.windows(image.len()).any(|part| part == image));
    // A mode that ignores opacity, and an alpha channel that is not an opacity map.
    for (mode, alpha, wanted) in [("opaque", "grey.png", [9, 8, 7, 100]), ("mask", "", [9, 8, 7, 255])] {
        let material = look(|look| {
            map(look, Layer::Color, "a.png");
            map(look, Layer::Opacity, alpha);
            look.set_text(MaterialText::OpacityMode, mode);
        });
        let (file, image) = (shown(&assets, &material, &[0]).to_glb().expect("a file"), png(2, 2, wanted));
        assert!(file.windows(image.len()).any(|part| part == image), "{mode}");
    }
    let text = json(&shown(&assets, &look(|look| look.texture = Some("b.jpg".into())), &[0]));
    assert!(text.contains("\"mimeType\":\"image/jpeg\""), "{text}");
    // Roughness is green and metal is blue.
    let material = look(|look| {
        map(look, Layer::Roughness, "grey.png");
        map(look, Layer::Metallic, "a.png");
        look.metallic = Some(1.0);
    });
    let (file, image) = (shown(&assets, &material, &[0]).to_glb().expect("a file"), png(8, 4, [255, 77, 7, 255]));
    assert!(file.windows(image.len()).any(|part| part == image));
}

#[test]
fn a_missing_or_broken_image_is_a_checker_pattern() {
    let mut broken = png(2, 2, [1; 4]);
    broken.truncate(60);
    let folder = Folder::new("broken", &[("broken.png", &broken), ("other.gif", b"GIF89a")]);
    let unknown = |name: &str| {
        let material = look(|look| look.texture = Some(name.into()));
        shown(&folder.assets(), &material, &[0]).to_glb().expect("a file")
    };
    let file = unknown("builtin:unknowntexture.png");
    for name in ["broken.png", "other.gif", "none.png", "../none.png", "builtin:none"] {
        assert!(unknown(name) == file, "{name}");
    }
    assert!(unknown("builtin:uvtest.png") != file);
    // Without a folder nothing is missing: the name goes into the file.
    let material = look(|look| look.texture = Some("/maps/a b.png".into()));
    let text = json(&shown(&Arc::default(), &material, &[0]));
    assert!(text.contains("\"images\":[{\"uri\":\"maps/a%20b.png\"}]"), "{text}");
}

#[test]
fn images_can_be_referenced() {
    let folder = Folder::new("references", &[("maps/a.png", &png(2, 2, [1; 4]))]);
    let mut glb = Fill(Glb::new().with_assets(folder.assets()).with_referenced_images());
    for name in ["maps/a.png", "builtin:default"] {
        glb.mesh("A", &look(|look| look.texture = Some(name.into())), &square(&[0]), DAffine3::IDENTITY);
    }
    let file = String::from_utf8_lossy(&glb.0.into_bytes().expect("a file")).into_owned();
    assert!(file.contains("\"uri\":\"maps/a.png\"") && file.contains("\"mimeType\":\"image/png\""));
}

#[test]
fn files_share_images_by_their_addresses() {
    let same = png(2, 2, [1; 4]);
    let names = ["maps/a.png", "maps/copy.png", "maps/b.png"];
    let folder = Folder::new("shared", &[(names[0], &same), (names[1], &same), (names[2], &png(4, 4, [2; 4]))]);
    let seen = Arc::new(Mutex::new(Vec::new()));
    let list = seen.clone();
    let glb = Glb::new().with_assets(folder.assets()).with_shared_images(move |ending, bytes| {
        list.lock().expect("a list").push((ending.to_owned(), bytes.to_vec()));
        (bytes.len() == same.len()).then(|| "../shared%20images/a.png".to_owned())
    });
    let mut glb = Fill(glb);
    for name in names {
        glb.mesh("A", &look(|look| look.texture = Some(name.into())), &square(&[0]), DAffine3::IDENTITY);
    }
    let file = String::from_utf8_lossy(&glb.0.into_bytes().expect("a file")).into_owned();
    assert_eq!(file.matches("\"uri\":\"../shared%20images/a.png\"").count(), 1, "two names of one image are one image");
    assert_eq!(file.matches("\"mimeType\":\"image/png\"").count(), 1);
    let seen = seen.lock().expect("a list");
    assert_eq!(seen.iter().map(|(ending, _)| ending.as_str()).collect::<Vec<_>>(), ["png"; 3]);
    assert_eq!(seen[0].1, std::fs::read(folder.0.join(names[0])).expect("the file"));
}

#[test]
fn a_placement_is_an_extension_of_the_texture() {
    let material = look(|look| {
        look.texture = Some("builtin:uvtest.png".into());
        look.set_number(MaterialNumber::Map(Layer::Color, LayerPart::Su), 2.0);
        look.set_number(MaterialNumber::Map(Layer::Color, LayerPart::Tv), 0.25);
    });
    let text = json(&shown(&Arc::default(), &material, &[0]));
    assert!(text.contains("\"KHR_texture_transform\":{\"offset\":[0,-0.25],\"rotation\":0,\"scale\":[2,1]}"), "{text}");
    assert!(text.contains("\"EXT_structural_metadata\",\"KHR_texture_transform\"]"), "{text}");
    let (_, library) = shown(&Arc::default(), &material, &[0]).to_obj("x.mtl");
    assert!(library.contains("map_Kd -s 2 1 -o 0 0.25 builtin_uvtest.png\n"), "{library}");
}

#[test]
fn a_normal_map_comes_with_tangents() {
    let folder = Folder::new("normals", &[("n.png", &png(2, 2, [128, 128, 255, 255]))]);
    let material = look(|look| map(look, Layer::Normal, "n.png"));
    let text = json(&shown(&folder.assets(), &material, &[0, 5]));
    assert!(text.contains("\"TANGENT\"") && text.contains("\"normalTexture\":{\"index\":0,\"texCoord\":1}"), "{text}");
}

#[test]
fn a_library_has_a_word_for_each_map_and_built_in_images_beside_it() {
    let folder = Folder::new("library", &[]);
    let material = look(|look| {
        for (layer, name) in [
            (Layer::Color, "builtin:uvtest.png"),
            (Layer::Opacity, "/maps/holes.png"),
            (Layer::Bump, "b u.png"),
            (Layer::Normal, "n.png"),
            (Layer::Emissive, "e.png"),
            (Layer::Occlusion, "o.png"),
            (Layer::Roughness, "r.png"),
            (Layer::Metallic, "m.png"),
        ] {
            map(look, layer, name);
        }
        look.set_number(MaterialNumber::BumpValue, 0.5);
    });
    let path = folder.0.join("a.obj");
    shown(&folder.assets(), &material, &[0]).write_obj(&path).expect("files");
    let library = std::fs::read_to_string(folder.0.join("a.mtl")).expect("a library");
    for line in [
        "map_Kd builtin_uvtest.png",
        "map_d maps/holes.png",
        "map_Bump -bm 0.5 b u.png",
        "norm n.png",
        "map_Ke e.png",
        "map_ao o.png",
        "map_Pr r.png",
        "map_Pm m.png",
    ] {
        assert!(library.lines().any(|other| other == line), "{line} in {library}");
    }
    assert!(folder.0.join("builtin_uvtest.png").is_file());
}

/// The pixels along a side of pictures.
const SIDE: usize = 256;

/// A picture from the front of a square of 2 metres that fills nearly the whole picture.
fn picture(model: &Model, side: usize) -> Image {
    let camera = Camera { margin: 0.0, ..Camera::auto(model.bounds()) }.looking_from(0.0, 0.0).orthographic();
    let picture = Picture { lines: Lines::None, ground: false, ..Picture::new(side, side) };
    picture.camera(camera).render(model)
}

#[test]
fn a_picture_shows_the_texture_the_right_way_round() {
    let material = look(|look| look.texture = Some("builtin:uvtest.png".into()));
    let image = picture(&shown(&Arc::default(), &material, &[0]), SIDE);
    let at = |u: usize, v: usize| {
        let place = |c: usize| if c == 0 { 6 } else { SIDE - 7 };
        let [r, g, b, _] = image.pixel(place(u), SIDE - 1 - place(v)).expect("a pixel");
        let most = r.max(g).max(b);
        [r, g, b].map(|channel| u32::from(most) * 2 / 3 < u32::from(channel))
    };
    assert_eq!([at(0, 0), at(1, 0)], [[false, true, false], [false, true, true]]);
    assert_eq!([at(0, 1), at(1, 1)], [[true, false, true], [true, false, false]]);
    // A rectangle with maps looks like the mesh.
    let maps = [SetMap { set: 0, maps: UvMap { u: dvec4(0.5, 0.0, 0.0, 0.0), v: dvec4(0.0, 0.5, 0.0, 0.0) }.into() }];
    let mut model = Model::new();
    let (scope, quad) = (Scope::new(dvec3(2.0, 2.0, 0.0)), front(DVec3::ZERO, 2.0, 2.0));
    assert!(model.quad(&Leaf::new(&Text::fixed("Square"), &material, &scope).with_uvs(&maps), &quad).is_continue());
    assert!(picture(&model, SIDE) == image);
    // Without coordinates it has the colour of the material.
    let plain = picture(&shown(&Arc::default(), &material, &[]), SIDE);
    let white = picture(&shown(&Arc::default(), &Arc::default(), &[0]), SIDE);
    assert!(plain == white && plain != image);
}

#[test]
fn a_picture_is_as_transparent_as_the_opacity_map() {
    let mut half = Image::filled(2, 2, [255, 0, 0, 255]);
    half.rgba[3] = 0;
    half.rgba[11] = 0;
    let folder = Folder::new("holes", &[("half.png", &half.to_png().expect("a file"))]);
    let shades = |mode: &str| {
        let material = look(|look| {
            map(look, Layer::Color, "half.png");
            map(look, Layer::Opacity, "half.png");
            look.set_text(MaterialText::OpacityMode, mode);
        });
        let image = picture(&shown(&folder.assets(), &material, &[0]), SIDE);
        // At a transparent place of the image, and at an opaque one.
        [SIDE / 4, SIDE * 3 / 4].map(|x| {
            let [r, g, b, _] = image.pixel(x, SIDE / 2).expect("a pixel");
            r / 2 > g.max(b)
        })
    };
    assert_eq!(shades("mask"), [false, true]);
    assert_eq!(shades("blend"), [false, true]);
    assert_eq!(shades("opaque"), [true, true]);
}

#[test]
fn no_coordinates_or_images_are_too_odd_to_be_drawn() {
    let folder =
        Folder::new("odd", &[("one.png", &png(1, 1, [200, 100, 50, 128])), ("long.png", &png(300, 1, [1; 4]))]);
    for name in ["one.png", "long.png", "builtin:uvtest.png"] {
        let material = look(|look| {
            map(look, Layer::Color, name);
            map(look, Layer::Opacity, "one.png");
            look.set_number(MaterialNumber::Map(Layer::Color, LayerPart::Su), 1e25);
        });
        for scale in [1e-300, 1e9, -1e9, 1e300] {
            let mut builder = MeshBuilder::new();
            let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
            let corners = points.map(|[x, y]| builder.point([x, y, 0.0]));
            builder.face(&corners, &[], FaceTag::PLAIN).uvs(&points.map(|[x, y]| dvec2(x * scale, y * scale)));
            let mut fill = Fill(Model::new().with_assets(folder.assets()));
            fill.mesh("A", &material, &Arc::new(builder.build().expect("a square")), DAffine3::IDENTITY);
            assert_eq!(picture(&fill.0, 24).rgba.len(), 4 * 24 * 24);
            let _ = fill.0.to_glb();
        }
    }
}
