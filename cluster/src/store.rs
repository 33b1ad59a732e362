//! Object stores by their addresses: `file:///folder`, `s3://bucket/folder`, and others with features of this crate.
//!
//! Keys and regions are variables of the environment, as the tools of each service have them: `AWS_*`, `GOOGLE_*`, `AZURE_*`.

use std::collections::HashMap;
use std::future::Future;
use std::io;
use std::path::PathBuf;
use std::sync::mpsc::sync_channel;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use cga_city::store::{Store, has_digest};
use cga_city::units::store::UnitStore;
use datafusion::error::{DataFusionError, Result};
use datafusion::execution::object_store::ObjectStoreRegistry;
use futures::{StreamExt as _, TryStreamExt as _, stream};
use object_store::path::Path;
use object_store::{ObjectMeta, ObjectStore, ObjectStoreExt as _};
use url::{Position, Url};

/// The number of files of a list that are in memory at a time.
const PART: usize = 1000;

/// The files below an address of a store. Calls wait for their result, on any thread.
#[derive(Clone, Debug)]
pub struct Objects {
    store: Arc<dyn ObjectStore>,
    base: Path,
    /// The folder, if it is one of this machine.
    folder: Option<PathBuf>,
}

impl Objects {
    /// The files below an address.
    ///
    /// # Errors
    /// A sentence about the address.
    pub fn open(address: &str) -> Result<Self, String> {
        let url = Url::parse(address).map_err(|why| {
            format!("`{address}` is not an address ({why}); write `file:///folder` or `s3://bucket/folder`")
        })?;
        let (store, base) = open(&url)?;
        let folder = if url.scheme() == "file" { url.to_file_path().ok() } else { None };
        Ok(Objects { store: store.into(), base, folder })
    }

    fn path(&self, name: &str) -> io::Result<Path> {
        let base = self.base.as_ref();
        let path = if base.is_empty() { name.to_owned() } else { format!("{base}/{name}") };
        Path::parse(path).map_err(io::Error::other)
    }

    /// The files whose names begin with a folder, with their sizes and times. Their names are relative, as in [`Store`].
    ///
    /// # Errors
    /// Errors of the store.
    pub fn list(&self, folder: &str) -> io::Result<Vec<(String, ObjectMeta)>> {
        let mut found = Vec::new();
        self.list_parts(folder, |part| {
            found.extend(part);
            Ok(())
        })?;
        Ok(found)
    }

    /// Calls a function with some files of a folder after others.
    fn list_parts(
        &self,
        folder: &str,
        mut each: impl FnMut(Vec<(String, ObjectMeta)>) -> io::Result<()>,
    ) -> io::Result<()> {
        let skipped = if self.base.as_ref().is_empty() { 0 } else { self.base.as_ref().len() + 1 };
        let named = |file: ObjectMeta| (file.location.as_ref()[skipped..].to_owned(), file);
        let mut files = self.store.list(Some(&self.path(folder)?)).chunks(PART);
        loop {
            let (part, rest) = wait(async move {
                let part = files.next().await;
                Ok((part, files))
            })?;
            files = rest;
            let Some(part) = part else { return Ok(()) };
            let part: Vec<ObjectMeta> = part.into_iter().collect::<Result<_, _>>().map_err(io::Error::other)?;
            each(part.into_iter().map(named).collect())?;
        }
    }

    /// Deletes files.
    ///
    /// # Errors
    /// Errors of the store.
    pub fn delete_all(&self, names: impl IntoIterator<Item = String>) -> io::Result<()> {
        let paths = names.into_iter().map(|name| self.path(&name)).collect::<io::Result<Vec<_>>>()?;
        if paths.is_empty() {
            return Ok(());
        }
        let mut deleted = self.store.delete_stream(stream::iter(paths.into_iter().map(Ok)).boxed());
        wait(async move {
            while let Some(result) = deleted.next().await {
                match result {
                    Ok(_) | Err(object_store::Error::NotFound { .. }) => {}
                    Err(why) => return Err(why),
                }
            }
            Ok(())
        })
    }
}

impl Store for Objects {
    fn read(&self, name: &str) -> io::Result<Option<Vec<u8>>> {
        let (store, path) = (self.store.clone(), self.path(name)?);
        wait(async move { get(&*store, &path).await })
    }

    fn write(&self, name: &str, bytes: Vec<u8>) -> io::Result<()> {
        let (store, path) = (self.store.clone(), self.path(name)?);
        wait(async move { store.put(&path, bytes.into()).await }).map(drop)
    }

    fn delete(&self, name: &str) -> io::Result<()> {
        let (store, path) = (self.store.clone(), self.path(name)?);
        wait(async move {
            match store.delete(&path).await {
                Err(object_store::Error::NotFound { .. }) => Ok(()),
                deleted => deleted,
            }
        })
    }

