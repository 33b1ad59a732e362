//! Spelling suggestions from a closed set of names.

/// The name nearest to `word`, if at most a third of the letters of `word` differ, or one letter of a short word. Case
/// is ignored.
pub fn nearest<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word: Vec<char> = word.chars().flat_map(char::to_lowercase).take(LONGEST).collect();
    let limit = (word.len() / 3).max(1);
    let letters = word.iter().fold(0, |set, c| set | letter(*c));
    // Among equally near names one that begins with the word wins, then the one with the closest length.
    let mut best: Option<((usize, bool, usize), &str)> = None;
    let mut other: Vec<char> = Vec::new();
    for name in names {
        // The sets of letters exclude most names: an edit adds one letter, removes one, or both.
        let set = if name.is_ascii() {
            if name.len() < LONGEST && limit < word.len().abs_diff(name.len()) {
                continue;
            }
            name.bytes().take(LONGEST).fold(0, |set, byte| set | letter(char::from(byte.to_ascii_lowercase())))
        } else {
            name.chars().flat_map(char::to_lowercase).take(LONGEST).fold(0, |set, c| set | letter(c))
        };
        if limit < (letters & !set).count_ones().max((set & !letters).count_ones()) as usize {
            continue;
        }
        other.clear();
        other.extend(name.chars().flat_map(char::to_lowercase).take(LONGEST));
        if limit < word.len().abs_diff(other.len()) {
            continue;
        }
        let far = distance(&word, &other);
        let rank = (far, !other.starts_with(&word), word.len().abs_diff(other.len()));
        // A name in which every letter differs is not similar.
        if far <= limit && far < word.len().max(other.len()) && best.is_none_or(|(least, _)| rank < least) {
            best = Some((rank, name));
        }
    }
    best.map(|(_, name)| name)
}

/// The bit of a letter. Several letters may share a bit.
fn letter(c: char) -> u64 {
    1 << (c as u32 % 64)
}

const LONGEST: usize = 64;

/// The number of edits between two words. A swap of neighbours is one edit.
fn distance(a: &[char], b: &[char]) -> usize {
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let change = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                let mut least = change.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
                if 1 < i && 1 < j && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                    least = least.min(rows[i - 2][j - 2] + 1);
                }
                least
            };
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn finds_slips_of_the_pen() {
        let names = ["extrude", "texture", "split", "s", "t"];
        assert_eq!(nearest("extrud", names), Some("extrude"));
        assert_eq!(nearest("Extrude", names), Some("extrude"));
        assert_eq!(nearest("spilt", names), Some("split"));
        assert_eq!(nearest("window", names), None);
        assert_eq!(nearest("r", names), None);
        assert_eq!(nearest("sqr", ["str", "sqrt"]), Some("sqrt"));
        let names = ["height", "floor_h", "x"];
        assert_eq!(nearest("hight", names), Some("height"));
        assert_eq!(nearest("HEIGHT", names), Some("height"));
        assert_eq!(nearest("floor", names), None);
        assert_eq!(nearest("floorh", names), Some("floor_h"));
        assert_eq!((nearest("y", names), nearest("", names)), (None, None));
    }
}
