//! `color`, `texture`, `setMaterial` and `resetMaterial`.

use std::sync::Arc;

use crate::asset::AssetError;
use crate::fault::FaultKind;
use crate::func;
use crate::geometry::obj::escaped;
use crate::material::layer::UNKNOWN_TEXTURE;
use crate::material::{Color, Layer, Material, MaterialNumber, MaterialText};
use crate::op::set;
use crate::run::env::Env;
use crate::shape::{Geometry, Placed, Shape};
use crate::value::array::Array;
use crate::value::shown::shown;
use crate::value::text::Text;

/// `color("#rrggbb")` or `color("#rrggbboo")` (*color operation*). The short form keeps the opacity.
pub fn color_hex(env: &mut Env, shape: &mut Shape, hex: Text) {
    match parse_hex(&hex) {
        Some((color, opacity)) => set::change_material(env, shape, |material| {
            material.color = Some(color);
            material.opacity = opacity.or(material.opacity);
        }),
        None => env.fault(
            FaultKind::Value,
            format!("`{}` is not a colour like \"#ff8000\"; the old colour stays", shown(&hex)),
        ),
    }
}

/// `color(r, g, b)`, each in 0..=1 (*color operation*).
pub fn color_rgb(env: &mut Env, shape: &mut Shape, r: f64, g: f64, b: f64) {
    let color = finite_color(env, r, g, b);
    set::change_material(env, shape, |material| material.color = Some(color));
}

/// `color(r, g, b, opacity)`, each in 0..=1 (*color operation*).
pub fn color_rgba(env: &mut Env, shape: &mut Shape, r: f64, g: f64, b: f64, opacity: f64) {
    let color = finite_color(env, r, g, b);
    let opacity = env.finite(opacity, "opacity").clamp(0.0, 1.0);
    set::change_material(env, shape, |material| (material.color, material.opacity) = (Some(color), Some(opacity)));
}

/// `opacity(f)`, an old spelling of `set(material.opacity, f)` (*opacity operation*, 2019.1).
pub fn opacity(env: &mut Env, shape: &mut Shape, value: f64) {
    set::material_opacity(env, shape, value);
}

/// `texture(file)`: sets the colour map (*texture operation*). A file with an alpha channel
/// also becomes the opacity map; otherwise the opacity map is reset. Without an asset folder, a fault: sinks that show images show a
/// checker pattern, and files name the image. Empty text removes the colour map, with a fault: it is not the name of a file.
pub fn texture(env: &mut Env, shape: &mut Shape, file: Text) {
    if file.is_empty() {
        let instead = "`set(material.colormap, \"\")` removes a texture without this fault";
        env.image_fault(format!("`texture` has no file: its name is empty, and the shape has no texture; {instead}"));
    }
    let (file, has_alpha) = image(env, Layer::Color, file);
    set::change_material(env, shape, |material| {
        let opacity = MaterialText::Map(Layer::Opacity);
        if has_alpha {
            material.set_text(opacity, file.clone());
        } else if material.text(opacity).is_some() {
            material.set_text(opacity, Text::default());
        }
        material.texture = Some(file);
    });
}

/// The image name for a layer of a material, and true if the image has an alpha channel. A missing file is a fault and becomes
/// `builtin:unknowntexture.png` (*CGA changelog*). A broken file is a fault and keeps its name, and so does every file without an asset
/// folder: the program may have it elsewhere. Only in colours and opacities the fault promises a checker pattern. As normals or roughness
/// it would spoil the light, so a shape is shown without such a map.
pub(crate) fn image(env: &mut Env, layer: Layer, file: Text) -> (Text, bool) {
    if file.is_empty() {
        return (file, false);
    }
    let why = match env.settings.assets.image_header(&file) {
        Ok(header) => return (file, header.has_alpha),
        Err(why) => why,
    };
    let instead = match layer.shows_checkers() {
        true => "a checker pattern takes its place",
        false => "the shape is shown without it",
    };
    env.image_fault(format!("`{}` cannot be shown: {why}; {instead}", escaped(&file)));
    use AssetError::{Broken, Format, NoFolder, TooLong};
    let keeps_name = matches!(why, Format(_) | Broken(_) | TooLong { .. } | NoFolder) && !file.starts_with("builtin:");
    (if keeps_name { file } else { Text::fixed(UNKNOWN_TEXTURE) }, false)
}

