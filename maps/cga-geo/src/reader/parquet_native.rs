//! Polygons of GeoParquet in lists of coordinates, the native encodings `polygon` and `multipolygon`: columns of x, y and z in place of WKB.

use std::fs::File;
use std::path::Path;

use parquet::basic::{Repetition, Type as Physical};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::DoubleType;
use parquet::file::reader::{FileReader as _, SerializedFileReader};
use parquet::schema::types::{SchemaDescriptor, Type};

use crate::outline::Outline;
use crate::row::{MOST_CORNERS, too_many_corners};

/// The polygons of the rows of a file, one row after another.
pub(super) struct NativePolygons {
    reader: SerializedFileReader<File>,
    shape: Lists,
    /// The numbers of the columns of x, y and, if there are heights, z.
    columns: Vec<usize>,
    /// The number of the next group of rows.
    next: usize,
    group: Vec<Coordinates>,
}

/// The lists around a corner.
struct Lists {
    /// The definition level from which a row is not null.
    row: i16,
    /// The definition levels from which the lists have an element, from the outermost list to the innermost.
    elements: Vec<i16>,
}

/// A column of coordinates in a group of rows, and its numbers of one row.
struct Coordinates {
    reader: ColumnReaderImpl<DoubleType>,
    /// The definition level of a number.
    number: i16,
    definitions: Vec<i16>,
    repetitions: Vec<i16>,
    values: Vec<f64>,
}

impl NativePolygons {
    /// Opens the column `geometry` of a file; `lists` is 2 for polygons and 3 for multipolygons.
    ///
    /// # Errors
    /// The file cannot be read, or the column is not made of such lists.
    pub(super) fn open(path: &Path, geometry: &str, lists: usize) -> Result<Self, String> {
        let file = File::open(path).map_err(|why| why.to_string())?;
        let reader = SerializedFileReader::new(file).map_err(|why| format!("it is not Parquet: {why}"))?;
        let schema = reader.metadata().file_metadata().schema_descr();
        let column = |name: &str| column(schema, geometry, name);
        let wrong = || format!("its column `{geometry}` is not made of {lists} lists of x and y in 64 bits");
        let (x, y) = column("x").zip(column("y")).ok_or_else(wrong)?;
        let shape = Lists::of(schema, geometry, x).filter(|shape| shape.elements.len() == lists).ok_or_else(wrong)?;
        let columns = [Some(x), Some(y), column("z")].into_iter().flatten().collect();
        Ok(NativePolygons { reader, shape, columns, next: 0, group: Vec::new() })
    }

    /// The polygons of the next row, or the reason why it has none.
    ///
    /// # Errors
    /// The file is damaged: further rows cannot be read.
    pub(super) fn next_row(&mut self) -> Result<Result<Vec<Outline>, String>, String> {
        loop {
            let mut is_read = !self.group.is_empty();
            for coordinates in &mut self.group {
                is_read &= coordinates.read()?;
            }
            if is_read {
                return self.shape.outlines(&self.group);
            }
            if self.reader.num_row_groups() <= self.next {
                return Err("further geometries are missing".to_owned());
            }
            let group = self.reader.get_row_group(self.next).map_err(|why| why.to_string())?;
            self.next += 1;
            let open = |column: &usize| match group.get_column_reader(*column).map_err(|why| why.to_string())? {
                ColumnReader::DoubleColumnReader(reader) => {
                    let number = group.metadata().column(*column).column_descr().max_def_level();
                    let (definitions, repetitions, values) = (Vec::new(), Vec::new(), Vec::new());
                    Ok(Coordinates { reader, number, definitions, repetitions, values })
                }
                _ => Err("its coordinates are not numbers of 64 bits".to_owned()),
            };
            self.group = self.columns.iter().map(open).collect::<Result<_, _>>()?;
        }
    }
}

