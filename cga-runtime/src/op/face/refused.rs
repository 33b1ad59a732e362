//! Faults for faces that an operation refuses.

use crate::fault::FaultKind;
use crate::run::env::Env;

/// Reports the faces that stay as they are, with one fault for each reason that occurs. `reasons` has the texts.
pub(in crate::op) fn report_refused<R: PartialEq>(
    env: &mut Env,
    name: &str,
    refused: &[(usize, R)],
    reasons: &[(R, &str)],
) {
    for (why, text) in reasons {
        let faces = refused.iter().filter(|refused| refused.1 == *why).map(|refused| refused.0);
        report_faces(env, name, faces, |face, more| format!("face {face} {text}{more}; it stays as it is"));
    }
}

/// Reports faces with one fault. The text is made of the first face and a count of the others, which is empty if there are
/// none.
pub(in crate::op) fn report_faces(
    env: &mut Env,
    name: &str,
    mut faces: impl Iterator<Item = usize>,
    text: impl Fn(usize, &str) -> String,
) {
    let Some(first) = faces.next() else { return };
    let more = match faces.count() {
        0 => String::new(),
        more => format!(", as {more} more"),
    };
    env.fault(FaultKind::Geometry, format!("`{name}`: {}", text(first, &more)));
}