/// `setMaterial(material)`: attributes by name, without `material.`, each followed by its value as text (*setMaterial
/// operation*). It does the same as setting each alone. An unknown name, and a name without a value, is a fault.
pub fn set_material(env: &mut Env, shape: &mut Shape, material: Array<Text>) {
    let (pairs, rest) = material.as_slice().as_chunks::<2>();
    for [name, value] in pairs {
        if let Some(which) = MaterialNumber::named(name) {
            set::material_number(env, shape, which, func::text_to_float(value.clone()));
        } else if let Some(which) = MaterialText::named(name) {
            set::material_text(env, shape, which, value.clone());
        } else if name.as_str() == "color.rgb" {
            color_hex(env, shape, value.clone());
        } else if name.as_str() == "doubleSided" {
            set::material_double_sided(env, shape, func::text_to_bool(value.clone()));
        } else {
            env.fault(FaultKind::Value, format!("`{}` is not an attribute of a material; it is ignored", shown(name)));
        }
    }
    for name in rest {
        env.fault(FaultKind::Value, format!("`setMaterial` has no value for `{}`; it is ignored", shown(name)));
    }
}

/// The material that `resetMaterial` resets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MaterialTarget {
    /// The attributes set by rules.
    Shape,
    /// The material of the geometry.
    Geometry,
    /// Both.
    All,
}

/// `resetMaterial(shape | geometry | all)`: restores the defaults (*resetMaterial operation*).
pub fn reset_material(env: &mut Env, shape: &mut Shape, target: MaterialTarget) {
    if target != MaterialTarget::Geometry && *shape.material() != Material::UNSET {
        set::change_material(env, shape, |material| *material = Material::UNSET);
    }
    if target == MaterialTarget::Shape || shape.own_material().is_none() {
        return;
    }
    let Geometry::Mesh(placed) = &shape.geometry else { return };
    if env.count_vertices(&placed.mesh).is_break() {
        return;
    }
    let mesh = Arc::new(placed.mesh.without_materials());
    shape.geometry = Geometry::Mesh(Arc::new(Placed { mesh, ..Placed::clone(placed) }));
}

fn finite_color(env: &mut Env, r: f64, g: f64, b: f64) -> Color {
    Color::new(env.finite(r, "red"), env.finite(g, "green"), env.finite(b, "blue"))
}

