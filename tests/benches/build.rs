//! The build cost of rules: a program with 1,000 rules in release, with one sink and with three, a façade with and
//! without styles, and a library at one site and at nine.
//!
//! `cargo bench -p cga-tests --bench build`; a number after `--` changes the count of rules. The program is written to a temporary
//! folder and built there. Its dependencies are built before and not counted.

#[path = "../../benches/common/mod.rs"]
mod common;
#[path = "build/facade.rs"]
mod facade;
#[path = "build/rules.rs"]
mod rules;

use std::fs;
use std::hint::black_box;
use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};

use cga_lang::compile::compile_text;
use cga_tests::tree::root;
use common::clock::fastest;
use common::table::{Table, number};

/// A program with one rule. Its size is subtracted from the size of the other programs.
const EMPTY: &str = r##"
cga::cga! { pub grammar Rules = "Lot --> Leaf."; }
"##;

const RULES: &str = r##"
cga::cga! { pub grammar Rules in "src/rules.cga"; }
"##;

const PLAIN: &str = r##"
cga::cga! { pub grammar Rules in "src/plain.cga"; }
"##;

const STYLES: &str = r##"
cga::cga! { pub grammar Rules in "src/styles.cga"; }
"##;

const ONE_SITE: &str = r##"
cga::cga! { pub grammar Rules in "src/wings0/main.cga"; }
"##;

const NINE_SITES: &str = r##"
cga::cga! { pub grammar Rules in "src/wings4/main.cga"; }
"##;

/// The number of styles of the façade, beside `Default`.
const STYLE_COUNT: usize = 14;

/// The rest of a program. Its argument is the start rule.
const MAIN: &str = r##"
use cga::sink::{buffers::Buffers, stats::Stats};
use cga::{Model, Settings, Shape};

fn main() {
    let settings = Settings { start: std::env::args().nth(1), ..Settings::default() };
    let (rules, shape) = (Rules::default(), Shape::rectangle(20.0, 12.0));
    let _ = (Buffers::new(), Model::new(), Stats::new());
SINKS}
"##;

const SINKS: [&str; 3] = [
    "    let mut out = Buffers::new();\n    rules.run(&shape, &settings, &mut out).unwrap();\n    println!(\"{}\", out.triangle_count());\n",
    "    let mut out = Model::new();\n    rules.run(&shape, &settings, &mut out).unwrap();\n    println!(\"{}\", out.len());\n",
    "    let mut out = Stats::new();\n    rules.run(&shape, &settings, &mut out).unwrap();\n    println!(\"{}\", out.total().leaves);\n",
];

fn main() {
    let asked = std::env::args().skip(1).find_map(|argument| argument.parse().ok());
    let text = rules::rules(asked.unwrap_or(1000));
    let count = front_half(&text);

    let project = Project::new(&text);
    project.build("empty", None);
    let (_, empty) = project.build("empty", None);
    let (one_time, one) = project.build("one", Some("Lot_0"));
    let (three_time, three) = project.build("three", Some("Lot_0"));
    let columns = ["program", "time / one sink", "build, s", "bytes a rule", "bytes a rule and sink"];
    let mut table = Table::new(&format!("Build: {count} rules in release"), &columns);
    for (name, sinks, time, size) in [("one sink", 1, one_time, one), ("three sinks", 3, three_time, three)] {
        let each = (size - empty) as f64 / count as f64;
        let cells = [
            number(time.as_secs_f64() / one_time.as_secs_f64(), 2),
            number(time.as_secs_f64(), 1),
            number(each, 0),
            number(each / f64::from(sinks), 0),
        ];
        table.row(name, &cells);
    }
    table.note("Buffers; buffers, a model and statistics. Bytes of the stripped binary, without the bytes of a program with one rule.");
    table.print();
    styles(&project, empty);
    imports(&project, empty);
}

/// Builds a façade without styles and with them. `empty` is the size of a program with one rule.
fn styles(project: &Project, empty: u64) {
    let columns = ["program", "time / without styles", "build, s", "lines", "kilobytes"];
    let mut table = Table::new("Build: a façade in release", &columns);
    let (plain_time, plain) = project.build("plain", Some("Lot"));
    let (styles_time, styles) = project.build("styles", Some("Style3$Lot"));
    for (name, count, time, size) in
        [("without styles", 0, plain_time, plain), ("14 styles", STYLE_COUNT, styles_time, styles)]
    {
        let cells = [
            number(time.as_secs_f64() / plain_time.as_secs_f64(), 2),
            number(time.as_secs_f64(), 1),
            facade::rules(count).lines().count().to_string(),
            number((size - empty) as f64 / 1000.0, 0),
        ];
        table.row(name, &cells);
    }
    table.print();
}

