//! Works in files of the store.

use std::sync::{Arc, Mutex, PoisonError};

use cga_city::store::{Store as _, digest_of};
use cga_city::units::work::{LoadedWork, Work};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::store::Objects;

/// A work with the store of its tiles.
#[derive(Debug)]
pub struct StoredWork {
    /// The work.
    pub loaded: LoadedWork,
    /// The store.
    pub store: Objects,
}

impl StoredWork {
    /// Loads the rules of a work.
    ///
    /// # Errors
    /// A sentence, or the errors of the rules.
    pub fn new(work: Work, store: Objects) -> Result<Self, String> {
        Ok(StoredWork { loaded: LoadedWork::new(work)?, store })
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

static WORKS: Cache<StoredWork> = Cache::new();

/// The work of an address. Its assets are read when the work is loaded.
///
/// # Errors
/// A sentence about the store or the rules.
pub fn work_at(address: &str) -> Result<Arc<StoredWork>, String> {
    WORKS.get(address, |store, name| StoredWork::new(published(&store, name)?, store))
}

/// The work of an address with a digest. If the work that is known has another one, its assets may have changed, and it is loaded again.
///
/// # Errors
/// A sentence about the store or the rules, or the assets of this machine are not the assets of the client.
pub(crate) fn work_with(address: &str, digest: &str) -> Result<Arc<StoredWork>, String> {
    let mut work = work_at(address)?;
    if work.loaded.digest != digest {
        WORKS.forget(address);
        work = work_at(address)?;
    }
    if work.loaded.digest == digest {
        return Ok(work);
    }
    let program = "this machine has another program than the client; install the same file";
    Err(match &work.loaded.work.assets {
        None => program.to_owned(),
        Some(folder) => {
            let folder = format!(
                "the folder `{}` has other files here than on the client; copy the folder of the client to all machines",
                folder.display()
            );
            if work.loaded.work.compiled.is_empty() { folder } else { format!("{folder}, or {program}") }
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
