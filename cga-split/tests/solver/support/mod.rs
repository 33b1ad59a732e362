//! Patterns as text, and a source of random ones.

use cga_split::{Item, Piece, Prefix, Size, solve};

/// A parsed pattern with its sizes.
#[derive(Clone, Debug)]
pub(crate) struct Pattern {
    pub(crate) items: Vec<Item>,
    pub(crate) sizes: Vec<Size>,
}

impl Pattern {
    /// Reads `1 | { ~2.5 | '.1 }* | 1`. Groups without a `*` are only brackets.
    pub(crate) fn read(text: &str) -> Self {
        let (mut items, mut sizes, mut open) = (Vec::new(), Vec::new(), Vec::new());
        let spaced = ["{", "}*", "}", "|"].iter().fold(text.to_owned(), |text, sign| match *sign {
            "}" => text,
            sign => text.replace(sign, &format!(" {sign} ")),
        });
        for word in spaced.replace("} ", " } ").split_whitespace() {
            match word {
                "|" => {}
                "{" => {
                    open.push(items.len());
                    items.push(Item::Repeat(0));
                }
                "}*" => {
                    let at: usize = open.pop().expect(text);
                    items[at] = Item::Repeat((items.len() - at - 1) as u32);
                }
                "}" => drop(items.remove(open.pop().expect(text))),
                size => {
                    items.push(Item::Slot);
                    let number = |text: &str| text.parse().unwrap_or_else(|_| panic!("{text} in {size}"));
                    sizes.push(match (size.strip_prefix('~'), size.strip_prefix('\'')) {
                        (Some(rest), _) => Size::floating(number(rest)),
                        (_, Some(rest)) => Size::relative(number(rest)),
                        _ => Size::absolute(number(size)),
                    });
                }
            }
        }
        assert!(open.is_empty(), "{text}");
        Pattern { items, sizes }
    }

    pub(crate) fn solve(&self, extent: f64) -> Vec<Piece> {
        solve(&self.items, &self.sizes, &mut vec![0.0; self.sizes.len()], extent).pieces()
    }

    /// Returns true if any of its slots floats.
    pub(crate) fn floats(&self) -> bool {
        self.sizes.iter().any(|size| size.prefix == Prefix::Floating && cga_split::is_size(size.value))
    }

    /// Writes the pattern as text.
    pub(crate) fn text(&self) -> String {
        let (mut text, mut ends, mut sizes) = (String::new(), Vec::new(), self.sizes.iter());
        for (at, item) in self.items.iter().enumerate() {
            while ends.pop_if(|end| *end <= at).is_some() {
                text.push_str(" }*");
            }
            match item {
                Item::Slot => {
                    let size = sizes.next().expect("a size a slot");
                    let prefix = match size.prefix {
                        Prefix::Absolute => "",
                        Prefix::Relative => "'",
                        Prefix::Floating => "~",
                    };
                    text.push_str(&format!(" {prefix}{} |", size.value));
                }
                Item::Repeat(len) => {
                    text.push_str(" {");
                    ends.push(at + 1 + *len as usize);
                }
            }
        }
        ends.iter().for_each(|_| text.push_str(" }*"));
        text
    }
}

/// Random numbers, the same in every run.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Random(seed ^ 0x9e37_79b9_7f4a_7c15)
    }

    pub(crate) fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) % limit
    }

    pub(crate) fn one_of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len() as u64) as usize]
    }

    /// A number from 0 to 1.
    pub(crate) fn share(&mut self) -> f64 {
        self.below(1 << 30) as f64 / (1u64 << 30) as f64
    }

    /// A size that suits an extent. Small whole multiples are as frequent as other sizes; a few sizes make no piece.
    pub(crate) fn size(&mut self, extent: f64) -> Size {
        let value = match self.below(13) {
            12 => extent * self.one_of(&[1e-11, 1e-13, 1e-20]),
            0 => self.one_of(&[0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0]),
            1..=4 => self.below(6) as f64 * extent / 12.0,
            5 => extent * self.one_of(&[1.0, 0.1, 1.0 / 3.0, 2.0]),
            _ => self.share() * extent / 2.0 + extent * 1e-3,
        };
        match self.below(3) {
            0 => Size::absolute(value),
            1 => Size::floating(value),
            _ => Size::relative(value / extent),
        }
    }

    /// A pattern of up to five items in a row, with groups up to `depth` levels deep.
    pub(crate) fn pattern(&mut self, extent: f64, depth: u64) -> Pattern {
        let mut pattern = Pattern { items: Vec::new(), sizes: Vec::new() };
        for _ in 0..1 + self.below(5) {
            if 0 < depth && self.below(3) == 0 {
                let inner = self.pattern(extent, depth - 1);
                pattern.items.push(Item::Repeat(inner.items.len() as u32));
                pattern.items.extend(inner.items);
                pattern.sizes.extend(inner.sizes);
            } else {
                pattern.items.push(Item::Slot);
                pattern.sizes.push(self.size(extent));
            }
        }
        pattern
    }
}