/// Builds a building with a library at one site and at nine. `empty` is the size of a program with one rule.
fn imports(project: &Project, empty: u64) {
    let columns = ["program", "time / one site", "build, s", "lines", "kilobytes"];
    let mut table = Table::new("Build: a library in release", &columns);
    let (one_time, one) = project.build("one_site", Some("Lot"));
    let (nine_time, nine) = project.build("nine_sites", Some("Lot"));
    for (name, wings, time, size) in [("one site", 0, one_time, one), ("nine sites", 4, nine_time, nine)] {
        let lines: usize = facade::imports(wings).iter().map(|(_, text)| text.lines().count()).sum();
        let cells = [
            number(time.as_secs_f64() / one_time.as_secs_f64(), 2),
            number(time.as_secs_f64(), 1),
            lines.to_string(),
            number((size - empty) as f64 / 1000.0, 0),
        ];
        table.row(name, &cells);
    }
    table.print();
}

/// Measures the front half of the compiler, up to the IR. Returns the number of rules.
fn front_half(text: &str) -> usize {
    let source = compile_text(text);
    assert!(source.compiled.diags.is_empty(), "{:?}", source.compiled.diags.first().map(|diag| &diag.message));
    // This count includes the rules made from blocks of splits and comps.
    let lowered = source.compiled.grammar.expect("there are no errors").rules.len();
    let count = text.matches("-->").count();
    let [best] = fastest(2.0, [&mut || drop(black_box(compile_text(black_box(text))))]);
    let time = best.as_secs_f64();
    let mut table =
        Table::new(&format!("Front half: {count} rules from text to IR"), &["step", "ms", "us a rule", "functions"]);
    table.row("compile", &[number(time * 1e3, 1), number(time * 1e6 / count as f64, 1), lowered.to_string()]);
    table.print();
    count
}

/// A package in a temporary folder, with a program for each number of sinks.
struct Project {
    folder: PathBuf,
}

impl Project {
    fn new(text: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("cga-build-{}", std::process::id()));
        let ours = root();
        let manifest = format!(
            "[package]\nname = \"rules\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n\
             [dependencies]\ncga = {{ path = {ours:?} }}\n\n[profile.release]\nstrip = true\n\n[workspace]\n"
        );
        let project = Project { folder };
        project.write("Cargo.toml", &manifest);
        let lock = fs::read_to_string(ours.join("Cargo.lock")).expect("a lock file");
        project.write("Cargo.lock", &lock);
        project.write("src/rules.cga", text);
        project.write("src/plain.cga", &facade::rules(0));
        project.write("src/styles.cga", &facade::rules(STYLE_COUNT));
        for wings in [0, 4] {
            for (name, text) in facade::imports(wings) {
                project.write(&format!("src/wings{wings}/{name}"), &text);
            }
        }
        let programs = [
            ("empty", EMPTY, 3),
            ("one", RULES, 1),
            ("three", RULES, 3),
            ("plain", PLAIN, 1),
            ("styles", STYLES, 1),
            ("one_site", ONE_SITE, 1),
            ("nine_sites", NINE_SITES, 1),
        ];
        for (name, head, sinks) in programs {
            let main = MAIN.replace("SINKS", &SINKS[..sinks].concat());
            project.write(&format!("src/bin/{name}.rs"), &format!("{head}{main}"));
        }
        project
    }

    fn write(&self, path: &str, text: &str) {
        let path = self.folder.join(path);
        fs::create_dir_all(path.parent().unwrap_or(&self.folder)).expect("a folder that can be made");
        fs::write(path, text).expect("a file that can be written");
    }

    /// Builds a program. Returns the time and the size of the binary in bytes. Checks that the program runs from
    /// `first_rule`.
    fn build(&self, program: &str, first_rule: Option<&str>) -> (Duration, u64) {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let target = self.folder.join("target");
        let start = Instant::now();
        let status = Command::new(cargo)
            .args(["build", "--release", "--offline", "--quiet", "--bin", program])
            .current_dir(&self.folder)
            .env("CARGO_TARGET_DIR", &target)
            .status()
            .expect("cargo runs");
        let time = start.elapsed();
        assert!(status.success(), "`{program}` does not build");
        let binary = target.join("release").join(format!("{program}{}", std::env::consts::EXE_SUFFIX));
        let run = Command::new(&binary).args(first_rule).output().expect("the program runs");
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        (time, fs::metadata(binary).expect("a binary").len())
    }
}

impl Drop for Project {
    fn drop(&mut self) {
        // A remaining folder does no harm.
        let _ = fs::remove_dir_all(&self.folder);
    }
}
