//! The work of a city as all machines know it: rules, columns and choices.

use std::path::PathBuf;

use cga::RuleLoader;
use cga_geo::crs::Crs;
use cga_geo::footprint::Footprint;
use cga_geo::survey::{Columns, Surveyor};
use serde::{Deserialize, Serialize};

use super::compiled;
use crate::build::Options;
use crate::rules::{CityGrammar, Rules};
use crate::tree::TreeLevel;

/// The work of a city.
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
    /// The rules with the values of the work.
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

/// The work of a city, ready to be done.
#[derive(Debug)]
pub struct LoadedWork {
    /// The work.
    pub work: Work,
    /// Its rules.
    pub rules: Rules,
    /// Its levels of detail.
    pub levels: Vec<TreeLevel>,
    /// The digest of all that tiles depend on beside the lots.
    pub digest: String,
}

impl LoadedWork {
    /// Loads the rules of a work.
    ///
    /// # Errors
    /// A sentence, or the errors of the rules.
    pub fn new(work: Work) -> Result<Self, String> {
        let rules = work.load_rules()?;
        let levels = work.options.tree_levels(&rules)?;
        let mut digest = blake3::Hasher::new();
        // The first program that made units.
        digest.update(concat!("cga-cluster ", env!("CARGO_PKG_VERSION"), " 1").as_bytes());
        digest.update(&serde_json::to_vec(&work).map_err(|why| why.to_string())?);
        levels.iter().for_each(|level| {
            // The digests of rules have the files of the assets, too.
            digest.update(&level.rules.digest);
        });
        Ok(LoadedWork { work, rules, levels, digest: digest.finalize().to_hex().to_string() })
    }

    /// Returns true if the rules of a lot can ask about neighbours, at any level of detail.
    pub fn asks(&self, footprint: &Footprint) -> bool {
        self.levels.iter().any(|level| level.neighbours.is_some() && level.rules.asks(footprint))
    }

    /// The metres up to which rules find other lots.
    pub fn distance(&self) -> f64 {
        self.work.options.neighbours.map_or(0.0, |distances| distances.largest())
    }

    /// The names of the columns that the rules use.
    pub fn column_names(&self) -> Vec<String> {
        self.work.columns.names(&self.rules.grammars())
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
