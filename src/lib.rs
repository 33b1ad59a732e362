// The first definition of a link counts: these replace those at the end of the README, which are right in the repository.
#![doc = "[reference]: crate::reference"]
#![doc = "[tutorial]: crate::guide::tutorial"]
#![doc = "[recipes]: crate::guide::recipes"]
#![doc = "[questions]: crate::guide::questions"]
#![doc = "[lots]: crate::guide::recipes#lots-with-attributes"]
#![doc = "[assets]: crate::guide::recipes#assets"]
#![doc = "[engines]: crate::guide::recipes#engines-and-browsers"]
#![doc = "[sliders]: crate::guide::recipes#attributes-in-a-user-interface"]
#![doc = "[sinks]: crate::guide::recipes#your-own-sink"]
#![doc = "[tiles]: crate::guide::recipes#maps-and-3d-tiles"]
#![doc = "[many]: crate::guide::programs#many-shapes-large-cities"]
#![doc = "[writing]: crate::guide::writing"]
#![doc = "[cityengine]: crate::guide::cityengine"]
#![doc = "[pyprt]: crate::guide::pyprt"]
#![cfg_attr(docsrs, doc = concat!("[picture]: <https://docs.rs/crate/cga/", env!("CARGO_PKG_VERSION"), "/source/docs/house.png>"))]
#![cfg_attr(docsrs, doc = concat!("[corner]: <https://docs.rs/crate/cga/", env!("CARGO_PKG_VERSION"), "/source/docs/gallery/scenes/corner.png>"))]
#![cfg_attr(docsrs, doc = concat!("[courtyard]: <https://docs.rs/crate/cga/", env!("CARGO_PKG_VERSION"), "/source/docs/gallery/scenes/courtyard.png>"))]
#![cfg_attr(docsrs, doc = concat!("[street]: <https://docs.rs/crate/cga/", env!("CARGO_PKG_VERSION"), "/source/docs/gallery/scenes/street.png>"))]
#![cfg_attr(docsrs, doc = concat!("[gallery]: <https://docs.rs/crate/cga/", env!("CARGO_PKG_VERSION"), "/source/docs/gallery/scenes.md>"))]
#![cfg_attr(docsrs, doc = concat!("[features]: <https://docs.rs/crate/cga/", env!("CARGO_PKG_VERSION"), "/source/docs/features.md>"))]
#![cfg_attr(docsrs, doc = concat!("[diagnostics]: <https://docs.rs/crate/cga/", env!("CARGO_PKG_VERSION"), "/source/docs/diagnostics.md>"))]
#![cfg_attr(docsrs, doc = concat!("[editor]: <https://docs.rs/crate/cga/", env!("CARGO_PKG_VERSION"), "/source/docs/editor.md>"))]
#![cfg_attr(docsrs, doc = concat!("[performance]: <https://docs.rs/crate/cga/", env!("CARGO_PKG_VERSION"), "/source/docs/performance.md>"))]
#![cfg_attr(not(docsrs), doc = concat!("[picture]: <file://", env!("CARGO_MANIFEST_DIR"), "/docs/house.png>"))]
#![cfg_attr(not(docsrs), doc = concat!("[corner]: <file://", env!("CARGO_MANIFEST_DIR"), "/docs/gallery/scenes/corner.png>"))]
#![cfg_attr(not(docsrs), doc = concat!("[courtyard]: <file://", env!("CARGO_MANIFEST_DIR"), "/docs/gallery/scenes/courtyard.png>"))]
#![cfg_attr(not(docsrs), doc = concat!("[street]: <file://", env!("CARGO_MANIFEST_DIR"), "/docs/gallery/scenes/street.png>"))]
#![cfg_attr(not(docsrs), doc = concat!("[gallery]: <file://", env!("CARGO_MANIFEST_DIR"), "/docs/gallery/scenes.md>"))]
#![cfg_attr(not(docsrs), doc = concat!("[features]: <file://", env!("CARGO_MANIFEST_DIR"), "/docs/features.md>"))]
#![cfg_attr(not(docsrs), doc = concat!("[diagnostics]: <file://", env!("CARGO_MANIFEST_DIR"), "/docs/diagnostics.md>"))]
#![cfg_attr(not(docsrs), doc = concat!("[editor]: <file://", env!("CARGO_MANIFEST_DIR"), "/docs/editor.md>"))]
#![cfg_attr(not(docsrs), doc = concat!("[performance]: <file://", env!("CARGO_MANIFEST_DIR"), "/docs/performance.md>"))]
#![doc = ""]
#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "eval")]
pub use cga_eval::{FileList, RuleDiagnostic, RuleFile, RuleFileError, RuleLoader};
#[cfg(feature = "live")]
pub use cga_eval::{Live, LiveError};
#[cfg(not(rust_analyzer))]
pub use cga_macros::cga;
#[cfg(rust_analyzer)]
pub use cga_macros::cga_for_editors as cga;
pub use cga_runtime::asset::{AssetError, AssetSource, Assets};
pub use cga_runtime::fault::{Error, Fault, FaultKind, LimitKind};
pub use cga_runtime::geometry::mesh::{Mesh, MeshBuilder, MeshError};
pub use cga_runtime::geometry::{Axis, Frame};
/// The vector types in meshes and sinks.
pub use cga_runtime::glam;
pub use cga_runtime::grammar::Grammar;
pub use cga_runtime::grammar::attribute::{Attribute, AttributeError, AttributeKind, ChoiceValues, Choices, Range};
/// ```
/// use cga::{Error, Grammars, Settings, Shape, cga};
///
/// cga! { grammar House; attr height = 6  Lot --> extrude(height) House. }
/// cga! { grammar Park; Lot --> Lawn. }
///
/// let lots = [
///     Shape::rectangle(10.0, 8.0).named("Mill Street 4").grammar("House").attribute("height", 12.5),
///     Shape::rectangle(20.0, 20.0).named("The Green").grammar("Park"),
/// ];
/// let models = Grammars::new().with(House::default()).with(Park::default()).generate_all(&lots, &Settings::default())?;
/// assert_eq!((models.to_model().volume(), models.count("Lawn")), (1000.0, 1));
/// # Ok::<(), Error>(())
/// ```
pub use cga_runtime::grammar::grammars::Grammars;
pub use cga_runtime::grammar::parallel::Stretch;
/// ```
/// use cga::{Error, Scene, Settings, Shape, cga};
///
/// cga! {
///     grammar House;
///     attr height = 6
///     Lot --> extrude(height) label("house") House
///     House --> case contextCompare(all, "house", world.highest) == 0 : Highest. else : Lower.
/// }
///
/// let lot = |x: f64, height: f64| Shape::rectangle(10.0, 8.0).at([x, 0.0, 0.0]).attribute("height", height);
/// let lots = [lot(0.0, 6.0), lot(10.0, 12.0), lot(20.0, 9.0)];
/// let models = Scene::new(&House::default(), &lots).generate(&Settings::default())?;
/// assert_eq!((models.count("Highest"), models.count("Lower")), (1, 2));
/// # Ok::<(), Error>(())
/// ```
pub use cga_runtime::grammar::scene::Scene;
pub use cga_runtime::grammar::scene::session::SceneSession;
pub use cga_runtime::grammar::scene::shared::{SceneLot, SharedScene};
/// ```
/// use cga::{Error, Grammar, Model, Settings, Shape, cga};
///
/// cga! { grammar House; Lot --> extrude(6) House. }
///
/// let chosen: Box<dyn Grammar> = Box::new(House::default());
/// let (mut session, mut model) = (chosen.session(&Settings::default())?, Model::new());
/// for width in [4.0, 5.0] {
///     session.run(&Shape::rectangle(width, 8.0), &mut model)?;
/// }
/// assert_eq!(model.volume(), 6.0 * 8.0 * (4.0 + 5.0));
/// # Ok::<(), Error>(())
/// ```
pub use cga_runtime::grammar::session::DynSession;
/// ```
/// use cga::sink::buffers::Buffers;
/// use cga::{Error, Settings, Shape, cga};
///
/// cga! { grammar House; Lot --> extrude(6) House. }
///
/// let (house, mut buffers) = (House::default(), Buffers::new());
/// let mut session = house.session(&Settings::default())?;
/// for width in [4.0, 5.0] {
///     session.run(&Shape::rectangle(width, 8.0), &mut buffers)?;
/// }
/// assert_eq!(buffers.triangle_count(), 24);
/// assert_eq!(session.generate(&Shape::rectangle(1.0, 2.0))?.volume(), 12.0);
/// # Ok::<(), Error>(())
/// ```
pub use cga_runtime::grammar::session::Session;
pub use cga_runtime::material::{Channel, Color, ColorOf, Layer, LayerPart, Material, MaterialNumber, MaterialText};
#[expect(deprecated, reason = "the old name")]
pub use cga_runtime::output::batches::ShapeError;
pub use cga_runtime::output::batches::{Batch, Batches, RunError};
pub use cga_runtime::output::error::WriteError;
pub use cga_runtime::output::model::{Geometry, LeafView, Leaves, Model};
pub use cga_runtime::run::building::Building;
pub use cga_runtime::run::coordinate_system::CoordinateSystem;
pub use cga_runtime::run::report::Report;
pub use cga_runtime::run::report::{Collection, Print, Reports, Summary};
pub use cga_runtime::run::rules::Rules;
#[doc(hidden)]
pub use cga_runtime::run::settings::Repeats;
pub use cga_runtime::run::settings::{Limits, Settings, WrongLots};
pub use cga_runtime::run::shape_tree::ShapeNode;
/// ```
/// use cga::{Error, Settings, Shape, cga};
///
/// cga! { grammar House; Lot --> extrude(6) split(y) { ~3 : Floor }*  Floor --> split(x) { ~4 : Room. }* }
///
/// let settings = Settings { tree: true, ..Settings::default() };
/// let model = House::default().generate_with(&Shape::rectangle(8.0, 10.0), &settings)?;
/// let picked = model.leaves().nth(3).and_then(|leaf| leaf.node()).unwrap();
/// assert_eq!((picked.rule(), picked.key().as_str()), ("Room", "0;1;1;"));
/// let floor = picked.parent().unwrap();
/// assert_eq!((floor.rule(), floor.scope().origin.y, floor.children().len()), ("Floor", 3.0, 2));
///
/// let (building, _) = model.buildings().next().unwrap();
/// let tree = building.tree.as_ref().unwrap();
/// assert_eq!((tree.len(), tree.find("0;1;").unwrap().index()), (7, floor.index()));
/// # Ok::<(), Error>(())
/// ```
pub use cga_runtime::run::shape_tree::ShapeTree;
pub use cga_runtime::run::sink::{Cuboid, Flow, Leaf, Quad, Sink};
pub use cga_runtime::run::start_rule::StartRule;
pub use cga_runtime::run::watch::{Progress, Watch};
pub use cga_runtime::shape::scope::Scope;
pub use cga_runtime::shape::{EdgeAttribute, Shape, ShapeRef};
pub use cga_runtime::value::array::Array;
pub use cga_runtime::value::text::Text;
pub use cga_runtime::value::{Value, ValueType};