/// The channels of `#rrggbb` or `#rrggbboo`.
fn parse_hex(hex: &str) -> Option<(Color, Option<f64>)> {
    let digits = hex.strip_prefix('#')?;
    if !matches!(digits.len(), 6 | 8) || !digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return None;
    }
    let channel = |at: usize| digits.get(at..at + 2).and_then(|pair| u8::from_str_radix(pair, 16).ok());
    let part = |at: usize| channel(at).map(|byte| f64::from(byte) / 255.0);
    Some((Color { r: part(0)?, g: part(2)?, b: part(4)? }, part(6)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::mesh::{FaceTag, Mesh, MeshBuilder};
    use crate::query::get;
    use crate::shape::Shape;

    fn texts(list: &[&'static str]) -> Array<Text> {
        list.iter().map(|text| Text::fixed(text)).collect()
    }

    /// A triangle with its own material.
    fn own() -> Shape {
        let mut builder = MeshBuilder::new();
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|p| builder.point(p));
        builder.face(&corners, &[], FaceTag { material: 0, ..FaceTag::PLAIN });
        let mut look = Material { color: Some(Color::new(0.2, 0.4, 0.6)), ..Material::UNSET };
        look.set_text(MaterialText::Map(Layer::Dirt), "dirt.png");
        builder.materials([look]);
        Shape::mesh_axis_aligned(builder.build().expect("a triangle"))
    }

    #[test]
    fn materials_are_set_by_name() {
        // *setMaterial operation*, example 1.
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 1.0, 1.0));
        let list = ["color.r", "1.0", "color.g", "0.0", "color.b", "0.0", "opacitymap", "builtin:default"];
        set_material(env, shape, texts(&list));
        assert_eq!(get::material_color_rgb(shape).as_str(), "#ff0000");
        assert_eq!(get::material_opacitymap(shape).as_str(), "builtin:default");
        let list = ["doubleSided", "false", "color.rgb", "#00ff00", "shininess", "200", "opacitymap.mode", "mask"];
        set_material(env, shape, texts(&list));
        assert_eq!((get::material_double_sided(shape), get::material_shininess(shape)), (false, 128.0));
        assert_eq!(get::material_color_rgb(shape).as_str(), "#00ff00");
        assert_eq!(env.take_faults().0.len(), 0);
        set_material(env, shape, texts(&["opacitymap.mode", "odd", "nothing", "1", "opacity", "x", "name"]));
        assert_eq!(env.take_faults().0.len(), 4);
        assert_eq!((get::material_opacitymap_mode(shape).as_str(), get::material_opacity(shape)), ("mask", 0.0));
        texture(env, shape, "wall.png".into());
        assert_eq!(
            (get::material_colormap(shape).as_str(), get::material_opacitymap(shape).as_str()),
            ("wall.png", "")
        );
        set_material(env, shape, Array::default());
        reset_material(env, shape, MaterialTarget::Shape);
        assert_eq!(shape.material(), &Material::UNSET);
    }

    #[test]
    fn a_texture_with_an_alpha_channel_is_an_opacity_map_too() {
        // *texture operation*: set if the texture contains an alpha channel, reset to an empty string otherwise.
        let folder = std::env::temp_dir().join(format!("cga-alpha-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let png = |kind: u8| {
            let head = [&b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x01\0\0\0\x01\x08"[..], &[kind, 0, 0, 0, 0, 0, 0, 0]]
                .concat();
            [&head[..], b"\0\0\0\0IEND\0\0\0\0"].concat()
        };
        // 4096 x 4096 pixels.
        let bomb = [&png(2)[..16], &[0, 0, 16, 0, 0, 0, 16, 0], &png(2)[24..]].concat();
        let files =
            [("clear.png", png(6)), ("solid.png", png(2)), ("early.png", png(2)[..30].to_vec()), ("bomb.png", bomb)];
        files.iter().for_each(|(name, bytes)| std::fs::write(folder.join(name), bytes).expect("a file"));
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 1.0, 1.0));
        // Without a folder no file is read, and files name the image.
        texture(env, shape, "clear.png".into());
        assert_eq!(
            (get::material_colormap(shape).as_str(), get::material_opacitymap(shape).as_str()),
            ("clear.png", "")
        );
        let fault = env.take_faults().0[0].to_string();
        assert!(fault.starts_with("`clear.png` cannot be shown: no asset folder is set"), "{fault}");
        env.settings.assets = Arc::new(crate::asset::Assets::below(&folder));
        let mut maps = |name: &str| {
            texture(env, shape, name.into());
            let faults: Vec<String> = env.take_faults().0.iter().map(|fault| fault.message.clone()).collect();
            let [color, opacity] = [get::material_colormap(shape), get::material_opacitymap(shape)];
            (color.to_string(), opacity.to_string(), faults.join("; "))
        };
        let texts = |color: &str, opacity: &str, fault: &str| (color.to_owned(), opacity.to_owned(), fault.to_owned());
        assert_eq!(maps("clear.png"), texts("clear.png", "clear.png", ""));
        assert_eq!(maps("solid.png"), texts("solid.png", "", ""));
        assert_eq!(maps("clear.png"), texts("clear.png", "clear.png", ""));
        assert_eq!(maps("builtin:uvtest.png"), texts("builtin:uvtest.png", "", ""));
        let fault = "`early.png` cannot be shown: the image ends early; a checker pattern takes its place";
        assert_eq!(maps("early.png"), texts("early.png", "", fault));
        let why = "its 45 bytes cannot hold an image of 4096 x 4096 pixels";
        let fault = format!("`bomb.png` cannot be shown: {why}; a checker pattern takes its place");
        assert_eq!(maps("bomb.png"), texts("bomb.png", "", &fault));
        for name in ["none.png", "../none.png", "builtin:none.png"] {
            let (color, opacity, fault) = maps(name);
            assert_eq!((color.as_str(), opacity.as_str()), ("builtin:unknowntexture.png", ""));
            assert!(fault.starts_with(&format!("`{name}` cannot be shown")), "{fault}");
        }
        let (color, opacity, fault) = maps("");
        assert_eq!((color.as_str(), opacity.as_str()), ("", ""));
        assert!(fault.starts_with("`texture` has no file: its name is empty"), "{fault}");
        set::material_normalmap(env, shape, "none.png".into());
        set::material_normalmap(env, shape, "none.png".into());
        let (faults, _) = env.take_faults();
        assert_eq!((faults.len(), faults[0].count), (1, 1));
        let _ = std::fs::remove_dir_all(&folder);
    }

    #[test]
    fn names_in_faults_stay_on_their_line() {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 1.0, 1.0));
        env.settings.assets = Arc::new(crate::asset::Assets::below("no-such-folder"));
        let name = "a\n\u{1b}[2J`b";
        texture(env, shape, name.into());
        color_hex(env, shape, name.into());
        set_material(env, shape, Array::from([Text::from(name), "1".into(), name.into()]));
        set::material_opacitymap_mode(env, shape, name.into());
        crate::op::insert(env, shape, crate::asset::File::from(name));
        crate::query::read_text_file(env, crate::asset::File::from(name));
        crate::func::color_ramp(env, name.into(), 0.0);
        let (faults, _) = env.take_faults();
        assert_eq!(faults.len(), 8);
        for fault in faults {
            let said = fault.to_string();
            assert!(said.contains(r"`a\n\u{1b}[2J\`b`") && !said.contains(char::is_control), "{said}");
        }
    }

    #[test]
    fn unset_attributes_are_those_of_the_geometry_until_they_are_reset() {
        let (env, shape) = (&mut Env::for_tests(), &mut own());
        assert_eq!((get::material_color_g(shape), get::material_dirtmap(shape).as_str()), (0.4, "dirt.png"));
        set::material_color_r(env, shape, 1.5);
        assert_eq!(shape.material().color, Some(Color::new(1.0, 0.4, 0.6)));
        reset_material(env, shape, MaterialTarget::Geometry);
        assert_eq!((get::material_color_r(shape), get::material_dirtmap(shape).as_str()), (1.0, ""));
        let shape = &mut own();
        set::material_dirtmap(env, shape, "other.png".into());
        reset_material(env, shape, MaterialTarget::All);
        assert_eq!((get::material_color_g(shape), get::material_dirtmap(shape).as_str()), (1.0, ""));
        assert_eq!(shape.to_mesh().check(), []);
        let shape = &mut Shape::mesh_axis_aligned(Mesh::default());
        env.take_faults();
        reset_material(env, shape, MaterialTarget::All);
        assert_eq!(env.take_faults().0.len(), 0);
    }

    #[test]
    fn hex_colours_are_read_or_refused() {
        assert_eq!(parse_hex("#ff0000"), Some((Color { r: 1.0, g: 0.0, b: 0.0 }, None)));
        assert_eq!(parse_hex("#84C0fC00").and_then(|(_, opacity)| opacity), Some(0.0));
        for bad in ["", "#", "ff0000", "#ff00", "#gg0000", "#ff00001", "#é0000", "#+f0000"] {
            assert_eq!(parse_hex(bad), None, "{bad}");
        }
    }
}
