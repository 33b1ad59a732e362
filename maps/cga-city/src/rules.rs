//! The rules of a city: one grammar or several, with values for each level of detail.

use std::collections::BTreeSet;
use std::fmt;
use std::path::Path;
use std::sync::Arc;

use cga::{Assets, Grammar, Grammars, RuleFile, RuleLoader, SceneLot, Settings, Shape, WrongLots};
use cga_geo::footprint::Footprint;
use cga_geo::missing;

use crate::level::Level;

/// A grammar of a city: a rule file that is loaded, or rules that are compiled into the program.
#[derive(Clone)]
pub struct CityGrammar {
    grammar: Box<dyn Grammar + Send + Sync>,
    /// The contents of a rule file and of its imports, or the version of compiled rules.
    contents: Vec<String>,
    warnings: Vec<String>,
}

impl CityGrammar {
    /// Compiled rules. Their text is unknown, so `version` must differ for other rules: finished tiles of the same version are kept.
    pub fn compiled(grammar: Box<dyn Grammar + Send + Sync>, version: &str) -> Self {
        CityGrammar { grammar, contents: vec!["compiled".to_owned(), version.to_owned()], warnings: Vec::new() }
    }
}

impl From<RuleFile> for CityGrammar {
    fn from(file: RuleFile) -> Self {
        // Where the files are does not matter.
        let contents = file.texts().map(|(_, text)| text.to_owned()).collect();
        let warnings = file.warnings().to_vec();
        CityGrammar { grammar: Box::new(file), contents, warnings }
    }
}

impl fmt::Debug for CityGrammar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.grammar.name())
    }
}

/// The rules of a city.
#[derive(Clone, Debug)]
pub struct Rules {
    files: Vec<CityGrammar>,
    assets: Arc<Assets>,
    /// The contents of the files and of the folder of assets.
    digest: [u8; 32],
}

impl Rules {
    /// Loads rule files. The first has all lots that name none; a column names the others by the names of their files without ending.
    ///
    /// # Errors
    /// A sentence about a file, or the errors of its rules.
    pub fn open<P: AsRef<Path>>(paths: &[P]) -> Result<Self, String> {
        let open = |path: &P| RuleLoader::new().open(path).map_err(|error| error.to_string());
        Rules::new(paths.iter().map(open).collect::<Result<_, _>>()?)
    }

    /// Rules that are loaded.
    ///
    /// # Errors
    /// As [`of_grammars`](Rules::of_grammars).
    pub fn new(files: Vec<RuleFile>) -> Result<Self, String> {
        Rules::of_grammars(files.into_iter().map(CityGrammar::from).collect())
    }

    /// Rules that are loaded or compiled. The first grammar has all lots that name none.
    ///
    /// # Errors
    /// A sentence: the list is empty, two grammars have one name, or a grammar has no start rule.
    pub fn of_grammars(files: Vec<CityGrammar>) -> Result<Self, String> {
        let name = |file: &CityGrammar| file.grammar.name().to_owned();
        let Some(first) = files.first().map(name) else { return Err("a city needs rules".to_owned()) };
        if let Some(twice) = (1..files.len()).find(|at| files[..*at].iter().any(|file| name(file) == name(&files[*at])))
        {
            return Err(format!("two rule files have the name `{}`; `{first}` is the first file", name(&files[twice])));
        }
        if let Some(file) = files.iter().find(|file| file.grammar.start_rules().is_empty()) {
            return Err(format!(
                "`{}` has no start rule; write a rule without parameters, as in `Lot --> extrude(9)`",
                name(file)
            ));
        }
        let mut rules = Rules { files, assets: Arc::default(), digest: [0; 32] };
        rules.digest = rules.digest_of(&[]);
        Ok(rules)
    }

    /// Inserts meshes and images of a folder.
    ///
    /// # Errors
    /// A sentence about a file of the folder.
    pub fn with_assets(mut self, folder: &Path) -> Result<Self, String> {
        let mut contents = Vec::new();
        contents_of(folder, folder, &mut contents)
            .map_err(|why| format!("cannot read `{}`: {why}", folder.display()))?;
        contents.sort_unstable();
        self.digest = self.digest_of(&contents);
        self.assets = Arc::new(Assets::below(folder));
        Ok(self)
    }