/// Meshes: building, measuring, checking, reading.
pub mod mesh {
    pub use cga_runtime::asset::EmbeddedImage;
    #[cfg(feature = "gltf")]
    pub use cga_runtime::asset::gltf::{GltfError, GltfFile, read_gltf};
    #[cfg(feature = "obj")]
    pub use cga_runtime::asset::obj::{ObjError, ObjFile, read_obj};
    pub use cga_runtime::geometry::mesh::check::Flaw;
    pub use cga_runtime::geometry::mesh::{Bounds, FaceRef, FaceTag, TagSet, UvAxis, UvExtent};

    /// The old address of [`cga::Mesh`](crate::Mesh).
    #[deprecated(note = "it is `cga::Mesh`")]
    pub type Mesh = crate::Mesh;
    /// The old address of [`cga::MeshBuilder`](crate::MeshBuilder).
    #[deprecated(note = "it is `cga::MeshBuilder`")]
    pub type MeshBuilder = crate::MeshBuilder;
    /// The old address of [`cga::MeshError`](crate::MeshError).
    #[deprecated(note = "it is `cga::MeshError`")]
    pub type MeshError = crate::MeshError;
}

/// Texture coordinates of leaves that are rectangles or boxes: maps from points of the world.
pub mod texture {
    pub use cga_runtime::geometry::uv_map::{FaceMaps, SetMap, UvMap};
}

