//! Where queries run: in this process, or on the machines of Ballista.

use std::net::{SocketAddr, ToSocketAddrs as _};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use ballista_core::config::TaskSchedulingPolicy;
use ballista_core::extension::{SessionConfigExt as _, SessionStateExt as _};
use ballista_core::registry::BallistaFunctionRegistry;
use ballista_executor::executor_process::{ExecutorProcessConfig, start_executor_process};
use ballista_scheduler::cluster::BallistaCluster;
use ballista_scheduler::config::SchedulerConfig;
use ballista_scheduler::scheduler_process::start_server;
use datafusion::arrow::array::RecordBatch;
use datafusion::error::{DataFusionError, Result};
use datafusion::execution::runtime_env::{RuntimeEnv, RuntimeEnvBuilder};
use datafusion::execution::{FunctionRegistry as _, SessionState, SessionStateBuilder};
use datafusion::prelude::{SessionConfig, SessionContext};

use crate::functions::functions;
use crate::store::Stores;

/// An executor without a heartbeat for this many seconds is dead, and its work is given to others.
const DEAD_AFTER: u64 = 12;

/// The time from one attempt to the next.
pub(crate) const PAUSE: Duration = Duration::from_secs(3);

/// The seconds from one heartbeat to the next.
const HEARTBEAT: u64 = 3;

/// A place where queries run.
pub struct Engine {
    /// Its queries.
    pub context: SessionContext,
    /// The number of times that a query without any progress is tried.
    pub attempts: usize,
}

impl Engine {
    /// This process, with a number of queries' parts that run at a time.
    ///
    /// # Errors
    /// DataFusion cannot start.
    pub fn embedded(partitions: usize) -> Result<Self> {
        let config = SessionConfig::new().with_target_partitions(partitions);
        Ok(Engine { context: SessionContext::new_with_state(state(config)?), attempts: 1 })
    }

    /// The machines of a scheduler, as in `http://host:50050`.
    ///
    /// # Errors
    /// Ballista cannot start.
    pub fn ballista(scheduler: &str, partitions: usize) -> Result<Self> {
        // With the adaptive planner, a job whose executor is lost does not end.
        let config = SessionConfig::new_with_ballista()
            .with_target_partitions(partitions)
            .with_ballista_adaptive_query_planner(false);
        let state = state(config)?.upgrade_for_ballista(scheduler.to_owned())?;
        let context = SessionContext::new_with_state(state);
        functions().iter().for_each(|function| context.register_udf(function.as_ref().clone()));
        Ok(Engine { context, attempts: 5 })
    }

    /// Waits until a query has an answer, on Ballista from an executor.
    ///
    /// # Errors
    /// A sentence about the scheduler.
    pub async fn answer(&self) -> Result<(), String> {
        self.query("select 1").await.map(drop)
    }

    /// The rows of a query.
    pub(crate) async fn query(&self, sql: &str) -> Result<Vec<RecordBatch>, String> {
        let rows = async { self.context.sql(sql).await?.collect().await };
        rows.await.map_err(|why: DataFusionError| why.strip_backtrace())
    }

    /// The rows of a query. An executor that has rows may be lost before they are fetched, so a query that failed is tried again.
    pub(crate) async fn retry(&self, sql: &str) -> Result<Vec<RecordBatch>, String> {
        // A query that cannot be planned is not tried again.
        let query = self.context.sql(sql).await.map_err(|why| why.strip_backtrace())?;
        let mut failures = 0;
        loop {
            match query.clone().collect().await.map_err(|why| why.strip_backtrace()) {
                Err(why) if failures + 1 < self.attempts => {
                    failures += 1;
                    log::warn!("a query failed and is tried again: {why}");
                    tokio::time::sleep(PAUSE).await;
                }
                done => return done,
            }
        }
    }
}

fn runtime() -> Result<Arc<RuntimeEnv>> {
    RuntimeEnvBuilder::new().with_object_store_registry(Arc::new(Stores::default())).build_arc()
}

fn state(mut config: SessionConfig) -> Result<SessionState> {
    // Lots in folders of folders are lots, too.
    config.options_mut().execution.listing_table_ignore_subdirectory = false;
    let state = SessionStateBuilder::new().with_config(config).with_runtime_env(runtime()?).with_default_features();
    let mut state = state.build();
    functions().into_iter().try_for_each(|function| state.register_udf(function).map(drop))?;
    Ok(state)
}

/// Runs a scheduler until the process ends.
///
/// # Errors
/// A sentence: the address cannot be used.
pub async fn scheduler(host: String, port: u16) -> Result<(), String> {
    let address = socket(&host, port)?;
    let config = SchedulerConfig {
        bind_host: host.clone(),
        external_host: host,
        bind_port: port,
        scheduling_policy: TaskSchedulingPolicy::PullStaged,
        executor_timeout_seconds: DEAD_AFTER,
        expire_dead_executor_interval_seconds: HEARTBEAT,
        override_session_builder: Some(Arc::new(state)),
        ..SchedulerConfig::default()
    };
    let cluster = BallistaCluster::new_from_config(&config).await.map_err(|why| why.to_string())?;
    start_server(cluster, address, Arc::new(config)).await.map_err(|why| why.to_string())
}

/// The choices of an executor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Executor {
    /// The host of the scheduler.
    pub scheduler_host: String,
    /// The port of the scheduler.
    pub scheduler_port: u16,
    /// The host of the executor, under which others reach it.
    pub host: String,
    /// The port for data; the next one is for orders.
    pub port: u16,
    /// The number of parts of queries that run at a time.
    pub cores: usize,
    /// The folder of parts of results.
    pub folder: PathBuf,
}

/// Runs an executor until the process ends.
///
/// # Errors
/// A sentence: an address or the folder cannot be used.
pub async fn executor(choices: Executor) -> Result<(), String> {
    let Executor { scheduler_host, scheduler_port, host, port, cores, folder } = choices;
    std::fs::create_dir_all(&folder).map_err(|why| format!("cannot write to `{}`: {why}", folder.display()))?;
    let mut registry = BallistaFunctionRegistry::default();
    let own = functions().into_iter().map(|function| (function.name().to_owned(), function));
    registry.scalar_functions.extend(own);
    let grpc_port = port.checked_add(1).ok_or("an executor needs two ports; write a `--port` of at most 65534")?;
    let config = ExecutorProcessConfig {
        bind_host: host.clone(),
        external_host: Some(host),
        port,
        grpc_port,
        scheduler_host,
        scheduler_port,
        scheduler_connect_timeout_seconds: 60,
        vcores: cores,
        task_scheduling_policy: TaskSchedulingPolicy::PullStaged,
        work_dir: Some(folder.to_string_lossy().into_owned()),
        // Parts of results of finished jobs are deleted after an hour.
        job_data_ttl_seconds: 3600,
        job_data_clean_up_interval_seconds: 600,
        executor_heartbeat_interval_seconds: HEARTBEAT,
        override_function_registry: Some(Arc::new(registry)),
        override_runtime_producer: Some(Arc::new(|_| runtime())),
        ..ExecutorProcessConfig::default()
    };
    start_executor_process(Arc::new(config)).await.map_err(|why| why.to_string())
}

fn socket(host: &str, port: u16) -> Result<SocketAddr, String> {
    let unknown = |why: String| format!("`{host}:{port}` cannot be used: {why}");
    let mut found = (host, port).to_socket_addrs().map_err(|why| unknown(why.to_string()))?;
    found.next().ok_or_else(|| unknown("the host has no address".to_owned()))
}
