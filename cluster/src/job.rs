//! Jobs as people write them: a file in TOML.
//!
//! ```toml
//! store = "s3://bucket/city"              # or a folder
//! lots = ["s3://maps/lots/"]              # files and folders of GeoParquet
//! rules = ["house.cga"]                   # or compiled = ["House"]
//! lod = ["Block@8"]
//! set = { slope = 40 }
//! attributes = { HOEHE = "height" }
//! ```

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use cga::RuleLoader;
use cga_city::build::Options;
use cga_city::surroundings::{Distances, MOST_DISTANCE};
use cga_city::units::work::{RuleTexts, Work};
use cga_geo::crs::{Crs, WGS_84};
use cga_geo::missing;
use cga_geo::reader::FileCrs;
use cga_geo::survey::Columns;
use serde::Deserialize;
use url::Url;

/// A job. Paths are relative to the folder of its file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// The folder or the address of the tiles.
    pub store: String,
    /// Files `.parquet` and folders with all such files below, or their addresses; the address of a folder ends with `/`.
    pub lots: Vec<String>,
    /// The rule files. The first has all lots that name none in the column `grammar_column`.
    #[serde(default)]
    pub rules: Vec<PathBuf>,
    /// The names of grammars that are compiled into the program, which come after the rule files; see [`program::main`](crate::program::main).
    #[serde(default)]
    pub compiled: Vec<String>,
    /// The folder of meshes and images that the rules insert, at the same path on all machines.
    pub assets: Option<PathBuf>,
    /// The coordinate system, as in `EPSG:25832`; without it, the system that the files name, else degrees.
    pub crs: Option<String>,
    /// The column of ids; without it, the column `id`.
    pub id: Option<String>,
    /// The column with the names of rule files, without `.cga`.
    pub grammar_column: Option<String>,
    /// The column with start rules.
    pub start_column: Option<String>,
    /// Columns and the attributes that they set. Other attributes are set by the columns of their names.
    #[serde(default)]
    pub attributes: BTreeMap<String, String>,
    /// Attributes of all lots and their values.
    #[serde(default)]
    pub set: BTreeMap<String, toml::Value>,
    /// Levels of detail for far away, from near to far, as in `Block@8`.
    #[serde(default)]
    pub lod: Vec<String>,
    /// The metres up to which `touches(inter)`, `overlaps(inter)` and `inside(inter)` find other lots.
    pub occlusion_distance: Option<f64>,
    /// The metres up to which queries of labelled shapes find other lots.
    pub context_distance: Option<f64>,
    /// The most lots of a near tile.
    pub tile_lots: Option<u64>,
    /// The most kilobytes of a tile with several lots.
    pub tile_size: Option<u64>,
    /// The most lots of a unit, the work of one call; one block of tiles is always whole.
    #[serde(default = "unit_lots")]
    pub unit_lots: u64,
    /// The most megabytes of footprints that are sorted at a time, on all machines together.
    #[serde(default = "wave_size")]
    pub wave_size: u64,
    /// The parts of a query that run at a time; without it, one on each processor of this machine.
    pub partitions: Option<usize>,
}

fn unit_lots() -> u64 {
    65_536
}

fn wave_size() -> u64 {
    128
}

impl Job {
    /// Reads the file of a job.
    ///
    /// # Errors
    /// A sentence about the file.
    pub fn open(path: &Path) -> Result<Self, String> {
        let unread = |why: String| format!("cannot read `{}`: {why}", path.display());
        let text = std::fs::read_to_string(path);
        let text = text.map_err(|error| unread(missing::unopened(path, &error, &["toml"])))?;
        let mut job: Job = toml::from_str(&text).map_err(|why| unread(why.to_string()))?;
        let folder = std::path::absolute(path).map_err(|why| unread(why.to_string()))?;
        let folder = folder.parent().unwrap_or(Path::new("/")).to_owned();
        job.store = address(&folder, &job.store)?;
        for lots in &mut job.lots {
            if !lots.contains("://") {
                let unread = |why: String| format!("lots: cannot read `{lots}`: {why}");
                let path = folder.join(&*lots);
                path.metadata().map_err(|error| unread(missing::unopened(&path, &error, &["parquet"])))?;
            }
            *lots = address(&folder, lots)?;
        }
        job.rules.iter_mut().chain(&mut job.assets).for_each(|path| *path = folder.join(&*path));
        Ok(job)
    }

