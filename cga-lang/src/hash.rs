//! Hashing for keys that an attacker cannot choose: numbers of tokens and instances, and the words of the language's
//! tables.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// A map with such keys, several times as fast as one that must resist chosen collisions. Its iteration order is
/// undefined, as for any hash map.
pub(crate) type FastMap<K, V> = HashMap<K, V, BuildHasherDefault<Fast>>;

/// A hasher that multiplies and folds.
#[derive(Clone, Copy, Default)]
pub(crate) struct Fast(u64);

impl Fast {
    fn add(&mut self, value: u64) {
        // The golden ratio in 64 bits spreads neighbours widely; maps look at the upper and the lower bits.
        let mixed = u128::from(self.0 ^ value).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 = (mixed >> 64) as u64 ^ mixed as u64;
    }
}

impl Hasher for Fast {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.add(u64::from_le_bytes(word) ^ (chunk.len() as u64) << 56);
        }
    }

    fn write_u32(&mut self, value: u32) {
        self.add(u64::from(value) + 1);
    }

    fn write_usize(&mut self, value: usize) {
        self.add(value as u64 + 1);
    }

    fn write_u8(&mut self, value: u8) {
        self.add(u64::from(value));
    }
}

#[cfg(test)]
mod tests {
    use super::Fast;
    use std::collections::HashSet;
    use std::hash::Hasher;

    #[test]
    fn neighbours_and_prefixes_differ() {
        let number = |value: u32| {
            let mut hasher = Fast::default();
            hasher.write_u32(value);
            hasher.finish()
        };
        let all: HashSet<u64> = (0..100_000).map(number).collect();
        assert_eq!(all.len(), 100_000);
        // A map uses the upper seven bits for its tags and the lower ones for places.
        for part in [0, 16, 32, 48] {
            let low: HashSet<u64> = (0..1000).map(|value| number(value) >> part & 0xffff).collect();
            assert!(900 < low.len(), "{part}: {}", low.len());
        }
        let text = |value: &str| {
            let mut hasher = Fast::default();
            hasher.write(value.as_bytes());
            hasher.write_u8(0xff);
            hasher.finish()
        };
        let words = ["", "s", "t", "scope.sx", "scope.sy", "scope.sxscope.sx", "material.color.r", "material.color.g"];
        assert_eq!(words.map(text).into_iter().collect::<HashSet<_>>().len(), words.len());
    }
}
