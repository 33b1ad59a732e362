use super::*;
use crate::outline::Outline;

cga::cga! {
    @Allow(unused_attribute)
    grammar House;
    attr height = 9
    attr kind = "home"
    attr rise = 0
    @Range(min = 1, max = 90) attr floors = 3
    @Enum("flat", "hip") attr roof = "hip"
    @StartRule Lot --> extrude(height) X.
    @StartRule Garden --> Lawn.
}

const SQUARE: [Corner; 4] = [[10.0, 50.0], [10.0002, 50.0], [10.0002, 50.0001], [10.0, 50.0001]];

fn row(rings: Vec<Vec<Corner>>) -> Row {
    Row::new(3, Ok(vec![Outline::new(rings)]))
}

fn survey(row: Row) -> Survey {
    survey_with(row, Columns::default())
}

fn survey_with(row: Row, columns: Columns) -> Survey {
    let house = House::default();
    Surveyor::new(vec![&house], columns).survey(row)
}

fn reason(rings: Vec<Vec<Corner>>) -> String {
    let survey = survey(row(rings));
    assert!(survey.footprints.is_empty());
    assert!(survey.problems[0].is_lost && survey.problems[0].row == 3);
    survey.problems[0].reason.clone()
}

#[test]
fn hostile_polygons_have_a_reason() {
    let far = SQUARE.map(|[x, y]| if y == 50.0 { [x, y] } else { [x + 90.0, y] });
    for (rings, why) in [
        (vec![], "empty polygon"),
        (vec![vec![]], "no area"),
        (vec![vec![SQUARE[0]; 9]], "no area"),
        (vec![vec![SQUARE[0], SQUARE[1], SQUARE[0], SQUARE[1]]], "no area"),
        (vec![vec![SQUARE[0], SQUARE[1], [f64::NAN, 50.0]]], "a corner is (NaN, 50)"),
        (vec![vec![SQUARE[0], SQUARE[1], [10.0, f64::INFINITY]]], "a corner is (10, inf)"),
        (vec![vec![SQUARE[0], SQUARE[2], SQUARE[1], [10.0, 50.00005]]], "its edges cross"),
        (vec![far.to_vec()], "km long"),
        (vec![vec![[1e7, 2e6], [1e7, 2e6 + 9.0], [1e7 + 9.0, 2e6]]], "not a longitude"),
        (vec![vec![[10.0, 89.0], [10.1, 89.0], [10.0, 89.0001]]], "at latitude 89"),
    ] {
        let found = reason(rings);
        assert!(found.contains(why), "{found}");
    }
}

#[test]
fn footprints_do_not_depend_on_winding_and_closing() {
    let expected = survey(row(vec![SQUARE.to_vec()]));
    let mut closed = SQUARE.to_vec();
    closed.extend([SQUARE[0], SQUARE[0]]);
    let turned = vec![SQUARE[0], SQUARE[3], SQUARE[2], SQUARE[1], SQUARE[0]];
    assert_eq!(survey(row(vec![closed])), expected);
    assert_eq!(survey(row(vec![turned])), expected);
    assert_eq!(expected.footprints[0].rings[0], SQUARE);
}

#[test]
fn a_footprint_across_the_meridian_of_180_degrees_is_whole() {
    let ring = vec![[179.9999, 10.0], [-179.9999, 10.0], [-179.9999, 10.0001], [179.9999, 10.0001]];
    let survey = survey(row(vec![ring]));
    let footprint = &survey.footprints[0];
    assert!((footprint.rings[0][1][0] - 180.0001).abs() < 1e-9);
    let lot = footprint.lot(&House::default(), &crate::frame::Frame::at(footprint.middle())).expect("a lot");
    assert!((lot.scope().size.x - 21.9).abs() < 0.1);
}

