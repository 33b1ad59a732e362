//! `getMaterial` and `readMaterial`.

use super::file::read_text;
use super::file_table;
use crate::asset::{AssetError, File};
use crate::func::{bool_to_text, float_to_text};
use crate::geometry::small_sort::sort_owned_by;
use crate::material::{MATERIAL_NUMBERS, MATERIAL_TEXTS, Material, MaterialText};
use crate::run::env::Env;
use crate::shape::Shape;
use crate::value::array::Array;
use crate::value::text::Text;

/// The material that `getMaterial` reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MaterialSource {
    /// The visible material: attributes set by rules over the attributes of the geometry.
    Used,
    /// The attributes set by rules.
    Shape,
    /// The material of the geometry; if there are several, the first.
    Geometry,
}

/// The attributes that `getMaterial` reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MaterialMode {
    /// The attributes that are set.
    Changed,
    /// All attributes, with their defaults.
    All,
}

/// `getMaterial(used | shape | geometry, changed | all)`: a row with name and value for each attribute, sorted by
/// name (*getMaterial function*). `setMaterial` takes this array.
pub fn get_material(env: &mut Env, shape: &Shape, source: MaterialSource, mode: MaterialMode) -> Array<Text> {
    let own = || shape.own_material().unwrap_or(&Material::UNSET);
    let material = match source {
        MaterialSource::Shape => shape.material().clone(),
        MaterialSource::Geometry => own().clone(),
        MaterialSource::Used => shape.material().over(own()),
    };
    table(env, rows(&material, mode == MaterialMode::All))
}

/// Names and values of a material, sorted by name: the attributes that are set, or all.
fn rows(material: &Material, all: bool) -> Vec<[Text; 2]> {
    let mut rows: Vec<[Text; 2]> = Vec::new();
    // The deprecated name is a synonym of `opacity`.
    for (name, which) in MATERIAL_NUMBERS.iter().filter(|(name, _)| *name != "color.a") {
        let value = material.number(*which).or_else(|| all.then(|| which.default_value()));
        rows.extend(value.map(|value| [Text::fixed(name), float_to_text(value)]));
    }
    for (name, which) in MATERIAL_TEXTS {
        let value = material.text(*which).cloned().or_else(|| all.then(|| Text::fixed(which.default_value())));
        rows.extend(value.map(|value| [Text::fixed(name), value]));
    }
    let sides = material.double_sided.or_else(|| all.then_some(true));
    rows.extend(sides.map(|sides| [Text::fixed("doubleSided"), bool_to_text(sides)]));
    sort_owned_by(&mut rows, Ord::cmp);
    rows
}

/// The rows as an array, if the run may hold it.
fn table(env: &mut Env, rows: Vec<[Text; 2]>) -> Array<Text> {
    if !env.may_hold(2 * rows.len()) {
        return Array::default();
    }
    Array::from(rows.into_iter().map(Vec::from).collect::<Vec<_>>())
}

/// `readMaterial(file)`: a row with name and value for each attribute in a file, as `getMaterial` gives them (*readMaterial function*).
/// `setMaterial` takes this array. An `.mtl` file gives its first material. A `.cgamat` file is a table with the rows of
/// `getMaterial(used, changed)`, in its order. Images are relative to the file. If the file cannot be read, an empty array with a fault.
pub fn read_material(env: &mut Env, file: File) -> Array<Text> {
    if let Some(known) = env.kept.tables.get(&file) {
        return known.clone();
    }
    let is_table = file.name.rsplit_once('.').is_some_and(|(_, end)| end.eq_ignore_ascii_case("cgamat"));
    let is_library = file.name.rsplit_once('.').is_some_and(|(_, end)| end.eq_ignore_ascii_case("mtl"));
    let found = match (is_table, is_library) {
        (true, _) => read_text(env, &file, "cgamat").map(|text| listed(env, &file, &text)),
        (_, true) => env.settings.assets.library(&file).map(|material| rows(&material, false)),
        _ => Err(AssetError::Format("only MTL and CGAMAT files can be read")),
    };
    let found = found.unwrap_or_else(|why| {
        env.asset_fault(format!("`{file}` cannot be read: {why}; it gives no material"));
        Vec::new()
    });
    let material = table(env, found);
    env.keep_table(file, &material);
    material
}

