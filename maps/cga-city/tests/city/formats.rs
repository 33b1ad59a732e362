//! Files of several formats, several numbers of threads.

use cga_city::build::{NoProgress, Options};
use cga_geo::synthetic::Town;

use crate::town::{build, city, files, options, rules};

#[test]
fn four_formats_give_the_same_tiles() {
    let folder = tempfile::tempdir().expect("a folder");
    let town = Town { broken: 50, ..Town::new(1000) };
    let of_format = |ending: &str| {
        let lots = folder.path().join(format!("town.{ending}"));
        town.write(&lots).expect("room");
        let out = folder.path().join(ending);
        let summary = city(&lots, &out);
        assert_eq!((summary.rows, summary.lost), (1000, 20));
        files(&out)
    };
    let [first, others @ ..] = ["geojson", "fgb", "shp", "parquet"].map(of_format);
    assert!(100 < first.len(), "{} files", first.len());
    for other in others {
        assert!(first == other);
    }
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let folder = tempfile::tempdir().expect("a folder");
    let lots = folder.path().join("town.fgb");
    Town::new(300).write(&lots).expect("room");
    let with = |jobs: usize| {
        let out = folder.path().join(jobs.to_string());
        let options = Options { jobs: Some(jobs), ..options() };
        build(&lots, &out, &rules(), options, &NoProgress).expect("a city");
        files(&out)
    };
    let first = with(1);
    assert!(first == with(2) && first == with(7));
}
