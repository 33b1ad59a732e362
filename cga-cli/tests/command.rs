//! The command as users call it: bytes, lines, errors and exit status.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use cga::{Shape, cga};

cga! {
    pub grammar Tower in "tests/rules/tower.cga";
}

/// An empty folder that goes with its test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("cga-cli-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/rules/tower.cga"), folder.join("tower.cga"))
            .expect("the rules");
        Folder(folder)
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join(name), text).expect("a file");
    }

    fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.0.join(name)).expect("a file")
    }

    fn command(&self, args: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_cga"));
        command.current_dir(&self.0).args(args.split_whitespace());
        command
    }

    fn run(&self, args: &str) -> Output {
        self.command(args).output().expect("the command")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// The bytes, the printed lines and the reports of compiled rules.
fn compiled(tower: &Tower, lot: &Shape) -> (Vec<u8>, String, String) {
    let model = tower.generate(lot).expect("no limit");
    let prints = model.prints().iter().map(|print| format!("{print}\n")).collect();
    let reports = serde_json::to_string_pretty(model.report().reports()).expect("JSON");
    (model.to_glb().expect("a file"), prints, reports + "\n")
}

#[test]
fn a_run_gives_the_bytes_the_lines_and_the_reports_of_compiled_rules() {
    let folder = Folder::new("bytes");
    for (seed, height) in [(7, 12.0), (8, 30.0), (9, 30.0)] {
        let output = folder.run(&format!(
            "run tower.cga --name Tower --lot 20x12 --seed {seed} --set height={height} -o x.glb --reports x.json"
        ));
        assert!(output.status.success(), "{}", text(&output.stderr));
        let tower = Tower { height, ..Tower::default() };
        let (glb, prints, reports) = compiled(&tower, &Shape::rectangle(20.0, 12.0).seed(seed));
        assert!(folder.read("x.glb") == glb, "seed {seed}");
        assert_eq!((text(&output.stdout), text(&folder.read("x.json"))), (prints, reports));
    }
}

#[test]
fn the_lots_of_a_file_have_their_attributes_and_seeds() {
    let folder = Folder::new("lots");
    let square = |east: f64| {
        let (low, high) = (east, east + 0.0002);
        format!("[[[{low}, 0], [{high}, 0], [{high}, 0.0002], [{low}, 0.0002], [{low}, 0]]]")
    };
    let polygon = |id: &str, properties: &str, east: f64| {
        let ring = square(east);
        format!(
            "{{\"type\": \"Feature\", \"id\": \"{id}\", \"properties\": {properties}, \
             \"geometry\": {{\"type\": \"Polygon\", \"coordinates\": {ring}}}}}"
        )
    };
    let features = [
        polygon("low", "{\"height\": 6, \"owner\": \"Ann\"}", -0.001),
        "{\"type\": \"Feature\", \"properties\": null, \"geometry\": {\"type\": \"Point\", \"coordinates\": [0, 0]}}"
            .to_owned(),
        polygon("high", "{\"height\": \"18\"}", 0.0),
    ];
    folder.write(
        "town.geojson",
        &format!("{{\"type\": \"FeatureCollection\", \"features\": [{}]}}", features.join(", ")),
    );
    let output = folder.run("run tower.cga --footprint town.geojson --seed 3 -o town.obj -o town.svg");
    let errors = text(&output.stderr);
    assert!(output.status.success(), "{errors}");
    assert!(
        errors.contains("feature 2 is left out: a Point is not a polygon") && errors.contains("2 lots, "),
        "{errors}"
    );
    let obj = text(&folder.read("town.obj"));
    let corners: Vec<[f64; 3]> = obj
        .lines()
        .filter_map(|line| line.strip_prefix("v "))
        .map(|line| {
            let mut numbers = line.split(' ').map(|number| number.parse().expect("a number"));
            [(); 3].map(|()| numbers.next().expect("three"))
        })
        .collect();
    let walls = |west: bool| corners.iter().filter(move |corner| (corner[0] < 0.0) == west).map(|corner| corner[1]);
    // 0.0002 degrees are 22.2 m at the equator, so the roof adds 6.4 m.
    for (west, height) in [(true, 6.0), (false, 18.0)] {
        let top = walls(west).fold(0.0, f64::max);
        assert!((height + 6.3..height + 6.9).contains(&top), "{west}: {top}");
    }
    assert!(text(&folder.read("town.svg")).starts_with("<svg"));
}

#[test]
fn mistakes_have_a_message_and_a_status() {
    let folder = Folder::new("mistakes");
    folder.write("wrong.cga", "Lot --> extrude(\n");
    folder.write("endless.cga", "Lot --> split(x) { '0.5 : Lot Lot Lot | ~1 : Lot Lot Lot }");
    folder.write("fault.cga", "Lot --> i(\"lost.obj\") X.");
    folder.write("empty.obj", "v 0 0 0\n");
    fs::create_dir_all(folder.0.join("rules")).expect("a folder");
    fs::create_dir_all(folder.0.join("empty/inner")).expect("a folder");
    folder.write("parts.cga", "Part(n) --> X.");
    folder.write("points.geojson", "{\"type\": \"Point\", \"coordinates\": [0, 0]}");
    folder.write("rules/in.cga", "Lot --> X.");
    folder.write("part.cga", "Part(n) --> X.");
    folder.write("import.cga", "import part : \"part.cga\"  Lot --> part.Part(1)");
    folder.write("feet.geojson", "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [900, 0], [900, 900], [0, 0]]]}");
    for (args, status, message) in [
        ("run tower.cga --set heigth=3", 2, "unknown attribute `heigth`; did you mean `height`?"),
        ("run tower.cga --set height=300", 2, "attribute `height`: 300 is outside of 6 to 60"),
        ("run tower.cga --start Lott", 2, "`Lott` is not a start rule"),
        ("run parts.cga", 1, "start rule"),
        ("run lost.cga", 2, "cannot read `lost.cga`"),
        ("run wrong.cga", 1, "error[unclosed_bracket]"),
        ("run endless.cga --deadline 0.05", 1, "the run was ended after 0.05 seconds; no file was written"),
        ("run fault.cga", 0, "lost.obj"),
        ("run fault.cga", 0, "no asset folder is set (`--assets FOLDER`)"),
        ("run fault.cga --deny-faults", 1, "lost.obj"),
        ("run tower.cga -o tower.stl", 2, "`tower.stl` ends in none of .glb, .obj, .png and .svg"),
        ("run tower.cga -o lost/tower.glb", 2, "cannot write `lost/tower.glb`"),
        ("run tower.cga --mesh tower.cga", 2, "cannot read `tower.cga`"),
        ("run tower.cga --footprint tower.cga", 2, "it is not GeoJSON"),
        ("run tower.cga --footprint feet.geojson", 2, "convert the file to EPSG:4326 first"),
        ("run tower.cga -o lost/tower.glb --start Lott", 2, "the folder `lost` does not exist; make it first"),
        ("run tower.cga -o a.glb -o ./a.glb", 2, "`./a.glb` is given twice"),
        ("run tower.cga -o a.glb --reports a.glb", 2, "`a.glb` is given twice"),
        ("run tower.cga --mesh empty.obj -o ./empty.obj", 2, "`./empty.obj` is an input of the run"),
        ("run tower.cga --reports rules/../tower.cga", 2, "`rules/../tower.cga` is an input of the run"),
        ("run tower.cga --assets lost", 2, "cannot read assets from `lost`: the folder does not exist"),
        ("run tower.cga --mesh empty.obj", 2, "cannot read `empty.obj`: it has no faces"),
        ("run rules/../tower.cga --root rules", 2, "it is not a file in `rules`"),
        ("run rules/in.cga --root rules", 0, "1 parts"),
        ("run rules/in.cga --root lost", 2, "cannot read `lost`"),
        ("attributes lost.cga", 2, "cannot read `lost.cga`"),
        ("check wrong.cga", 1, ""),
        ("check lost.cga", 2, "cannot read"),
        ("check empty", 2, "`empty` has no file whose name ends in .cga"),
        ("check tower.cga empty", 2, "`empty` has no file whose name ends in .cga"),
        ("watch tower.cga -o x.stl", 2, "`x.stl` ends in none of"),
        ("run tower.cga --footprint points.geojson", 1, "feature 1 is left out: a Point is not a polygon"),
        ("watch tower.cga --assets lost", 2, "cannot watch `lost`"),
        ("run import.cga --reports part.cga", 2, "`part.cga` is an input of the run"),
        ("run import.cga --assets rules -o rules/new.glb --reports new.json", 0, "wrote `rules/new.glb`"),
        // The output of the first run is among the assets of the second.
        ("run import.cga --assets rules -o rules/new.glb --reports new.json", 0, "wrote `rules/new.glb`"),
    ] {
        let output = folder.run(args);
        let errors = text(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{args}: {errors}");
        assert!(errors.contains(message), "{args}: {errors}");
    }
}

/// A link to the rules has another name.
#[cfg(unix)]
#[test]
fn the_file_of_a_link_is_an_input_too() {
    let folder = Folder::new("link");
    let rules = folder.read("tower.cga");
    std::os::unix::fs::symlink("tower.cga", folder.0.join("x.json")).expect("a link");
    let output = folder.run("run tower.cga --reports x.json");
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("`x.json` is an input of the run"), "{}", text(&output.stderr));
    assert!(folder.read("tower.cga") == rules);
}

/// Rules of others may have escapes of terminals, and marks that turn the direction of writing.
#[test]
fn a_terminal_gets_no_escapes_from_rules() {
    let folder = Folder::new("escapes");
    let escape = "\u{1b}[2J\u{202e}\r";
    let rules = format!("attr name = \"{escape}\"\nLot --> set(material.name, name) i(name) Wall /* {escape} */\n");
    folder.write("escape.cga", &rules);
    folder.write("wrong.cga", &format!("Lot --> X. + /* {escape} */ \"{escape}\"\n"));
    let commands = ["check escape.cga", "check wrong.cga", "check wrong.cga --format short", "attributes escape.cga"];
    for args in commands.into_iter().chain(["run escape.cga", "run wrong.cga", "run escape.cga --lot \u{1b}x"]) {
        let Output { stdout, stderr, .. } = folder.run(args);
        let all = text(&stdout) + &text(&stderr);
        assert!(!all.contains(['\u{1b}', '\u{202e}', '\r']) && all.contains("\\u{1b}"), "{args}: {all:?}");
    }
}

/// A program that has the file before open still reads it.
#[test]
fn reports_take_the_place_of_the_file_before_when_they_are_whole() {
    use std::io::Read as _;
    let folder = Folder::new("whole-reports");
    folder.write("x.json", "before");
    let mut before = fs::File::open(folder.0.join("x.json")).expect("the file");
    let output = folder.run("run tower.cga --reports x.json");
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let mut text = String::new();
    before.read_to_string(&mut text).expect("the file before");
    assert_eq!(text, "before");
    assert!(folder.read("x.json").starts_with(b"{"));
}

/// A feature with a square at some degrees to the east.
fn square(id: u32, properties: &str, east: f64) -> String {
    let (low, high) = (east, east + 0.0002);
    format!(
        "{{\"type\": \"Feature\", \"id\": {id}, \"properties\": {properties}, \"geometry\": {{\"type\": \"Polygon\", \"coordinates\": \
         [[[{low}, 0], [{high}, 0], [{high}, 0.0002], [{low}, 0.0002], [{low}, 0]]]}}}}"
    )
}

fn collection(features: &[String]) -> String {
    format!("{{\"type\": \"FeatureCollection\", \"features\": [{}]}}", features.join(", "))
}

/// A square that crosses itself.
const CROSSED: &str = "{\"type\": \"Feature\", \"properties\": null, \"geometry\": {\"type\": \"Polygon\", \"coordinates\": \
                       [[[0, 0], [0.1, 0.1], [0.1, 0], [0, 0.1], [0, 0]]]}}";

#[test]
fn lots_keep_their_seeds_when_others_cannot_be_used() {
    let folder = Folder::new("seeds");
    folder.write("random.cga", "attr value = rand(0, 1000)  Lot --> print(value) X.");
    let lines = |features: &[String]| {
        folder.write("lots.geojson", &collection(features));
        let output = folder.run("run random.cga --footprint lots.geojson");
        assert_ne!(output.status.code(), Some(2), "{}", text(&output.stderr));
        text(&output.stdout).lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let [first, second, third] = [0, 1, 2].map(|at| square(at, "null", 0.001 * f64::from(at)));
    let all = lines(&[first.clone(), second, third.clone()]);
    assert_eq!(lines(&[first, CROSSED.to_owned(), third]), [all[0].clone(), all[2].clone()]);
}

#[test]
fn properties_are_read_by_the_types_of_attributes() {
    let folder = Folder::new("properties");
    folder.write(
        "lot.cga",
        "attr height = 1  attr list = [1]  attr name = \"\"  Lot --> print(name + height + size(list)) X.",
    );
    let features = [
        square(1, "{\"height\": \"tall\", \"list\": [1, 2, 3], \"name\": 7}", 0.0),
        square(2, "{\"height\": \"2\", \"list\": null, \"name\": \"n\"}", 0.001),
    ];
    folder.write("lots.geojson", &format!("\u{feff}{}", collection(&features)));
    let output = folder.run("run lot.cga --footprint lots.geojson");
    assert_eq!(text(&output.stdout), "713\nn21\n");
    let note = "lots.geojson: feature `1`: its property `height` is left out: \"tall\" is not a number\n";
    assert!(text(&output.stderr).contains(note), "{}", text(&output.stderr));
}

#[test]
fn a_value_that_is_refused_is_named_and_the_other_lots_are_made() {
    let folder = Folder::new("refused");
    let features = [
        square(1, "{\"height\": 300}", 0.0),
        square(2, "{\"height\": 30}", 0.001),
        square(3, "{\"height\": 8}", 0.002),
    ];
    folder.write("lots.geojson", &collection(&features));
    let output = folder.run("run tower.cga --footprint lots.geojson -o town.obj");
    let errors = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{errors}");
    let note =
        "lots.geojson: feature `1`: its property `height` is left out: attribute `height`: 300 is outside of 6 to 60\n";
    assert!(errors.contains(note) && errors.contains("3 lots, "), "{errors}");
    assert!(folder.0.join("town.obj").is_file());
    // A value may be one of the values of another one that comes later.
    folder.write("lot.cga", "@Enum(valuesAttr = list, restricted = true) attr one = \"a\"  attr list = [\"a\"]  Lot --> print(one + size(list)) X.");
    folder.write("lots.geojson", &collection(&[square(1, "{\"one\": \"b\", \"list\": [\"b\", \"c\"]}", 0.0)]));
    let output = folder.run("run lot.cga --footprint lots.geojson");
    assert_eq!((output.status.code(), text(&output.stdout)), (Some(0), "b2\n".to_owned()), "{}", text(&output.stderr));
}

#[test]
fn lots_far_from_each_other_have_a_note_and_lots_around_the_antimeridian_are_neighbours() {
    let folder = Folder::new("far");
    folder.write("lot.cga", "Lot --> X.");
    let run = |features: &[String]| {
        folder.write("lots.geojson", &collection(features));
        let output = folder.run("run lot.cga --footprint lots.geojson -o town.obj");
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        let widest = text(&folder.read("town.obj"))
            .lines()
            .filter_map(|line| line.strip_prefix("v ")?.split(' ').next()?.parse::<f64>().ok())
            .fold(0.0, |widest: f64, x| widest.max(x.abs()));
        (text(&output.stderr), widest)
    };
    let (errors, widest) = run(&[square(1, "null", -20.0), square(2, "null", 20.0)]);
    assert!(
        errors.contains("the lots are up to 2226 km from their middle: the Earth is taken as flat") && 2e6 < widest,
        "{errors}"
    );
    let (errors, widest) = run(&[square(1, "null", 179.999), square(2, "null", -179.999)]);
    assert!(!errors.contains("from their middle") && widest < 200.0, "{errors} {widest}");
}

#[test]
fn the_polygons_of_a_collection_are_lots_and_its_other_parts_are_named() {
    let folder = Folder::new("parts");
    folder.write("random.cga", "attr value = rand(0, 1000)  Lot --> print(value) X.");
    let run = |geometry: &str| {
        let others = [1, 2].map(|at| square(at, "null", 0.001 * f64::from(at)));
        let feature = format!("{{\"type\": \"Feature\", \"id\": 0, \"properties\": null, \"geometry\": {geometry}}}");
        folder.write("lots.geojson", &collection(&[feature, others[0].clone(), others[1].clone()]));
        let output = folder.run("run random.cga --footprint lots.geojson");
        let lines: Vec<String> = text(&output.stdout).lines().map(str::to_owned).collect();
        (output.status.code(), lines, text(&output.stderr))
    };
    let inside = |parts: &str| format!("{{\"type\": \"GeometryCollection\", \"geometries\": [{parts}]}}");
    let ring = "[[[0, 0], [0.0002, 0], [0.0002, 0.0002], [0, 0.0002], [0, 0]]]";
    let (polygon, point) = (
        format!("{{\"type\": \"Polygon\", \"coordinates\": {ring}}}"),
        "{\"type\": \"Point\", \"coordinates\": [0, 0]}",
    );
    let (status, all, errors) = run(&polygon);
    assert_eq!((status, all.len()), (Some(0), 3), "{errors}");
    let (status, same, errors) = run(&inside(&format!("{point}, {}, {point}", inside(&format!("{point}, {polygon}")))));
    assert_eq!((status, &same), (Some(0), &all), "{errors}");
    assert_eq!(errors.matches("feature `0`: a Point of its collection is left out").count(), 1, "{errors}");
    // Without a polygon, the feature counts for no seed.
    let (status, some, errors) = run(&inside(point));
    assert_eq!((status, some), (Some(0), all[..2].to_vec()), "{errors}");
    assert!(errors.contains("feature `0` is left out: it has no polygon"), "{errors}");
    // A broken one counts as one polygon.
    let deep = (0..10_000).fold(polygon.clone(), |inner, _| inside(&inner));
    for (broken, why) in [
        (inside(&polygon.replace(ring, "[[[0]]]")), "feature `0` is left out: a corner has one number"),
        (inside(&polygon.replace(ring, "[[[]]]")), "is left out: "),
        (deep, "feature 1 is left out: "),
    ] {
        let (status, some, errors) = run(&broken);
        assert_eq!((status, some), (Some(1), all[1..].to_vec()), "{errors:.500}");
        assert!(errors.contains(why), "{errors:.500}");
    }
}

#[test]
fn a_file_without_lots_says_why() {
    let folder = Folder::new("crossed");
    folder.write("lots.geojson", &collection(&[CROSSED.to_owned()]));
    let errors = text(&folder.run("run tower.cga --footprint lots.geojson").stderr);
    assert!(errors.contains("feature 1 is left out: "), "{errors}");
}

/// The neighbours of a broken feature keep their seeds, too.
#[test]
fn a_broken_feature_is_left_out_and_the_others_are_made() {
    let folder = Folder::new("broken");
    folder.write("random.cga", "attr value = rand(0, 1000)  Lot --> print(value) X.");
    let squares = [0, 1, 2].map(|at| square(at, "null", 0.001 * f64::from(at)));
    let lines = |second: &str| {
        folder.write("lots.geojson", &collection(&[squares[0].clone(), second.to_owned(), squares[2].clone()]));
        let output = folder.run("run random.cga --footprint lots.geojson");
        let lines: Vec<String> = text(&output.stdout).lines().map(str::to_owned).collect();
        (output.status.code(), lines, text(&output.stderr))
    };
    let (status, all, _) = lines(&squares[1]);
    assert_eq!((status, all.len()), (Some(0), 3));
    for (number, why) in [
        ("NaN", "feature 2 is left out: it is not GeoJSON: "),
        ("1e999", "feature 2 is left out: it is not GeoJSON: "),
        ("\"0\"", "feature 2 is left out: it is not GeoJSON: "),
        ("1e9", "feature `1` is left out: its coordinates are not longitudes and latitudes in degrees"),
        ("-1e300", "feature `1` is left out: its coordinates"),
    ] {
        let broken = squares[1].replacen("[[[0.001", &format!("[[[{number}"), 1);
        assert_ne!(broken, squares[1]);
        let (status, some, errors) = lines(&broken);
        assert_eq!((status, some), (Some(1), vec![all[0].clone(), all[2].clone()]), "{number}: {errors}");
        assert!(errors.contains(why), "{number}: {errors}");
    }
}

/// Two streams whose readers are gone.
fn unread() -> [Stdio; 2] {
    [(); 2].map(|()| Stdio::from(std::io::pipe().expect("a pipe").1))
}

#[test]
fn readers_may_stop_reading() {
    let folder = Folder::new("closed");
    folder.write("fault.cga", "Lot --> i(\"lost.obj\") print(\"hello\") X.");
    for args in ["check tower.cga", "run fault.cga", "run fault.cga --reports -", "attributes tower.cga"] {
        let [out, error] = unread();
        let status = folder.command(args).stdout(out).stderr(error).status().expect("the command");
        assert_eq!(status.code(), Some(0), "{args}");
    }
}

#[test]
fn reports_on_standard_output_are_json_alone() {
    let folder = Folder::new("reports");
    let output = folder.run("run tower.cga --reports -");
    let reports: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(reports[0]["key"], "facades");
    assert!(text(&output.stderr).lines().any(|line| line == "3"), "{}", text(&output.stderr));
}

#[test]
fn attributes_are_listed() {
    let folder = Folder::new("attributes");
    let table = text(&folder.run("attributes tower.cga").stdout);
    assert!(table.contains("  height  12; 6 to 60; In metres.\n") && table.starts_with("start rules: Lot"), "{table}");
    let json: serde_json::Value =
        serde_json::from_slice(&folder.run("attributes tower.cga --json").stdout).expect("JSON");
    assert_eq!(json[1]["name"], "wall");
}

/// A process that ends with its test.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn a_watched_file_is_run_again_and_a_mistake_keeps_the_last_model() {
    let folder = Folder::new("watch");
    let expected = |height| compiled(&Tower { height, ..Tower::default() }, &Shape::rectangle(20.0, 15.0)).0;
    let has = |bytes: Vec<u8>| fs::read(folder.0.join("x.glb")).is_ok_and(|found| found == bytes);
    let rules = text(&folder.read("tower.cga"));
    let log = fs::File::create(folder.0.join("log")).expect("a file");
    let mut command = folder.command("watch tower.cga --name Tower -o x.glb");
    let _running = Running(command.stdout(Stdio::null()).stderr(log).spawn().expect("the command"));
    until("the first run", &|| has(expected(12.0)));
    folder.write("tower.cga", &rules.replace("height = 12", "height = 18"));
    until("a change", &|| has(expected(18.0)));
    folder.write("tower.cga", &rules.replace("extrude(height)", "extrude(height"));
    until("a mistake", &|| text(&folder.read("log")).contains("error[unclosed_bracket]"));
    assert!(has(expected(18.0)));
    folder.write("tower.cga", &rules);
    until("the mend", &|| has(expected(12.0)));
}

/// Waits until something is so. A second event may come for one change, so tests wait for results and not for runs.
fn until(what: &str, is_so: &dyn Fn() -> bool) {
    let begun = Instant::now();
    while !is_so() {
        assert!(begun.elapsed() < Duration::from_secs(60), "{what}");
        sleep(Duration::from_millis(10));
    }
}

#[test]
fn a_watch_follows_imports_above_and_a_folder_that_is_made_again() {
    let folder = Folder::new("above");
    let rules = "import part : \"part.cga\"  Lot --> part.Part";
    let make = || fs::create_dir(folder.0.join("rules")).expect("a folder");
    make();
    folder.write("rules/lot.cga", rules);
    folder.write("part.cga", "Part --> print(\"one\") X.");
    let log = fs::File::create(folder.0.join("log")).expect("a file");
    let mut command = folder.command("watch rules/lot.cga");
    let _running = Running(command.stdout(log).stderr(Stdio::null()).spawn().expect("the command"));
    let says = |line: &str| text(&folder.read("log")).lines().any(|said| said == line);
    until("the first run", &|| says("one"));
    folder.write("part.cga", "Part --> print(\"two\") X.");
    until("a change above", &|| says("two"));
    fs::remove_dir_all(folder.0.join("rules")).expect("the folder");
    make();
    folder.write("rules/lot.cga", &format!("{rules} print(\"three\")"));
    until("the folder again", &|| says("three"));
    folder.write("rules/lot.cga", &format!("{rules} print(\"four\")"));
    until("a change in it", &|| says("four"));
}
