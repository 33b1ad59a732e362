//! The command line of `cga-cluster`, also for programs with compiled grammars.

use std::net::TcpStream;
use std::path::PathBuf;
use std::process::ExitCode;
use std::thread::available_parallelism;
use std::time::{Duration, Instant};

use cga::Grammar;
use cga_city::program;
use cga_city::units::compiled;
use clap::{Args, Parser, Subcommand};

use crate::engine::{self, Engine};
use crate::job::Job;
use crate::progress_bar::ProgressBar;
use crate::run::{Summary, run};
use crate::threads::threads;
use crate::town;

/// Makes 3D Tiles of the lots of GeoParquet files with CGA rules, on one machine or many.
#[derive(Debug, Parser)]
#[command(name = "cga-cluster", version)]
struct Options {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Makes a town of made-up outlines in the folder `town`, and says what to type next
    Town(TownOptions),
    /// Runs a job in this process
    Run(RunOptions),
    /// Runs a job on the machines of a scheduler
    Submit(SubmitOptions),
    /// Runs the scheduler of a cluster
    Scheduler(SchedulerOptions),
    /// Runs an executor of a cluster
    Executor(ExecutorOptions),
}

#[derive(Debug, Args)]
struct TownOptions {
    /// Shows no progress
    #[arg(long)]
    quiet: bool,
}

#[derive(Debug, Args)]
struct RunOptions {
    /// The file of the job
    job: PathBuf,
    /// The number of threads [default: one on each processor]
    #[arg(long, value_name = "COUNT")]
    threads: Option<usize>,
    /// Shows no progress
    #[arg(long)]
    quiet: bool,
}

#[derive(Debug, Args)]
struct SubmitOptions {
    /// The file of the job
    job: PathBuf,
    /// The scheduler
    #[arg(long, value_name = "HOST:PORT", default_value = "127.0.0.1:50050")]
    scheduler: String,
    /// Shows no progress
    #[arg(long)]
    quiet: bool,
}

#[derive(Debug, Args)]
struct SchedulerOptions {
    /// The address that executors and clients reach
    #[arg(long, default_value = "127.0.0.1")]
    host: String,
    /// The port
    #[arg(long, default_value_t = 50050)]
    port: u16,
}

#[derive(Debug, Args)]
struct ExecutorOptions {
    /// The scheduler
    #[arg(long, value_name = "HOST:PORT", default_value = "127.0.0.1:50050")]
    scheduler: String,
    /// The address that other executors reach
    #[arg(long, default_value = "127.0.0.1")]
    host: String,
    /// The port for data; the next one is for orders
    #[arg(long, default_value_t = 50051)]
    port: u16,
    /// The number of parts of queries that run at a time [default: one on each processor]
    #[arg(long, value_name = "COUNT")]
    cores: Option<usize>,
    /// The folder of parts of results
    #[arg(long, value_name = "DIR", default_value = "cga-cluster-work")]
    work_dir: PathBuf,
}

