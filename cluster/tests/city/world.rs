//! Lots, rules and jobs of the tests, and the city that `cga-city` makes of them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use cga_city::build::{Build, NoProgress, Options};
use cga_cluster::engine::Engine;
use cga_cluster::job::Job;
use cga_cluster::run::{self, Summary};
use cga_geo::reader;
use cga_geo::synthetic::Town;

/// Roofs by kind, and a rule that fails for some heights.
pub(crate) const RULES: &str = r##"
    @Range(min = 1, max = 90)
    attr height = 9
    attr kind = "home"
    attr slope = 34
    @StartRule Lot --> [ extrude(height) comp(f) { side : Wall. } ] t(0, height, 0) Roof
    Roof --> case kind == "hall" : Lost(1) case kind == "shop" : roofGable(slope) X. else : roofHip(slope) X.
    Lost(n) --> case height < 5 && n > 0 : Lost(n + 1) else : Flat.
    @StartRule Block --> extrude(height + 1) X.
"##;

/// The choices of a job, beside lots, rules and store.
pub(crate) const CHOICES: &str = "lod = [\"Block\"]\ntile_lots = 100\nunit_lots = 300\nwave_size = 1\n";

/// Files of lots, rules and a job in a folder of their own.
pub(crate) struct World {
    folder: tempfile::TempDir,
    lots: Vec<PathBuf>,
}

impl World {
    /// Towns that are so far from each other that each has blocks of its own. One row in `broken` cannot be used.
    pub(crate) fn new(towns: u64, rows: u64, broken: u64) -> Self {
        let mut world = World::empty(RULES);
        for at in 0..towns {
            let path = world.add_lots(&format!("town-{at}.parquet"));
            let middle = [9.0 + 0.7 * at as f64, 48.0 + 0.3 * (at % 3) as f64];
            Town { seed: at + 1, middle, broken, ..Town::new(rows) }.write(&path).expect("room");
        }
        world.write_job("out", CHOICES);
        world
    }

    /// A folder with rules and without lots.
    pub(crate) fn empty(rules: &str) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::create_dir(folder.path().join("lots")).expect("room");
        std::fs::write(folder.path().join("house.cga"), rules).expect("room");
        World { folder, lots: Vec::new() }
    }

    /// The path of a file of lots, which the caller writes.
    pub(crate) fn add_lots(&mut self, name: &str) -> PathBuf {
        let path = self.path("lots").join(name);
        if !self.lots.contains(&path) {
            self.lots.push(path.clone());
        }
        path
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Writes the file of the job.
    pub(crate) fn write_job(&self, store: &str, choices: &str) {
        let text = format!("store = \"{store}\"\nlots = [\"lots\"]\nrules = [\"house.cga\"]\n{choices}");
        std::fs::write(self.path("job.toml"), text).expect("room");
    }

    /// The files of lots.
    pub(crate) fn lots(&self) -> &[PathBuf] {
        &self.lots
    }

    pub(crate) fn job(&self) -> Job {
        Job::open(&self.path("job.toml")).expect("a job")
    }

    /// Runs the job in this process.
    pub(crate) async fn run(&self) -> Result<Summary, String> {
        run::run(&Engine::embedded(2).expect("an engine"), &self.job(), &run::NoProgress).await
    }

    /// Makes the city with `cga-city`, in the folder `expected`.
    pub(crate) fn expected(&self) -> PathBuf {
        self.expected_with(|options| options)
    }

    /// Makes the city with `cga-city` and changed options.
    pub(crate) fn expected_with(&self, change: impl Fn(Options) -> Options) -> PathBuf {
        let out = self.path("expected");
        let work = self.job().work(&reader::FileCrs::Epsg(4326)).expect("a work");
        let rules = work.load_rules().expect("rules");
        let mut build = Build::begin(&out, change(work.options.clone())).expect("a folder");
        for path in &self.lots {
            let rows = reader::open(path, &work.columns.names(&rules.grammars())).expect("lots").rows;
            let surveyor = cga_geo::survey::Surveyor::new(rules.grammars(), work.columns.clone());
            build.add(&path.to_string_lossy(), rows, &surveyor, &NoProgress).expect("room");
        }
        build.finish(&rules, &NoProgress).expect("a city");
        out
    }
}

/// The files of a city that viewers and further runs read, with their bytes.
pub(crate) fn files(city: &Path) -> BTreeMap<String, Vec<u8>> {
    fn add(found: &mut BTreeMap<String, Vec<u8>>, folder: &Path, name: &str) {
        for entry in std::fs::read_dir(folder).into_iter().flatten() {
            let entry = entry.expect("an entry");
            let name = format!("{name}/{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                add(found, &entry.path(), &name);
            } else if let Ok(bytes) = std::fs::read(entry.path()) {
                found.insert(name, bytes);
            }
        }
    }
    let mut found = BTreeMap::new();
    ["tiles", "sets"].iter().for_each(|part| add(&mut found, &city.join(part), part));
    found.extend(std::fs::read(city.join("tileset.json")).ok().map(|bytes| ("tileset.json".to_owned(), bytes)));
    found
}

/// Compares all files of two cities.
pub(crate) fn assert_equal(found: &BTreeMap<String, Vec<u8>>, expected: &BTreeMap<String, Vec<u8>>) {
    let others: Vec<&String> = found.keys().filter(|name| !expected.contains_key(*name)).collect();
    assert!(others.is_empty(), "other files: {others:?}");
    for (name, bytes) in expected {
        assert!(found.contains_key(name), "`{name}` is missing");
        assert!(&found[name] == bytes, "`{name}` has other bytes");
    }
}

/// The tables of failures, as lines of `id`, `lost` and `reason`: rows, and buildings.
pub(crate) fn failures(city: &Path) -> [Vec<String>; 2] {
    ["rows", "buildings"].map(|part| {
        let folder = city.join("failures").join(part);
        let files = std::fs::read_dir(folder).into_iter().flatten();
        let text = |file: std::io::Result<std::fs::DirEntry>| std::fs::read_to_string(file.expect("a file").path());
        let mut lines: Vec<String> = files.flat_map(|file| lines(&text(file).expect("a text"))).collect();
        lines.sort();
        lines
    })
}

/// The same lines of the table of `cga-city`.
pub(crate) fn expected_failures(city: &Path) -> [Vec<String>; 2] {
    let text = std::fs::read_to_string(city.join("problems.jsonl")).expect("a table");
    let (rows, buildings): (Vec<&str>, Vec<&str>) = text.lines().partition(|line| line.contains("\"row\":"));
    [rows, buildings].map(|part| {
        let mut lines = lines(&part.join("\n"));
        lines.sort();
        lines
    })
}

fn lines(table: &str) -> Vec<String> {
    let line = |line: &str| {
        let line: serde_json::Value = serde_json::from_str(line).expect("JSON");
        format!("{} {} {} {}", line["tile"], line["id"], line["lost"], line["reason"])
    };
    table.lines().map(line).collect()
}
