//! Which loops are whose, and what faces carry: stored for what is usual, many faces alike.

use std::ops::{Index, Range};

use super::FaceTag;

/// Where the loops of each face end. Faces of one loop need no memory as long as they come first.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct FaceEnds {
    /// So many faces have one loop each.
    single: u32,
    /// Where the loops of the faces after those end.
    ends: Vec<u32>,
}

impl FaceEnds {
    /// Faces of one loop each.
    pub(crate) fn single(count: usize) -> Self {
        FaceEnds { single: count as u32, ends: Vec::new() }
    }

    pub(crate) fn len(&self) -> usize {
        self.single as usize + self.ends.len()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.single == 0 && self.ends.is_empty()
    }

    /// Adds a face that ends with the loop before `end`.
    #[inline]
    pub(crate) fn push(&mut self, end: usize) {
        if self.ends.is_empty() && end == self.single as usize + 1 {
            self.single += 1;
        } else {
            self.ends.push(end as u32);
        }
    }

    /// The loops of a face.
    #[inline]
    pub(crate) fn loops(&self, face: usize) -> Range<usize> {
        let single = self.single as usize;
        if face < single {
            return face..face + 1;
        }
        let start = if face == single { self.single } else { self.ends[face - single - 1] };
        start as usize..self.ends[face - single] as usize
    }

    /// Whether every face has a loop, and all faces together have `loops`.
    pub(crate) fn cover(&self, loops: usize) -> bool {
        let mut last = self.single;
        self.ends.iter().all(|&end| std::mem::replace(&mut last, end) < end) && last as usize == loops
    }
}

/// The tag of each face, as runs of equal ones.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Tags {
    /// The end of each run, and its tag.
    runs: Vec<(u32, FaceTag)>,
}

impl Tags {
    /// Faces that are all alike.
    pub(crate) fn uniform(count: usize, tag: FaceTag) -> Self {
        Tags { runs: vec![(count as u32, tag)] }
    }

    pub(crate) fn len(&self) -> usize {
        self.runs.last().map_or(0, |run| run.0 as usize)
    }

    #[inline]
    pub(crate) fn push(&mut self, tag: FaceTag) {
        match self.runs.last_mut() {
            Some(run) if run.1 == tag => run.0 += 1,
            last => {
                let end = last.map_or(1, |run| run.0 + 1);
                self.runs.push((end, tag));
            }
        }
    }

    /// All runs: the face before which each ends, and its tag.
    pub(crate) fn runs(&self) -> &[(u32, FaceTag)] {
        &self.runs
    }
}

impl Index<usize> for Tags {
    type Output = FaceTag;
    #[inline]
    fn index(&self, face: usize) -> &FaceTag {
        let run = if self.runs.len() == 1 { 0 } else { self.runs.partition_point(|run| run.0 as usize <= face) };
        &self.runs[run].1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_with_holes_may_come_anywhere() {
        let mut faces = FaceEnds::default();
        [1, 2, 5, 6, 8].iter().for_each(|&end| faces.push(end));
        let loops: Vec<_> = (0..faces.len()).map(|face| faces.loops(face)).collect();
        assert_eq!(loops, [0..1, 1..2, 2..5, 5..6, 6..8]);
        assert!(faces.cover(8) && !faces.cover(7));
        assert!(FaceEnds::single(3).cover(3) && FaceEnds::default().cover(0));
    }

    #[test]
    fn tags_are_found_in_their_runs() {
        let mut tags = Tags::default();
        let list = [FaceTag::PLAIN, FaceTag::PLAIN, FaceTag::CAP, FaceTag::PLAIN];
        list.iter().for_each(|&tag| tags.push(tag));
        assert_eq!((tags.len(), tags.runs().len()), (4, 3));
        assert!((0..4).all(|face| tags[face] == list[face]));
    }
}
