//! The traits of public types. A new type joins one of the lists.

use std::fmt::Debug;
use std::fs;

use cga::mesh::{
    Bounds, EmbeddedImage, FaceRef, FaceTag, Flaw, GltfError, GltfFile, ObjError, ObjFile, TagSet, UvAxis, UvExtent,
};
use cga::sink::buffers::{BufferSize, Buffers, Chunks, Submesh, Vertex};
use cga::sink::gltf::Glb;
use cga::sink::meshes::{Granularity, MeshLeaf, Meshes, TriangleMesh};
use cga::sink::obj::Obj;
use cga::sink::picture::{Camera, Image, Lines, Picture, Projection, Style, Viewpoint};
use cga::sink::sink_table::SinkTable;
use cga::sink::stats::{Measures, Stats};
use cga::sink::svg::Svg;
use cga::sink::watertight::Watertight;
use cga::sink::{Axes, Filled, PartId, Replay};
use cga::split::{Item, Piece, Prefix, Size, Solution};
use cga::street::{Centerline, Kind, Network, NetworkOptions, NetworkPart, Side, StreetError};
use cga::texture::{FaceMaps, SetMap, UvMap};
use cga::{
    Array, AssetError, Assets, Attribute, AttributeError, AttributeKind, Axis, Batch, Batches, Building, Channel,
    ChoiceValues, Choices, Collection, Color, ColorOf, Cuboid, EdgeAttribute, Error, Fault, FaultKind, FileList, Flow,
    Frame, Geometry, Grammars, Layer, LayerPart, Leaf, LeafView, Leaves, LimitKind, Limits, Live, LiveError, Material,
    MaterialNumber, MaterialText, Mesh, MeshBuilder, MeshError, Model, Print, Progress, Quad, Range, Report, Reports,
    RuleDiagnostic, RuleFile, RuleFileError, RuleLoader, RunError, Scene, SceneLot, SceneSession, Scope, Session,
    Settings, Shape, ShapeNode, ShapeRef, ShapeTree, SharedScene, StartRule, Stretch, Summary, Text, Value, ValueType,
    Watch, WriteError, WrongLots, cga,
};
use cga_tests::tree::root;

cga! { grammar House; Lot --> House. }

/// Public names that are traits or old names of types.
const OTHER: [&str; 8] =
    ["AssetSource", "ChunkResult", "CoordinateSystem", "DynSession", "Grammar", "Rules", "ShapeError", "Sink"];

fn data<T: Clone + PartialEq + Debug + Send + Sync>() {}

fn choice<T: Copy + Eq + Debug + Send + Sync>() {}

fn error<T: std::error::Error + Clone + PartialEq + Send + Sync + 'static>() {}

fn state<T: Debug + Send + Sync>() {}

fn shown<T: Debug>() {}

/// Shows that types belong to a list.
macro_rules! each {
    ($list:ident: $($ty:ty),* $(,)?) => { $($list::<$ty>();)* };
}

#[test]
fn public_types_have_the_common_traits() {
    each!(data: Array<f64>, Attribute, AttributeKind, Batch<Model>, Batches<Model>, Bounds, BufferSize, Buffers, Building, ChoiceValues, Choices);
    each!(data: Collection, Color, FileList, EdgeAttribute, EmbeddedImage, FaceTag, Flaw, Flow, Frame, GltfFile, Material, Measures, Mesh);
    each!(data: MeshLeaf, Meshes, Model, ObjFile, Print, Progress, Range, Report, Reports, Scope, ShapeTree, StartRule, Stats, Stretch);
    each!(data: Submesh, Summary, TagSet, Text, TriangleMesh, UvExtent, Value, Vertex);
    each!(data: Axes, ColorOf, Cuboid, FaceMaps, Geometry<'static>, LeafView<'static>, Quad, SetMap, UvMap);
    each!(data: Camera, Image, Limits, Picture, Projection, RuleDiagnostic, Style, Svg, Viewpoint);
    each!(data: Centerline, Network, NetworkOptions, NetworkPart, Item, Piece, Prefix, Size);
    each!(choice: Axis, Channel, FaultKind, Granularity, Kind, Layer, LayerPart, LimitKind, Lines);
    each!(choice: MaterialNumber, MaterialText, PartId, Side, UvAxis, ValueType, WrongLots);
    each!(error: AssetError, AttributeError, Error, Fault, GltfError, LiveError, MeshError, ObjError, RuleFileError, RunError, StreetError);
    // The error of a writer can be neither copied nor compared.
    each!(state: WriteError);
    // They share assets or a watch, or refer to a mesh, a model or a tree.
    each!(state: Assets, Grammars, Live, RuleFile, RuleLoader, Scene<'static>, SceneLot, Settings, Shape, SharedScene, Watch, FaceRef<'static>, Leaves<'static>, ShapeNode<'static>);
    // They are filled and then used up.
    each!(state: Chunks<fn(&Buffers) -> Flow>, Glb, MeshBuilder, Obj<Vec<u8>>, SinkTable, Solution, Watertight<Model>);
    // They belong to the thread of a run.
    each!(shown: Filled<'static>, Leaf<'static>, Replay<'static>, SceneSession<'static>, Session<'static, House>, ShapeRef<'static>);
}

#[test]
fn each_public_type_is_in_a_list() {
    let own = include_str!("traits.rs");
    let body = own.split_once("fn public_types_have_the_common_traits").map_or("", |(_, body)| body);
    let words: Vec<&str> = body.split(|c: char| !c.is_alphanumeric()).collect();
    let list = fs::read_to_string(root().join("tests/house/interface.txt")).expect("the list");
    let types =
        list.lines().filter(|line| line.starts_with("cga::") && !line.contains([' ', '.'])).filter_map(|line| {
            let (place, name) = line.rsplit_once("::")?;
            let is_type = |name: &str| name.starts_with(|c: char| c.is_uppercase());
            (is_type(name) && !is_type(place.rsplit("::").next().unwrap_or_default())).then_some(name)
        });
    let missing: Vec<&str> = types.filter(|name| !OTHER.contains(name) && !words.contains(name)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
