//! The numbers of a run's looks.
//!
//! Slim shapes and sinks have numbers in place of looks. So a constant colour costs one comparison, a colour that is a parameter one search,
//! and a sink looks a material up only where the number changes. Random colours must not let the table grow without limit, so when it is full, a shape
//! takes the look of its base.
//!
//! A number is only a short form: no result depends on which looks have one. Templates need a number for each of their looks. So a
//! template that is made when the table is full gets *temporary* numbers, and is not kept.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use super::look::Look;
use super::look_changes::{ChangePlace, Changes};
use super::look_id::LookId;
use crate::fixed_hash::FixedState;
use crate::material::Color;
use crate::shape::state::UNSET;
use crate::value::read::Read;

/// The largest number of looks with a lasting number: more than rules make with constant colours in any sensible use.
const MOST: usize = 1 << 16;

/// The largest number of such looks that are not results of constant changes.
const MOST_OTHERS: usize = 1 << 12;

/// The number of looks that a session keeps for its next run.
const MANY: usize = 1024;

/// The looks of a run by number, and the results of changes.
#[derive(Clone, Debug)]
pub(crate) struct LookTable {
    /// The first is the look that no rule has changed. It is not in the maps: most tables have no other.
    list: Vec<Arc<Look>>,
    /// The numbers by the address of the look.
    by_address: BTreeMap<u64, LookId>,
    /// The numbers by the hash of the look.
    by_hash: HashMap<u64, Vec<LookId>, FixedState>,
    /// The same looks with an open colour, by number, where they are known.
    open: Vec<Option<LookId>>,
    /// The last of them that was made.
    last_open: Option<LookId>,
    /// The looks with temporary numbers, sorted by number.
    temporary: Vec<(LookId, Arc<Look>)>,
    /// The number of temporary numbers so far.
    made: u32,
    lasting: Changes,
    of_run: Changes,
}

impl Default for LookTable {
    fn default() -> Self {
        LookTable {
            by_address: BTreeMap::new(),
            by_hash: HashMap::default(),
            list: vec![UNSET.clone()],
            open: Vec::new(),
            last_open: None,
            temporary: Vec::new(),
            made: 0,
            lasting: Changes::default(),
            of_run: Changes::default(),
        }
    }
}

impl LookTable {
    /// Begins another run of the session.
    pub(crate) fn begin(&mut self) {
        self.of_run = Changes::default();
        self.made = 0;
    }

    /// Returns true if the table is so large that another run should begin with an empty one.
    pub(crate) fn is_full(&self) -> bool {
        MANY <= self.list.len()
    }

    /// The look with a lasting number.
    #[inline]
    pub(crate) fn lasting(&self, id: LookId) -> Option<&Arc<Look>> {
        self.list.get(id.index() as usize)
    }

    /// The look with a number; `None` for the look of the base.
    pub(crate) fn get(&self, id: LookId) -> Option<&Arc<Look>> {
        let temporary = || {
            let at = self.temporary.binary_search_by_key(&id.index(), |(known, _)| known.index()).ok()?;
            Some(&self.temporary[at].1)
        };
        self.lasting(id).or_else(temporary)
    }

    /// The number of a look, or `OF_BASE`.
    #[inline]
    pub(crate) fn id(&self, look: &Arc<Look>) -> LookId {
        if Arc::ptr_eq(&self.list[0], look) {
            return LookId(0);
        }
        self.by_address.get(&address(look)).copied().unwrap_or(LookId::OF_BASE)
    }

    /// The number of a look that is not the result of a constant change. It gets one if there is room.
    pub(crate) fn number(&mut self, look: &Arc<Look>) -> LookId {
        match self.id(look) {
            LookId::OF_BASE => self.within(look, MOST_OTHERS),
            known => known,
        }
    }

    /// The number of a look that is the result of a constant change. It gets one if there is room.
    fn intern(&mut self, look: &Arc<Look>) -> LookId {
        self.within(look, MOST)
    }

