//! A run in the background.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use bevy_asset::RenderAssetUsages;
use bevy_ecs::component::Component;
use bevy_math::Vec3;
use bevy_mesh::Mesh;
use bevy_tasks::futures::check_ready;
use bevy_tasks::{AsyncComputeTaskPool, Task, TaskPool};
use bevy_transform::components::Transform;
use cga::glam::DVec3;
use cga::sink::meshes::Granularity;
use cga::{Error, Model, Watch};

use crate::channel::Channels;
use crate::convert;
use crate::event::CgaError;
use crate::parts::CgaMesh;
use crate::scene::LotPlace;
use crate::source::{Cga, LeafEvents};

/// A run is under way for this entity. Removing the component ends the run without a model.
#[derive(Component, Debug)]
pub struct CgaRun {
    task: Task<Result<Generated, CgaError>>,
    /// Ends the run early; `None` if the user has a watch, which may belong to other runs too.
    watch: Option<Watch>,
    pub(crate) is_outdated: bool,
}

/// A model with all that is needed to show it.
#[derive(Debug)]
pub(crate) struct Generated {
    pub(crate) model: Arc<Model>,
    /// The point of the shape's coordinates to which all places are relative.
    pub(crate) origin: DVec3,
    pub(crate) meshes: Vec<GeneratedMesh>,
    pub(crate) leaves: Vec<GeneratedLeaf>,
}

/// A mesh and its places.
#[derive(Debug)]
pub(crate) struct GeneratedMesh {
    pub(crate) mesh: Mesh,
    pub(crate) places: Vec<PlacedMesh>,
}

/// A place of a mesh.
#[derive(Debug)]
pub(crate) struct PlacedMesh {
    pub(crate) name: String,
    pub(crate) transform: Transform,
    pub(crate) part: CgaMesh,
}

/// A leaf with an event of its own.
#[derive(Debug)]
pub(crate) struct GeneratedLeaf {
    pub(crate) leaf: usize,
    pub(crate) transform: Transform,
    pub(crate) size: Vec3,
}

impl CgaRun {
    /// Starts a run, for a lot of a scene at its place among the others.
    pub(crate) fn start(cga: &Cga, place: Option<LotPlace>) -> Self {
        let own = cga.settings.watch.is_none().then(Watch::new);
        let watch = own.clone().or_else(|| cga.settings.watch.clone());
        let source = place.map_or_else(
            || RunSource::alone(cga, watch.clone()),
            |place| RunSource::Lot { place, watch: watch.clone() },
        );
        let shown = Shown {
            granularity: cga.granularity,
            leaf_events: cga.leaf_events.clone(),
            watertight: cga.watertight,
            usages: cga.usages,
        };
        let pool = AsyncComputeTaskPool::get_or_init(TaskPool::default);
        let task = pool.spawn(async move {
            catch_unwind(AssertUnwindSafe(|| generate(&source, &shown))).unwrap_or_else(|panic| {
                let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
                Err(CgaError::Panic(text.or_else(|| panic.downcast_ref().cloned()).unwrap_or_default()))
            })
        });
        CgaRun { task, watch: own, is_outdated: false }
    }

    /// The result, once.
    pub(crate) fn poll(&mut self) -> Option<Result<Generated, CgaError>> {
        check_ready(&mut self.task)
    }
}

impl Drop for CgaRun {
    fn drop(&mut self) {
        if let Some(watch) = &self.watch {
            watch.stop();
        }
    }
}

/// The source of a model.
enum RunSource {
    Alone(Box<Cga>),
    Lot { place: LotPlace, watch: Option<Watch> },
}

impl RunSource {
    fn alone(cga: &Cga, watch: Option<Watch>) -> Self {
        let mut cga = Box::new(cga.clone());
        cga.settings.watch = watch;
        RunSource::Alone(cga)
    }

    fn model(&self) -> Result<Model, Error> {
        match self {
            RunSource::Alone(cga) => cga.grammar.generate_with(&cga.shape, &cga.settings),
            RunSource::Lot { place, watch } => place.generate(watch.as_ref()),
        }
    }
}

/// The choices of [`Cga`] for the meshes and events of a model.
struct Shown {
    granularity: Granularity,
    leaf_events: LeafEvents,
    watertight: bool,
    usages: RenderAssetUsages,
}

fn generate(source: &RunSource, shown: &Shown) -> Result<Generated, CgaError> {
    let model = source.model().map_err(CgaError::Run)?;
    if model.report().stopped {
        return Err(CgaError::Stopped);
    }
    // The numbers of its leaves stay.
    let meshes =
        if shown.watertight { model.watertight().meshes(shown.granularity) } else { model.meshes(shown.granularity) };
    let origin = meshes.origin;
    let meshes = meshes.into_iter().map(|mut mesh| {
        let mut channels = Channels::of(&mesh);
        let made = convert::mesh(&mut mesh, &mut channels, shown.usages);
        let name = mesh.rule.as_ref().map_or_else(|| material_name(&mesh.material), ToString::to_string);
        let part = |leaves| CgaMesh {
            rule: mesh.rule.clone(),
            material: mesh.material.clone(),
            leaves,
            channels: channels.of_layer,
        };
        let places = if mesh.places.is_empty() {
            vec![PlacedMesh { name, transform: Transform::IDENTITY, part: part(std::mem::take(&mut mesh.leaves)) }]
        } else {
            let each = mesh.places.iter().zip(&mesh.leaves);
            each.map(|(place, leaf)| PlacedMesh {
                name: name.clone(),
                transform: convert::place(place),
                part: part(vec![leaf.clone()]),
            })
            .collect()
        };
        GeneratedMesh { mesh: made, places }
    });
    let meshes = meshes.collect();
    let leaves =
        if shown.leaf_events == LeafEvents::None { Vec::new() } else { leaves(&model, &shown.leaf_events, origin) };
    Ok(Generated { model: Arc::new(model), origin, meshes, leaves })
}

/// The leaves with events.
fn leaves(model: &Model, events: &LeafEvents, origin: DVec3) -> Vec<GeneratedLeaf> {
    let chosen = model.leaves().enumerate().filter(|(_, leaf)| events.includes(leaf.rule()));
    let made = chosen.map(|(leaf, view)| GeneratedLeaf {
        leaf,
        transform: convert::corner(&view.scope(), origin),
        size: convert::vector(view.size()),
    });
    made.collect()
}

/// The name of a material, or its colour.
fn material_name(material: &cga::Material) -> String {
    let hex = || {
        let color = material.color();
        let [r, g, b] = [color.r, color.g, color.b].map(|channel| (channel * 255.0).round() as u8);
        format!("#{r:02x}{g:02x}{b:02x}")
    };
    material.name.as_ref().map_or_else(hex, |name| name.to_string())
}
