//! Writes the gallery, `docs/gallery/`: for each worked example of the reference a picture, its rules and the resulting
//! pieces. `tests/documented.rs` checks the rules, and that the pages show them.

#[path = "gallery/mod.rs"]
mod gallery;
#[path = "../tests/documented/pages/mod.rs"]
mod pages;

use std::error::Error;
use std::fs;
use std::path::Path;

use gallery::chapter::{chapters, contents};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/gallery");
    let chapters = chapters();
    for chapter in &chapters {
        fs::create_dir_all(folder.join(chapter.name))?;
        fs::write(folder.join(chapter.name).with_extension("md"), chapter.markdown())?;
        for (number, cell) in chapter.cells.iter().enumerate() {
            cell.picture().write_png(folder.join(chapter.picture(number)))?;
        }
        println!("wrote docs/gallery/{}.md with {} pictures", chapter.name, chapter.cells.len());
    }
    fs::write(folder.join("README.md"), contents(&chapters))?;
    Ok(())
}
