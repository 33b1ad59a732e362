//! The loops and tags of faces, stored compactly for the usual case of many similar faces.

use std::ops::{Index, Range};

use smallvec::{Array, SmallVec};

use super::{FaceTag, Mesh};

/// The end of each loop. Meshes of few loops, such as a box, need no memory for them.
pub(crate) type LoopEnds = SmallVec<[u32; 6]>;

/// The end of each face's loops. Faces with one loop need no memory while they come first.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct FaceEnds {
    /// The number of leading faces with one loop each.
    single: u32,
    /// The ends of the loops of the later faces.
    ends: Vec<u32>,
}

impl FaceEnds {
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

    /// The face of a loop.
    pub(crate) fn face_of(&self, ring: usize) -> usize {
        let single = self.single as usize;
        if ring < single { ring } else { single + self.ends.partition_point(|&end| end as usize <= ring) }
    }

    /// Moves a face to the front.
    pub(crate) fn bring_to_front(&mut self, face: usize) {
        let loops = self.loops(face).len() as u32;
        let single = self.single as usize;
        if loops == 1 {
            if let Some(at) = face.checked_sub(single) {
                self.ends.remove(at);
                self.ends[..at].iter_mut().for_each(|end| *end += 1);
                self.single += 1;
            }
            return;
        }
        // Faces with one loop no longer come first.
        let before = (1..=self.single).chain(self.ends[..face - single].iter().copied()).map(|end| end + loops);
        let ends = std::iter::once(loops).chain(before).chain(self.ends[face - single + 1..].iter().copied()).collect();
        *self = FaceEnds { single: 0, ends };
    }

    /// Returns true if every face has a loop, and all faces together have `loops` loops.
    pub(crate) fn cover(&self, loops: usize) -> bool {
        let mut last = self.single;
        self.ends.iter().all(|&end| std::mem::replace(&mut last, end) < end) && last as usize == loops
    }
}

/// The tag of each face, as runs of equal tags.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Tags {
    /// The end of each run, and its tag. Most meshes have one run.
    runs: SmallVec<[(u32, FaceTag); 1]>,
}

impl Tags {
    pub(crate) fn len(&self) -> usize {
        self.runs.last().map_or(0, |run| run.0 as usize)
    }

    #[inline]
    pub(crate) fn push(&mut self, tag: FaceTag) {
        match self.runs.last_mut() {
            Some(run) if run.1 == tag => run.0 += 1,
            _ => self.begin_run(tag),
        }
    }

    /// The tag of a single face, in place of all others.
    #[inline]
    pub(crate) fn put_single(&mut self, tag: FaceTag) {
        match &mut self.runs[..] {
            [run] => *run = (1, tag),
            _ => self.runs = SmallVec::from_buf([(1, tag)]),
        }
    }

    /// Adds a face whose tag differs from the tag of the face before it.
    #[cold]
    #[inline(never)]
    fn begin_run(&mut self, tag: FaceTag) {
        let end = self.len() as u32 + 1;
        self.runs.push((end, tag));
    }

    /// Moves a face to the front.
    pub(crate) fn bring_to_front(&mut self, face: usize) {
        let tag = self[face];
        let run = self.runs.partition_point(|run| run.0 as usize <= face);
        // The faces before it move by one, and so does the end of the last of their runs. Later runs keep their ends.
        self.runs[..run].iter_mut().for_each(|run| run.0 += 1);
        if run != 0 && self.runs[run].0 == self.runs[run - 1].0 {
            self.runs.remove(run);
            if run < self.runs.len() && self.runs[run].1 == self.runs[run - 1].1 {
                self.runs.remove(run - 1);
            }
        }
        if self.runs[0].1 != tag {
            self.runs.insert(0, (1, tag));
        }
    }

    /// The tags after a change, which is called once for each run.
    pub(crate) fn mapped(&self, mut change: impl FnMut(FaceTag) -> FaceTag) -> Tags {
        let mut runs: SmallVec<[(u32, FaceTag); 1]> = SmallVec::with_capacity(self.runs.len());
        for &(end, tag) in &self.runs {
            let tag = change(tag);
            match runs.last_mut() {
                Some(last) if last.1 == tag => last.0 = end,
                _ => runs.push((end, tag)),
            }
        }
        Tags { runs }
    }