    /// The number of a look. A new one is among the first `most`.
    fn within(&mut self, look: &Arc<Look>, most: usize) -> LookId {
        // The sides of boxes with such a look have maps of their own.
        if look.coordinates.has_cube() {
            return LookId::OF_BASE;
        }
        let hash = look.hash();
        let found =
            self.by_hash.get(&hash).and_then(|ids| ids.iter().find(|id| self.list[id.index() as usize] == *look));
        if let Some(&id) = found {
            return id;
        }
        if self.list[0].hash() == hash && self.list[0] == *look {
            return LookId(0);
        }
        if most <= self.list.len() {
            return LookId::OF_BASE;
        }
        let id = LookId(self.list.len() as u32 | flag(look));
        self.list.push(look.clone());
        self.by_address.insert(address(look), id);
        self.by_hash.entry(hash).or_default().push(id);
        id
    }

    /// Returns the number of a look. A full table gives a temporary number. A look that never has a number gives `OF_BASE`.
    pub(crate) fn number_at_least_for_now(&mut self, look: &Arc<Look>) -> LookId {
        let id = self.number(look);
        if id != LookId::OF_BASE || look.coordinates.has_cube() {
            return id;
        }
        if let Some((id, _)) = self.temporary.iter().find(|(_, known)| known == look) {
            return *id;
        }
        let id = LookId((self.made % LookId::TEMPORARY) | LookId::TEMPORARY | flag(look));
        self.made += 1;
        self.temporary.push((id, look.clone()));
        id
    }

    /// Opens the colour of a look, and returns the number of the result. A look without a colour stays as it is, and so does every look
    /// when the table is full.
    pub(crate) fn open(&mut self, id: LookId) -> LookId {
        if let Some(&Some(open)) = self.open.get(id.index() as usize) {
            return open;
        }
        self.found_open(id)
    }

    #[cold]
    #[inline(never)]
    fn found_open(&mut self, id: LookId) -> LookId {
        let Some(look) = self.get(id).cloned() else { return id };
        let is_like = |open: &LookId| {
            let open = &self.list[open.index() as usize];
            open.material.is_equal_except_color(&look.material) && open.coordinates == look.coordinates
        };
        let open = self.last_open.filter(is_like).or_else(|| {
            let open = Look { material: Arc::new(look.material.open()?), coordinates: look.coordinates.clone() };
            self.last_open = Some(self.number(&Arc::new(open))).filter(|open| *open != LookId::OF_BASE);
            self.last_open
        });
        let open = open.unwrap_or(id);
        if id.is_lasting() {
            self.open.resize(self.list.len(), None);
            self.open[id.index() as usize] = Some(open);
        }
        open
    }

    /// Returns true if the colour of a look is open.
    pub(crate) fn is_open(&self, id: LookId) -> bool {
        self.get(id).is_some_and(|look| look.material.painted(Color::WHITE).is_some())
    }

    /// Paints a look: its open colour becomes the colour of the look `own`. Returns the number of the result, which is temporary if the table
    /// is full.
    pub(crate) fn painted(&mut self, id: LookId, own: LookId) -> LookId {
        let color = self.get(own).and_then(|look| look.material.color);
        let Some((look, color)) = self.get(id).zip(color) else { return id };
        let Some(material) = look.material.painted(color) else { return id };
        let painted = Look { material: Arc::new(material), coordinates: look.coordinates.clone() };
        self.number_at_least_for_now(&Arc::new(painted))
    }

    /// The number of temporary numbers in use.
    pub(crate) fn temporary_count(&self) -> usize {
        self.temporary.len()
    }

    /// Ends the use of all temporary numbers but the first `count`.
    pub(crate) fn end_temporary(&mut self, count: usize) {
        self.temporary.truncate(count);
    }

