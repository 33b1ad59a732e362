//! Cities in units: rows in any batches become the files of a city that is made at once.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use cga_city::build::{NoProgress, Options};
use cga_city::store::{Folder, Store as _};
use cga_city::units::city::{Finished, begin, delete_old_files, finish, keep_failed};
use cga_city::units::counts::Counts;
use cga_city::units::failed_rows::FailedRows;
use cga_city::units::lot::UnitLot;
use cga_city::units::make::{UnitFile, UnitLots, UnitMaker};
use cga_city::units::plan::{Plan, PlanIndex};
use cga_city::units::store::UnitStore as _;
use cga_city::units::work::{LoadedWork, RuleTexts, Work};
use cga_geo::reader;
use cga_geo::row::Row;
use cga_geo::survey::Columns;
use cga_geo::synthetic::Town;

use crate::town::{build, options};

/// Walls stand where they touch no neighbour. Some halls fail.
const ASKING: &str = "attr height = 9  attr kind = \"home\"
    @StartRule Lot --> case kind == \"hall\" && height < 7 : Endless(1) else : extrude(height) label(\"house\") comp(f) { side : Wall | top : Roof }
    Endless(n) --> case n < 0 : X. else : Endless(n + 1)
    Wall --> case touches(inter) : NIL else : Wall.
    Roof --> case contextCount(inter, \"house\") > 2 : roofHip(20) X. else : X.
    @StartRule Block --> extrude(height) X.";

fn work(text: &str, options: Options) -> LoadedWork {
    let file = "town.cga".to_owned();
    let rules = vec![RuleTexts { texts: vec![(file.clone(), text.to_owned())], file }];
    let columns = Columns { id: Some("id".into()), ..Columns::default() };
    let (compiled, assets, values) = (Vec::new(), None, Vec::new());
    LoadedWork::new(Work { rules, compiled, assets, values, columns, crs: 4326, options }).expect("good rules")
}

/// The rows of a file. Their order is changed.
fn rows(lots: &Path, work: &LoadedWork, step: usize) -> Vec<Row> {
    let all: Vec<Row> = reader::open(lots, &work.column_names()).expect("lots").rows.collect();
    (0..step).flat_map(|first| all.iter().skip(first).step_by(step).cloned().collect::<Vec<_>>()).collect()
}

fn plan(folder: &Path, work: &LoadedWork, rows: &[Row], batch: usize) -> Result<Plan, String> {
    let store = Folder(folder.to_owned());
    begin(&store, "out")?;
    let mut all = Counts::default();
    for part in rows.chunks(batch) {
        let counts = Counts::of(work, part.iter().map(|row| (&[][..], row.clone())), &store)?;
        all.add(Counts::from_bytes(&counts.to_bytes())?)?;
    }
    keep_failed(&store, &all.failed()).map_err(|why| why.to_string())?;
    let plan = all.plan(work, 1)?;
    delete_old_files(&store, &plan, &[])?;
    Ok(plan)
}

/// Makes the units of a plan in another order. Unfinished ones alone are made; the result is their number.
fn make(folder: &Path, work: &LoadedWork, plan: Plan, rows: &[Row]) -> Result<(usize, Finished), String> {
    let (store, index) = (Folder(folder.to_owned()), PlanIndex::new(plan));
    let (surveyor, mut table) = (work.surveyor()?, FailedRows::default());
    let mut lots: BTreeMap<usize, Vec<Vec<u8>>> = BTreeMap::new();
    for row in rows {
        for footprint in table.survey(&surveyor, &[], row.clone()) {
            let lot = UnitLot::new(&footprint, work);
            for unit in index.units(lot.key, lot.class) {
                lots.entry(unit).or_default().push(lot.bytes.clone());
            }
        }
    }
    let threads = rayon::ThreadPoolBuilder::new().num_threads(2).stack_size(16 << 20).build().expect("threads");
    let maker = UnitMaker { work, store: &store, threads: &threads, progress: &NoProgress };
    let (mut plan, mut made) = (index.plan, 0);
    let has_margins = plan.has_margins();
    for (unit, lots) in lots.into_iter().rev() {
        let unit = &mut plan.units[unit];
        let lots = UnitLots::new(unit, lots.iter().map(|bytes| &bytes[..]))?;
        if has_margins {
            unit.set_read(lots.read);
        }
        if UnitFile::finished(store.read(&unit.name()).expect("a store").as_deref(), unit).is_none() {
            maker.make(unit, &lots)?;
            made += 1;
        }
    }
    Ok((made, finish(&store, &plan, work.levels.len())?))
}

/// The files of a city that viewers read.
fn files(city: &Path) -> BTreeMap<String, Vec<u8>> {
    let is_shown = |name: &String| name == "tileset.json" || name.starts_with("tiles/") || name.starts_with("sets/");
    crate::town::files(city).into_iter().filter(|(name, _)| is_shown(name)).collect()
}

fn assert_equal(found: &BTreeMap<String, Vec<u8>>, expected: &BTreeMap<String, Vec<u8>>) {
    assert_eq!(found.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>());
    let others: Vec<&String> = expected.keys().filter(|name| found[*name] != expected[*name]).collect();
    assert!(others.is_empty(), "other bytes: {others:?}");
}

fn table(city: &Path, folder: &str) -> Vec<String> {
    let files = fs::read_dir(city.join(folder)).into_iter().flatten().map(|file| file.expect("a file").path());
    let text: String = files.map(|path| fs::read_to_string(path).expect("a text")).collect();
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    lines.sort();
    lines
}

/// Three towns, each on both sides of a border between the widest tiles.
fn towns(folder: &Path) -> PathBuf {
    let path = folder.join("town.geojsonl");
    let mut features = String::new();
    for at in 0..3u32 {
        let part = folder.join(format!("{at}.geojson"));
        let middle = [360.0 / 2048.0 * f64::from(51 + at), 48.0];
        Town { seed: u64::from(at) + 1, middle, broken: 50, ..Town::new(400) }.write(&part).expect("room");
        let text = fs::read_to_string(part).expect("a text");
        let lines = text.lines().filter(|line| line.contains("\"Feature\""));
        lines.for_each(|line| features.extend([line.trim_end_matches(','), "\n"]));
    }
    fs::write(&path, features).expect("room");
    path
}

#[test]
fn units_of_any_batches_have_the_files_of_a_city_that_is_made_at_once() {
    let town_rules = include_str!("../../rules/town.cga");
    for (text, asks) in [(town_rules, false), (ASKING, true)] {
        let folder = tempfile::tempdir().expect("a folder");
        let lots = towns(folder.path());
        let expected = folder.path().join("expected");
        let work = work(text, options());
        let summary = build(&lots, &expected, &work.rules, options(), &NoProgress).expect("a city");
        let (out, rows) = (folder.path().join("out"), rows(&lots, &work, 7));
        let first = plan(&out, &work, &rows, 100).expect("a plan");
        assert_eq!((first.units.len() > 2, first.has_margins()), (true, asks));
        let count = first.units.len();
        let (made, finished) = make(&out, &work, first.clone(), &rows).expect("a city");
        assert_eq!(made, count);
        assert_equal(&files(&out), &files(&expected));
        let failed = [table(&out, "failures/rows"), table(&out, "failures/buildings")];
        assert_eq!((failed[0].len() + failed[1].len()) as u64, summary.lost + summary.notes);
        assert_eq!(finished.lost + finished.notes, failed[1].len() as u64);
        assert_eq!(failed[1].is_empty(), !asks);

        // Other batches in another order, and a file that a lost machine had begun: all units are kept.
        fs::write(out.join("tiles/.part-3"), "a part").expect("room");
        let mut others = rows.clone();
        others.reverse();
        let second = plan(&out, &work, &others, 333).expect("a plan");
        assert_eq!(second, first);
        assert_eq!(make(&out, &work, second, &others).expect("a city").0, 0);
        assert_equal(&files(&out), &files(&expected));
        assert!(!out.join("tiles/.part-3").exists());
        assert_eq!(table(&out, "failures/rows"), failed[0]);
    }
}

#[test]
fn lots_that_changed_after_they_were_counted_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let lots = towns(folder.path());
    let work = work(ASKING, options());
    let (out, mut rows) = (folder.path().join("out"), rows(&lots, &work, 1));
    let plan = plan(&out, &work, &rows, 100).expect("a plan");
    let lost = [rows.remove(0)];
    let error = make(&out, &work, plan.clone(), &rows).expect_err("one is missing");
    assert!(error.contains("start again when the lots do not change any more"), "{error}");
    rows.extend(lost);
    let columns = &mut rows[5].columns;
    let id = columns.iter().position(|(name, _)| name == "id").expect("an id");
    columns[id].1 = cga_geo::column::ColumnValue::Text("x".into());
    let error = make(&out, &work, plan, &rows).expect_err("another id");
    assert!(error.contains("start again when the lots do not change any more"), "{error}");
    assert!(!out.join("tileset.json").exists());
}

#[test]
fn counts_of_other_rules_and_other_folders_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let lots = folder.path().join("town.geojson");
    Town::new(20).write(&lots).expect("room");
    let (one, two) = (work(ASKING, options()), work(&ASKING.replace("X.", "Y."), options()));
    let store = Folder(folder.path().join("out"));
    let counts = |work: &LoadedWork| {
        Counts::of(work, rows(&lots, work, 1).iter().map(|row| (&[][..], row.clone())), &store).expect("counts")
    };
    let error = counts(&one).plan(&two, 300).expect_err("other rules");
    assert!(error.contains("count all rows again"), "{error}");
    assert!(counts(&one).add(counts(&two)).expect_err("other rules").contains("count all rows again"));
    assert!(Counts::from_bytes(b"no").expect_err("two letters").contains("not the counts of rows"));
    let error = begin(&Folder(folder.path().to_owned()), "town").expect_err("a file");
    assert!(error.contains("`town` has files that are not a city"), "{error}");
    assert!(Folder(folder.path().join("new")).is_empty().expect("a store"));
    let empty = Counts::default().plan(&one, 300).expect("a plan");
    let error = finish(&store, &empty, 1).expect_err("no lots");
    assert!(error.contains("the city is empty"), "{error}");
}
