//! Makes a city.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use cga_city::build::{Build, Options, Summary};
use cga_city::leftovers::is_of_city;
use cga_city::rules::Rules;
use cga_city::surroundings::Distances;
use cga_geo::crs::{Crs, WGS_84};
use cga_geo::missing;
use cga_geo::reader::{self, FileCrs};
use cga_geo::survey::{Columns, Surveyor};
use cga_geo::terrain::{AsciiGrid, Terrain};

use crate::named_columns::NamedColumns;
use crate::options::CityOptions;
use crate::progress_bar::ProgressBar;
use crate::stream::say;
use crate::{Problem, Status};

pub(crate) fn city(options: &CityOptions) -> Result<Status, Problem> {
    let begun = Instant::now();
    let rules = rules(options)?;
    let Some(out) = &options.out else { return Err(Problem::unusable("`--out` is missing")) };
    let columns = columns(options, &rules)?;
    let terrain = options.terrain.as_deref().map(terrain).transpose().map_err(Problem::unusable)?;
    let choices = Options {
        levels: options.lod.clone(),
        lots_per_tile: options.tile_lots,
        most_bytes: options.tile_size.saturating_mul(1 << 10),
        jobs: options.jobs.map(|jobs| jobs as usize),
        shares_images: !options.embed_images,
        plain_far: options.plain_far,
        watertight_near: options.watertight,
        neighbours: Some(Distances { occlusion: options.occlusion_distance, context: options.context_distance }),
    };
    // Wrong levels are reported before a file is read.
    choices.check(&rules).map_err(|why| Problem::unusable(format!("--lod: {why}")))?;
    inputs_stay(options, out)?;
    let mut named = NamedColumns::new(&columns);
    let open = |path: &PathBuf| open(path, options, &columns, &rules, &mut named);
    let files = options.lots.iter().map(open).collect::<Result<Vec<_>, _>>()?;
    named.check_files().map_err(Problem::unusable)?;
    let bar = ProgressBar::new(options.quiet);
    let mut build = Build::begin(out, choices).map_err(Problem::unusable)?;
    for (path, (rows, crs)) in options.lots.iter().zip(files) {
        let mut surveyor = Surveyor::new(rules.grammars(), columns.clone()).crs(crs);
        if let Some(terrain) = &terrain {
            surveyor = surveyor.terrain(terrain.clone());
        }
        let rows = rows.inspect(|row| named.add_row(row));
        let added = build.add(&path.to_string_lossy(), rows, &surveyor, &bar);
        added.map_err(|why| Problem::unusable(format!("cannot write to `{}`: {why}", out.display())))?;
    }
    // A damaged file may end before its columns are seen.
    let columns = if build.is_damaged() { Ok(()) } else { named.check_rows() };
    if let Err(why) = columns {
        bar.finish();
        return Err(Problem::unusable(why));
    }
    let summary = build.finish(&rules, &bar);
    bar.finish();
    let summary = summary.map_err(Problem::failed)?;
    tell(&summary, out, begun.elapsed().as_secs_f64());
    let is_denied = options.deny_lost && 0 < summary.lost;
    if summary.lots == 0 {
        return Err(Problem::failed("the city is empty: no row has a polygon that can be used"));
    }
    if summary.levels.iter().any(|level| level.buildings == 0) {
        return Err(Problem::failed("all buildings of a level are lost; the reasons are above"));
    }
    Ok(if is_denied { Status::Failed } else { Status::Success })
}

/// # Errors
/// A file of the command is one that the city may replace, or the city would be a part of its assets.
fn inputs_stay(options: &CityOptions, out: &Path) -> Result<(), Problem> {
    if let Some(folder) = options.assets.as_ref().filter(|folder| is_inside(out, folder)) {
        // The digest of each tile has all files of the assets.
        let (out, folder) = (out.display(), folder.display());
        return Err(Problem::unusable(format!(
            "`{out}` is inside of the assets in `{folder}`, so each run would make all tiles again; name an `--out` outside of that \
             folder, or move the assets to a folder of their own"
        )));
    }
    // A folder that does not exist has no files.
    let Ok(out) = out.canonicalize() else { return Ok(()) };
    let inputs = options.lots.iter().chain(&options.rules).chain(&options.terrain).chain(&options.assets);
    for input in inputs {
        let Ok(path) = input.canonicalize() else { continue };
        let Ok(below) = path.strip_prefix(&out) else { continue };
        if is_of_city(&below.to_string_lossy().replace('\\', "/")) {
            let (input, out) = (input.display(), out.display());
            return Err(Problem::unusable(format!(
                "`{input}` is among the tiles in `{out}`; move it, or name another `--out`"
            )));
        }
    }
    Ok(())
}

