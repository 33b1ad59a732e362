//! Geometries as well-known binary, also in the extended form of PostGIS, which shapely writes for corners with heights.

use geozero::wkb::{process_ewkb_geom, process_wkb_geom};

use super::collector::Collector;
use super::quiet::quiet;
use crate::outline::Outline;

/// The polygons of a geometry as WKB. Parts of a collection that are left out are added to the notes.
///
/// # Errors
/// A sentence: the bytes are not WKB, or the geometry has no polygon that can be used.
pub fn outlines(wkb: &[u8], notes: &mut Vec<String>) -> Result<Vec<Outline>, String> {
    let mut collector = Collector::default();
    // The extended form has flags in the upper bits of the type.
    let is_extended = match wkb {
        [0, flags, ..] | [1, _, _, _, flags, ..] => flags & 0xe0 != 0,
        _ => false,
    };
    let read = quiet(|| match is_extended {
        true => process_ewkb_geom(&mut &*wkb, &mut collector),
        false => process_wkb_geom(&mut &*wkb, &mut collector),
    });
    let outlines = collector.outlines(read.ok_or("its geometry is damaged")?);
    notes.append(&mut collector.notes);
    outlines
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A triangle with heights. `kind` is the type of the polygon, after which an extended form may have the number of its system.
    fn triangle(is_little: bool, kind: u32, system: Option<u32>) -> Vec<u8> {
        let number = |number: u32| if is_little { number.to_le_bytes() } else { number.to_be_bytes() };
        let numbers = [Some(kind), system, Some(1), Some(4)].into_iter().flatten();
        let mut bytes = vec![u8::from(is_little)];
        numbers.for_each(|own| bytes.extend(number(own)));
        for corner in [[9.0_f64, 48.0, 1.0], [9.5, 48.0, 2.0], [9.5, 48.5, 3.0], [9.0, 48.0, 1.0]] {
            corner
                .iter()
                .for_each(|side| bytes.extend(if is_little { side.to_le_bytes() } else { side.to_be_bytes() }));
        }
        bytes
    }

    #[test]
    fn the_extended_form_gives_the_same_polygons() {
        let read = |wkb: &[u8]| outlines(wkb, &mut Vec::new());
        let plain = read(&triangle(true, 1003, None)).expect("a polygon");
        for is_little in [true, false] {
            for (kind, system) in [(1003, None), (0x8000_0003, None), (0xa000_0003, Some(4326))] {
                assert_eq!(read(&triangle(is_little, kind, system)).as_ref(), Ok(&plain), "{kind:x}");
            }
        }
        assert!(read(&triangle(true, 0x8000_0003, None)[..30]).is_err() && read(&[1, 3, 0, 0, 0x80]).is_err());
    }
}
