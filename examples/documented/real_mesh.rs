//! A mesh from a file, inserted and cut, with its pieces pulled apart.

use std::error::Error;
use std::path::Path;
use std::sync::Arc;

use cga::sink::picture::Camera;
use cga::{Assets, Model, Settings, Shape, cga};

use crate::pages::meshes;
use crate::sheet::Cell;

cga! {
    grammar Cut = r##"
attr file = ""
attr pieces = 6

@StartRule
Whole --> s(0,0,0) i(file)
          color("#c9b79c") Whole.

# Across the longer side of the ground.
@StartRule
Slices --> s(0,0,0) i(file)
           Across
Across --> case scope.sx < scope.sz :
              split(z) { ~scope.sz/pieces : t(0, 0, 0.9*split.index*scope.sz) Colour(split.index) }*
          else :
              split(x) { ~scope.sx/pieces : t(0.9*split.index*scope.sx, 0, 0) Colour(split.index) }*

@StartRule
Layers --> s(0,0,0) i(file)
           split(y) { ~scope.sy/pieces : t(0, 0.9*split.index*scope.sy, 0) Colour(split.index) }*

Colour(n) --> case n % 3 == 0 : color("#d98c5f") Piece.
              case n % 3 == 1 : color("#c9b79c") Piece.
              else            : color("#7f9f8f") Piece.
"##;
}

/// The mesh before the cut, and cut along the ground and upwards. Without a path, a ball.
pub(crate) fn cells(path: Option<&Path>) -> Result<Vec<Cell>, Box<dyn Error>> {
    let (assets, file) = match path {
        Some(path) => {
            let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
            let name = path.file_name().and_then(|name| name.to_str()).ok_or("the path ends in no file name")?;
            (Assets::below(folder), name.to_owned())
        }
        None => (Assets::new().with("ball", meshes::sphere(32, 24, 1.0)), "ball".to_owned()),
    };
    let assets = Arc::new(assets);
    let rules = Cut { file: file.clone(), ..Cut::default() };
    let run = |start: &str| -> Result<Model, cga::Error> {
        let settings = Settings { start: Some(start.into()), assets: assets.clone(), ..Settings::default() };
        rules.generate_with(&Shape::rectangle(1.0, 1.0), &settings)
    };
    let cell = |start: &str, azimuth: f64, elevation: f64| -> Result<Cell, Box<dyn Error>> {
        let model = run(start)?;
        for fault in model.faults() {
            eprintln!("{file}: {fault}");
        }
        let closed = model.leaves().filter(|leaf| leaf.mesh().0.is_closed()).count();
        let caption =
            format!("{file}, {start}: {closed} of {} pieces closed, together {:.6} m3", model.len(), model.volume());
        let camera = Camera::auto(model.bounds()).looking_from(azimuth, elevation);
        Ok(Cell { model, camera, borders: false, caption })
    };
    Ok(vec![
        cell("Whole", -40.0, 18.0)?,
        cell("Layers", -40.0, 34.0)?,
        cell("Slices", -40.0, 18.0)?,
        cell("Slices", 130.0, 18.0)?,
    ])
}
