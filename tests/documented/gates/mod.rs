//! The gates over everything that the repository draws, and for each gate a planted scene that it must catch.

use std::sync::OnceLock;

use cga_gates::{Look, Survey, looks};
use cga_tests::drawn::drawn;

/// The longer side of a picture, in pixels.
const PIXELS: usize = 400;

struct Surveyed {
    name: String,
    survey: Survey,
    looks: Vec<Look>,
}

fn all() -> &'static [Surveyed] {
    static ALL: OnceLock<Vec<Surveyed>> = OnceLock::new();
    ALL.get_or_init(|| {
        let mut list = Vec::new();
        for drawn in drawn() {
            let t = std::time::Instant::now();
            let survey = Survey::of(&drawn.model, &["House"]);
            let t1 = t.elapsed();
            let looks = looks(&survey, PIXELS);
            eprintln!("{} {} tris survey {t1:?} looks {:?}", drawn.name, survey.triangles.len(), t.elapsed() - t1);
            list.push(Surveyed { name: drawn.name, survey, looks });
        }
        list
    })
}

#[test]
fn try_all() {
    for s in all() {
        use cga_gates::*;
        let t = std::time::Instant::now();
        let show = |title: &str, found: Vec<Finding>| {
            if !found.is_empty() {
                let text = report(&s.survey, &found);
                let lines: Vec<&str> = text.lines().take(14).collect();
                eprintln!("== {} {title}: {}\n{}", s.name, found.len(), lines.join("\n"));
            }
        };
        show("inside out", inside_out(&s.survey));
        show("backs", back_faces(&s.survey, &s.looks));
        show("holes", holes(&s.survey, &s.looks, &[]));
        show("fights", fights(&s.survey, &s.looks));
        show("nested", nested(&s.survey));
        eprintln!("{} gates {:?}", s.name, t.elapsed());
    }
}
