//! Results that a run keeps, because rules ask for the same again and again.

use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;
use std::sync::Arc;

use super::Env;
use crate::asset::{AssetError, File, Query};
use crate::fault::FaultKind;
use crate::fixed_hash::FixedState;
use crate::geometry::mesh::Mesh;
use crate::geometry::primitive::PrimitiveKind;
use crate::shape::edge_attributes::SampledAttributes;
use crate::shape::texture::SharedSets;
use crate::value::array::Array;
use crate::value::text::Text;

/// The number of file searches whose results are kept: rules repeat them for every shape.
const SEARCHES_KEPT: usize = 32;

/// The number of tables that are kept: functions read the same files again and again.
const TABLES_KEPT: usize = 16;

/// The number of images whose sizes are kept: rules sort the same images for every shape.
const IMAGE_SIZES_KEPT: usize = 10_000;

/// The largest number of corners of a primitive that is kept. There are some thousand such primitives, and together they take
/// less than 100 MB.
const PRIMITIVE_KEPT: u64 = 1024;

/// The first results of each kind.
#[derive(Debug, Default)]
pub(crate) struct KeptResults {
    /// The primitives made so far.
    primitives: HashMap<PrimitiveKind, Arc<Mesh>, FixedState>,
    /// The results of file searches; see [`Env::files`].
    searches: BTreeMap<File, Rc<[Text]>>,
    /// The tables read so far, by file.
    pub(crate) tables: BTreeMap<File, Array<Text>>,
    /// The widths and heights of images.
    pub(crate) image_sizes: BTreeMap<File, Result<(u32, u32), AssetError>>,
    /// The meshes of leaves with changed texture coordinates.
    pub(crate) shared_sets: SharedSets,
    /// The attributes of the edges of the initial shape, once a rule has asked for them.
    pub(super) edge_attributes: Option<Option<Arc<SampledAttributes>>>,
}

impl Env {
    /// The files found by a search, sorted.
    pub(crate) fn files(&mut self, query: &File) -> Rc<[Text]> {
        if let Some(known) = self.kept.searches.get(query) {
            return known.clone();
        }
        let asked = Query::new(&query.name);
        let (found, cut_short) = self.settings.assets.search(&asked, &query.folder);
        let found: Rc<[Text]> = found.into();
        if let Some(why) = asked.trouble() {
            self.fault(FaultKind::Value, format!("a search for files is incomplete: {why}"));
        }
        if cut_short {
            self.fault_once(FaultKind::Limit, "the asset folder is too large to be searched; some files are left out");
        }
        if self.kept.searches.len() < SEARCHES_KEPT {
            self.kept.searches.insert(query.clone(), found.clone());
        }
        found
    }

    /// Keeps a table that was read, if there is room.
    pub(crate) fn keep_table(&mut self, file: File, table: &Array<Text>) {
        if self.kept.tables.len() < TABLES_KEPT {
            self.kept.tables.insert(file, table.clone());
        }
    }

    /// Keeps the size of an image, if there is room.
    pub(crate) fn keep_image_size(&mut self, file: &File, size: &Result<(u32, u32), AssetError>) {
        if self.kept.image_sizes.len() < IMAGE_SIZES_KEPT {
            self.kept.image_sizes.insert(file.clone(), size.clone());
        }
    }

    /// A primitive in the unit box. Small ones are kept for the run, and count for nothing; others count at each use. So the counts of a
    /// template do not depend on what the run has made before. `None` when the limit of vertices is reached.
    pub(crate) fn primitive(&mut self, what: PrimitiveKind) -> Option<Arc<Mesh>> {
        let is_kept = what.corner_count() <= PRIMITIVE_KEPT.min(self.settings.limits.vertices);
        if !is_kept && self.count_corners(what.corner_count()).is_break() {
            return None;
        }
        if let Some(mesh) = self.kept.primitives.get(&what) {
            return Some(mesh.clone());
        }
        let mesh = Arc::new(what.mesh());
        // A mesh that was ended early is empty.
        if self.spend(0).is_break() {
            return None;
        }
        if is_kept {
            self.kept.primitives.insert(what, mesh.clone());
        }
        Some(mesh)
    }
}
