//! Lists in text: items, each followed by `;`.
//!
//! The last `;` of a list may be missing. Empty items do not count, except in conversions to arrays (*CGA changelog
//! 2020.1*: `;` is a list with one empty item, "" is a list without items). A `*` at either end of a search text
//! matches anything.

use super::whole;
use crate::geometry::work;
use crate::run::env::Env;
use crate::shape::view::View;
use crate::value::array::{Array, Element};
use crate::value::text::Text;

/// The units of work of an item, besides its bytes.
const ITEM: usize = 4;

fn items(list: &str) -> impl Iterator<Item = &str> + Clone {
    list.split(';').filter(|item| !item.is_empty())
}

/// The items with a `;` after each. Never longer than the list that they come from, with a last `;`.
fn list_of<'t>(env: &mut Env, items: impl Iterator<Item = &'t str>) -> Text {
    let mut list = String::new();
    for item in items {
        // The check below ends the run.
        if !work::spend(ITEM + item.len()) {
            break;
        }
        list.push_str(item);
        list.push(';');
    }
    if env.may_write(list.len()) { Text::from(list) } else { Text::default() }
}

/// Returns true if an item matches a search text.
fn matches(item: &str, search: &str) -> bool {
    let (from_start, search) = search.strip_prefix('*').map_or((true, search), |rest| (false, rest));
    let (to_end, search) = search.strip_suffix('*').map_or((true, search), |rest| (false, rest));
    match (from_start, to_end) {
        (true, true) => item == search,
        (true, false) => item.starts_with(search),
        (false, true) => item.ends_with(search),
        (false, false) => item.contains(search),
    }
}

/// The list with an item at its end (*listAdd*).
pub fn list_add(env: &mut Env, list: Text, item: Text) -> Text {
    let end = |text: &str| if text.is_empty() || text.ends_with(';') { "" } else { ";" };
    env.write(format_args!("{list}{}{item}{}", end(&list), end(&item)))
}

/// The list with a `;` at its end and without empty items (*listClean*).
pub fn list_clean(env: &mut Env, list: Text) -> Text {
    list_of(env, items(&list))
}

/// The number of matching items (*listCount*).
pub fn list_count(list: Text, search: Text) -> f64 {
    items(&list).filter(|item| matches(item, &search)).count() as f64
}

/// The first item; "" without one (*listFirst*).
pub fn list_first(env: &mut Env, list: Text) -> Text {
    env.copy(items(&list).next().unwrap_or_default())
}

/// The last item; "" without one (*listLast*).
pub fn list_last(env: &mut Env, list: Text) -> Text {
    env.copy(items(&list).last().unwrap_or_default())
}

/// The elements of an array as text, row by row (*listFromArray*).
pub fn list_from_array<T: Element>(env: &mut Env, array: Array<T>) -> Text {
    let mut list = String::new();
    for value in &array {
        // Writing to a string cannot fail.
        let _ = value.print(&mut list);
        list.push(';');
        if !env.may_print(list.len()) {
            return Text::default();
        }
    }
    if env.may_write(list.len()) { Text::from(list) } else { Text::default() }
}

/// All items, including empty ones, in one row (*listToArray*).
pub fn list_to_array(env: &mut Env, list: Text) -> Array<Text> {
    if list.is_empty() { Array::default() } else { env.copy_all(list.strip_suffix(';').unwrap_or(&list).split(';')) }
}

/// The number of the first matching item, from 0; -1 without one (*listIndex*).
pub fn list_index(list: Text, search: Text) -> f64 {
    items(&list).position(|item| matches(item, &search)).map_or(-1.0, |place| place as f64)
}

/// An item by its number, from 0; "" if it does not exist (*listItem*).
pub fn list_item(env: &mut Env, list: Text, index: f64) -> Text {
    let index = whole(env.finite(index, "the index of an item"));
    env.copy(index.and_then(|index| items(&list).nth(index)).unwrap_or_default())
}

/// A random item; "" without items (*listRandom*). Always draws a random number.
pub fn list_random(env: &mut Env, shape: &mut impl View, list: Text) -> Text {
    // The same formula as in the utility library, where `rand` includes its upper end.
    let place = shape.draw() * (items(&list).count() as f64 - 1e-7);
    env.copy(whole(place).and_then(|place| items(&list).nth(place)).unwrap_or_default())
}

