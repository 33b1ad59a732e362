//! The exceptions of the package.

use cga::Error;
use pyo3::create_exception;
use pyo3::exceptions::PyException;
use pyo3::prelude::*;

create_exception!(pycga, CgaError, PyException, "The base of all exceptions of this package.");
create_exception!(
    pycga,
    RuleError,
    CgaError,
    "Rules that cannot be loaded. `diagnostics` has the errors and warnings as data."
);
create_exception!(
    pycga,
    AttributeValueError,
    CgaError,
    "An attribute that the rules do not have, or a value that it cannot take."
);
create_exception!(pycga, ShapeError, CgaError, "A geometry that is not a lot.");
create_exception!(pycga, RunError, CgaError, "A run that ended without a model. `trail` has the rules that led there.");
create_exception!(pycga, DeadlineError, RunError, "A run that took longer than its deadline.");
create_exception!(
    pycga,
    CityError,
    CgaError,
    "A city that cannot be made: its folder, its choices, its tables, or lots that changed after they were counted."
);
create_exception!(pycga, WriteError, CgaError, "A model that cannot be written.");

/// The message for a panic, which is a mistake of the library.
pub(crate) const PANIC: &str = "the run failed inside of the library; please report this with the rules and the lot";

/// The exception of a run.
pub(crate) fn run_error(py: Python<'_>, error: &Error) -> PyErr {
    let message = error.to_string();
    match error {
        // The caller knows which lot it is.
        Error::Lot { lot, problems } if lot.is_empty() => AttributeValueError::new_err(problems.join("; also, ")),
        Error::Attribute { .. } | Error::Lot { .. } => AttributeValueError::new_err(message),
        Error::Shape(_) => ShapeError::new_err(message),
        Error::Limit { trail, .. } => {
            let trail: Vec<String> = trail.iter().map(ToString::to_string).collect();
            with_trail(py, RunError::new_err(message), trail)
        }
        _ => with_trail(py, RunError::new_err(message), Vec::new()),
    }
}

/// The exception for a panic.
pub(crate) fn panicked(py: Python<'_>) -> PyErr {
    with_trail(py, RunError::new_err(PANIC), Vec::new())
}

/// The exception for a deadline of a number of seconds.
pub(crate) fn late(py: Python<'_>, seconds: f64) -> PyErr {
    with_trail(py, DeadlineError::new_err(late_message(seconds)), Vec::new())
}

pub(crate) fn late_message(seconds: f64) -> String {
    format!("the run was ended after its deadline of {seconds} seconds")
}

fn with_trail(py: Python<'_>, error: PyErr, trail: Vec<String>) -> PyErr {
    match error.value(py).setattr("trail", trail) {
        Ok(()) => error,
        Err(other) => other,
    }
}
