//! Materials of closed leaves that show their outside alone.

use std::collections::HashMap;
use std::sync::Arc;

use crate::material::Material;
use crate::output::sink_table::SinkTable;

/// The single-sided form of each material, by numbers. Only for look-ups, never iterated.
#[derive(Debug, Default)]
pub(super) struct SingleSided(HashMap<u32, u32>);

impl SingleSided {
    /// The material for a closed leaf: the same if rules or an asset say which sides it shows.
    pub(super) fn of(&mut self, material: u32, table: &mut SinkTable) -> u32 {
        *self.0.entry(material).or_insert_with(|| {
            let own = &table.materials()[material as usize];
            if own.double_sided.is_some() {
                return material;
            }
            let single = Arc::new(Material { double_sided: Some(false), ..Material::clone(own) });
            table.material(&single)
        })
    }
}
