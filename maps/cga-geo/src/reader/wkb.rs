//! Geometries as well-known binary.

use geozero::wkb::process_wkb_geom;

use super::collector::Collector;
use super::quiet::quiet;
use crate::outline::Outline;

/// The polygons of a geometry as WKB. Parts of a collection that are left out are added to the notes.
///
/// # Errors
/// A sentence: the bytes are not WKB, or the geometry has no polygon that can be used.
pub fn outlines(wkb: &[u8], notes: &mut Vec<String>) -> Result<Vec<Outline>, String> {
    let mut collector = Collector::default();
    let read = quiet(|| process_wkb_geom(&mut &*wkb, &mut collector));
    let outlines = collector.outlines(read.ok_or("its geometry is damaged")?);
    notes.append(&mut collector.notes);
    outlines
}