/// The sinks of this crate, and what sinks receive besides the types that are beside [`cga::Sink`](crate::Sink).
pub mod sink {
    #[cfg(feature = "gltf")]
    pub use cga_runtime::output::gltf;
    pub use cga_runtime::output::{buffers, meshes, obj, picture, sink_table, stats, svg, watertight, write_file};
    /// A trait has no name that can be deprecated.
    #[doc(hidden)]
    pub use cga_runtime::run::sink::Sink;
    pub use cga_runtime::run::sink::{Axes, Filled, PartId, Replay};

    /// The old address of [`cga::Cuboid`](crate::Cuboid).
    #[deprecated(note = "it is `cga::Cuboid`")]
    pub type Cuboid = crate::Cuboid;
    /// The old address of [`cga::Flow`](crate::Flow).
    #[deprecated(note = "it is `cga::Flow`")]
    pub type Flow = crate::Flow;
    /// The old address of [`cga::Leaf`](crate::Leaf).
    #[deprecated(note = "it is `cga::Leaf`")]
    pub type Leaf<'a> = crate::Leaf<'a>;
    /// The old address of [`cga::Quad`](crate::Quad).
    #[deprecated(note = "it is `cga::Quad`")]
    pub type Quad = crate::Quad;

    /// The old address of [`cga::WriteError`](crate::WriteError).
    pub mod error {
        /// The old address of [`cga::WriteError`](crate::WriteError).
        #[deprecated(note = "it is `cga::WriteError`")]
        pub type WriteError = crate::WriteError;
    }
}

