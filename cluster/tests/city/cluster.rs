//! Ballista on loopback: a scheduler and two executors as processes, some of which are killed.

use std::collections::BTreeMap;
use std::fs;
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU16, Ordering};
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

use crate::world::{CHOICES, World, assert_equal, expected_failures, failures, files};

/// A process that is killed at the end.
pub(crate) struct Process(Child);

impl Process {
    fn start(world: &World, program: &Path, log: &str, args: &[&str]) -> Self {
        let log = fs::File::create(world.path(log)).expect("room");
        let mut command = Command::new(program);
        let command = command.args(args).current_dir(world.path("")).env("RUST_LOG", "warn");
        Process(
            command
                .stderr(log.try_clone().expect("a file"))
                .stdout(log)
                .stdin(Stdio::null())
                .spawn()
                .expect("a process"),
        )
    }

    fn kill(mut self) {
        self.0.kill().expect("it runs");
        self.0.wait().expect("an end");
    }

    /// Waits for the end.
    pub(crate) fn ended_well(&mut self) -> bool {
        let begun = Instant::now();
        loop {
            if let Some(status) = self.0.try_wait().expect("a status") {
                return status.success();
            }
            assert!(begun.elapsed() < Duration::from_secs(400), "the job does not end");
            sleep(Duration::from_millis(50));
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// The first of two neighbouring ports that are free.
fn port() -> u16 {
    static NEXT: AtomicU16 = AtomicU16::new(0);
    loop {
        let at = NEXT.fetch_add(2, Ordering::Relaxed);
        let port = 21_000 + (std::process::id() as u16 % 4000) * 8 + at;
        if [port, port + 1].iter().all(|port| TcpListener::bind(("127.0.0.1", *port)).is_ok()) {
            return port;
        }
    }
}

pub(crate) struct Cluster<'w> {
    world: &'w World,
    program: PathBuf,
    address: String,
    port: String,
}

impl<'w> Cluster<'w> {
    pub(crate) fn new(world: &'w World) -> Self {
        Cluster::of(world, env!("CARGO_BIN_EXE_cga-cluster").into())
    }

    /// A cluster of another program.
    pub(crate) fn of(world: &'w World, program: PathBuf) -> Self {
        let port = port();
        Cluster { world, program, address: format!("127.0.0.1:{port}"), port: port.to_string() }
    }

    pub(crate) fn scheduler(&self) -> Process {
        let scheduler =
            Process::start(self.world, &self.program, "scheduler.log", &["scheduler", "--port", &self.port]);
        // Executors wait for it.
        while std::net::TcpStream::connect(&self.address).is_err() {
            sleep(Duration::from_millis(50));
        }
        scheduler
    }

    pub(crate) fn executor(&self, name: &str) -> Process {
        let (port, log) = (port().to_string(), format!("{name}.log"));
        let args = ["executor", "--scheduler", &self.address, "--port", &port, "--cores", "1", "--work-dir", name];
        Process::start(self.world, &self.program, &log, &args)
    }

    pub(crate) fn submit(&self) -> Process {
        Process::start(
            self.world,
            &self.program,
            "submit.log",
            &["submit", "job.toml", "--scheduler", &self.address, "--quiet"],
        )
    }

    /// Waits until a third of the tiles is made, and a unit is finished.
    fn wait_for_a_third(&self, expected: usize) {
        let begun = Instant::now();
        while count(&self.world.path("out/tiles")) < expected / 3 || units(&self.world.path("out/units")).is_empty() {
            assert!(begun.elapsed() < Duration::from_secs(300), "no tile is made: {}", self.logs());
            sleep(Duration::from_millis(10));
        }
    }

    pub(crate) fn logs(&self) -> String {
        let log = |name: &str| fs::read_to_string(self.world.path(name)).unwrap_or_default();
        ["submit.log", "scheduler.log", "one.log", "two.log"].map(|name| format!("{name}:\n{}", log(name))).join("\n")
    }
}

fn count(folder: &Path) -> usize {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.map(|entry| if entry.path().is_dir() { count(&entry.path()) } else { 1 }).sum()
}

/// The files of finished units, with their times.
fn units(folder: &Path) -> BTreeMap<String, SystemTime> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if entry.path().is_dir() {
            found.extend(units(&entry.path()));
        } else if entry.path().extension().is_some_and(|ending| ending == "json") {
            let time = entry.metadata().expect("a file").modified().expect("a time");
            found.insert(entry.path().to_string_lossy().into_owned(), time);
        }
    }
    found
}

