//! The initial shapes of a run.

use std::io::Read as _;
use std::path::Path;

use cga::{Assets, Grammar, Mesh, Shape};

use crate::footprints::{self, Notes};
use crate::options::LotOptions;
use crate::path::folder;
use crate::problem::Problem;
use crate::stream::say;

/// The width and the depth of a lot that is not given, in metres.
const USUAL: (f64, f64) = (20.0, 15.0);

/// The initial shapes of a run.
#[derive(Debug)]
pub(crate) struct Lots {
    pub(crate) shapes: Vec<Shape>,
    /// True if each row of the file is a lot with the values that the file has.
    pub(crate) are_whole: bool,
}

/// The initial shapes, with seeds from `seed` on. Notes about the rows of a file are written to standard error.
///
/// # Errors
/// A file that cannot be used, or that has no lot.
pub(crate) fn lots(options: &LotOptions, grammar: &dyn Grammar, seed: u64) -> Result<Lots, Problem> {
    let unread = |path: &Path, why: String| Problem::unusable(format!("cannot read `{}`: {why}", path.display()));
    if let Some(path) = &options.footprint {
        let text = text(path).map_err(|why| unread(path, why))?;
        let mut notes = Notes::default();
        let shapes = footprints::lots(&text, grammar, seed, &mut notes).map_err(|why| unread(path, why))?;
        if shapes.is_empty() {
            let notes: String = notes.list.iter().map(|note| format!("\n  {note}")).collect();
            return Err(Problem::failed(format!("`{}` has no polygon that can be a lot{notes}", path.display())));
        }
        notes.list.iter().for_each(|note| say(format_args!("{}: {note}", path.display())));
        return Ok(Lots { shapes, are_whole: !notes.has_mistakes });
    }
    let shape = match &options.mesh {
        Some(path) => Shape::mesh(mesh(path).map_err(|why| unread(path, why))?),
        None => {
            let (width, depth) = options.lot.unwrap_or(USUAL);
            Shape::rectangle(width, depth)
        }
    };
    Ok(Lots { shapes: vec![shape.seed(seed)], are_whole: true })
}

/// The most bytes of a file of lots.
const MOST_BYTES: u64 = 1 << 30;

/// The text of a file of lots. A device may never end.
fn text(path: &Path) -> Result<String, String> {
    let file = std::fs::File::open(path).map_err(|why| why.to_string())?;
    let mut text = String::new();
    let read = file.take(MOST_BYTES + 1).read_to_string(&mut text).map_err(|why| why.to_string())?;
    if MOST_BYTES < read as u64 {
        return Err("it has more than 1 GB; divide it into several files".to_owned());
    }
    Ok(text)
}

/// The mesh of a file, with its materials.
fn mesh(path: &Path) -> Result<Mesh, String> {
    let name = path.file_name().ok_or("it is not a file")?;
    let name = name.to_str().ok_or("its name is not valid UTF-8; rename the file")?;
    let mesh = Assets::below(folder(path)).mesh(name).map_err(|why| why.to_string())?;
    if mesh.face_count() == 0 {
        return Err("it has no faces, so there is nothing to build on".to_owned());
    }
    Ok(Mesh::clone(&mesh))
}
