//! The work of a job as all machines know it: rules, columns and choices, in a file of the store.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use cga::RuleLoader;
use cga_city::build::Options;
use cga_city::rules::{CityGrammar, Rules};
use cga_city::store::{Store as _, digest_of};
use cga_city::tree::TreeLevel;
use cga_geo::crs::Crs;
use cga_geo::footprint::Footprint;
use cga_geo::survey::{Columns, Surveyor};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::compiled;
use crate::store::Objects;

/// The work of a job.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Work {
    /// The rule files. The first has all lots that name none.
    pub rules: Vec<RuleTexts>,
    /// The names of compiled grammars, which come after the rule files.
    pub compiled: Vec<String>,
    /// The folder of meshes and images, at the same path on all machines.
    pub assets: Option<PathBuf>,
    /// The names of attributes and the texts of their values.
    pub values: Vec<(String, String)>,
    /// The columns that have a meaning.
    pub columns: Columns,
    /// The code of the coordinate system.
    pub crs: u32,
    /// The levels and the sizes of tiles.
    pub options: Options,
}

/// A rule file with the files that it imports.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RuleTexts {
    /// The name of the file.
    pub file: String,
    /// The names and texts of all files.
    pub texts: Vec<(String, String)>,
}

impl Work {
    /// The rules with the values of the job.
    ///
    /// # Errors
    /// A sentence, or the errors of the rules.
    pub fn load_rules(&self) -> Result<Rules, String> {
        let load = |RuleTexts { file, texts }: &RuleTexts| {
            let loader = texts.iter().fold(RuleLoader::new(), |loader, (name, text)| loader.with_file(name, text));
            loader.memory_file(file).map(CityGrammar::from).map_err(|why| why.to_string())
        };
        let compiled = self.compiled.iter().map(|name| compiled::named(name));
        let mut rules = Rules::of_grammars(self.rules.iter().map(load).chain(compiled).collect::<Result<_, _>>()?)?;
        if let Some(folder) = &self.assets {
            rules = rules.with_assets(folder)?;
        }
        for (name, value) in &self.values {
            rules.set(name, value).map_err(|why| format!("the value of `{name}`: {why}"))?;
        }
        Ok(rules)
    }
}

/// The work of a job, ready to be done.
#[derive(Debug)]
pub struct LoadedWork {
    /// The work.
    pub work: Work,
    /// Its rules.
    pub rules: Rules,
    /// Its levels of detail.
    pub levels: Vec<TreeLevel>,
    /// The store of the tiles.
    pub store: Objects,
    /// The digest of all that tiles depend on beside the lots.
    pub digest: String,
}

impl LoadedWork {
    /// Loads the rules of a work with its store.
    ///
    /// # Errors
    /// A sentence, or the errors of the rules.
    pub fn new(work: Work, store: Objects) -> Result<Self, String> {
        let rules = work.load_rules()?;
        let levels = work.options.tree_levels(&rules)?;
        let mut digest = blake3::Hasher::new();
        digest.update(concat!("cga-cluster ", env!("CARGO_PKG_VERSION"), " 1").as_bytes());
        digest.update(&serde_json::to_vec(&work).map_err(|why| why.to_string())?);
        levels.iter().for_each(|level| {
            // The digests of rules have the files of the assets, too.
            digest.update(&level.rules.digest);
        });
        Ok(LoadedWork { work, rules, levels, store, digest: digest.finalize().to_hex().to_string() })
    }

    /// Returns true if the rules of a lot can ask about neighbours, at any level of detail.
    pub fn asks(&self, footprint: &Footprint) -> bool {
        self.levels.iter().any(|level| level.neighbours.is_some() && level.rules.asks(footprint))
    }

    /// The metres up to which rules find other lots.
    pub fn distance(&self) -> f64 {
        self.work.options.neighbours.map_or(0.0, |distances| distances.largest())
    }

    /// Makes footprints of rows.
    ///
    /// # Errors
    /// The coordinate system is unknown.
    pub fn surveyor(&self) -> Result<Surveyor<'_>, String> {
        let crs = Crs::from_epsg(self.work.crs)?;
        Ok(Surveyor::new(self.rules.grammars(), self.work.columns.clone()).crs(crs))
    }
}

