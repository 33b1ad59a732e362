//! The files of a run.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use cga::sink::picture::Picture;
use cga::sink::write_file;
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
    let files = written(options);
    for path in &files {
        let folder = folder(path);
        if !folder.is_dir() {
            let (path, folder) = (path.display(), folder.display());
            return Err(format!("cannot write `{path}`: the folder `{folder}` does not exist; make it first"));
        }
    }
    let RunOptions { rules, lot, .. } = options;
    check_inputs(options, std::iter::once(&rules.file).chain(&lot.footprint).chain(&lot.mesh))?;
    let mut known = BTreeSet::new();
    match files.iter().find(|path| !known.insert(real(path))) {
        Some(twice) => Err(format!("`{}` is given twice; give each output its own name", twice.display())),
        None => Ok(()),
    }
}

/// Checks that a run writes over none of its inputs.
///
/// # Errors
/// A sentence about a file that is written and is one of the inputs.
pub(crate) fn check_inputs<'i>(
    options: &RunOptions,
    inputs: impl IntoIterator<Item = &'i PathBuf>,
) -> Result<(), String> {
    let inputs: BTreeSet<PathBuf> = inputs.into_iter().filter_map(|input| input.canonicalize().ok()).collect();
    match written(options).iter().find(|path| inputs.contains(&real(path))) {
        Some(path) => Err(format!("`{}` is an input of the run; give the output another name", path.display())),
        None => Ok(()),
    }
}

/// The files that a run writes. The materials of an OBJ file are beside it.
fn written(options: &RunOptions) -> Vec<PathBuf> {
    let materials = options.output.iter().filter(|path| FileKind::of(path) == Ok(FileKind::Obj));
    let materials = materials.map(|path| path.with_extension("mtl"));
    let reports = options.reports.iter().filter(|path| **path != Path::new("-"));
    options.output.iter().chain(reports).cloned().chain(materials).collect()
}

/// The path of a file without links. A file that does not exist has a folder that may.
fn real(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| {
        let folder = folder(path);
        folder.canonicalize().unwrap_or_else(|_| folder.to_owned()).join(path.file_name().unwrap_or_default())
    })
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

/// Writes the reported values as JSON to a file, or to standard output for `-`. A file of that name stays as it is if this fails.
///
/// # Errors
/// A sentence about the file.
pub(crate) fn write_reports(report: &Report, path: &Path) -> Result<(), String> {
    let text = serde_json::to_string_pretty(report.reports());
    let mut text = text.map_err(|why| format!("cannot write the reports to `{}`: {why}", path.display()))?;
    text.push('\n');
    if path == Path::new("-") {
        return print(&text);
    }
    write_file(path, text.as_bytes()).map_err(|why| why.to_string())
}