/// The items from number `start` to before number `end`, as a list (*listRange*).
pub fn list_range(env: &mut Env, list: Text, start: f64, end: f64) -> Text {
    let start = whole(env.finite(start, "the start of a range of items")).unwrap_or(0);
    let end = whole(env.finite(end, "the end of a range of items")).unwrap_or(0);
    list_of(env, items(&list).take(end).skip(start))
}

/// The list without the first matching item (*listRemove*).
pub fn list_remove(env: &mut Env, list: Text, search: Text) -> Text {
    let first = items(&list).position(|item| matches(item, &search));
    list_of(env, items(&list).enumerate().filter(|(place, _)| Some(*place) != first).map(|(_, item)| item))
}

/// The list without the matching items (*listRemoveAll*).
pub fn list_remove_all(env: &mut Env, list: Text, search: Text) -> Text {
    list_of(env, items(&list).filter(|item| !matches(item, &search)))
}

/// The matching items as a list (*listRetainAll*).
pub fn list_retain_all(env: &mut Env, list: Text, search: Text) -> Text {
    list_of(env, items(&list).filter(|item| matches(item, &search)))
}

/// The number of items (*listSize*).
pub fn list_size(list: Text) -> f64 {
    items(&list).count() as f64
}

/// The list with a `;` at its end (*listTerminate*). An empty list stays empty.
pub fn list_terminate(env: &mut Env, list: Text) -> Text {
    if list.is_empty() || list.ends_with(';') { list } else { env.write(format_args!("{list};")) }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{Random, env, faults, limit, small_env, text};
    use super::*;
    use crate::fault::LimitKind;
    use crate::shape::Shape;

    fn rule() -> Text {
        text("rule;your;city;")
    }

    #[test]
    fn items_are_found_by_search_text() {
        // *listIndex*, *listCount*, *listItem*, *listFirst*, *listLast*, *listSize*.
        let env = &mut env();
        assert_eq!(
            ["city", "*y", "*y*", "x", "*", "y*", "ci*"].map(|s| list_index(rule(), text(s))),
            [2.0, 2.0, 1.0, -1.0, 0.0, 1.0, 2.0]
        );
        assert_eq!(
            ["city", "*y*", "*y", "*", "**", ""].map(|s| list_count(rule(), text(s))),
            [1.0, 2.0, 1.0, 3.0, 3.0, 0.0]
        );
        assert_eq!(list_count(text("city;cityengine;city;"), text("city")), 2.0);
        assert_eq!([2.0, 0.9, -1.0, 3.0].map(|i| list_item(env, rule(), i)), ["city", "rule", "", ""].map(text));
        assert_eq!((list_first(env, rule()), list_last(env, rule())), (text("rule"), text("city")));
        assert_eq!((list_first(env, text(";;")), list_last(env, text(""))), (text(""), text("")));
        assert_eq!((list_size(rule()), list_size(text("a;;b")), list_size(text(""))), (3.0, 2.0, 0.0));
        assert_eq!(faults(env), 0);
        assert_eq!(list_item(env, rule(), f64::NAN), text("rule"));
        assert_eq!(faults(env), 1);
    }

    #[test]
    fn items_are_added_and_removed() {
        // *listAdd*, *listClean*, *listRange*, *listRemove*, *listRemoveAll*, *listRetainAll*, *listTerminate*.
        let env = &mut env();
        for item in ["city", "city;"] {
            assert_eq!(list_add(env, text("rule;your;"), text(item)), rule());
        }
        assert_eq!(
            (list_add(env, text("a"), text("b")), list_add(env, text(""), text("b"))),
            (text("a;b;"), text("b;"))
        );
        assert_eq!(list_clean(env, text(";;;;;my;city;rules;;your;;city;;")), text("my;city;rules;your;city;"));
        assert_eq!((list_clean(env, text(";;a;;b")), list_clean(env, text(";;"))), (text("a;b;"), text("")));
        assert_eq!(list_range(env, text("rule;your;city;with;cityengine;"), 0.0, 3.0), rule());
        assert_eq!(list_range(env, text("t1;t2;t3;t4"), 2.0, 3.0), text("t3;"));
        assert_eq!(list_range(env, text("t1;t2;t3;t4"), -2.0, 99.0), text("t1;t2;t3;t4;"));
        assert_eq!((list_range(env, rule(), 3.0, 1.0), list_range(env, rule(), 9.0, 12.0)), (text(""), text("")));
        assert_eq!(list_remove(env, rule(), text("your")), text("rule;city;"));
        assert_eq!(list_remove(env, rule(), text("*u*")), text("your;city;"));
        assert_eq!(list_remove(env, text("floor_1;floor_2;floor_3;"), text("*_2")), text("floor_1;floor_3;"));
        let designs = || text("rule;your;designs;and;your;cities;");
        assert_eq!(list_remove_all(env, designs(), text("your")), text("rule;designs;and;cities;"));
        assert_eq!(list_remove_all(env, designs(), text("*u*")), text("designs;and;cities;"));
        assert_eq!(list_retain_all(env, designs(), text("*s")), text("designs;cities;"));
        assert_eq!(list_retain_all(env, text("floor;floor_1;floor_2;"), text("*_*")), text("floor_1;floor_2;"));
        assert_eq!(["a", "a;", ""].map(|list| list_terminate(env, text(list))), ["a;", "a;", ""].map(text));
    }

    #[test]
    fn lists_are_arrays() {
        // *listFromArray*, *listToArray*.
        let env = &mut env();
        assert_eq!(list_from_array(env, Array::from([1.0, 2.0, 3.5])), text("1;2;3.5;"));
        assert_eq!(list_from_array(env, Array::from([true, false, true])), text("true;false;true;"));
        assert_eq!(list_from_array(env, Array::from(["rule", "your", "city"].map(text))), rule());
        assert_eq!(list_to_array(env, rule()), Array::from(["rule", "your", "city"].map(text)));
        assert_eq!(list_to_array(env, text("a;;b")), Array::from(["a", "", "b"].map(text)));
        assert_eq!((list_to_array(env, text("")).len(), list_to_array(env, text(";")).len()), (0, 1));
        let env = &mut small_env(2, 100);
        assert!(list_to_array(env, rule()).is_empty());
        assert_eq!(limit(env), Some(LimitKind::Array));
        for make in [
            |env: &mut Env| list_from_array(env, Array::from([1.0, 2.0, 3.0])),
            |env: &mut Env| list_add(env, text("abc"), text("d")),
            |env: &mut Env| list_terminate(env, text("abcde")),
        ] {
            let env = &mut small_env(10, 5);
            assert_eq!(make(env), text(""));
            assert_eq!(limit(env), Some(LimitKind::Text));
        }
    }

    #[test]
    fn items_come_by_chance_and_evenly() {
        let (env, mut shape) = (&mut env(), Shape::rectangle(1.0, 1.0));
        let drawn: Vec<Text> = (0..3000).map(|_| list_random(env, &mut shape, rule())).collect();
        for item in ["rule", "your", "city"] {
            let often = drawn.iter().filter(|other| other.as_str() == item).count();
            assert!((900..1100).contains(&often), "{item}: {often}");
        }
        let mut other = shape.clone();
        assert_eq!(list_random(env, &mut shape, text("")), text(""));
        other.seed.draw();
        assert_eq!(shape.seed.draw(), other.seed.draw());
    }

    #[test]
    fn lists_and_arrays_go_back_and_forth() {
        let mut random = Random(88);
        for _ in 0..3_000 {
            let env = &mut env();
            let mut item = || text(["", "a", "ü", "bc", "*"][random.below(5)]);
            let array: Array<Text> = (0..4).map(|_| item()).collect();
            let list = list_from_array(env, array.clone());
            assert_eq!(list_to_array(env, list.clone()), array);
            let clean = list_clean(env, list.clone());
            assert_eq!(list_clean(env, clean.clone()), clean);
            let search = item();
            let kept = list_size(list_retain_all(env, list.clone(), search.clone()));
            assert_eq!(kept, list_count(list.clone(), search.clone()));
            assert_eq!(kept + list_size(list_remove_all(env, list.clone(), search)), list_size(list));
        }
    }
}