/// Runs the command with compiled grammars, which jobs name in the key `compiled`. Scheduler, executors and clients are the same program.
///
/// ```no_run
/// use cga::{Grammar as _, cga};
///
/// cga! {
///     grammar House;
///     attr height = 9
///     Lot --> extrude(height) Body.
/// }
///
/// fn main() -> std::process::ExitCode {
///     cga_cluster::program::main([House::default().boxed()])
/// }
/// ```
pub fn main(grammars: impl IntoIterator<Item = Box<dyn Grammar + Send + Sync>>) -> ExitCode {
    // Ballista reports lost executors; `RUST_LOG=info` has more.
    env_logger::Builder::from_env(env_logger::Env::default().default_filter_or("error,cga_cluster=warn")).init();
    let added = grammars.into_iter().try_for_each(compiled::add);
    let runtime = tokio::runtime::Runtime::new().map_err(|why| format!("cannot start threads: {why}"));
    let ended = added.and(runtime).and_then(|runtime| runtime.block_on(command(Options::parse().command)));
    match ended {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// The most threads of a process, and the most parts of queries that run at a time in it. Its memory grows with their square.
const MOST_THREADS: usize = 1024;

/// The most parts of queries that run at a time on a cluster.
const MOST_ON_CLUSTER: usize = 4096;

/// A number of threads or parts from 1 to a bound.
///
/// # Errors
/// A sentence: the number is larger.
fn bounded(name: &str, count: usize, most: usize) -> Result<usize, String> {
    (count <= most).then_some(count.max(1)).ok_or_else(|| format!("{name}: {count} is too many; write at most {most}"))
}

async fn command(command: Command) -> Result<(), String> {
    let processors = available_parallelism().map_or(1, usize::from);
    match command {
        Command::Town(options) => {
            let job = town::write()?;
            embedded(&Job::open(&job)?, processors, options.quiet).await?;
            let name = program::name("cga-cluster");
            println!("\nNext: change `town/town.toml` or `town/town.cga`, and type\n  {name} run town/town.toml");
            Ok(())
        }
        Command::Run(RunOptions { job, threads, quiet }) => {
            let threads = bounded("--threads", threads.unwrap_or(processors), MOST_THREADS)?;
            embedded(&Job::open(&job)?, threads, quiet).await
        }
        Command::Submit(options) => {
            let job = Job::open(&options.job)?;
            TcpStream::connect(&options.scheduler).map_err(|why| {
                format!(
                    "no scheduler answers at `{}` ({why}); start one with `cga-cluster scheduler`",
                    options.scheduler
                )
            })?;
            let address = format!("http://{}", options.scheduler);
            let partitions = bounded("partitions", job.partitions.unwrap_or(processors), MOST_ON_CLUSTER)?;
            let engine = Engine::ballista(&address, partitions);
            let engine = engine.map_err(|why| why.to_string())?;
            wait_for_executor(&engine, &options.scheduler).await?;
            make(&engine, &job, options.quiet).await
        }
        Command::Scheduler(SchedulerOptions { host, port }) => engine::scheduler(host, port).await,
        Command::Executor(ExecutorOptions { scheduler, host, port, cores, work_dir: folder }) => {
            let wrong = || format!("`{scheduler}` is not a host with a port, as in `127.0.0.1:50050`");
            let (scheduler_host, scheduler_port) = scheduler.rsplit_once(':').ok_or_else(wrong)?;
            let scheduler_port = scheduler_port.parse().map_err(|_| wrong())?;
            let cores = bounded("--cores", cores.unwrap_or(processors), MOST_THREADS)?;
            let scheduler_host = scheduler_host.to_owned();
            threads(cores)?;
            engine::executor(engine::Executor { scheduler_host, scheduler_port, host, port, cores, folder }).await
        }
    }
}

/// Waits until an executor answers. A scheduler without executors never reports an error.
async fn wait_for_executor(engine: &Engine, scheduler: &str) -> Result<(), String> {
    let answer = engine.answer();
    tokio::pin!(answer);
    if let Ok(answer) = tokio::time::timeout(Duration::from_secs(10), &mut answer).await {
        return answer;
    }
    eprintln!(
        "no executor answers `{scheduler}` yet; start one with `cga-cluster executor --scheduler {scheduler}`. The job waits"
    );
    answer.await
}

/// Runs a job in this process.
async fn embedded(job: &Job, count: usize, is_quiet: bool) -> Result<(), String> {
    let partitions = bounded("partitions", job.partitions.unwrap_or(count), MOST_THREADS)?;
    threads(count)?;
    let engine = Engine::embedded(partitions).map_err(|why| why.to_string())?;
    make(&engine, job, is_quiet).await
}

async fn make(engine: &Engine, job: &Job, is_quiet: bool) -> Result<(), String> {
    let begun = Instant::now();
    let bar = ProgressBar::new(is_quiet);
    let made = run(engine, job, &bar).await;
    bar.end();
    let Summary { lots, units_made, units_kept, tally, failed_rows, lost_rows, lost, notes } = made?;
    for (number, level) in tally.levels.iter().enumerate() {
        let name = if number == 0 { "near".to_owned() } else { format!("far {number}") };
        let megabytes = level.bytes as f64 / 1e6;
        println!("{name}: {} tiles, {} buildings, {megabytes:.1} MB", level.tiles, level.buildings);
    }
    println!(
        "{lots} lots, {lost_rows} rows or polygons lost, {lost} buildings lost, {} notes (all in `failures`); \
         {units_made} units made, {units_kept} kept, in {:.1} s; wrote `{}/tileset.json`",
        notes + failed_rows - lost_rows,
        begun.elapsed().as_secs_f64(),
        job.store.trim_end_matches('/')
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn too_many_threads_and_parts_are_refused() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("job.toml");
        std::fs::write(&path, "store = \"out\"\nlots = [\".\"]\npartitions = 5000").expect("room");
        let job = path.to_string_lossy();
        for (arguments, why) in [
            (vec!["run", &job, "--threads", "5000"], "--threads: 5000 is too many; write at most 1024"),
            (vec!["run", &job], "partitions: 5000 is too many; write at most 1024"),
            (vec!["executor", "--cores", "5000"], "--cores: 5000 is too many; write at most 1024"),
        ] {
            let options = Options::parse_from(["cga-cluster"].into_iter().chain(arguments));
            assert_eq!(command(options.command).await, Err(why.to_owned()));
        }
        assert_eq!((bounded("a", 0, 3), bounded("a", 3, 3)), (Ok(1), Ok(3)));
    }
}
