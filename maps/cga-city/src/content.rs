//! The contents of a tile: the buildings of some lots as one GLB, with a feature for each building.

use std::panic::{AssertUnwindSafe, catch_unwind};

use cga::sink::gltf::Glb;
use cga_geo::footprint::Footprint;
use cga_geo::frame::Frame;

use crate::glb_bounds::{Bounds, glb_bounds};
use crate::rules::LevelRules;

/// The most problems of a tile that are listed.
pub const MOST_PROBLEMS: usize = 100;

/// The contents of a tile.
#[derive(Clone, Debug, PartialEq)]
pub struct Content {
    /// The file; empty if no building has a face.
    pub glb: Vec<u8>,
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

/// Makes the contents of a tile. `None` if the file has more than `most_bytes` and more than one lot: then its lots are divided. Positions
/// move by at most `accuracy` metres, which makes the file smaller unless the tile is too wide for that.
pub fn content(
    lots: &[Footprint],
    frame: &Frame,
    rules: &LevelRules,
    accuracy: f64,
    most_bytes: u64,
) -> Option<Content> {
    let mut session = rules.grammars.session(&rules.settings);
    let glb = Glb::new().with_assets(rules.settings.assets.clone()).named("tile");
    let mut glb = glb.with_quantization(accuracy).without_rules();
    let mut content =
        Content { glb: Vec::new(), bounds: Bounds::EMPTY, buildings: 0, problems: Vec::new(), problems_left_out: 0 };
    for footprint in lots {
        let lot = match footprint.lot(rules.grammar(footprint.grammar.as_deref()), frame) {
            Ok(lot) => lot,
            Err(why) => {
                content.add(footprint, true, why.to_string());
                continue;
            }
        };
        // A mistake of the runtime must not end a city.
        let run = catch_unwind(AssertUnwindSafe(|| session.run(&lot, &mut glb)));
        match run {
            Ok(Ok(report)) => {
                content.buildings += 1;
                report.faults().iter().for_each(|fault| content.add(footprint, false, in_command(&fault.to_string())));
            }
            Ok(Err(why)) => content.add(footprint, true, why.to_string()),
            Err(_) => {
                session = rules.grammars.session(&rules.settings);
                content.add(
                    footprint,
                    true,
                    "the run failed; please report this with the rules and the lot".to_owned(),
                );
            }
        }
        if most_bytes < glb.size() && 1 < lots.len() {
            return None;
        }
    }
    if glb.size() == 0 {
        return Some(content);
    }
    let made = glb.into_bytes().map_err(|why| why.to_string()).and_then(|bytes| Ok((glb_bounds(&bytes)?, bytes)));
    match made {
        Ok((_, bytes)) if most_bytes < bytes.len() as u64 && 1 < lots.len() => return None,
        Ok((bounds, bytes)) if !bounds.is_empty() => {
            // From x, y, z of rules to east, north, up.
            let Bounds { low, high } = bounds;
            content.bounds = Bounds { low: [low[0], -high[2], low[1]], high: [high[0], -low[2], high[1]] };
            content.glb = bytes;
        }
        Ok(_) => {}
        Err(_) if 1 < lots.len() => return None,
        Err(why) => lots.iter().for_each(|lot| content.add(lot, true, why.clone())),
    }
    Some(content)
}

/// A fault in the words of the command: its messages name settings of the library.
fn in_command(fault: &str) -> String {
    fault.replace("`Settings::assets`", "`--assets FOLDER`")
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