    /// The result of a change, if an earlier one at the same place began with the look `before` and read the same values.
    #[inline]
    pub(crate) fn changed(&mut self, place: ChangePlace, before: LookId, reads: &[Read<'_>]) -> Option<LookId> {
        self.changes(place).after(place.number, before, reads)
    }

    /// Returns true if results of a change are kept: a change that reads values keeps a few.
    pub(crate) fn keeps_more(&mut self, place: ChangePlace, reads: &[Read<'_>]) -> bool {
        reads.is_empty() || self.changes(place).has_room(place.number)
    }

    /// Returns the number of the look after a change, and keeps it if both looks have a lasting number. Without room it is `OF_BASE`.
    pub(crate) fn change(
        &mut self,
        place: ChangePlace,
        before: LookId,
        reads: &[Read<'_>],
        look: &Arc<Look>,
    ) -> LookId {
        let is_constant = reads.is_empty();
        if !is_constant && (!before.is_lasting() || !self.keeps_more(place, reads)) {
            return LookId::OF_BASE;
        }
        let after = if is_constant { self.intern(look) } else { self.number(look) };
        if before.is_lasting() && after != LookId::OF_BASE {
            self.changes(place).keep(place.number, before, reads, after);
        }
        after
    }

    #[inline]
    fn changes(&mut self, place: ChangePlace) -> &mut Changes {
        if place.is_of_run { &mut self.of_run } else { &mut self.lasting }
    }
}

/// The flag of a look with texture coordinates.
fn flag(look: &Look) -> u32 {
    if look.coordinates.is_empty() { 0 } else { LookId::COORDINATES }
}

fn address(look: &Arc<Look>) -> u64 {
    Arc::as_ptr(look).addr() as u64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Material;
    use crate::value::text::Text;

    fn named(number: usize) -> Arc<Look> {
        let name = Some(number.to_string().as_str().into());
        Arc::new(Look { material: Arc::new(Material { name, ..Material::default() }), ..Look::default() })
    }

    #[test]
    fn a_number_is_found_however_many_looks_come_after() {
        let mut ids = LookTable::default();
        let looks: Vec<_> = (0..300).map(named).collect();
        let numbers: Vec<_> = looks.iter().map(|look| ids.number(look)).collect();
        let found: Vec<_> = looks.iter().map(|look| ids.id(look)).collect();
        assert_eq!(found, numbers);
        assert_eq!(ids.id(&named(7)), LookId::OF_BASE);
        assert_eq!(ids.number(&named(7)), numbers[7]);
    }

    #[test]
    fn a_place_that_changes_many_looks_in_turn_adds_each_once() {
        let mut ids = LookTable::default();
        let before: Vec<_> = (0..200).map(|number| ids.number(&named(number))).collect();
        let place = ChangePlace::lasting(0);
        for _ in 0..3 {
            for &before in &before {
                if ids.changed(place, before, &[]).is_none() {
                    let after = ids.change(place, before, &[], &named(1000 + before.0 as usize));
                    assert_eq!(ids.changed(place, before, &[]), Some(after));
                }
            }
        }
        assert_eq!(ids.list.len(), 1 + 2 * 200);
        assert_eq!(ids.changed(ChangePlace::lasting(1), before[0], &[]), None);
        assert_eq!(ids.changed(ChangePlace::of_run(0), before[0], &[]), None);
    }

    #[test]
    fn a_change_with_values_is_found_by_them_and_a_place_with_many_keeps_the_first() {
        let mut ids = LookTable::default();
        let before = ids.number(&named(0));
        let place = ChangePlace::lasting(5);
        let text = |number: usize| Text::from(number.to_string().as_str());
        for number in 0..100 {
            let (text, kept) = (text(number), number < 64);
            let reads = [Read::Float(number as f64), Read::Text(&text)];
            assert_eq!(ids.changed(place, before, &reads), None);
            let after = ids.change(place, before, &reads, &named(1000 + number));
            assert_eq!((ids.changed(place, before, &reads), after != LookId::OF_BASE), (kept.then_some(after), kept));
        }
        let count = ids.list.len();
        assert_eq!(count, 2 + 64);
        let (one, two) = (text(1), text(2));
        for reads in [[Read::Float(1.0), Read::Text(&two)], [Read::Bool(true), Read::Text(&one)]] {
            assert_eq!(ids.changed(place, before, &reads), None);
        }
        let reads = [Read::Float(1.0), Read::Text(&one)];
        assert_eq!(ids.changed(place, before, &reads), Some(ids.id(&ids.list[3].clone())));
        let others = [(place, LookId(0)), (ChangePlace::lasting(4), before), (ChangePlace::of_run(5), before)];
        assert!(others.iter().all(|(place, before)| ids.changed(*place, *before, &reads).is_none()));
        // Temporary numbers are not kept.
        let temporary = LookId(7 | LookId::TEMPORARY);
        assert_eq!(ids.change(ChangePlace::lasting(6), temporary, &reads, &named(7)), LookId::OF_BASE);
        assert_eq!(ids.list.len(), count);
    }

    #[test]
    fn a_change_of_a_run_ends_with_it() {
        let mut ids = LookTable::default();
        let place = ChangePlace::of_run(3);
        ids.change(place, LookId(0), &[], &named(1));
        assert!(ids.changed(place, LookId(0), &[]).is_some());
        ids.begin();
        assert!(ids.changed(place, LookId(0), &[]).is_none());
    }

    /// A look with a colour and an opacity.
    fn coloured(r: f64, opacity: f64) -> Arc<Look> {
        let material = Material { color: Some(Color::new(r, 0.2, 0.3)), opacity: Some(opacity), ..Material::default() };
        Arc::new(Look { material: Arc::new(material), ..Look::default() })
    }

    #[test]
    fn looks_that_differ_in_colour_have_one_look_with_an_open_colour() {
        let mut ids = LookTable::default();
        let [red, dark, clear] = [(1.0, 1.0), (0.1, 1.0), (1.0, 0.5)].map(|(r, a)| ids.number(&coloured(r, a)));
        let open = ids.open(red);
        assert!(open != red && ids.is_open(open) && !ids.is_open(red));
        assert!(ids.open(dark) == open && ids.open(clear) != open && ids.open(open) == open);
        assert_eq!([red, dark].map(|own| ids.painted(open, own)), [red, dark]);
        // A rule has set one channel.
        let mut material = Material::clone(&ids.get(open).unwrap().material);
        material.set_number(crate::material::MaterialNumber::Color(crate::material::Channel::R), 0.1);
        let part = ids.number(&Arc::new(Look { material: Arc::new(material), ..Look::default() }));
        assert!(ids.is_open(part));
        assert_eq!(ids.painted(part, red), dark);
        // Looks without a colour stay as they are.
        let plain = ids.number(&named(1));
        assert_eq!((ids.open(plain), ids.open(LookId(0))), (plain, LookId(0)));
    }

    #[test]
    fn a_full_table_has_no_more_open_colours() {
        let mut ids = LookTable::default();
        let own = ids.number(&coloured(1.0, 1.0));
        (0..MOST_OTHERS).for_each(|number| _ = ids.number(&named(number)));
        assert_eq!(ids.open(own), own);
        let other = ids.number_at_least_for_now(&coloured(0.5, 1.0));
        assert!(!other.is_lasting());
        assert_eq!(ids.open(other), other);
    }

    #[test]
    fn a_full_table_gives_temporary_numbers() {
        let mut ids = LookTable::default();
        (0..MOST_OTHERS).for_each(|number| _ = ids.number(&named(number)));
        let others: Vec<_> = (0..3).map(|number| named(MOST_OTHERS + number)).collect();
        assert_eq!(ids.number(&others[0]), LookId::OF_BASE);
        let numbers: Vec<_> = others.iter().map(|look| ids.number_at_least_for_now(look)).collect();
        assert_eq!(ids.number_at_least_for_now(&named(MOST_OTHERS)), numbers[0]);
        assert!(numbers.iter().zip(&others).all(|(id, look)| !id.is_lasting() && ids.get(*id) == Some(look)));
        ids.end_temporary(1);
        assert_eq!((ids.get(numbers[0]), ids.get(numbers[1])), (Some(&others[0]), None));
        let later = ids.number_at_least_for_now(&others[1]);
        assert!(later != numbers[1] && ids.get(later) == Some(&others[1]));
        // A constant change still has room.
        let place = ChangePlace::lasting(0);
        assert!(
            ids.change(place, LookId(0), &[], &named(9999)).is_lasting()
                && ids.changed(place, LookId(0), &[]).is_some()
        );
        ids.change(place, numbers[0], &[], &named(9999));
        assert_eq!(ids.changed(place, numbers[0], &[]), None);
    }
}