/// Writes a value as a file of the store. Its name has the digest of its contents, so a file is never another one later.
///
/// # Errors
/// A sentence about the store.
pub fn publish<T: Serialize>(store: &Objects, value: &T) -> Result<String, String> {
    let text = serde_json::to_vec(value).map_err(|why| why.to_string())?;
    let name = format!("jobs/{}.json", &digest_of(&text)[..32]);
    store.write(&name, text).map_err(|why| format!("cannot write `{name}` to the store: {why}"))?;
    Ok(name)
}

/// Reads a value that was published.
///
/// # Errors
/// A sentence about the store.
pub fn published<T: DeserializeOwned>(store: &Objects, name: &str) -> Result<T, String> {
    let unread = |why: String| format!("cannot read `{name}` from the store: {why}");
    let text = store.read(name).map_err(|why| unread(why.to_string()))?;
    serde_json::from_slice(&text.ok_or_else(|| unread("it does not exist".to_owned()))?)
        .map_err(|why| unread(why.to_string()))
}

/// The number of values that a cache keeps.
const KEPT: usize = 4;

/// The values that were used last, by their addresses. Files of the store that have a digest in their names are seldom loaded twice.
pub(crate) struct Cache<T>(Mutex<Vec<(String, Arc<T>)>>);

impl<T> Cache<T> {
    pub(crate) const fn new() -> Self {
        Cache(Mutex::new(Vec::new()))
    }

    /// Forgets the value of an address.
    fn forget(&self, address: &str) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).retain(|(known, _)| known != address);
    }

    /// The value of an address `STORE/jobs/DIGEST.json`, which is loaded if it is not known.
    pub(crate) fn get(
        &self,
        address: &str,
        load: impl FnOnce(Objects, &str) -> Result<T, String>,
    ) -> Result<Arc<T>, String> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(at) = known.iter().position(|(name, _)| name == address) {
            let found = known.remove(at);
            let value = found.1.clone();
            known.push(found);
            return Ok(value);
        }
        let Some(at) = address.rfind("jobs/") else { return Err(format!("`{address}` is not a file of a job")) };
        let value = Arc::new(load(Objects::open(&address[..at])?, &address[at..])?);
        if known.len() == KEPT {
            known.remove(0);
        }
        known.push((address.to_owned(), value.clone()));
        Ok(value)
    }
}

static WORKS: Cache<LoadedWork> = Cache::new();

/// The work of an address. Its assets are read when the work is loaded.
///
/// # Errors
/// A sentence about the store or the rules.
pub fn work_at(address: &str) -> Result<Arc<LoadedWork>, String> {
    WORKS.get(address, |store, name| LoadedWork::new(published(&store, name)?, store))
}

/// The work of an address with a digest. If the work that is known has another one, its assets may have changed, and it is loaded again.
///
/// # Errors
/// A sentence about the store or the rules, or the assets of this machine are not the assets of the client.
pub(crate) fn work_with(address: &str, digest: &str) -> Result<Arc<LoadedWork>, String> {
    let mut work = work_at(address)?;
    if work.digest != digest {
        WORKS.forget(address);
        work = work_at(address)?;
    }
    if work.digest == digest {
        return Ok(work);
    }
    let program = "this machine has another program than the client; install the same file";
    Err(match &work.work.assets {
        None => program.to_owned(),
        Some(folder) => {
            let folder = format!(
                "the folder `{}` has other files here than on the client; copy the folder of the client to all machines",
                folder.display()
            );
            if work.work.compiled.is_empty() { folder } else { format!("{folder}, or {program}") }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cache_keeps_the_values_that_were_used_last() {
        let cache: Cache<u32> = Cache::new();
        let loads = std::cell::Cell::new(0);
        let get = |number: u32| {
            let load = |_, _: &str| {
                loads.set(loads.get() + 1);
                Ok(number)
            };
            cache.get(&format!("file:///city/jobs/{number}.json"), load).expect("an address")
        };
        for number in [1, 2, 3, 4, 1, 5, 1] {
            assert_eq!(*get(number), number);
        }
        assert_eq!(loads.get(), 5);
        // The second one was used least recently.
        get(2);
        assert_eq!(loads.get(), 6);
        assert_eq!(cache.0.lock().expect("a cache").len(), KEPT);
    }
}
