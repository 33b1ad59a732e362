//! The contents of a tile: the buildings of some lots as one GLB, with a feature for each building.

use std::panic::{AssertUnwindSafe, catch_unwind};

use cga::sink::gltf::Glb;
use cga::sink::watertight::Watertight;
use cga::{DynSession, Error, Report, Scene, SceneSession, Settings, Shape, Sink};
use cga_geo::footprint::Footprint;
use cga_geo::frame::Frame;

use crate::glb_bounds::{Bounds, glb_bounds};
use crate::images::{Images, TileImages};
use crate::rules::LevelRules;
use crate::surroundings::Surroundings;

/// The most problems of a tile that are listed.
pub const MOST_PROBLEMS: usize = 100;

/// The contents of a tile.
#[derive(Clone, Debug, PartialEq)]
pub struct Content {
    /// The file; empty if no building has a face.
    pub glb: Vec<u8>,
    /// The images that it shares with other tiles.
    pub images: Images,
    /// The box around the buildings: east, north and up in metres.
    pub bounds: Bounds,
    /// The number of buildings.
    pub buildings: u64,
    /// Faults of runs and lots that cannot be built, each with the id of its lot; at most [`MOST_PROBLEMS`].
    pub problems: Vec<LotProblem>,
    /// The number of problems beyond.
    pub problems_left_out: u64,
}

/// A problem of a lot.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct LotProblem {
    /// The id of the lot.
    pub id: String,
    /// True if the lot has no building, or a part of one.
    pub is_lost: bool,
    /// The reason.
    pub reason: String,
}

/// The form of the files of tiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Form {
    /// The metres by which positions may move, which makes files smaller unless a tile is too wide for that.
    pub accuracy: f64,
    /// The most bytes of a file with several lots.
    pub most_bytes: u64,
    /// True for images in files of their own, which tiles share.
    pub shares_images: bool,
    /// False for files without normals, whose faces share corners.
    pub has_normals: bool,
    /// True for files whose triangles meet edge to edge, so that no pixel shows through a building.
    pub is_watertight: bool,
}

/// Makes the contents of a tile. `None` if the file has more bytes than its form allows and more than one lot: then its lots are divided.
///
/// With `around`, the rules of the lots find each other and the lots around the tile, which have no building in it.
pub fn content(
    lots: &[Footprint],
    around: Option<&Surroundings>,
    frame: &Frame,
    rules: &LevelRules,
    form: Form,
) -> Option<Content> {
    let glb = Glb::new().with_assets(rules.settings.assets.clone()).named("tile");
    let Form { accuracy, most_bytes, shares_images, has_normals, is_watertight } = form;
    let mut glb = glb.with_quantization(accuracy).without_rules();
    if !has_normals {
        glb = glb.without_normals();
    }
    // Shared corners are known at the end.
    let most_parts = if has_normals { most_bytes } else { most_bytes.saturating_mul(2) };
    let images = TileImages::default();
    if shares_images {
        let images = images.clone();
        glb = glb.with_shared_images(move |ending, bytes| images.take(ending, bytes));
    }
    let mut content = Content::default();
    if let (Some(Err(why)), Some(first)) = (around.map(|around| &around.lots), lots.first()) {
        content.add(first, false, why.clone());
    }
    let lot = |footprint: &Footprint| footprint.lot(rules.grammar(footprint.grammar.as_deref()), frame);
    let (mut shapes, mut numbers) = (Vec::new(), Vec::new());
    for footprint in lots {
        match lot(footprint) {
            Ok(shape) => {
                numbers.push(footprint);
                shapes.push(shape);
            }
            Err(why) => content.add(footprint, true, why.to_string()),
        }
    }
    // Lots of other tiles that cannot be built are problems of those tiles.
    let others = around.and_then(|around| around.lots.as_ref().ok()).into_iter().flatten();
    shapes.extend(others.filter_map(|footprint| lot(footprint).ok()));
    let scene = around.map(|Surroundings { distances, .. }| {
        let scene = Scene::of_grammars(&rules.grammars, &shapes);
        scene.occlusion_distance(distances.occlusion).context_distance(distances.context)
    });
    let mut runs = Runs::open(scene, rules);
    for (index, footprint) in numbers.into_iter().enumerate() {
        // A mistake of the runtime must not end a city.
        let run = catch_unwind(AssertUnwindSafe(|| runs.run(index, &shapes, &mut glb, is_watertight)));
        match run {
            Ok(Ok(report)) => {
                content.buildings += 1;
                report.faults().iter().for_each(|fault| content.add(footprint, false, in_command(&fault.to_string())));
            }
            Ok(Err(why)) => content.add(footprint, true, why.to_string()),
            Err(_) => {
                runs = Runs::open(scene, rules);
                content.add(
                    footprint,
                    true,
                    "the run failed; please report this with the rules and the lot".to_owned(),
                );
            }
        }
        if most_parts < glb.size() && 1 < lots.len() {
            return None;
        }
    }
    // The size of a file leaves out meshes that are inserted, so the box around all meshes tells whether it has some.
    let made = glb.into_bytes().map_err(|why| why.to_string()).and_then(|bytes| Ok((glb_bounds(&bytes)?, bytes)));
    match made {
        Ok((_, bytes)) if most_bytes < bytes.len() as u64 && 1 < lots.len() => return None,
        Ok((bounds, bytes)) if !bounds.is_empty() => {
            // From x, y, z of rules to east, north, up.
            let Bounds { low, high } = bounds;
            content.bounds = Bounds { low: [low[0], -high[2], low[1]], high: [high[0], -low[2], high[1]] };
            content.glb = bytes;
            content.images = images.into_images();
        }
        Ok(_) => {}
        Err(_) if 1 < lots.len() => return None,
        Err(why) => lots.iter().for_each(|lot| content.add(lot, true, why.clone())),
    }
    Some(content)
}