/// The number of a column of coordinates below the column of geometries.
fn column(schema: &SchemaDescriptor, geometry: &str, name: &str) -> Option<usize> {
    let is_own = |parts: &[String]| {
        parts.first().is_some_and(|first| first == geometry) && parts.last().is_some_and(|last| last == name)
    };
    let is_own = |at: &usize| is_own(schema.column(*at).path().parts());
    let at = (0..schema.num_columns()).find(is_own)?;
    (schema.column(at).physical_type() == Physical::DOUBLE).then_some(at)
}

impl Lists {
    fn of(schema: &SchemaDescriptor, geometry: &str, column: usize) -> Option<Self> {
        let root = schema.root_schema().get_fields().iter().find(|field| field.name() == geometry)?;
        let (mut level, mut elements) = (0, Vec::new());
        let mut count = |field: &Type| match field.get_basic_info().repetition() {
            Repetition::REQUIRED => level,
            Repetition::OPTIONAL => {
                level += 1;
                level
            }
            Repetition::REPEATED => {
                level += 1;
                elements.push(level);
                level
            }
        };
        let row = count(root);
        let mut field = root.clone();
        for name in &schema.column(column).path().parts()[1..] {
            let inner =
                field.is_group().then(|| field.get_fields().iter().find(|inner| inner.name() == name))??.clone();
            count(&inner);
            field = inner;
        }
        Some(Lists { row, elements })
    }

    /// The polygons of a row, or the reason why it has none.
    ///
    /// # Errors
    /// The columns of coordinates do not fit together.
    fn outlines(&self, group: &[Coordinates]) -> Result<Result<Vec<Outline>, String>, String> {
        let [x, y, ..] = group else { return Err("its coordinates are missing".to_owned()) };
        let is_alike =
            |other: &Coordinates| other.repetitions == x.repetitions && other.definitions.len() == x.definitions.len();
        if !group.iter().all(is_alike) {
            return Err("its columns of coordinates have different lists".to_owned());
        }
        let corners = x.definitions.len();
        if MOST_CORNERS < corners {
            return Ok(Err(too_many_corners(corners)));
        }
        if x.definitions.first().is_none_or(|level| *level < self.row) {
            return Ok(Err("it has no geometry".to_owned()));
        }
        let lists = self.elements.len() as i16;
        let mut outlines: Vec<Outline> = Vec::new();
        let [mut xs, mut ys] = [x, y].map(|column| column.values.iter());
        let mut zs = group.get(2).map(|column| (column, column.values.iter()));
        for (number, (definition, repetition)) in x.definitions.iter().zip(&x.repetitions).enumerate() {
            // The last list has corners, the one around it rings. Polygons are a list around both, or the row is one.
            let has_polygon = lists < 3 || self.elements[0] <= *definition;
            if has_polygon && *repetition <= lists - 2 {
                outlines.push(Outline::default());
            }
            let z = zs.as_mut().and_then(|(column, values)| column.has_number(number).then(|| values.next())?);
            let Some(outline) = outlines.last_mut() else { continue };
            if self.elements[lists as usize - 2] <= *definition && *repetition < lists {
                outline.rings.push(Vec::new());
            }
            if *definition < self.elements[lists as usize - 1] {
                continue;
            }
            let corner = (x.has_number(number) && y.has_number(number)).then(|| xs.next().zip(ys.next())).flatten();
            let Some((x, y)) = corner else { return Ok(Err("a corner has no coordinates".to_owned())) };
            if let Some(ring) = outline.rings.last_mut() {
                ring.push([*x, *y]);
            }
            if outline.rings.len() == 1 {
                z.into_iter().for_each(|z| outline.lower_to(*z));
            }
        }
        Ok(Ok(outlines))
    }
}

impl Coordinates {
    /// Returns true if a corner of the row has a number.
    fn has_number(&self, corner: usize) -> bool {
        self.definitions[corner] == self.number
    }

    /// Reads the numbers of the next row. Returns false at the end of the group.
    fn read(&mut self) -> Result<bool, String> {
        let Coordinates { reader, definitions, repetitions, values, .. } = self;
        definitions.clear();
        repetitions.clear();
        values.clear();
        let read = reader.read_records(1, Some(definitions), Some(repetitions), values);
        Ok(read.map_err(|why| why.to_string())?.0 == 1)
    }
}
