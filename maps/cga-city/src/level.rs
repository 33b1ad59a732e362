//! Levels of detail.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

/// A level of detail: a start rule, or values of attributes, for buildings that are far away.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Level {
    /// The start rule; `None` for the usual one. A lot with a start rule of its own keeps it.
    pub start: Option<String>,
    /// The names of attributes and the texts of their values.
    pub values: Vec<(String, String)>,
    /// The error in metres that a viewer sees when it shows this level in the place of the near one.
    pub error: Option<f64>,
}

/// The level as it is written on the command line.
impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.start.as_deref().unwrap_or_default())?;
        for (number, (name, value)) in self.values.iter().enumerate() {
            write!(f, "{}{name}={value}", if number == 0 { "" } else { "," })?;
        }
        self.error.map_or(Ok(()), |error| write!(f, "@{error}"))
    }
}

/// `RULE`, `name=value` or `name=value,name=value`, each with `@METRES` for the error.
impl FromStr for Level {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "write a start rule or an attribute, as in `Block`, `detail=0` or `detail=0@8`".to_owned();
        let (what, error) = match text.rsplit_once('@') {
            Some((what, metres)) => {
                let error: f64 = metres.trim().parse().map_err(|_| format!("`{metres}` is not a number of metres"))?;
                if !(0.0 < error && error.is_finite()) {
                    return Err("the error of a level is more than 0 metres".to_owned());
                }
                (what, Some(error))
            }
            None => (text, None),
        };
        if what.trim().is_empty() {
            return Err(wrong());
        }
        if !what.contains('=') {
            return Ok(Level { start: Some(what.trim().to_owned()), values: Vec::new(), error });
        }
        let value = |part: &str| {
            let (name, value) = part.split_once('=').ok_or_else(wrong)?;
            Ok((name.trim().to_owned(), value.to_owned()))
        };
        let values = what.split(',').map(value).collect::<Result<_, String>>()?;
        Ok(Level { start: None, values, error })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_start_rules_or_values() {
        let block = Level { start: Some("Block".into()), values: Vec::new(), error: Some(12.5) };
        assert_eq!("Block@12.5".parse(), Ok(block));
        let values = vec![("detail".into(), "0".into()), ("roof".into(), "flat".into())];
        assert_eq!("detail=0,roof=flat".parse(), Ok(Level { start: None, values, error: None }));
        for text in ["Block@12.5", "detail=0,roof=flat", "Block"] {
            assert_eq!(text.parse::<Level>().map(|level| level.to_string()), Ok(text.to_owned()));
        }
        for wrong in ["", "@3", "Block@x", "Block@0", "a=1,b"] {
            assert!(wrong.parse::<Level>().is_err(), "{wrong}");
        }
    }
}
