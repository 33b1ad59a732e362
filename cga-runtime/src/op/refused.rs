//! Faults for faces that an operation refuses.

use crate::fault::FaultKind;
use crate::run::env::Env;

/// Reports the faces that stay as they are, with one fault for each reason that occurs. `reasons` has the texts.
pub(super) fn report_refused<R: PartialEq>(env: &mut Env, name: &str, refused: &[(usize, R)], reasons: &[(R, &str)]) {
    for (why, text) in reasons {
        let mut faces = refused.iter().filter(|refused| refused.1 == *why).map(|refused| refused.0);
        let Some(first) = faces.next() else { continue };
        let more = match faces.count() {
            0 => String::new(),
            more => format!(", as {more} more"),
        };
        env.fault(FaultKind::Geometry, format!("`{name}`: face {first} {text}{more}; it stays as it is"));
    }
}