    /// The work of the job, for lots with a coordinate system.
    ///
    /// # Errors
    /// A sentence about a choice, or the errors of the rules.
    pub fn work(&self, crs: &FileCrs) -> Result<Work, String> {
        let rules = |path: &PathBuf| {
            let unread = |why: String| format!("rules: cannot read `{}`: {why}", path.display());
            path.metadata().map_err(|error| unread(missing::unopened(path, &error, &["cga"])))?;
            let rules = RuleLoader::new().open(path).map_err(|why| why.to_string())?;
            let texts = rules.texts().map(|(name, text)| (name.to_owned(), text.to_owned())).collect();
            Ok(RuleTexts { file: rules.file().to_owned(), texts })
        };
        let crs = match (&self.crs, crs) {
            (Some(given), _) => given.parse::<Crs>().map_err(|why| format!("crs: {why}"))?.code(),
            (None, FileCrs::Epsg(code)) => *code,
            (None, FileCrs::None) => WGS_84,
            (None, FileCrs::Unknown(name)) => {
                return Err(format!(
                    "the coordinate system `{name}` of the lots has no code; name it, as in `crs = \"EPSG:25832\"`"
                ));
            }
        };
        let (usual, near) = (Options::default(), Distances::default());
        let options = Options {
            levels: self.lod.iter().map(|level| level.parse()).collect::<Result<_, _>>()?,
            lots_per_tile: self.tile_lots.unwrap_or(usual.lots_per_tile).max(1),
            most_bytes: self.tile_size.map_or(usual.most_bytes, |size| size.saturating_mul(1 << 10)),
            neighbours: Some(Distances {
                occlusion: distance("occlusion_distance", self.occlusion_distance, near.occlusion)?,
                context: distance("context_distance", self.context_distance, near.context)?,
            }),
            ..usual
        };
        Ok(Work {
            rules: self.rules.iter().map(rules).collect::<Result<_, String>>()?,
            compiled: self.compiled.clone(),
            assets: self.assets.clone(),
            values: self.set.iter().map(|(name, value)| (name.clone(), text_of(value))).collect(),
            columns: Columns {
                id: self.id.clone(),
                grammar: self.grammar_column.clone(),
                start: self.start_column.clone(),
                attributes: self.attributes.iter().map(|(column, name)| (column.clone(), name.clone())).collect(),
                footing: None,
            },
            crs,
            options,
        })
    }
}

/// The text of a value, as rules read it: texts of arrays have quotes, and rows end with `;`.
fn text_of(value: &toml::Value) -> String {
    fn elements(list: &[toml::Value]) -> String {
        let is_of_rows = list.iter().any(toml::Value::is_array);
        let element = |value: &toml::Value| match value {
            toml::Value::String(text) => format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\"")),
            toml::Value::Array(row) => elements(row),
            other => other.to_string(),
        };
        list.iter().map(element).collect::<Vec<_>>().join(if is_of_rows { "; " } else { ", " })
    }
    match value {
        toml::Value::String(text) => text.clone(),
        toml::Value::Array(list) => format!("[{}]", elements(list)),
        other => other.to_string(),
    }
}

/// The metres of a key, or the usual ones.
fn distance(key: &str, metres: Option<f64>, usual: f64) -> Result<f64, String> {
    let metres = metres.unwrap_or(usual);
    let is_known = (0.0..=MOST_DISTANCE).contains(&metres);
    is_known.then_some(metres).ok_or_else(|| format!("{key}: a distance is from 0 to {MOST_DISTANCE} metres"))
}

