//! Suggestions for misspelt names from the host program.

/// The number of letters that are compared.
const LONGEST: usize = 64;

/// The name nearest to `word`, if at most a third of its letters differ. Case does not count. Among equally near
/// names the first is taken.
pub(crate) fn nearest<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters = |text: &str| text.chars().flat_map(char::to_lowercase).take(LONGEST).collect::<Vec<char>>();
    let word = letters(word);
    let near = names.into_iter().map(|name| (distance(&word, &letters(name)), name));
    let best = near.min_by_key(|(far, _)| *far)?;
    (best.0 <= (word.len() / 3).max(1) && best.0 < word.len()).then_some(best.1)
}

/// The number of letters to insert, remove or change to turn one word into the other.
fn distance(from: &[char], to: &[char]) -> usize {
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, a) in from.iter().enumerate() {
        let mut corner = row[0];
        row[0] = i + 1;
        for (j, b) in to.iter().enumerate() {
            let changed = corner + usize::from(a != b);
            corner = row[j + 1];
            row[j + 1] = changed.min(corner + 1).min(row[j] + 1);
        }
    }
    row[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_seen_and_strangers_are_not() {
        let names = ["height", "floor_h", "x"];
        assert_eq!(nearest("hight", names), Some("height"));
        assert_eq!(nearest("HEIGHT", names), Some("height"));
        assert_eq!(nearest("floor", names), None);
        assert_eq!(nearest("floorh", names), Some("floor_h"));
        assert_eq!((nearest("y", names), nearest("", names)), (None, None));
        assert_eq!(distance(&['a', 'b', 'c'], &['b', 'c', 'd']), 2);
    }
}
