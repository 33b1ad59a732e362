//! The options of the command.

use std::path::PathBuf;

use cga_city::level::Level;
use cga_city::surroundings::MOST_DISTANCE;
use cga_geo::crs::Crs;
use clap::{Args, Parser, Subcommand};

/// Makes 3D Tiles of the lots of a map file with CGA rules. Without arguments it makes a town of made-up outlines.
#[derive(Debug, Parser)]
#[command(name = "cga-city", version, args_conflicts_with_subcommands = true, after_help = STATUS)]
pub(crate) struct Options {
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
    #[command(flatten)]
    pub(crate) city: CityOptions,
}

const STATUS: &str = "\
Each row or value that cannot be used is a line in DIR/problems.jsonl. A run that was stopped goes on where it ended when it is started again.
exit status: 0 all went well, 1 the rules have errors, a file of lots is damaged, no building was made or the run
ended early, 2 a file cannot be read or written or the arguments are wrong";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Writes a new file of made-up outlines: .geojson, .fgb, .shp or .parquet
    Outlines(OutlineOptions),
    /// Serves a city and a page that shows it, for browsers on this computer
    View(ViewOptions),
}

#[derive(Debug, Args)]
pub(crate) struct CityOptions {
    /// Map files with the lots: .geojson, .json, .geojsonl, .fgb, .shp, .parquet
    #[arg(value_name = "LOTS", requires_all = ["rules", "out"])]
    pub(crate) lots: Vec<PathBuf>,
    /// A rule file. Of several, the first has all lots that name none in the column of `--grammar-column`
    #[arg(long, value_name = "RULES.cga", requires = "lots")]
    pub(crate) rules: Vec<PathBuf>,
    /// The folder of the tiles: a new one, or one of an earlier run
    #[arg(long, value_name = "DIR", requires = "lots")]
    pub(crate) out: Option<PathBuf>,
    /// The coordinate system of the lots, as in `EPSG:25832` [default: the system that the file names, else degrees]
    #[arg(long, value_name = "EPSG:n")]
    pub(crate) crs: Option<CrsOption>,
    /// Sets an attribute of all lots, as in `--set height=12`
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = pair)]
    pub(crate) values: Vec<(String, String)>,
    /// Sets an attribute from a column of another name
    #[arg(long = "attribute", value_name = "COLUMN=NAME", value_parser = pair)]
    pub(crate) attributes: Vec<(String, String)>,
    /// The column of ids [default: the ids of the format, else the column `id`]
    #[arg(long, value_name = "COLUMN")]
    pub(crate) id: Option<String>,
    /// The column with the names of rule files, without `.cga`
    #[arg(long, value_name = "COLUMN")]
    pub(crate) grammar_column: Option<String>,
    /// The column with start rules
    #[arg(long, value_name = "COLUMN")]
    pub(crate) start_column: Option<String>,
    /// A grid of heights (.asc) in the coordinate system of the lots. Lots stand at the lowest ground of their corners
    #[arg(long, value_name = "GRID.asc")]
    pub(crate) terrain: Option<PathBuf>,
    /// The attribute that gets the rise of the ground below a lot in metres
    #[arg(long, value_name = "NAME", requires = "terrain")]
    pub(crate) footing: Option<String>,
    /// The folder of meshes and images that the rules insert
    #[arg(long, value_name = "FOLDER")]
    pub(crate) assets: Option<PathBuf>,
    /// Writes images into each tile that shows them, in place of one file for all tiles
    #[arg(long)]
    pub(crate) embed_images: bool,
    /// A level of detail for far away, from near to far: a start rule (`Block`), or attributes (`detail=0`), with `@8` for an error of 8 m
    #[arg(long, value_name = "LEVEL")]
    pub(crate) lod: Vec<Level>,
    /// Writes far tiles without normals, which have about 40 % fewer bytes. Some viewers show them without light and shade
    #[arg(long)]
    pub(crate) plain_far: bool,
    /// Lets the triangles of near tiles meet edge to edge, so that single pixels do not show through a façade. Such tiles take several times as long and
    /// have up to 1.8 times as many triangles
    #[arg(long)]
    pub(crate) watertight: bool,
    /// The metres up to which `touches(inter)`, `overlaps(inter)` and `inside(inter)` find other lots
    #[arg(long, value_name = "METRES", default_value = "1", value_parser = distance)]
    pub(crate) occlusion_distance: f64,
    /// The metres up to which queries of labelled shapes find other lots
    #[arg(long, value_name = "METRES", default_value = "100", value_parser = distance)]
    pub(crate) context_distance: f64,
    /// The most lots of a near tile
    #[arg(long, value_name = "COUNT", default_value_t = 256, value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) tile_lots: u64,
    /// The most kilobytes of a tile with several lots
    #[arg(long, value_name = "KB", default_value_t = 4096, value_parser = clap::value_parser!(u64).range(1..1 << 22))]
    pub(crate) tile_size: u64,
    /// The number of threads [default: one on each processor]
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u64).range(1..1024))]
    pub(crate) jobs: Option<u64>,
    /// Fails if a row, a polygon or a building is missing
    #[arg(long)]
    pub(crate) deny_lost: bool,
    /// Shows no progress
    #[arg(long)]
    pub(crate) quiet: bool,
}