/// The address of a path, or an address as it is.
fn address(folder: &Path, path: &str) -> Result<String, String> {
    if path.contains("://") {
        return Ok(path.to_owned());
    }
    let whole = folder.join(path);
    let url = if whole.is_dir() { Url::from_directory_path(whole) } else { Url::from_file_path(whole) };
    url.map(String::from)
        .map_err(|()| format!("`{path}` cannot be used; write a path, or an address as in `s3://bucket/folder`"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_has_paths_relative_to_its_file_and_values_as_text() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("job.toml");
        let rules = "attr slope = 30  attr kind = \"home\"  attr names = [\"a\"]  attr sizes = [1]  @StartRule Lot --> extrude(9) X.";
        std::fs::write(folder.path().join("house.cga"), rules).expect("room");
        let text = "store = \"out\"\nlots = [\"lots.parquet\", \"s3://maps/a.parquet\"]\nrules = [\"house.cga\"]\n\
                    set = { slope = 40, kind = \"shop\" }\nlod = [\"slope=0@9\"]";
        std::fs::write(&path, text).expect("room");
        assert!(Job::open(&path).expect_err("no lots").contains("its folder has no file `.parquet`"));
        std::fs::write(folder.path().join("lots.parquet"), "").expect("room");
        let job = Job::open(&path).expect("right");
        assert!(job.store.starts_with("file:///") && job.store.ends_with("/out"), "{}", job.store);
        assert!(job.lots[0].ends_with("/lots.parquet") && job.lots[1] == "s3://maps/a.parquet");
        let work = job.work(&FileCrs::Epsg(25832)).expect("right");
        let values = [("kind", "shop"), ("slope", "40")].map(|(name, value)| (name.to_owned(), value.to_owned()));
        assert_eq!((work.values.as_slice(), work.crs, work.options.levels.len()), (&values[..], 25832, 1));
        assert!(work.load_rules().is_ok());
        let arrays = text.replace("slope = 40", "sizes = [[1, 2.5], [3, 4]], names = ['a;\"b', 'c\\d', \"e\"]");
        std::fs::write(&path, arrays).expect("room");
        let work = Job::open(&path).and_then(|job| job.work(&FileCrs::None)).expect("arrays");
        assert!(work.load_rules().is_ok(), "{:?}", work.load_rules());
        assert_eq!(work.values[2], ("sizes".to_owned(), "[1, 2.5; 3, 4]".to_owned()));
        std::fs::write(&path, format!("{text}\ncolour = 3")).expect("room");
        assert!(Job::open(&path).expect_err("unknown").contains("colour"));
        for (right, wrong, proposal) in [
            ("lots.parquet", "lost.parquet", "/lots.parquet`?"),
            ("house.cga", "hose.cga", "/house.cga`?"),
            ("house.cga\"]", "house.cga\"]\ncrs = \"EPSG:25899\"", "such as EPSG:25832"),
            (
                "house.cga\"]",
                "house.cga\"]\ncontext_distance = 1001",
                "context_distance: a distance is from 0 to 1000 metres",
            ),
            (
                "house.cga\"]",
                "house.cga\"]\nocclusion_distance = nan",
                "occlusion_distance: a distance is from 0 to 1000 metres",
            ),
        ] {
            std::fs::write(&path, text.replace(right, wrong)).expect("room");
            let error = Job::open(&path).and_then(|job| job.work(&FileCrs::None)).expect_err("a mistake");
            assert!(error.contains(proposal), "{error}");
        }
        let error = Job::open(&folder.path().join("jop.toml")).expect_err("missing");
        assert!(error.contains("did you mean") && error.contains("/job.toml`?"), "{error}");
        assert!(job.work(&FileCrs::Unknown("Gauss".into())).expect_err("no code").contains("EPSG:25832"));
    }
}