    /// Sets an attribute in all files that have it.
    ///
    /// # Errors
    /// No file has it, or one refuses the value.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), String> {
        set(&mut self.files, name, value)
    }

    /// The grammars.
    pub fn grammars(&self) -> Vec<&dyn Grammar> {
        self.files.iter().map(|file| &*file.grammar as &dyn Grammar).collect()
    }

    /// Checks names of attributes that columns set.
    ///
    /// # Errors
    /// A sentence with a name that no file has.
    pub fn check_attributes<'n>(&self, mut names: impl Iterator<Item = &'n str>) -> Result<(), String> {
        let has = |name: &str| {
            self.files.iter().any(|file| file.grammar.attributes().iter().any(|attribute| attribute.name.is(name)))
        };
        match names.find(|name| !has(name)) {
            Some(name) => {
                let attributes = self.files.iter().flat_map(|file| file.grammar.attributes());
                let known = attributes.map(|attribute| attribute.name.as_str());
                let known = missing::names(name, "the rules", "attributes", known);
                Err(format!("`{name}` is not an attribute of the rules; {known}"))
            }
            None => Ok(()),
        }
    }

    /// The warnings about the rules.
    pub fn warnings(&self) -> impl Iterator<Item = &str> {
        self.files.iter().flat_map(|file| &file.warnings).map(String::as_str)
    }

    /// The rules of a level.
    ///
    /// # Errors
    /// A start rule or an attribute that no file has, or a value that one refuses.
    pub fn at(&self, level: &Level) -> Result<LevelRules, String> {
        let mut files = self.files.clone();
        level.values.iter().try_for_each(|(name, value)| set(&mut files, name, value))?;
        if let Some(start) = &level.start {
            for file in files.iter().map(|file| &file.grammar) {
                if !file.start_rules().iter().any(|rule| rule.name.is(start)) {
                    let known: Vec<&str> = file.start_rules().iter().map(|rule| rule.name.as_str()).collect();
                    return Err(format!(
                        "`{start}` is not a start rule of `{}`; its start rules are {}",
                        file.name(),
                        known.join(", ")
                    ));
                }
            }
        }
        let mut digest = blake3::Hasher::new();
        digest.update(&self.digest).update(format!("{:?}", level.start).as_bytes());
        for attribute in files
            .iter()
            .map(|file| &file.grammar)
            .flat_map(|grammar| grammar.attributes().iter().map(move |attribute| grammar.get(&attribute.name).ok()))
        {
            digest.update(format!("{attribute:?};").as_bytes());
        }
        let settings = Settings {
            start: level.start.clone(),
            assets: self.assets.clone(),
            wrong_lots: WrongLots::Fault,
            ..Settings::default()
        };
        let asking = asking(&files, &level.start);
        let first = files[0].clone();
        let boxed = files.into_iter().map(|file| file.grammar);
        let grammars = boxed.fold(Grammars::new(), Grammars::with_boxed);
        Ok(LevelRules { first, grammars, settings, digest: *digest.finalize().as_bytes(), asking })
    }

    fn digest_of(&self, assets: &[(String, [u8; 32])]) -> [u8; 32] {
        let mut digest = blake3::Hasher::new();
        let mut add = |bytes: &[u8]| {
            digest.update(&(bytes.len() as u64).to_le_bytes()).update(bytes);
        };
        for file in &self.files {
            add(file.grammar.name().as_bytes());
            file.contents.iter().for_each(|text| add(text.as_bytes()));
        }
        for (name, content) in assets {
            add(name.as_bytes());
            add(content);
        }
        *digest.finalize().as_bytes()
    }
}

/// The rules of a level of detail.
#[derive(Clone, Debug)]
pub struct LevelRules {
    first: CityGrammar,
    /// The grammars with the values of the level.
    pub grammars: Grammars,
    /// The settings of all runs.
    pub settings: Settings,
    /// The digest of rules, values and assets.
    pub digest: [u8; 32],
    /// The names of files and of start rules that can ask about neighbours; `None` for lots without a start rule of their own.
    asking: BTreeSet<(String, Option<String>)>,
}

impl LevelRules {
    /// The grammar of a lot with a name, or without one.
    pub fn grammar(&self, name: Option<&str>) -> &dyn Grammar {
        match name.and_then(|name| self.grammars.get(name)) {
            Some(grammar) => grammar,
            None => &*self.first.grammar,
        }
    }

    /// Returns true if the rules of some lots can ask about neighbours.
    pub fn can_ask(&self) -> bool {
        !self.asking.is_empty()
    }

    /// Returns true if the rules of a lot can ask about neighbours.
    pub fn asks(&self, footprint: &Footprint) -> bool {
        self.can_ask()
            && self
                .asking
                .contains(&(self.grammar(footprint.grammar.as_deref()).name().to_owned(), footprint.start.clone()))
    }
}