/// Runs on many initial shapes, on several threads with the feature `rayon`. The results equal the results of a loop, to
/// the byte.
///
/// [`generate_all`](parallel::generate_all) returns a model of each shape. Its batches can be written as one file,
/// without being joined first:
///
/// ```
/// use cga::{Error, Settings, Shape, cga};
///
/// cga! {
///     grammar House;
///     Lot --> extrude(6) report("floor area", 2 * scope.sx * scope.sz) split(y) { { 3 : Storey. }* }
/// }
///
/// let lots: Vec<Shape> = (1..=100).map(|at| Shape::rectangle(f64::from(at), 10.0)).collect();
/// let houses = House::default().generate_all(&lots, &Settings::default())?;
/// assert_eq!((houses.len(), houses.count("Storey")), (100, 200));
/// assert_eq!(houses.report().reported("floor area").unwrap().summary().sum, 101_000.0);
/// assert_eq!(houses.to_obj("houses.mtl").0.matches("\nf ").count(), 200 * 6);
/// # Ok::<(), Error>(())
/// ```
///
/// [`run_all`](parallel::run_all) has a sink for each stretch of shapes. Grammars have methods that do the same:
///
/// ```
/// # use cga::{Error, Settings, Shape, cga};
/// # cga! { grammar House; Lot --> extrude(6) split(y) { { 3 : Storey. }* } }
/// # let lots: Vec<Shape> = (1..=100).map(|at| Shape::rectangle(f64::from(at), 10.0)).collect();
/// use cga::sink::buffers::Buffers;
///
/// let batches = House::default().run_all(&lots, &Settings::default(), |_stretch| Buffers::new())?;
/// assert_eq!(batches.sinks().map(Buffers::triangle_count).sum::<usize>(), 200 * 12);
/// assert_eq!(batches.iter().next_back().unwrap().shapes, 99..100);
/// # Ok::<(), Error>(())
/// ```
///
/// The functions also take a grammar that is chosen at run time:
///
/// ```
/// # use cga::{Error, Grammar, Settings, Shape, cga};
/// # cga! { grammar House; Lot --> extrude(6) split(y) { { 3 : Storey. }* } }
/// # let lots: Vec<Shape> = (1..=100).map(|at| Shape::rectangle(f64::from(at), 10.0)).collect();
/// use cga::parallel::run_all;
/// use cga::sink::stats::Stats;
///
/// let chosen: Box<dyn Grammar + Sync> = Box::new(House::default());
/// let batches = run_all(&*chosen, &lots, &Settings::default(), |_stretch| Stats::new())?;
/// assert_eq!(batches.report().leaves, 200);
/// # Ok::<(), Error>(())
/// ```
///
/// A [`RunError`] has the index of the shape:
///
/// ```
/// # use cga::{Settings, Shape, cga};
/// # cga! { grammar House; Lot --> extrude(6) split(y) { { 3 : Storey. }* } }
/// let lots = [Shape::rectangle(4.0, 5.0), Shape::rectangle(f64::NAN, 5.0)];
/// let error = House::default().generate_all(&lots, &Settings::default()).unwrap_err();
/// assert_eq!(error.shape, Some(1));
/// assert!(error.to_string().starts_with("initial shape 1: "));
/// ```
pub mod parallel {
    #[expect(deprecated, reason = "the old name")]
    pub use cga_runtime::grammar::parallel::derive_all;
    pub use cga_runtime::grammar::parallel::{generate_all, run_all};