    /// All runs: the number of the face after the run, and the tag.
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

/// Shrinks a list that has much more capacity than it needs. Small lists are not shrunk, because copying costs more
/// than the memory is worth.
pub(super) fn give_back_room<T>(list: &mut Vec<T>) {
    if has_much_room::<T>(list.len(), list.capacity()) {
        list.shrink_to_fit();
    }
}

/// The same for a list that holds few elements in itself.
fn give_back_spilled_room<A: Array>(list: &mut SmallVec<A>) {
    if has_much_room::<A::Item>(list.len(), list.capacity()) {
        list.shrink_to_fit();
    }
}

fn has_much_room<T>(len: usize, capacity: usize) -> bool {
    const SMALL: usize = 1 << 12;
    let spare = capacity - len;
    len / 11 < spare && SMALL < spare * size_of::<T>()
}

impl Mesh {
    /// Shrinks lists that have much more capacity than they need.
    pub(crate) fn give_back_room(&mut self) {
        give_back_room(&mut self.points);
        give_back_room(&mut self.corners);
        give_back_spilled_room(&mut self.loop_ends);
        give_back_room(&mut self.face_ends.ends);
        give_back_spilled_room(&mut self.tags.runs);
        give_back_room(&mut self.normals);
        self.uvs.give_back_room();
    }

    /// Moves a face to the front. The order of the others stays.
    pub(crate) fn bring_to_front(&mut self, face: usize) {
        let (rings, corners) = (self.face_loops(face), self.face_corners(face));
        to_front(&mut self.corners, corners.clone());
        self.uvs.bring_to_front(&corners);
        if !self.normals.is_empty() {
            to_front(&mut self.normals, corners.clone());
        }
        to_front(&mut self.loop_ends, rings.clone());
        let (first, others) = self.loop_ends[..rings.end].split_at_mut(rings.len());
        first.iter_mut().for_each(|end| *end -= corners.start as u32);
        others.iter_mut().for_each(|end| *end += corners.len() as u32);
        self.face_ends.bring_to_front(face);
        self.tags.bring_to_front(face);
    }
}

/// Moves a range to the front.
pub(super) fn to_front<T: Copy>(list: &mut [T], range: Range<usize>) {
    // The elements before a long range move as a block; a rotation would move them one by one.
    if size_of_val(&list[range.clone()]) <= 256 {
        list[..range.end].rotate_right(range.len());
        return;
    }
    let moved = list[range.clone()].to_vec();
    list.copy_within(..range.start, moved.len());
    list[..moved.len()].copy_from_slice(&moved);
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Mesh {
        /// The bytes of the mesh's lists, and the bytes of their capacity.
        pub(crate) fn bytes(&self) -> [usize; 2] {
            fn of<T>(list: &Vec<T>) -> [usize; 2] {
                [list.len(), list.capacity()].map(|count| count * size_of::<T>())
            }
            fn of_few<A: Array>(list: &SmallVec<A>) -> [usize; 2] {
                [list.len(), list.capacity()].map(|count| count * size_of::<A::Item>())
            }
            let indices = [of(&self.corners), of_few(&self.loop_ends), of(&self.face_ends.ends)];
            let points = [&self.points, &self.normals].map(of);
            let all = indices.into_iter().chain(points).chain([of_few(&self.tags.runs), self.uvs.bytes()]);
            all.fold([0; 2], |sum, next| [sum[0] + next[0], sum[1] + next[1]])
        }
    }

    #[test]
    fn faces_with_holes_may_come_anywhere() {
        let mut faces = FaceEnds::default();
        [1, 2, 5, 6, 8].iter().for_each(|&end| faces.push(end));
        let loops: Vec<_> = (0..faces.len()).map(|face| faces.loops(face)).collect();
        assert_eq!(loops, [0..1, 1..2, 2..5, 5..6, 6..8]);
        assert!(faces.cover(8) && !faces.cover(7));
        assert!(FaceEnds { single: 3, ends: Vec::new() }.cover(3) && FaceEnds::default().cover(0));
    }

    #[test]
    fn any_face_can_be_brought_to_the_front() {
        let loops = [1, 1, 3, 1, 2];
        for moved in 0..loops.len() {
            let (mut faces, mut tags, mut end) = (FaceEnds::default(), Tags::default(), 0);
            let tag = |face: usize| FaceTag { group: loops[face] as u32, ..FaceTag::PLAIN };
            for (face, count) in loops.iter().enumerate() {
                end += count;
                faces.push(end);
                tags.push(tag(face));
            }
            assert!((0..end).all(|ring| faces.loops(faces.face_of(ring)).contains(&ring)));
            faces.bring_to_front(moved);
            tags.bring_to_front(moved);
            let order = std::iter::once(moved).chain((0..loops.len()).filter(|&face| face != moved));
            for (place, face) in order.enumerate() {
                assert_eq!((faces.loops(place).len(), tags[place]), (loops[face], tag(face)));
            }
            assert!(faces.cover(end) && (faces.len(), tags.len()) == (loops.len(), loops.len()));
            // Equal neighbours are in one run.
            assert!(tags.runs().windows(2).all(|pair| pair[0].1 != pair[1].1));
        }
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
