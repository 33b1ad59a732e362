//! Writes the gallery, `docs/gallery/`: scenes of our own, and for each worked example of the reference a picture, its rules
//! and the resulting pieces. The program `documented` of the tests checks the rules, and that the pages show them.
//!
//! `cargo run --release -p cga-tests --example gallery -- scenes` writes the page of the scenes alone.

use std::error::Error;
use std::fs;
use std::path::Path;

use cga::Settings;
use cga_tests::gallery::chapter::{chapters, contents};
use cga_tests::gallery::same;
use cga_tests::gallery::scenes as scene_page;
use cga_tests::scenes::{self, materials};
use cga_tests::tree::root;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = root().join("docs/gallery");
    write_scenes(&folder)?;
    if std::env::args().nth(1).as_deref() == Some("scenes") {
        return Ok(());
    }
    let chapters = chapters();
    let mut drawn = Vec::new();
    for chapter in &chapters {
        fs::create_dir_all(folder.join(chapter.name))?;
        fs::write(folder.join(chapter.name).with_extension("md"), chapter.markdown())?;
        for (number, cell) in chapter.cells.iter().enumerate() {
            let picture = cell.picture().to_indexed_png()?;
            let path = folder.join(chapter.picture(number));
            let other = drawn.iter().find(|(_, known)| *known == picture).map(|(title, _)| *title);
            if other != same::original(cell.title) {
                let (is, listed) = (other.unwrap_or("no other"), same::original(cell.title).unwrap_or("no other"));
                return Err(format!("{} looks as {is}, and tests/gallery/same.rs says {listed}", cell.title).into());
            }
            match other {
                Some(_) if path.exists() => fs::remove_file(path)?,
                Some(_) => {}
                None => {
                    fs::write(path, &picture)?;
                    drawn.push((cell.title, picture));
                }
            }
        }
        println!("wrote docs/gallery/{}.md with {} pictures", chapter.name, chapter.drawn().count());
    }
    fs::write(folder.join("README.md"), contents(&chapters))?;
    Ok(())
}

/// Writes the page of the scenes and its pictures.
fn write_scenes(folder: &Path) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder.join("scenes"))?;
    let mut list = Vec::new();
    for scene in scenes::scenes() {
        let model = scene.model_with(&Settings { assets: materials::assets(), ..Settings::default() })?;
        model.faults().iter().for_each(|fault| eprintln!("{}: {fault}", scene.name));
        let path = folder.join(scene_page::picture_path(&scene));
        fs::write(path, scene_page::picture(&scene, &model).to_indexed_png()?)?;
        list.push((scene, model));
    }
    fs::write(folder.join("scenes.md"), scene_page::markdown(&list))?;
    println!("wrote docs/gallery/scenes.md with {} pictures", list.len());
    Ok(())
}