    fn is_whole(&self, name: &str, count: u64, digest: &str) -> bool {
        if self.folder.is_some() {
            return matches!(self.read(name), Ok(Some(bytes)) if has_digest(&bytes, count, digest));
        }
        // Objects are whole or do not exist, and a description is deleted before its object is replaced. So the size is enough.
        let Ok(path) = self.path(name) else { return false };
        let store = self.store.clone();
        wait(async move { store.head(&path).await }).is_ok_and(|found| found.size == count)
    }
}

impl UnitStore for Objects {
    fn is_empty(&self) -> io::Result<bool> {
        let (store, prefix) = (self.store.clone(), self.base.clone());
        wait(async move { store.list(Some(&prefix)).next().await.transpose() }).map(|first| first.is_none())
    }

    fn read_all(&self, names: Vec<String>) -> io::Result<Vec<Option<Vec<u8>>>> {
        let paths = names.into_iter().map(|name| self.path(&name)).collect::<io::Result<Vec<_>>>()?;
        let store = self.store.clone();
        let read = move |path| {
            let store = store.clone();
            async move { get(&*store, &path).await }
        };
        wait(async move { stream::iter(paths).map(read).buffered(32).try_collect().await })
    }

    fn delete_where(&self, folder: &str, is_other: &dyn Fn(&str) -> bool) -> io::Result<()> {
        let others = |part: Vec<(String, ObjectMeta)>| {
            self.delete_all(part.into_iter().map(|(name, _)| name).filter(|name| is_other(name)))
        };
        self.list_parts(folder, others)
    }

    /// Parts of files have the name of the file, `#` and a number, and lists do not have them. Stores that are not folders have whole objects alone.
    fn delete_parts(&self, folder: &str, is_own: &dyn Fn(&str) -> bool) -> io::Result<()> {
        let Some(root) = &self.folder else { return Ok(()) };
        let mut open = vec![root.join(folder)];
        while let Some(folder) = open.pop() {
            let entries = match std::fs::read_dir(&folder) {
                Err(why) if why.kind() == io::ErrorKind::NotFound => continue,
                entries => entries?,
            };
            for entry in entries {
                let path = entry?.path();
                if path.is_dir() {
                    // A link leads to folders of others.
                    open.extend((!path.is_symlink()).then_some(path));
                    continue;
                }
                let name = path.strip_prefix(root).unwrap_or(&path).to_string_lossy().replace('\\', "/");
                let part = name.rsplit_once('#');
                let is_number = |end: &str| !end.is_empty() && end.bytes().all(|byte| byte.is_ascii_digit());
                if part.is_some_and(|(whole, end)| is_number(end) && is_own(whole)) {
                    std::fs::remove_file(&path)?;
                }
            }
        }
        Ok(())
    }
}

async fn get(store: &dyn ObjectStore, path: &Path) -> object_store::Result<Option<Vec<u8>>> {
    match store.get(path).await {
        Ok(found) => Ok(Some(found.bytes().await?.to_vec())),
        Err(object_store::Error::NotFound { .. }) => Ok(None),
        Err(why) => Err(why),
    }
}

fn open(url: &Url) -> Result<(Box<dyn ObjectStore>, Path), String> {
    let is_of_service = |name: &str| ["aws_", "azure_", "google_"].iter().any(|start| name.starts_with(start));
    let options = std::env::vars().map(|(name, value)| (name.to_lowercase(), value));
    object_store::parse_url_opts(url, options.filter(|(name, _)| is_of_service(name)))
        .map_err(|why| format!("`{url}` cannot be used: {why}"))
}

/// Waits for a result. The work is done by threads for input and output, so a thread of any other runtime may wait.
fn wait<T: Send + 'static>(work: impl Future<Output = object_store::Result<T>> + Send + 'static) -> io::Result<T> {
    static THREADS: OnceLock<io::Result<tokio::runtime::Runtime>> = OnceLock::new();
    let threads = THREADS.get_or_init(|| {
        tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().thread_name("store").build()
    });
    let threads = threads.as_ref().map_err(|why| io::Error::other(why.to_string()))?;
    let (result, waiting) = sync_channel(1);
    threads.spawn(async move { result.send(work.await) });
    waiting.recv().map_err(io::Error::other)?.map_err(io::Error::other)
}

/// The stores that queries read, each opened when its first file is read.
#[derive(Debug, Default)]
pub struct Stores(Mutex<HashMap<String, Arc<dyn ObjectStore>>>);

impl ObjectStoreRegistry for Stores {
    fn register_store(&self, url: &Url, store: Arc<dyn ObjectStore>) -> Option<Arc<dyn ObjectStore>> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.insert(url[..Position::BeforePath].to_owned(), store)
    }

    fn get_store(&self, url: &Url) -> Result<Arc<dyn ObjectStore>> {
        let host = &url[..Position::BeforePath];
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(store) = known.get(host) {
            return Ok(store.clone());
        }
        let root = Url::parse(&format!("{host}/")).map_err(|why| DataFusionError::External(why.into()))?;
        let store: Arc<dyn ObjectStore> = open(&root).map_err(DataFusionError::Execution)?.0.into();
        known.insert(host.to_owned(), store.clone());
        Ok(store)
    }
}
