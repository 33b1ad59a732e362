//! Rule files as assets: loaded, and loaded again when they change.

use std::collections::HashSet;

use bevy_asset::io::Reader;
use bevy_asset::{Asset, AssetEvent, AssetId, AssetLoader, AssetPath, Assets, Handle, LoadContext};
use bevy_ecs::change_detection::DetectChanges;
use bevy_ecs::component::Component;
use bevy_ecs::entity::Entity;
use bevy_ecs::message::MessageReader;
use bevy_ecs::system::{Commands, Query, Res};
use bevy_ecs::world::Ref;
use bevy_reflect::TypePath;
use bevy_transform::components::Transform;
use cga::{Grammar, RuleFile, RuleFileError, RuleLoader, Settings, Shape, Value};

use crate::source::Cga;

/// The most files of one grammar.
const MOST_FILES: usize = 1000;

/// The rules of a file of the asset folder, such as `rules/tower.cga`, with the files that it imports.
///
/// With Bevy's feature `file_watcher`, a file that is saved is loaded again, and so are the files that import it. With a mistake in the rules,
/// Bevy logs the error with its line, and the last good rules stay.
#[derive(Asset, TypePath, Clone, Debug)]
pub struct CgaRules {
    /// The rules. Their name is the name of the file without its ending.
    pub rules: RuleFile,
}

/// Loads [`CgaRules`]. The plugin registers one without Rust functions; register another one for rules that call some.
#[derive(TypePath, Clone, Debug, Default)]
pub struct CgaRuleLoader {
    /// The functions of the program.
    pub loader: RuleLoader,
}

impl AssetLoader for CgaRuleLoader {
    type Asset = CgaRules;
    type Settings = ();
    type Error = RuleFileError;

    async fn load(
        &self,
        reader: &mut dyn Reader,
        _: &(),
        context: &mut LoadContext<'_>,
    ) -> Result<CgaRules, RuleFileError> {
        let mut bytes = Vec::new();
        let read = reader.read_to_end(&mut bytes).await;
        let name = context.path().path().to_string_lossy().replace('\\', "/");
        let source = context.path().source().clone_owned();
        let text = read.map(|_| RuleLoader::decode(&bytes)).unwrap_or_default();
        let mut loader = self.loader.clone().with_file(&name, &text);
        let mut known = HashSet::from([name.clone()]);
        let mut files = vec![(name.clone(), text)];
        while let Some((from, text)) = files.pop() {
            for names in RuleLoader::imports(&from, &text) {
                // The nearest file is the one that is meant.
                for name in names {
                    if known.contains(&name) {
                        break;
                    }
                    if known.len() == MOST_FILES {
                        continue;
                    }
                    let path = AssetPath::from_path_buf(name.clone().into()).with_source(source.clone());
                    if let Ok(bytes) = context.read_asset_bytes(path).await {
                        let text = RuleLoader::decode(&bytes);
                        loader = loader.with_file(&name, &text);
                        known.insert(name.clone());
                        files.push((name, text));
                        break;
                    }
                }
            }
        }
        Ok(CgaRules { rules: loader.memory_file(&name)? })
    }

    fn extensions(&self) -> &[&str] {
        &["cga"]
    }
}

/// An entity whose grammar comes from a rule file. When the rules are loaded, the entity gets a [`Cga`]; when they change, its grammar is
/// replaced and keeps the values that were set, by name.
///
/// ```
/// # use bevy_asset::AssetServer;
/// # use bevy_cga::CgaFile;
/// # use bevy_ecs::prelude::*;
/// # use cga::Shape;
/// fn add_tower(mut commands: Commands, assets: Res<AssetServer>) {
///     let rules = assets.load("rules/tower.cga");
///     commands.spawn(CgaFile::new(rules, Shape::rectangle(20.0, 15.0)).set("height", 40.0));
/// }
/// ```
#[derive(Component, Clone, Debug)]
#[require(Transform)]
pub struct CgaFile {
    /// The rules.
    pub rules: Handle<CgaRules>,
    /// The initial shape of the first [`Cga`].
    pub shape: Shape,
    /// The settings of the first [`Cga`].
    pub settings: Settings,
    /// The values of attributes of the first [`Cga`], by name.
    pub values: Vec<(String, Value)>,
}

impl CgaFile {
    /// The rules of a file on a shape, with default settings.
    pub fn new(rules: Handle<CgaRules>, shape: Shape) -> Self {
        CgaFile { rules, shape, settings: Settings::default(), values: Vec::new() }
    }

    /// Sets an attribute when the rules are loaded. A value that the rules refuse is logged.
    #[must_use]
    pub fn set(mut self, name: impl Into<String>, value: impl Into<Value>) -> Self {
        self.values.push((name.into(), value.into()));
        self
    }

    /// Sets the settings of runs.
    #[must_use]
    pub fn settings(self, settings: Settings) -> Self {
        CgaFile { settings, ..self }
    }
}

/// Gives entities the rules that were loaded.
pub(crate) fn take_rules(
    mut events: MessageReader<AssetEvent<CgaRules>>,
    rules: Res<Assets<CgaRules>>,
    mut entities: Query<(Entity, Ref<CgaFile>, Option<&mut Cga>)>,
    mut commands: Commands,
) {
    let changed: HashSet<AssetId<CgaRules>> = events
        .read()
        .filter_map(|event| match event {
            AssetEvent::Added { id } | AssetEvent::Modified { id } => Some(*id),
            _ => None,
        })
        .collect();
    for (entity, file, cga) in &mut entities {
        if !file.is_changed() && !changed.contains(&file.rules.id()) {
            continue;
        }
        let Some(CgaRules { rules }) = rules.get(&file.rules) else { continue };
        let mut rules = rules.clone();
        match cga {
            Some(mut cga) => {
                for (name, error) in rules.take_values(&*cga.grammar) {
                    tracing::warn!("{entity}: the value of `{name}` is dropped: {error}");
                }
                cga.grammar = Box::new(rules);
            }
            None => {
                for (name, value) in &file.values {
                    if let Err(error) = rules.set(name, value.clone()) {
                        tracing::warn!("{entity}: {error}");
                    }
                }
                commands.entity(entity).try_insert(Cga::new(rules, file.shape.clone()).settings(file.settings.clone()));
            }
        }
    }
}