/// Lots of several units, all in one wave of a job with several parts, and the city that is expected.
fn world(rows: u64) -> (World, BTreeMap<String, Vec<u8>>) {
    let world = World::new(12, rows, 100);
    world.write_job("out", &format!("{}partitions = 8\n", CHOICES.replace("wave_size = 1", "wave_size = 64")));
    let expected = files(&world.expected());
    (world, expected)
}

fn assert_whole(world: &World, expected: &BTreeMap<String, Vec<u8>>) {
    assert_equal(&files(&world.path("out")), expected);
    let [rows, buildings] = failures(&world.path("out"));
    assert_eq!([&rows, &buildings], expected_failures(&world.path("expected")).each_ref());
}

/// The rows of a town. On a fast machine a job may end before its processes are killed; then it is tried with more rows.
const ROWS: [u64; 3] = [1500, 6000, 24_000];

#[test]
fn a_job_whose_executor_is_killed_has_the_same_tiles() {
    assert!(ROWS.into_iter().any(killed_executor), "each job ended before its executor was killed");
}

/// False if the job had ended.
fn killed_executor(rows: u64) -> bool {
    let (world, expected) = world(rows);
    let cluster = Cluster::new(&world);
    let _scheduler = cluster.scheduler();
    let (_one, two) = (cluster.executor("one"), cluster.executor("two"));
    let mut submit = cluster.submit();
    cluster.wait_for_a_third(expected.len());
    two.kill();
    if world.path("out/tileset.json").exists() {
        return false;
    }
    assert!(submit.ended_well(), "{}", cluster.logs());
    assert_whole(&world, &expected);
    true
}

#[test]
fn a_job_is_submitted_again_after_its_client_and_scheduler_were_killed() {
    assert!(ROWS.into_iter().any(killed_client), "each job ended before its client was killed");
}

/// False if the job had finished all its units.
fn killed_client(rows: u64) -> bool {
    let (world, expected) = world(rows);
    let cluster = Cluster::new(&world);
    let scheduler = cluster.scheduler();
    let (one, two) = (cluster.executor("one"), cluster.executor("two"));
    let submit = cluster.submit();
    cluster.wait_for_a_third(expected.len());
    submit.kill();
    scheduler.kill();
    [one, two].into_iter().for_each(Process::kill);
    let finished = units(&world.path("out/units"));
    if world.path("out/tileset.json").exists() {
        return false;
    }

    let _scheduler = cluster.scheduler();
    let (_one, _two) = (cluster.executor("one"), cluster.executor("two"));
    assert!(cluster.submit().ended_well(), "{}", cluster.logs());
    assert_whole(&world, &expected);
    let after = units(&world.path("out/units"));
    assert!(finished.iter().all(|(name, time)| after[name] == *time), "finished units were made again");
    let said = fs::read_to_string(world.path("submit.log")).expect("a log");
    let counts = format!("{} units made, {} kept", after.len() - finished.len(), finished.len());
    assert!(said.contains(&counts), "{said}");
    finished.len() < after.len()
}

#[test]
fn a_job_without_an_executor_names_the_command_for_one() {
    let world = World::new(1, 50, 0);
    let cluster = Cluster::new(&world);
    let _scheduler = cluster.scheduler();
    let mut submit = cluster.submit();
    let begun = Instant::now();
    while !cluster.logs().contains("cga-cluster executor --scheduler 127.0.0.1:") {
        assert!(begun.elapsed() < Duration::from_secs(300), "no message: {}", cluster.logs());
        sleep(Duration::from_millis(50));
    }
    let _one = cluster.executor("one");
    assert!(submit.ended_well(), "{}", cluster.logs());
    assert_equal(&files(&world.path("out")), &files(&world.expected()));
}
