//! Reports for `serde`: what the methods of the types return.

use serde::Serialize;
use serde::ser::{SerializeStruct, Serializer};

use super::{Collection, Report, Reports, Summary};

/// The fields, and the results of the methods.
impl Serialize for Report {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut row = serializer.serialize_struct("Report", 8)?;
        row.serialize_field("shapes", &self.shapes)?;
        row.serialize_field("leaves", &self.leaves)?;
        row.serialize_field("faults", &self.faults)?;
        row.serialize_field("faults_left_out", &self.faults_left_out)?;
        row.serialize_field("stopped", &self.stopped)?;
        row.serialize_field("reports", &self.reports)?;
        row.serialize_field("prints", &self.prints)?;
        row.serialize_field("prints_left_out", &self.prints_left_out())?;
        row.end()
    }
}

/// A list of collections, sorted by key.
impl Serialize for Reports {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter())
    }
}

/// The key, the type, the statistics, and for text the number of reports of each text.
impl Serialize for Collection {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut row = serializer.serialize_struct("Collection", 4)?;
        row.serialize_field("key", &self.key)?;
        row.serialize_field("type", &self.ty)?;
        row.serialize_field("summary", &self.summary)?;
        row.serialize_field("texts", &self.texts)?;
        row.end()
    }
}

/// The fields, and the extremes and the mean, which are null without numbers.
impl Serialize for Summary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut row = serializer.serialize_struct("Summary", 7)?;
        row.serialize_field("count", &self.count)?;
        row.serialize_field("nans", &self.nans)?;
        row.serialize_field("numbers", &self.numbers)?;
        row.serialize_field("sum", &self.sum)?;
        row.serialize_field("min", &self.min())?;
        row.serialize_field("max", &self.max())?;
        row.serialize_field("average", &self.average())?;
        row.end()
    }
}