#[test]
fn columns_set_attributes_by_name_and_by_table() {
    let mut given = row(vec![SQUARE.to_vec()]);
    given.columns = vec![
        ("kind".into(), ColumnValue::Text("shop".into())),
        ("HOEHE".into(), ColumnValue::Text("12.5".into())),
        ("gid".into(), ColumnValue::Number(17.0)),
        ("rule".into(), ColumnValue::Text("Garden".into())),
    ];
    let columns = Columns {
        id: Some("gid".into()),
        start: Some("rule".into()),
        attributes: vec![("HOEHE".into(), "height".into())],
        footing: Some("rise".into()),
        ..Columns::default()
    };
    let found = survey_with(given, columns).footprints.remove(0);
    let number = ColumnValue::Number;
    let values = [("height", number(12.5)), ("kind", ColumnValue::Text("shop".into())), ("rise", number(0.0))];
    assert_eq!(found.values, values.map(|(name, value)| (name.to_owned(), value)));
    assert_eq!((found.id.as_str(), found.start.as_deref()), ("17", Some("Garden")));
    let bytes = found.to_bytes();
    assert_eq!(Footprint::from_bytes(&bytes), Ok(found));
}

#[test]
fn wrong_values_are_reported_and_the_building_stays() {
    let mut given = row(vec![SQUARE.to_vec()]);
    given.columns = vec![("height".into(), ColumnValue::Text("tall".into()))];
    let survey = survey(given);
    assert_eq!(survey.footprints.len(), 1);
    assert_eq!(survey.problems[0].reason, "its column `height` is left out: `tall` is not a number");
    assert!(!survey.problems[0].is_lost);
}

#[test]
fn unknown_grammars_and_start_rules_are_lost_rows() {
    let mut given = row(vec![SQUARE.to_vec()]);
    given.columns = vec![("kind".into(), ColumnValue::Text("Tower".into()))];
    let by_grammar = Columns { grammar: Some("kind".into()), ..Columns::default() };
    let reasons = |columns| survey_with(given.clone(), columns).problems[0].reason.clone();
    assert_eq!(reasons(by_grammar), "`Tower` is not one of the grammars House");
    let by_start = Columns { start: Some("kind".into()), ..Columns::default() };
    assert_eq!(reasons(by_start), "`Tower` is not a start rule of `House`");
}

#[test]
fn lots_stand_at_the_lowest_ground_of_their_corners() {
    let house = House::default();
    let columns = Columns { footing: Some("rise".into()), ..Columns::default() };
    let slope = |[x, _]: Corner| (x < 10.0003).then_some(100.0 + (x - 10.0) * 1e4);
    let surveyor = Surveyor::new(vec![&house], columns).terrain(Arc::new(slope));
    let found = surveyor.survey(row(vec![SQUARE.to_vec()]));
    let ColumnValue::Number(rise) = found.footprints[0].values[0].1 else { panic!("a number") };
    assert_eq!(found.footprints[0].base, 100.0);
    assert!((rise - 2.0).abs() < 1e-6);
    let outside = SQUARE.map(|[x, y]| [x + 1.0, y]);
    let found = surveyor.survey(row(vec![outside.to_vec()]));
    assert!(found.problems[0].reason.contains("no height below"));
    assert_eq!(found.footprints[0].base, 0.0);
}

#[test]
fn a_wrong_coordinate_system_is_noted() {
    let house = House::default();
    let notes = |crs: &str, ring: &[Corner]| {
        let surveyor = Surveyor::new(vec![&house], Columns::default()).crs(crs.parse().expect("a code"));
        let survey = surveyor.survey(row(vec![ring.to_vec()]));
        assert_eq!(survey.footprints.len(), 1, "{:?}", survey.problems);
        survey.problems.into_iter().map(|problem| problem.reason).collect::<Vec<_>>()
    };
    let small = notes("EPSG:25832", &SQUARE);
    assert_eq!(small, ["it is smaller than 1 cm; is EPSG:25832 its coordinate system? `--crs` names another one"]);
    let metres = |x: f64, y: f64| [[x, y], [x + 20.0, y], [x + 20.0, y + 10.0], [x, y + 10.0]];
    assert_eq!(notes("EPSG:25832", &metres(500_000.0, 5_400_000.0)), [""; 0]);
    // The north of Norway in the zone of the whole country.
    assert_eq!(notes("EPSG:25833", &metres(1_080_000.0, 7_800_000.0)), [""; 0]);
    // Zones of Gauss and Krüger have their number in front.
    let far = notes("EPSG:25832", &metres(3_500_000.0, 5_400_000.0));
    assert!(far.len() == 1 && far[0].contains("degrees of longitude from the middle of its zone"), "{far:?}");
    assert_eq!(notes("EPSG:4326", &SQUARE), [""; 0]);
}