/// The start rules that can ask about neighbours, with their files.
fn asking(files: &[CityGrammar], start: &Option<String>) -> BTreeSet<(String, Option<String>)> {
    let mut asking = BTreeSet::new();
    for file in files.iter().map(|file| &file.grammar) {
        let asks = |start: Option<String>| {
            let settings = Settings { start, ..Settings::default() };
            SceneLot::new(file.boxed(), Shape::rectangle(1.0, 1.0), settings).asks_about_neighbours()
        };
        let own = file.start_rules().iter().map(|rule| Some(rule.name.as_str().to_owned()));
        let own = own.filter(|rule| asks(rule.clone()));
        asking.extend(own.chain(asks(start.clone()).then_some(None)).map(|rule| (file.name().to_owned(), rule)));
    }
    asking
}

fn set(files: &mut [CityGrammar], name: &str, value: &str) -> Result<(), String> {
    let has = |file: &CityGrammar| file.grammar.attributes().iter().any(|attribute| attribute.name.is(name));
    let set = |file: &mut CityGrammar| file.grammar.set_text(name, value).map_err(|why| why.to_string());
    if files.iter().any(has) {
        return files.iter_mut().filter(|file| has(file)).try_for_each(set);
    }
    // The message of the first file names similar attributes.
    set(&mut files[0])
}

/// The names and digests of all files below a folder.
fn contents_of(root: &Path, folder: &Path, contents: &mut Vec<(String, [u8; 32])>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            contents_of(root, &path, contents)?;
        } else if path.is_file() {
            let mut hasher = blake3::Hasher::new();
            hasher.update_reader(std::fs::File::open(&path)?)?;
            let name = path.strip_prefix(root).unwrap_or(&path).to_string_lossy().replace('\\', "/");
            contents.push((name, *hasher.finalize().as_bytes()));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rules(text: &str) -> Rules {
        Rules::new(vec![RuleFile::from_text(text).expect("good rules")]).expect("one file")
    }

    const HOUSE: &str =
        "attr height = 9  @StartRule Lot --> extrude(height) X.  @StartRule Block --> extrude(height) Y.";

    #[test]
    fn digests_follow_rules_values_and_start_rules() {
        let near = Level::default();
        let digest = |rules: &Rules, level: &Level| rules.at(level).expect("known").digest;
        let first = digest(&rules(HOUSE), &near);
        assert_eq!(digest(&rules(HOUSE), &near), first);
        assert_ne!(digest(&rules(&HOUSE.replace("X.", "Z.")), &near), first);
        assert_ne!(digest(&rules(HOUSE), &"height=3".parse().unwrap()), first);
        assert_ne!(digest(&rules(HOUSE), &"Block".parse().unwrap()), first);
        let mut set = rules(HOUSE);
        set.set("height", "12").expect("an attribute");
        assert_ne!(digest(&set, &near), first);
    }

    #[test]
    fn start_rules_that_ask_about_neighbours_are_known() {
        let asking = "@StartRule Lot --> extrude(9) comp(f) { side : case touches(inter) : X. else : Y. | top : Z. }
            @StartRule Block --> extrude(9) Y.  @StartRule Own --> case touches(intra) : X. else : Y.";
        let lot = |start: Option<&str>| Footprint {
            id: String::new(),
            seed: 0,
            grammar: None,
            start: start.map(str::to_owned),
            values: Vec::new(),
            rings: Vec::new(),
            base: 0.0,
        };
        let asks = |level: &str, start: Option<&str>| {
            let level = if level.is_empty() { Level::default() } else { level.parse().expect("a level") };
            rules(asking).at(&level).expect("known").asks(&lot(start))
        };
        let found = [("", None), ("", Some("Block")), ("", Some("Own")), ("Block", None), ("Block", Some("Lot"))];
        assert_eq!(found.map(|(level, start)| asks(level, start)), [true, false, false, false, true]);
        assert!(!rules(HOUSE).at(&Level::default()).expect("known").can_ask());
    }

    #[test]
    fn rules_need_a_start_rule() {
        for text in ["attr height = 9", "House(h) --> extrude(h) X."] {
            let file = RuleFile::from_text(text).expect("good rules");
            let error = Rules::new(vec![file]).expect_err("refused");
            assert!(error.contains("has no start rule"), "{error}");
        }
    }

    #[test]
    fn wrong_levels_are_named() {
        let rules = rules(HOUSE);
        let error = |level: &str| rules.at(&level.parse().unwrap()).err().unwrap();
        assert!(error("Blok").contains("its start rules are Lot, Block"), "{}", error("Blok"));
        assert!(error("hight=3").contains("height"), "{}", error("hight=3"));
        assert!(error("height=tall").contains("tall"), "{}", error("height=tall"));
    }
}