/// Returns true if a file is in a folder, or is that folder. The file and the folders around it need not exist.
fn is_inside(file: &Path, folder: &Path) -> bool {
    let (Ok(file), Ok(folder)) = (std::path::absolute(file), folder.canonicalize()) else { return false };
    let known = file.ancestors().find_map(|around| around.canonicalize().ok());
    known.is_some_and(|known| known.starts_with(folder))
}

/// The rules with the values of the command.
fn rules(options: &CityOptions) -> Result<Rules, Problem> {
    for path in &options.rules {
        let unread = |why: String| Problem::unusable(format!("cannot read `{}`: {why}", path.display()));
        let metadata = path.metadata().map_err(|error| unread(missing::unopened(path, &error, &["cga"])))?;
        if !metadata.is_file() {
            return Err(unread("it is not a file".to_owned()));
        }
    }
    let mut rules = Rules::open(&options.rules).map_err(Problem::failed)?;
    rules.warnings().for_each(|warning| say(format_args!("{warning}\n")));
    if let Some(folder) = &options.assets {
        rules = rules.with_assets(folder).map_err(Problem::unusable)?;
    }
    for (name, value) in &options.values {
        rules.set(name, value).map_err(|why| Problem::unusable(format!("--set {name}: {why}")))?;
    }
    Ok(rules)
}

fn columns(options: &CityOptions, rules: &Rules) -> Result<Columns, Problem> {
    let named = options.attributes.iter().map(|(_, name)| name).chain(&options.footing);
    rules.check_attributes(named.map(String::as_str)).map_err(Problem::unusable)?;
    Ok(Columns {
        id: options.id.clone(),
        grammar: options.grammar_column.clone(),
        start: options.start_column.clone(),
        attributes: options.attributes.clone(),
        footing: options.footing.clone(),
    })
}

type Opened = (Box<dyn Iterator<Item = cga_geo::row::Row>>, Crs);

/// The rows of a file, and their coordinate system.
fn open(
    path: &Path,
    options: &CityOptions,
    columns: &Columns,
    rules: &Rules,
    named: &mut NamedColumns,
) -> Result<Opened, Problem> {
    let unread = |why: String| Problem::unusable(format!("cannot read `{}`: {why}", path.display()));
    let file = reader::open(path, &columns.names(&rules.grammars())).map_err(unread)?;
    named.add_file(file.columns.as_deref());
    let code = match (options.crs, &file.crs) {
        (Some(given), _) => given.0,
        (None, FileCrs::Epsg(code)) => *code,
        (None, FileCrs::None) => WGS_84,
        (None, FileCrs::Unknown(name)) => {
            return Err(unread(format!(
                "its coordinate system `{name}` has no code; name it, as in `--crs EPSG:25832`"
            )));
        }
    };
    let crs = Crs::from_epsg(code).map_err(|why| unread(format!("{why}; name another one with `--crs`")))?;
    Ok((file.rows, crs))
}

fn terrain(path: &Path) -> Result<Arc<dyn Terrain>, String> {
    let unread = |why: String| format!("cannot read `{}`: {why}", path.display());
    let file = std::fs::File::open(path).map_err(|error| unread(missing::unopened(path, &error, &["asc"])))?;
    let grid = AsciiGrid::read(std::io::BufReader::new(file)).map_err(unread)?;
    Ok(Arc::new(grid))
}

/// Says what was made, for a person who waits.
fn tell(summary: &Summary, out: &Path, seconds: f64) {
    let Summary { rows, lots, levels, made, kept, lost, notes, problems } = summary;
    problems.iter().for_each(say);
    let shown = problems.len() as u64;
    if shown < lost + notes {
        say(format_args!("… and {} more, in {}", lost + notes - shown, out.join("problems.jsonl").display()));
    }
    for (number, level) in levels.iter().enumerate() {
        let name = if number == 0 { "near".to_owned() } else { format!("far {number}") };
        let each = level.bytes as f64 / level.buildings.max(1) as f64;
        say(format_args!(
            "{name}: {} tiles, {} buildings, {:.1} MB, {each:.0} bytes a building",
            level.tiles,
            level.buildings,
            level.bytes as f64 / 1e6
        ));
    }
    say(format_args!(
        "{rows} rows, {lots} lots, {lost} lost, {notes} notes; {made} tiles made, {kept} kept, in {seconds:.1} s; wrote `{}`",
        out.join("tileset.json").display()
    ));
}
