//! A town of made-up outlines, for a first try.

use std::path::Path;

use cga_city::program;
use cga_geo::synthetic::Town;

use crate::options::{CityOptions, OutlineOptions};
use crate::stream::say;
use crate::{Problem, Status, command};

/// The rules of the town.
const RULES: &str = include_str!("../rules/town.cga");

/// The number of lots.
const ROWS: u64 = 2000;

/// Writes outlines and rules in the folder `town`, makes the tiles, and says what to type next.
pub(crate) fn town(options: CityOptions) -> Result<Status, Problem> {
    let folder = Path::new("town");
    let [lots, rules, out] = ["town.geojson", "town.cga", "tiles"].map(|name| folder.join(name));
    let unwritten = |why: std::io::Error| Problem::unusable(format!("cannot write to `{}`: {why}", folder.display()));
    std::fs::create_dir_all(folder).map_err(unwritten)?;
    // Files that exist stay: a person may have changed them, or they are another town.
    if rules.exists() {
        say(format_args!("took the rules {}, which exist already", rules.display()));
    } else {
        std::fs::write(&rules, RULES).map_err(unwritten)?;
        say(format_args!("wrote rules to {}", rules.display()));
    }
    if lots.exists() {
        say(format_args!("took the outlines {}, which exist already", lots.display()));
    } else {
        Town { broken: 400, ..Town::new(ROWS) }.write(&lots).map_err(Problem::unusable)?;
        say(format_args!("wrote {ROWS} made-up outlines to {}; some are broken", lots.display()));
    }
    let mut options = CityOptions { lots: vec![lots], rules: vec![rules], out: Some(out), ..options };
    if options.lod.is_empty() {
        options.lod = ["Block".parse().map_err(Problem::unusable)?].into();
    }
    let status = command::city(&options)?;
    let name = program::name("cga-city");
    say(format_args!(
        "\nNext: change the rules or a value, and type\n  \
         {name} town/town.geojson --rules town/town.cga --out town/tiles --lod Block --set slope=50\n  \
         {name} view town/tiles\n\
         or take a map of your own: {name} LOTS --rules RULES.cga --out DIR; `{name} --help` has all options"
    ));
    Ok(status)
}

/// Writes a new file of outlines.
pub(crate) fn outlines(options: &OutlineOptions) -> Result<Status, Problem> {
    let OutlineOptions { file, rows, seed, broken } = options;
    let is_shapefile = file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("shp"));
    let others = ["shx", "dbf", "prj", "cpg"].map(|ending| file.with_extension(ending));
    let written = std::iter::once(file).chain(others.iter().filter(|_| is_shapefile));
    if let Some(old) = written.into_iter().find(|path| path.symlink_metadata().is_ok()) {
        return Err(Problem::unusable(format!("`{}` exists already; name a new file", old.display())));
    }
    let town = Town { seed: *seed, broken: *broken, ..Town::new(*rows) };
    town.write(file).map_err(Problem::unusable)?;
    say(format_args!("wrote {rows} outlines to {}", file.display()));
    Ok(Status::Success)
}