/// The rows of a table of attributes, with image names relative to the asset folder. Spaces around cells do not count, and rows without a
/// name are left out.
fn listed(env: &Env, file: &File, text: &str) -> Vec<[Text; 2]> {
    let row = |cells: Vec<Text>| {
        let cell = |number: usize| Text::from(cells.get(number).map_or("", |cell: &Text| cell.trim()));
        let (name, value) = (cell(0), cell(1));
        let is_image = matches!(MaterialText::named(&name), Some(MaterialText::Map(_)));
        let value = if is_image { env.settings.assets.image_beside(file, &value) } else { value };
        (!name.is_empty()).then_some([name, value])
    };
    file_table::rows(text).into_iter().filter_map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::op;
    use crate::shape::Shape;

    #[test]
    fn a_material_is_read_as_the_reference_shows_it() {
        // *getMaterial function*, example 1.
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 1.0, 1.0));
        op::color_rgb(env, shape, 0.5, 0.6, 0.7);
        let changed = get_material(env, shape, MaterialSource::Used, MaterialMode::Changed);
        assert_eq!(changed.to_string(), "(3x2)\n   color.b   0.7\n   color.g   0.6\n   color.r   0.5");
        assert!(get_material(env, shape, MaterialSource::Geometry, MaterialMode::Changed).is_empty());
    }

    #[test]
    fn what_is_read_can_be_set() {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 1.0, 1.0));
        let all = get_material(env, shape, MaterialSource::Shape, MaterialMode::All);
        assert_eq!((all.rows(), all.columns()), (12 + 7 + 50 + 13 + 1, 2));
        op::set_material(env, shape, all.clone());
        assert_eq!(env.take_faults().0.len(), 0);
        assert_eq!(get_material(env, shape, MaterialSource::Shape, MaterialMode::Changed), all);
        op::reset_material(env, shape, op::MaterialTarget::Shape);
        assert!(get_material(env, shape, MaterialSource::Shape, MaterialMode::Changed).is_empty());
    }

    #[test]
    fn a_material_file_is_a_table_or_a_library() {
        let files: [(&'static str, &'static [u8]); 5] = [
            (
                "glass/glass.cgamat",
                b"color.r,0.5\nname, Glass\ncolormap, images/pane.png\nbumpmap,none.png\n,1\nopacity, 0.25\n",
            ),
            ("glass/images/pane.png", b""),
            ("wood.mtl", b"newmtl Oak\nKd 0.5 0.25 1\nmap_Kd glass/images/pane.png\nnewmtl Ash\nKd 1 1 1\n"),
            ("empty.mtl", b"# nothing"),
            ("wood.txt", b"color.r,1"),
        ];
        let assets = crate::asset::Assets::from_source(std::collections::BTreeMap::from(files));
        let settings = crate::run::settings::Settings {
            assets: std::sync::Arc::new(assets),
            ..crate::run::settings::Settings::default()
        };
        let (env, shape) =
            (&mut Env::with_names(&settings, &[], &Shape::rectangle(1.0, 1.0), ""), &mut Shape::cuboid(1.0, 1.0, 1.0));
        let glass = read_material(env, "glass/glass.cgamat".into());
        let cells: Vec<&str> = glass.as_slice().iter().map(Text::as_str).collect();
        let image = "/glass/images/pane.png";
        let expected = ["color.r", "0.5", "name", "Glass", "colormap", image, "bumpmap", "none.png", "opacity", "0.25"];
        assert_eq!((cells, glass.columns()), (expected.to_vec(), 2));
        op::set_material(env, shape, glass);
        assert_eq!(shape.material().opacity, Some(0.25));
        #[cfg(feature = "obj")]
        {
            let wood = read_material(env, "wood.mtl".into());
            let cells: Vec<&str> = wood.as_slice().iter().map(Text::as_str).collect();
            assert_eq!(cells, ["color.b", "1", "color.g", "0.25", "color.r", "0.5", "colormap", image, "name", "Oak"]);
        }
        assert!(env.take_faults().0.iter().all(|fault| fault.message.contains(".png")), "the images are empty");
        for name in ["empty.mtl", "wood.txt", "none.cgamat", "wood"] {
            assert!(read_material(env, name.into()).is_empty());
            assert_eq!(env.take_faults().0.len(), 1, "{name}");
        }
    }
}
