//! Grammars that are compiled into the program, by name.

use std::sync::{Mutex, OnceLock, PoisonError};

use cga::Grammar;
use cga_geo::missing;

use crate::rules::CityGrammar;

static KNOWN: Mutex<Vec<Box<dyn Grammar + Send + Sync>>> = Mutex::new(Vec::new());

/// Adds a compiled grammar under the name of its header. The work of a city names it.
///
/// # Errors
/// A sentence: it has no name, or another one has its name.
pub fn add(grammar: Box<dyn Grammar + Send + Sync>) -> Result<(), String> {
    let name = grammar.name();
    if name.is_empty() {
        return Err("a compiled grammar has no name; begin it with a header, as in `grammar House;`".to_owned());
    }
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    if known.iter().any(|other| other.name() == name) {
        return Err(format!("two compiled grammars have the name `{name}`"));
    }
    known.push(grammar);
    Ok(())
}

/// The compiled grammar with a name.
///
/// # Errors
/// A sentence: this program does not have it, or its own file cannot be read.
pub(crate) fn named(name: &str) -> Result<CityGrammar, String> {
    let known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let Some(found) = known.iter().find(|grammar| grammar.name() == name) else {
        if known.is_empty() {
            return Err(format!(
                "this program has no compiled grammars, so `{name}` is unknown; write a program that calls `cga_cluster::program::main` with it"
            ));
        }
        let names = known.iter().map(|grammar| grammar.name());
        return Err(format!(
            "`{name}` is not compiled into this program; {}",
            missing::names(name, "the program", "grammars", names)
        ));
    };
    Ok(CityGrammar::compiled(found.boxed(), &program()?))
}

/// The digest of this program. Compiled rules have no text that could be compared, so a program that was built again makes all tiles again.
fn program() -> Result<String, String> {
    static DIGEST: OnceLock<Result<String, String>> = OnceLock::new();
    let read = || -> std::io::Result<String> {
        let mut digest = blake3::Hasher::new();
        digest.update_reader(std::fs::File::open(std::env::current_exe()?)?)?;
        Ok(digest.finalize().to_hex().to_string())
    };
    DIGEST.get_or_init(|| read().map_err(|why| format!("cannot read the file of this program: {why}"))).clone()
}
