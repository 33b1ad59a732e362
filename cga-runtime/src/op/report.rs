//! `report`, `print` and `label`.

use crate::fault::FaultKind;
use crate::run::env::Env;
use crate::shape::view::View;
use crate::value::Value;
use crate::value::text::Text;

/// `report(key, value)`: adds a number, a truth value or text to the collection of that key and type (*report
/// operation*). Numbers need not be finite; NaN is counted separately.
pub fn report(env: &mut Env, _: &mut impl View, key: Text, value: impl Into<Value>) {
    env.report(key, value.into());
}

/// `print(value)`: keeps a line with the model (*print operation*).
pub fn print(env: &mut Env, _: &mut impl View, value: impl Into<Value>) {
    env.print(value.into());
}

/// `label(name)`: leaves a labelled copy of the shape, which queries of other shapes find (*label operation*). The shape itself goes on
/// without a label. An empty name is a fault.
pub fn label(env: &mut Env, shape: &mut impl View, name: Text) {
    if name.is_empty() {
        env.fault(FaultKind::Value, "a label must not be empty; the shape gets none");
    } else {
        env.collect_label(name, || shape.body());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::op::{Length, extrude};
    use crate::query::get;
    use crate::run::report::Print;
    use crate::run::settings::{Limits, Settings};
    use crate::shape::Shape;
    use crate::value::ValueType;

    fn env(reports: u64, prints: u64) -> Env {
        let limits = Limits { reports, prints, ..Limits::default() };
        let settings = Settings { limits, ..Settings::default() };
        Env::with_names(&settings, &["Lot"], &Shape::rectangle(1.0, 1.0), "Lot")
    }

    #[test]
    fn a_report_counts_and_sums() {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::rectangle(4.0, 5.0));
        extrude(env, shape, Length::Absolute(10.0));
        let height = get::scope_sy(shape);
        report(env, shape, "myHeight".into(), height);
        let summary = env.reports.get("myHeight").expect("reported").summary();
        assert_eq!((summary.count, summary.sum), (1, 10.0));
        assert_eq!((summary.average(), summary.min(), summary.max()), (Some(10.0), Some(10.0), Some(10.0)));
    }

    fn prints(env: &Env) -> Vec<Print> {
        env.prints.clone().in_order()
    }

    #[test]
    fn printed_text_is_kept_as_it_is() {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::rectangle(4.0, 5.0));
        print(env, shape, Text::fixed("x = 1"));
        env.trail.push(0);
        print(env, shape, 1.69 - 0.69);
        let lines: Vec<_> = prints(env).iter().map(|line| (line.rule.to_string(), line.to_string())).collect();
        assert_eq!(lines, [("", "x = 1"), ("Lot", "1")].map(|(rule, line)| (rule.to_owned(), line.to_owned())));
        assert!(crate::query::print(env, true));
        assert_eq!(prints(env).last().map(|line| &line.value), Some(&Value::Bool(true)));
    }

    #[test]
    fn a_key_and_a_type_are_a_collection() {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::rectangle(4.0, 5.0));
        for value in [3.0, f64::NAN, -1.0] {
            report(env, shape, "k".into(), value);
        }
        for text in ["b", "a", "b"] {
            report(env, shape, "k".into(), Text::fixed(text));
        }
        report(env, shape, "k".into(), true);
        report(env, shape, "k".into(), false);
        let types: Vec<_> = env.reports.iter().map(|it| (it.key(), it.ty(), it.summary().count)).collect();
        assert_eq!(types, [("k", ValueType::Float, 3), ("k", ValueType::Bool, 2), ("k", ValueType::Text, 3)]);
        let floats = env.reports.get("k").expect("reported").summary();
        assert_eq!((floats.nans, floats.sum, floats.average(), floats.min()), (1, 2.0, Some(1.0), Some(-1.0)));
        let bools = env.reports.of_type("k", ValueType::Bool).expect("reported").summary();
        assert_eq!((bools.sum, bools.average()), (1.0, Some(0.5)));
        let texts = env.reports.of_type("k", ValueType::Text).expect("reported");
        assert_eq!((texts.texts().collect::<Vec<_>>(), texts.summary().max()), (vec![("a", 1), ("b", 2)], None));
        assert_eq!(env.reports.group("k").count, 8);
        assert!(env.reports.get("").is_none() && env.reports.get("kk").is_none());
    }

    #[test]
    fn what_has_no_room_is_counted_and_said_once() {
        let (env, shape) = (&mut env(2, 2), &mut Shape::rectangle(4.0, 5.0));
        for key in ["a", "b", "c", "d", "a"] {
            report(env, shape, key.into(), 1.0);
        }
        report(env, shape, "a".into(), Text::fixed("no room"));
        (0..5).for_each(|line| print(env, shape, f64::from(line)));
        assert_eq!((env.reports.left_out(), env.prints.quota.left_out), (3, 3));
        assert_eq!(env.reports.get("a").expect("reported").summary().count, 2);
        let (faults, _) = env.take_faults();
        assert!(faults.len() == 2 && faults.iter().all(|fault| fault.kind == FaultKind::Limit), "{faults:?}");
    }

    #[test]
    fn long_texts_take_no_more_than_their_share() {
        let (env, shape) = (&mut env(1000, 1000), &mut Shape::rectangle(4.0, 5.0));
        let long = Text::from("x".repeat(10 << 20));
        (0..20).for_each(|_| print(env, shape, long.clone()));
        assert_eq!((prints(env).len(), env.prints.quota.left_out), (6, 14));
    }

    #[test]
    fn a_label_needs_a_name() {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::rectangle(4.0, 5.0));
        label(env, shape, "a".into());
        assert_eq!(env.take_faults().0.len(), 0);
        label(env, shape, Text::default());
        assert_eq!(env.take_faults().0.len(), 1);
    }
}
