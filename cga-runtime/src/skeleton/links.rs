//! Pieces between the meeting places of a stop, and those that cancel each other.

use super::Failure;
use super::stop::{Contacts, to_segment};
use super::wavefront::{Wavefront, turn_back};

/// An end of a link: a corner that goes on, or a meeting place, by the first corner in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    Corner(u32),
    Place(u32),
}

impl End {
    pub(super) fn corner(self) -> u32 {
        let (End::Corner(corner) | End::Place(corner)) = self;
        corner
    }
}

/// A piece, or what is left of one between places.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    pub(super) from: End,
    pub(super) to: End,
    pub(super) edge: u32,
    /// The piece it is of.
    pub(super) piece: u32,
}

/// What comes to a place and goes on from there, as numbers of links.
#[derive(Debug, Default)]
pub(super) struct Junction {
    pub(super) place: u32,
    pub(super) arrive: Vec<usize>,
    pub(super) depart: Vec<usize>,
}

/// All links with a place at one end at least.
#[derive(Debug)]
pub(super) struct Links {
    pub(super) list: Vec<Link>,
    /// Pairs that lay on each other, against each other; no longer in the list.
    pub(super) cancelled: Vec<[Link; 2]>,
    /// One a place where something changes, in the order of their first corners.
    pub(super) junctions: Vec<Junction>,
}

impl Links {
    /// Divides the pieces that have to do with meeting places.
    pub(super) fn of(front: &Wavefront, contacts: &Contacts) -> Self {
        let place = |corner: u32| contacts.place(corner).unwrap_or(corner);
        let next = |piece: u32| front.corners[piece as usize].next;
        // Corners that nothing touches go on.
        let mut active = vec![false; front.corners.len()];
        for &corner in front.alive.iter().filter(|&&corner| place(corner) != corner) {
            active[place(corner) as usize] = true;
        }
        contacts.ends.iter().for_each(|&corner| active[place(corner) as usize] = true);
        let mut touches: Vec<(u32, f64, u32)> = Vec::new();
        for &(piece, corner) in &contacts.touches {
            let here = place(corner);
            if here != place(piece) && here != place(next(piece)) {
                active[here as usize] = true;
                let along = front.lines[front.corners[piece as usize].after as usize].along;
                touches.push((piece, along.dot(contacts.spots[here as usize]), here));
            }
        }
        touches.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
        touches.dedup_by_key(|touch| (touch.0, touch.2));
        let end = |corner: u32| {
            let place = place(corner);
            if active[place as usize] { End::Place(place) } else { End::Corner(corner) }
        };
        let mut list: Vec<Link> = Vec::new();
        for &piece in &front.alive {
            let first = touches.partition_point(|touch| touch.0 < piece);
            let on = touches[first..].iter().take_while(|touch| touch.0 == piece).map(|touch| End::Place(touch.2));
            let mut from = end(piece);
            for to in on.chain([end(next(piece))]) {
                let changes = matches!((from, to), (End::Place(_), _) | (_, End::Place(_)));
                if changes && from != to {
                    list.push(Link { from, to, edge: front.corners[piece as usize].after, piece });
                }
                from = to;
            }
        }
        let cancelled = cancel(&mut list);
        let places = front.alive.iter().copied().filter(|&corner| active[corner as usize]);
        let mut junctions: Vec<Junction> = places.map(|place| Junction { place, ..Junction::default() }).collect();
        junctions.sort_unstable_by_key(|junction| junction.place);
        for (number, link) in list.iter().enumerate() {
            let mut at = |end: End| match end {
                End::Place(place) => junctions.binary_search_by_key(&place, |junction| junction.place).ok(),
                End::Corner(_) => None,
            };
            let ends = [link.from, link.to].map(&mut at);
            if let Some(at) = ends[0] {
                junctions[at].depart.push(number);
            }
            if let Some(at) = ends[1] {
                junctions[at].arrive.push(number);
            }
        }
        Links { list, cancelled, junctions }
    }

    /// Finds links of a place that lie on each other, so that the far end of the shorter one touches the other. Whether
    /// there was any.
    pub(super) fn lie_together(&self, front: &Wavefront, contacts: &mut Contacts) -> Result<bool, Failure> {
        let mut found = false;
        for junction in &self.junctions {
            for &arriving in &junction.arrive {
                for &leaving in &junction.depart {
                    found |= self.touch(front, contacts, [arriving, leaving], front.epsilon);
                }
            }
        }
        if found {
            return Ok(true);
        }
        // Where nothing is between them they meet, however far they seem to be from each other.
        for pair in self.pairs(front) {
            let [a, b] = pair.map(|link| front.lines[self.list[link].edge as usize]);
            if turn_back(&a, &b) {
                if !self.touch(front, contacts, pair, f64::INFINITY) {
                    return Err(Failure::Tangled);
                }
                found = true;
            }
        }
        Ok(found)
    }

    /// Notes that a link to a place and one from it touch, if they do. Whether that is new.
    fn touch(&self, front: &Wavefront, contacts: &mut Contacts, pair: [usize; 2], near: f64) -> bool {
        let [arriving, leaving] = pair.map(|link| &self.list[link]);
        let spot = |end: End| contacts.spots[end.corner() as usize];
        let (far, here, end) = (spot(arriving.from), spot(arriving.to), spot(leaving.to));
        let (a, b) = (far - here, end - here);
        if a.dot(b) <= 0.0 {
            return false;
        }
        let (corner, piece, distance) = if b.length_squared() <= a.length_squared() {
            (leaving.to.corner(), arriving.piece, to_segment(end, here, far))
        } else {
            (arriving.from.corner(), leaving.piece, to_segment(far, here, end))
        };
        if distance > near * near {
            return false;
        }
        if corner == piece || corner == front.corners[piece as usize].next {
            contacts.end(corner)
        } else {
            contacts.touch(piece, corner)
        }
    }
}

/// Takes out links between the same places that run against each other.
fn cancel(list: &mut Vec<Link>) -> Vec<[Link; 2]> {
    let mut gone = vec![false; list.len()];
    let mut cancelled = Vec::new();
    for i in 0..list.len() {
        let Link { from: End::Place(_), to: End::Place(_), .. } = list[i] else { continue };
        let against = |k: &usize| !gone[*k] && (list[*k].to, list[*k].from) == (list[i].from, list[i].to);
        if let Some(k) = (i + 1..list.len()).find(against).filter(|_| !gone[i]) {
            (gone[i], gone[k]) = (true, true);
            cancelled.push([list[i], list[k]]);
        }
    }
    let mut gone = gone.into_iter();
    list.retain(|_| gone.next() == Some(false));
    cancelled
}
