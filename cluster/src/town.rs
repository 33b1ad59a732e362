//! A town of made-up outlines, for a first try.

use std::path::{Path, PathBuf};

use cga_geo::synthetic::Town;

/// The rules of the town.
const RULES: &str = include_str!("../../maps/cga-city/rules/town.cga");

const JOB: &str = "\
# The tiles; an address such as \"s3://bucket/town\" works as well.
store = \"tiles\"
lots = [\"town.parquet\"]
rules = [\"town.cga\"]
lod = [\"Block\"]
set = { slope = 34 }
";

/// Writes outlines, rules and a job into the folder `town`. Files that exist stay: a person may have changed them.
pub(crate) fn write() -> Result<PathBuf, String> {
    let folder = Path::new("town");
    let unwritten = |why: std::io::Error| format!("cannot write to `{}`: {why}", folder.display());
    std::fs::create_dir_all(folder).map_err(unwritten)?;
    let [lots, rules, job] = ["town.parquet", "town.cga", "town.toml"].map(|name| folder.join(name));
    if !lots.exists() {
        Town { broken: 400, ..Town::new(2000) }.write(&lots)?;
    }
    for (path, text) in [(&rules, RULES), (&job, JOB)] {
        if !path.exists() {
            std::fs::write(path, text).map_err(unwritten)?;
        }
    }
    Ok(job)
}
