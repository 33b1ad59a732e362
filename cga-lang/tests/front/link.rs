//! `tests/data/link`: what is found in programs of several files, and where.

#[test]
fn findings_stand_in_the_files_they_are_about() {
    crate::common::parts::walk("link");
}