    /// The old address of [`cga::Batch`](crate::Batch).
    #[deprecated(note = "it is `cga::Batch`")]
    pub type Batch<S> = crate::Batch<S>;
    /// The old address of [`cga::Batches`](crate::Batches).
    #[deprecated(note = "it is `cga::Batches`")]
    pub type Batches<S> = crate::Batches<S>;
    /// The old name of [`cga::RunError`](crate::RunError).
    #[deprecated(note = "it is `cga::RunError`")]
    pub type ShapeError = crate::RunError;
    /// The old address of [`cga::Stretch`](crate::Stretch).
    #[deprecated(note = "it is `cga::Stretch`")]
    pub type Stretch = crate::Stretch;
}

/// Streets, sidewalks and junctions from centre lines: initial shapes with texture coordinates along and across.
///
/// ```
/// use cga::street::{Centerline, Network, NetworkOptions};
/// use cga::{Model, Sink, cga};
///
/// cga! {
///     grammar Streets;
///     Street   --> color("#5c5e63") Roadway.
///     Crossing --> color("#6d7078") Roadway.
///     Sidewalk --> extrude(world.up, 0.15) Pavement.
/// }
///
/// let lines = [Centerline::new(&[[-50.0, 0.0], [50.0, 0.0]]), Centerline::new(&[[0.0, -40.0], [0.0, 40.0]])];
/// let mut model = Model::new();
/// for part in Network::new(&lines, &NetworkOptions::default())?.parts() {
///     let _ = Streets::default().generate_from(part.start_rule(), &part.shape())?.replay(&mut model as &mut dyn Sink);
/// }
/// // Four streets and the crossing; four times two sidewalks, and four corners.
/// assert_eq!((model.count("Roadway"), model.count("Pavement")), (5, 12));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub mod street {
    pub use cga_street::{Centerline, Kind, Network, NetworkOptions, NetworkPart, Side, StreetError};
}

/// The split solver: pieces from sizes and an extent.
pub mod split {
    pub use cga_runtime::split::{Item, Piece, Prefix, Size, Solution, solve};
}

/// The reference of the language: operations, selectors, functions, attributes and annotations.
///
#[doc = include_str!("../docs/reference.md")]
pub mod reference {}

#[cfg(any(doc, doctest))]
pub mod guide;

/// The interface of generated code, without a promise of stability.
#[doc(hidden)]
pub mod __rt {
    pub use cga_runtime::rt::*;

    #[cfg(rust_analyzer)]
    pub use super::words;
}

#[cfg(rust_analyzer)]
#[doc(hidden)]
pub mod words;
