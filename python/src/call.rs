//! The settings of a call.

use std::sync::Arc;
use std::time::Duration;

use cga::{
    Assets, Attribute, Error, Grammar, Limits, RuleFile, Settings, Shape as Initial, Text, Value, Watch, WrongLots,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyMapping;

use crate::errors::AttributeValueError;
use crate::value::{coerced, from_python};

/// The settings of a call, and the values of its attributes.
pub(crate) struct Call {
    pub(crate) settings: Settings,
    pub(crate) watch: Watch,
    /// In seconds.
    pub(crate) deadline: Option<f64>,
    attributes: Vec<(Text, Value)>,
}

impl Call {
    /// # Errors
    /// A value that no attribute can have, a limit that does not exist, a deadline that is not a time.
    pub(crate) fn new(
        rules: &RuleFile,
        assets: &Arc<Assets>,
        attributes: Option<&Bound<'_, PyMapping>>,
        start: Option<String>,
        limits: Option<&Bound<'_, PyMapping>>,
        deadline: Option<f64>,
    ) -> PyResult<Self> {
        let mut values = Vec::new();
        for (name, given) in items(attributes)? {
            // None is the default.
            if given.is_none() && find(rules, &name).is_some() {
                continue;
            }
            let wanted = find(rules, &name).map(|attribute| attribute.ty);
            let value = from_python(&given, wanted);
            let value = value.map_err(|why| AttributeValueError::new_err(format!("attribute `{name}`: {why}")))?;
            values.push((Text::from(name), value));
        }
        let limits: Limits = match limits {
            Some(limits) => {
                pythonize::depythonize(limits).map_err(|why| PyValueError::new_err(format!("limits: {why}")))?
            }
            None => Limits::default(),
        };
        let watch = match deadline.map(Duration::try_from_secs_f64) {
            Some(Ok(limit)) => Watch::deadline(limit),
            Some(Err(_)) => return Err(PyValueError::new_err("the deadline is a number of seconds, as in 2.5")),
            None => Watch::new(),
        };
        let settings =
            Settings { start, limits, assets: assets.clone(), watch: Some(watch.clone()), ..Settings::default() };
        Ok(Call { settings, watch, deadline, attributes: values })
    }

    /// A wrong value of a row becomes a fault of its model, and the value is left out.
    pub(crate) fn with_wrong_values(mut self) -> Self {
        self.settings.wrong_lots = WrongLots::Fault;
        self
    }

    /// The lot with the values of the call, where it has none of its own.
    pub(crate) fn lot(&self, rules: &RuleFile, mut initial: Initial) -> Initial {
        let empty_lists: Vec<(String, Value)> = initial
            .attributes()
            .filter(|(_, value)| matches!(value, Value::Floats(array) if array.is_empty()))
            .filter_map(|(name, value)| Some((name.to_owned(), coerced(value.clone(), find(rules, name)?.ty))))
            .collect();
        for (name, value) in empty_lists {
            initial = initial.attribute(name, value);
        }
        for (name, value) in &self.attributes {
            if !initial.attributes().any(|(own, _)| name.is(own)) {
                initial = initial.attribute(name.clone(), value.clone());
            }
        }
        initial
    }

    /// Checks the attributes and the start rule of the call, which do not depend on a lot.
    ///
    /// # Errors
    /// The error of a run that would fail for each lot.
    pub(crate) fn check(&self, rules: &RuleFile) -> Result<(), Error> {
        let settings = Settings { wrong_lots: WrongLots::Fail, ..self.settings.clone() };
        let lot = self.lot(rules, Initial::rectangle(1.0, 1.0));
        match rules.used_values(&lot, &settings) {
            Err(error @ (Error::Lot { .. } | Error::Attribute { .. } | Error::StartRule { .. })) => Err(error),
            _ => Ok(()),
        }
    }
}

/// The items of a mapping with texts as keys.
pub(crate) fn items<'py>(mapping: Option<&Bound<'py, PyMapping>>) -> PyResult<Vec<(String, Bound<'py, PyAny>)>> {
    match mapping {
        Some(mapping) => mapping.items()?.iter().map(|item| item.extract()).collect(),
        None => Ok(Vec::new()),
    }
}

fn find<'r>(rules: &'r RuleFile, name: &str) -> Option<&'r Attribute> {
    rules.attributes().iter().find(|attribute| attribute.name.is(name))
}
