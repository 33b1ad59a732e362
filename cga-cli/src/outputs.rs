//! The files of a run.

use std::collections::BTreeSet;
use std::path::Path;

use cga::sink::picture::Picture;
use cga::{Batches, Model, Report, WriteError};

use crate::options::RunOptions;
use crate::stream::print;
use crate::watch::folder;

/// The kind of a file, by the ending of its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileKind {
    Glb,
    Obj,
    Png,
    Svg,
}

impl FileKind {
    /// The kind of a file.
    ///
    /// # Errors
    /// Its name has another ending.
    pub(crate) fn of(path: &Path) -> Result<Self, String> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
        match ending.as_str() {
            "glb" => Ok(FileKind::Glb),
            "obj" => Ok(FileKind::Obj),
            "png" => Ok(FileKind::Png),
            "svg" => Ok(FileKind::Svg),
            _ => Err(format!("`{}` ends in none of .glb, .obj, .png and .svg", path.display())),
        }
    }
}

/// Checks the files that a run writes.
///
/// # Errors
/// A sentence about a file with another ending, one that is given twice or is an input, or one whose folder does not exist.
pub(crate) fn check_outputs(options: &RunOptions) -> Result<(), String> {
    options.output.iter().try_for_each(|path| FileKind::of(path).map(drop))?;
    let reports = options.reports.iter().filter(|path| **path != Path::new("-"));
    let mut known = BTreeSet::new();
    for path in options.output.iter().chain(reports) {
        let shown = path.display();
        let folder = folder(path);
        if !folder.is_dir() {
            return Err(format!(
                "cannot write `{shown}`: the folder `{}` does not exist; make it first",
                folder.display()
            ));
        }
        let real =
            folder.canonicalize().unwrap_or_else(|_| folder.to_owned()).join(path.file_name().unwrap_or_default());
        let RunOptions { rules, lot, .. } = options;
        let mut inputs = std::iter::once(&rules.file).chain(&lot.footprint).chain(&lot.mesh);
        if inputs.any(|input| input.canonicalize().is_ok_and(|input| input == real)) {
            return Err(format!("`{shown}` is an input of the run; give the output another name"));
        }
        if !known.insert(real) {
            return Err(format!("`{shown}` is given twice; give each output its own name"));
        }
    }
    Ok(())
}

/// The result of a run: the model of a lot, or the models of all lots of a file.
pub(crate) enum Output {
    One(Box<Model>),
    Many(Batches<Model>),
}

impl Output {
    /// The number of its parts.
    pub(crate) fn parts(&self) -> usize {
        match self {
            Output::One(model) => model.len(),
            Output::Many(models) => models.sinks().map(Model::len).sum(),
        }
    }

    pub(crate) fn report(&self) -> &Report {
        match self {
            Output::One(model) => model.report(),
            Output::Many(models) => models.report(),
        }
    }

    /// Writes a file. A file of that name stays as it is if this fails.
    ///
    /// # Errors
    /// A sentence about the file.
    pub(crate) fn write(&self, path: &Path, (width, height): (usize, usize)) -> Result<(), String> {
        let picture = |model: &Model| Picture::new(width, height).render(model).write_png(path);
        let written = match (FileKind::of(path)?, self) {
            (FileKind::Glb, Output::One(model)) => model.write_glb(path),
            (FileKind::Glb, Output::Many(models)) => models.write_glb(path),
            (FileKind::Obj, Output::One(model)) => model.write_obj(path),
            (FileKind::Obj, Output::Many(models)) => models.write_obj(path),
            (FileKind::Png, Output::One(model)) => picture(model),
            (FileKind::Png, Output::Many(models)) => picture(&models.to_model()),
            (FileKind::Svg, Output::One(model)) => model.write_svg(path),
            (FileKind::Svg, Output::Many(models)) => models.to_model().write_svg(path),
        };
        written.map_err(|why: WriteError| why.to_string())
    }
}

/// Writes the reported values as JSON to a file, or to standard output for `-`.
///
/// # Errors
/// A sentence about the file.
pub(crate) fn write_reports(report: &Report, path: &Path) -> Result<(), String> {
    let refused = |why: &dyn std::fmt::Display| format!("cannot write the reports to `{}`: {why}", path.display());
    let mut text = serde_json::to_string_pretty(report.reports()).map_err(|why| refused(&why))?;
    text.push('\n');
    if path == Path::new("-") {
        return print(&text);
    }
    std::fs::write(path, text).map_err(|why| refused(&why))
}