#[test]
fn a_height_beyond_the_earth_is_left_out() {
    let mut given = row(vec![SQUARE.to_vec()]);
    let outlines = given.outlines.as_mut().expect("an outline");
    [1e300, f64::NEG_INFINITY, 120.0, 118.0, f64::NAN].into_iter().for_each(|height| outlines[0].lower_to(height));
    let survey = survey(given);
    assert_eq!(survey.footprints[0].base, 118.0);
    assert_eq!(survey.problems.len(), 1);
    let why = "a height of 1e300 m is left out: heights are from -12000 m to 100000 m";
    assert_eq!(survey.problems[0].reason, why);
}

#[test]
fn values_that_an_attribute_refuses_are_problems_of_their_row() {
    let mut given = row(vec![SQUARE.to_vec()]);
    let text = |text: &str| ColumnValue::Text(text.into());
    given.columns = vec![("floors".into(), ColumnValue::Number(900.0)), ("roof".into(), text("dome"))];
    let found = survey(given.clone());
    let reasons: Vec<&str> = found.problems.iter().map(|problem| problem.reason.as_str()).collect();
    let expected = [
        "its column `floors` is left out: `900` is not from 1 to 90",
        "its column `roof` is left out: `dome` is not one of flat, hip",
    ];
    assert_eq!(reasons, expected);
    assert!(found.footprints[0].values.is_empty() && found.problems.iter().all(|problem| !problem.is_lost));
    for (column, value) in [("floors", ColumnValue::Number(f64::NAN)), ("floors", text("inf"))] {
        given.columns = vec![(column.into(), value)];
        assert_eq!(survey(given.clone()).problems.len(), 1);
    }
    given.columns = vec![("floors".into(), ColumnValue::Number(90.0)), ("roof".into(), text("flat"))];
    assert_eq!(survey(given).problems, []);
}

#[test]
fn misplaced_holes_are_left_out_with_a_note() {
    let square = |x: f64, y: f64, size: f64| -> Vec<Corner> {
        let [x, y, size] = [10.0 + x * 1e-5, 50.0 + y * 1e-5, size * 1e-5];
        vec![[x, y], [x + size, y], [x + size, y + size], [x, y + size]]
    };
    let outer = || square(0.0, 0.0, 20.0);
    for (holes, left) in [
        (vec![square(30.0, 0.0, 5.0)], 0),
        (vec![square(5.0, 5.0, 10.0), square(7.0, 7.0, 4.0)], 1),
        (vec![square(7.0, 7.0, 4.0), square(5.0, 5.0, 10.0)], 1),
        (vec![square(-5.0, -5.0, 40.0)], 0),
    ] {
        let found = survey(row([vec![outer()], holes].concat()));
        let why = "1 holes outside of the outline or inside of other holes were left out";
        assert_eq!(
            (found.problems.len(), found.problems[0].reason.as_str(), found.problems[0].is_lost),
            (1, why, false)
        );
        assert_eq!(found.footprints[0].rings.len(), 1 + left);
    }
    // A hole may touch the outline and other holes at corners.
    let touching = vec![[10.0, 50.0], [10.00008, 50.00002], [10.00002, 50.00008]];
    let second = vec![[10.00008, 50.00002], [10.00012, 50.00004], [10.00012, 50.00002]];
    let found = survey(row(vec![outer(), touching, second]));
    assert_eq!((found.problems.len(), found.footprints[0].rings.len()), (0, 3), "{:?}", found.problems);
}

#[test]
fn values_in_reasons_are_short_and_plain() {
    let mut given = row(vec![SQUARE.to_vec()]);
    given.columns = vec![("height".into(), ColumnValue::Text(format!("\u{1b}{}", "9".repeat(1 << 20))))];
    let reason = &survey(given).problems[0].reason;
    assert!(reason.len() < 200 && !reason.contains('\u{1b}'), "{reason}");
}