/// A code of EPSG that is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CrsOption(pub(crate) u32);

impl std::str::FromStr for CrsOption {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.parse().map(|crs: Crs| CrsOption(crs.code()))
    }
}

#[derive(Debug, Args)]
pub(crate) struct OutlineOptions {
    /// The file
    pub(crate) file: PathBuf,
    /// The number of rows
    #[arg(long, default_value_t = 2000)]
    pub(crate) rows: u64,
    /// The seed of all random choices
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// One in this many rows cannot be used; 0 for none
    #[arg(long, default_value_t = 0)]
    pub(crate) broken: u64,
}

#[derive(Debug, Args)]
pub(crate) struct ViewOptions {
    /// The folder of a city
    pub(crate) dir: PathBuf,
    /// The port; 0 takes a free one
    #[arg(long, default_value_t = 8080)]
    pub(crate) port: u16,
    /// The folder of the page [default: the page that `maps/view/build.sh` builds]
    #[arg(long, value_name = "FOLDER")]
    pub(crate) page: Option<PathBuf>,
}

/// A distance in metres.
fn distance(text: &str) -> Result<f64, String> {
    let metres: f64 = text.trim().parse().map_err(|_| format!("`{text}` is not a number of metres"))?;
    let is_known = (0.0..=MOST_DISTANCE).contains(&metres);
    is_known.then_some(metres).ok_or_else(|| format!("a distance is from 0 to {MOST_DISTANCE} metres"))
}

/// Two names with `=` between them.
fn pair(text: &str) -> Result<(String, String), String> {
    let (first, second) = text.split_once('=').ok_or("write two names with `=` between them, as in `height=12`")?;
    Ok((first.trim().to_owned(), second.trim().to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(args: &[&str]) -> Result<Options, String> {
        Options::try_parse_from(["cga-city"].iter().chain(args)).map_err(|error| error.to_string())
    }

    #[test]
    fn a_city_has_lots_rules_and_a_folder() {
        let args = [
            "a.shp",
            "--rules",
            "a.cga",
            "--out",
            "o",
            "--crs",
            "EPSG:25832",
            "--attribute",
            "HOEHE=height",
            "--lod",
            "Block@9",
        ];
        let city = of(&args).expect("right").city;
        assert_eq!((city.crs, city.lod[0].error), (Some(CrsOption(25832)), Some(9.0)));
        assert_eq!(city.attributes, [("HOEHE".to_owned(), "height".to_owned())]);
        assert!(of(&[]).expect("a town").city.lots.is_empty());
        assert!(matches!(
            of(&["outlines", "a.fgb", "--rows", "9"]).expect("right").command,
            Some(Command::Outlines(_))
        ));
    }

    #[test]
    fn wrong_arguments_are_named() {
        for (args, why) in [
            (&["a.shp"][..], "--rules"),
            (&["--rules", "a.cga"], "<LOTS>"),
            (&["a.shp", "--rules", "a.cga", "--out", "o", "--crs", "Gauss"], "write `EPSG:25832`"),
            (&["a.shp", "--rules", "a.cga", "--out", "o", "--set", "height"], "as in `height=12`"),
            (&["a.shp", "--rules", "a.cga", "--out", "o", "--lod", "@2"], "as in `Block`"),
            (&["a.shp", "--rules", "a.cga", "--out", "o", "--jobs", "0"], "--jobs"),
            (&["a.shp", "--rules", "a.cga", "--out", "o", "--context-distance", "1e9"], "from 0 to 1000 metres"),
            (&["a.shp", "--rules", "a.cga", "--out", "o", "--occlusion-distance=nan"], "from 0 to 1000 metres"),
        ] {
            let error = of(args).expect_err("wrong");
            assert!(error.contains(why), "{args:?}: {error}");
        }
    }
}
