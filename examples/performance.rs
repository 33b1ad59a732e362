//! Runs all benches and writes their tables to `docs/performance.md`, with a description of the machine.
//!
//! `cargo run --example performance`. The part of the page from `BY_HAND` on is kept as it is. Leave the machine idle meanwhile: times are the best of many runs, but on a
//! busy machine all runs are slow.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// Packages, benches and their arguments, in the order of the page.
const BENCHES: [(&str, &str, &[&str]); 16] = [
    ("cga", "rules", &[]),
    ("cga", "queries", &[]),
    ("cga-tests", "city", &[]),
    ("cga", "files", &[]),
    ("cga-tests", "watertight", &[]),
    ("cga", "scenes", &[]),
    ("cga", "scenes", &["--instructions"]),
    ("cga-tests", "memory", &[]),
    ("cga", "cutting", &[]),
    ("cga", "offset", &[]),
    ("cga", "comp", &[]),
    ("cga", "triangles", &[]),
    ("cga", "textures", &[]),
    ("cga", "relation", &[]),
    ("cga-split", "solve", &[]),
    ("cga-tests", "build", &[]),
];

const HEAD: &str = "# Performance

Written by `cargo run --example performance`, which runs all benches on one machine; do not edit, except from *Builds of the repository*
on. Times differ from machine to machine, so look at the ratios. A ratio compares two ways that run in turn in one process; each time is the best of many.

*By hand* is a loop without a grammar. It knows all sizes and fills the same buffers: vertices, indices, and where rule or
material change. *Buffers* is the grammar with `Buffers`, *terminals only* the grammar with a sink that keeps nothing. Every
scene is checked: counts and checksums equal the formulas, and both ways have the same runs. Growth divides the cost of
a terminal in the largest size of a workload by the cost in the smallest: 1 is linear.

A is a façade with windows, A-color the same with a colour in every bay, A-chance with glass that is lit by chance. B is the
Menger sponge, B2 a box that is divided in the golden ratio, D a city of façades.
";

/// The heading of the part of the page that is written by hand.
const BY_HAND: &str = "\n## Builds of the repository\n";

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let path = root.join("docs/performance.md");
    let old = fs::read_to_string(&path)?;
    let by_hand = old.find(BY_HAND).map_or("", |start| &old[start..]);
    let mut page = format!("{HEAD}\nThe machine: {}.\n", machine());
    for (package, bench, arguments) in BENCHES {
        let output = Command::new(env!("CARGO"))
            .args(["bench", "--package", package, "--bench", bench, "--"])
            .args(arguments)
            .current_dir(root)
            .stderr(Stdio::inherit())
            .output()?;
        if !output.status.success() {
            return Err(format!("the bench `{bench}` failed").into());
        }
        let tables = String::from_utf8(output.stdout)?;
        print!("{tables}");
        page.push_str(&tables);
    }
    page.push_str(by_hand);
    fs::write(path, page)?;
    Ok(())
}

/// Processor, cores, operating system and compiler.
fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or(1, |cores| cores.get());
    let compiler = first_line("rustc", &["--version"]).unwrap_or_else(|| "an unknown compiler".to_owned());
    format!("{}, {cores} cores, {}, {compiler}", processor(), system())
}

fn processor() -> String {
    field("/proc/cpuinfo", "model name", ':')
        .or_else(|| first_line("sysctl", &["-n", "machdep.cpu.brand_string"]))
        .or_else(|| std::env::var("PROCESSOR_IDENTIFIER").ok())
        .unwrap_or_else(|| std::env::consts::ARCH.to_owned())
}

fn system() -> String {
    field("/etc/os-release", "PRETTY_NAME", '=').unwrap_or_else(|| std::env::consts::OS.to_owned())
}

/// The value after a key at the start of a line, without quotes.
fn field(file: &str, key: &str, between: char) -> Option<String> {
    let text = fs::read_to_string(file).ok()?;
    let line = text.lines().find(|line| line.starts_with(key))?;
    Some(line.split_once(between)?.1.trim().trim_matches('"').to_owned())
}

fn first_line(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.lines().next()?.to_owned())
}