/// The runs of the lots of a tile.
enum Runs<'c> {
    /// Rules that find no neighbours.
    Alone(Box<dyn DynSession + 'c>),
    /// Rules among neighbours. The session is opened by the first run, whose error says what is wrong.
    Scene(Scene<'c>, &'c Settings, Option<Box<SceneSession<'c>>>),
}

impl<'c> Runs<'c> {
    fn open(scene: Option<Scene<'c>>, rules: &'c LevelRules) -> Self {
        match scene {
            None => Runs::Alone(rules.grammars.session(&rules.settings)),
            Some(scene) => Runs::Scene(scene, &rules.settings, None),
        }
    }

    fn run(&mut self, index: usize, shapes: &[Shape], glb: &mut Glb, is_watertight: bool) -> Result<Report, Error> {
        if !is_watertight {
            return self.run_into(index, shapes, glb);
        }
        let mut sink = Watertight::new(glb);
        let report = self.run_into(index, shapes, &mut sink)?;
        sink.into_inner();
        Ok(report)
    }

    fn run_into(&mut self, index: usize, shapes: &[Shape], sink: &mut dyn Sink) -> Result<Report, Error> {
        match self {
            Runs::Alone(session) => session.run(&shapes[index], sink),
            Runs::Scene(scene, settings, session) => {
                let session = match session {
                    Some(session) => session,
                    none => none.insert(Box::new(scene.session(settings)?)),
                };
                session.run(index, sink)
            }
        }
    }
}

/// A fault in the words of the command: its messages name settings of the library.
fn in_command(fault: &str) -> String {
    fault.replace("`Settings::assets`", "`--assets FOLDER`")
}

impl Default for Content {
    fn default() -> Self {
        Content {
            glb: Vec::new(),
            images: Images::new(),
            bounds: Bounds::EMPTY,
            buildings: 0,
            problems: Vec::new(),
            problems_left_out: 0,
        }
    }
}

impl Content {
    fn add(&mut self, footprint: &Footprint, is_lost: bool, reason: String) {
        // Every lost building is listed: a tile has few lots.
        if !is_lost && MOST_PROBLEMS <= self.problems.len() {
            self.problems_left_out += 1;
            return;
        }
        self.problems.push(LotProblem { id: footprint.id.clone(), is_lost, reason });
    }
}
