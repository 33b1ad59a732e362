//! Functions for DataFusion, the same in one process and on the client, the scheduler and the executors of Ballista.
//!
//! | function | result |
//! |---|---|
//! | `cga_lots(work, geometry, columns)` | the lots of a row: a list of `{cell, key, low, high, bytes, class, west, north, east, south, footprint}` |
//! | `cga_failures(work, geometry, columns)` | writes the problems of a batch of rows; a list of `{name, lines, lost}`: its file, in the first row |
//! | `cga_building(work, geometry, columns)` | `{glb, reason}`: the building of a row, or the reason why it has none |
//! | `cga_units(plan, key, class)` | the numbers of the units that read a lot: its own one, and others whose rules may find it |
//! | `cga_tile(plan, unit, array_agg(footprint))` | makes the tiles of a unit; the number of its buildings |
//!
//! `work` and `plan` are addresses of files in the store; see [`work`](crate::work) and [`plan`](crate::plan). Each is one text for all rows.
//! `columns` is a group with the columns that the rules use, as in `named_struct('height', "HOEHE")`. Arguments of other types are refused.
//! A process reads the assets of a work when it loads it; `cga_tile` reads them again if the plan was made with others.

use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

use async_trait::async_trait;
use cga_city::area::Area;
use cga_city::build::NoProgress;
use cga_city::cell::DEEPEST;
use cga_city::content::{Form, content};
use cga_city::units::failed_rows::FailedRows;
use cga_city::units::lot::{Sums, UnitLot};
use cga_city::units::make::{UnitLots, UnitMaker};
use cga_city::units::plan::counted;
use cga_geo::frame::Frame;
use cga_geo::reader::arrow::Rows;
use cga_geo::survey::Survey;
use datafusion::arrow::array::{
    Array, ArrayRef, AsArray, Float64Array, LargeBinaryArray, LargeBinaryBuilder, LargeListArray, ListArray,
    StringArray, StringBuilder, StructArray, UInt32Array, UInt64Array, new_empty_array,
};
use datafusion::arrow::buffer::OffsetBuffer;
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{DataType, Field, Fields, UInt32Type, UInt64Type};
use datafusion::error::{DataFusionError, Result};
use datafusion::logical_expr::async_udf::{AsyncScalarUDF, AsyncScalarUDFImpl};
use datafusion::logical_expr::{ColumnarValue, ScalarFunctionArgs, ScalarUDF, ScalarUDFImpl, Signature, Volatility};

use crate::arguments::{Argument, address, check};
use crate::plan::plan_at;
use crate::threads::threads;
use crate::work::{StoredWork, work_at};

/// All functions. The client, the scheduler and the executors register them.
pub fn functions() -> Vec<Arc<ScalarUDF>> {
    use Argument::{Address, Columns, Footprints, Geometry, Number};
    use Volatility::{Immutable, Volatile};
    let rows = |name, of: fn(&StoredWork, &Rows) -> Result<ArrayRef>, volatility, kind: fn() -> DataType| {
        Function::of_batch(name, &[Address, Geometry, Columns], volatility, kind, move |args| {
            let work = work_at(&address(&args[0])?).map_err(failed)?;
            let columns = args[2].as_struct_opt().ok_or_else(|| failed("the columns are not a group".to_owned()))?;
            of(&work, &Rows::new(&args[1], columns).map_err(failed)?)
        })
    };
    vec![
        rows("cga_lots", lots, Immutable, || list_of(lot_fields())),
        rows("cga_failures", failures, Volatile, || list_of(failure_fields())),
        rows("cga_building", buildings, Immutable, || DataType::Struct(building_fields())),
        Function::of_batch("cga_units", &[Address, Number, Number], Immutable, unit_list, units),
        Function::waiting("cga_tile", &[Address, Number, Footprints], || DataType::UInt64, tiles),
    ]
}

/// A function from columns to a column.
type Body = dyn Fn(&[ArrayRef]) -> Result<ArrayRef> + Send + Sync;

/// A function of this crate. Equal names are equal functions.
struct Function {
    name: &'static str,
    arguments: &'static [Argument],
    signature: Signature,
    kind: fn() -> DataType,
    body: Arc<Body>,
}

impl Function {
    /// A function that gets a batch of rows at a time, on the thread of its query.
    fn of_batch(
        name: &'static str,
        arguments: &'static [Argument],
        volatility: Volatility,
        kind: fn() -> DataType,
        body: impl Fn(&[ArrayRef]) -> Result<ArrayRef> + Send + Sync + 'static,
    ) -> Arc<ScalarUDF> {
        let signature = Signature::any(arguments.len(), volatility);
        Arc::new(ScalarUDF::from(Function { name, arguments, signature, kind, body: Arc::new(body) }))
    }

    /// A function that writes to the store and gets one row at a time. Others run while it works.
    fn waiting(
        name: &'static str,
        arguments: &'static [Argument],
        kind: fn() -> DataType,
        body: fn(&[ArrayRef]) -> Result<ArrayRef>,
    ) -> Arc<ScalarUDF> {
        let signature = Signature::any(arguments.len(), Volatility::Volatile);
        let function = Function { name, arguments, signature, kind, body: Arc::new(body) };
        Arc::new(AsyncScalarUDF::new(Arc::new(function)).into_scalar_udf())
    }
}

impl fmt::Debug for Function {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

impl PartialEq for Function {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Function {}

impl Hash for Function {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}

impl ScalarUDFImpl for Function {
    fn name(&self) -> &str {
        self.name
    }

    fn signature(&self) -> &Signature {
        &self.signature
    }

    fn return_type(&self, kinds: &[DataType]) -> Result<DataType> {
        check(self.name, self.arguments, kinds)?;
        Ok((self.kind)())
    }

    fn invoke_with_args(&self, args: ScalarFunctionArgs) -> Result<ColumnarValue> {
        if args.number_rows == 0 {
            return Ok(ColumnarValue::Array(new_empty_array(&(self.kind)())));
        }
        let mut columns = args.args;
        // An address that is written in the query needs no row for each of its rows.
        if let Some(ColumnarValue::Scalar(first)) = columns.first() {
            columns[0] = ColumnarValue::Array(first.to_array()?);
        }
        let others = columns.split_off(1);
        let columns = columns.into_iter().map(|first| first.into_array(1));
        let others = others.into_iter().map(|column| column.into_array(args.number_rows));
        let columns = columns.chain(others).collect::<Result<Vec<_>>>()?;
        (self.body)(&columns).map(ColumnarValue::Array)
    }
}

#[async_trait]
impl AsyncScalarUDFImpl for Function {
    fn ideal_batch_size(&self) -> Option<usize> {
        Some(1)
    }

    async fn invoke_async_with_args(&self, args: ScalarFunctionArgs) -> Result<ColumnarValue> {
        if args.number_rows == 0 {
            return Ok(ColumnarValue::Array(new_empty_array(&(self.kind)())));
        }
        let columns = ColumnarValue::values_to_arrays(&args.args)?;
        let body = self.body.clone();
        let made = tokio::task::spawn_blocking(move || body(&columns)).await;
        made.map_err(|why| failed(why.to_string()))?.map(ColumnarValue::Array)
    }
}

fn failed(why: String) -> DataFusionError {
    DataFusionError::Execution(why)
}

fn fields<const N: usize>(fields: [(&str, DataType); N]) -> Fields {
    fields.into_iter().map(|(name, kind)| Field::new(name, kind, true)).collect()
}

fn lot_fields() -> Fields {
    let field = |kind: DataType| move |name| Field::new(name, kind.clone(), true);
    let numbers = ["cell", "key", "low", "high", "bytes", "class"].map(field(DataType::UInt64));
    let sides = ["west", "north", "east", "south"].map(field(DataType::Float64));
    numbers.into_iter().chain(sides).chain(["footprint"].map(field(DataType::LargeBinary))).collect()
}

fn unit_list() -> DataType {
    DataType::List(unit_item())
}

fn unit_item() -> Arc<Field> {
    Arc::new(Field::new_list_field(DataType::UInt32, true))
}

fn failure_fields() -> Fields {
    fields([("name", DataType::Utf8), ("lines", DataType::UInt64), ("lost", DataType::UInt64)])
}

fn building_fields() -> Fields {
    fields([("glb", DataType::LargeBinary), ("reason", DataType::Utf8)])
}

fn item(fields: Fields) -> Arc<Field> {
    Arc::new(Field::new_list_field(DataType::Struct(fields), true))
}

fn list_of(fields: Fields) -> DataType {
    DataType::List(item(fields))
}

/// A list for each row: its length, and the columns of all members.
fn list(fields: Fields, lengths: Vec<usize>, columns: Vec<ArrayRef>) -> Result<ArrayRef> {
    let members = StructArray::try_new(fields.clone(), columns, None)?;
    Ok(Arc::new(ListArray::try_new(item(fields), OffsetBuffer::from_lengths(lengths), Arc::new(members), None)?))
}

fn lots(work: &StoredWork, rows: &Rows) -> Result<ArrayRef> {
    let surveyor = work.loaded.surveyor().map_err(failed)?;
    let (mut lengths, mut bytes) = (Vec::new(), LargeBinaryBuilder::new());
    let (mut numbers, mut sides) = ([const { Vec::new() }; 6], [const { Vec::new() }; 4]);
    for at in 0..rows.len() {
        let footprints = surveyor.survey(rows.row(at)).footprints;
        lengths.push(footprints.len());
        for footprint in footprints {
            let UnitLot { key, class, sums, area, bytes: own } = UnitLot::new(&footprint, &work.loaded);
            let Sums { digests: [low, high], bytes: count, .. } = sums;
            let row = [counted(key), key, low, high, count, class.into()];
            numbers.iter_mut().zip(row).for_each(|(column, number)| column.push(number));
            let area = area.map(|Area { low: [west, north], high: [east, south] }| [west, north, east, south]);
            sides.iter_mut().enumerate().for_each(|(side, column)| column.push(area.map(|area| area[side])));
            bytes.append_value(own);
        }
    }
    let numbers = numbers.map(|column| Arc::new(UInt64Array::from(column)) as ArrayRef);
    let sides = sides.map(|column| Arc::new(Float64Array::from(column)) as ArrayRef);
    let columns = numbers.into_iter().chain(sides).chain([Arc::new(bytes.finish()) as ArrayRef]);
    list(lot_fields(), lengths, columns.collect())
}

/// Writes a part of the table of rows that failed. Its name follows from the rows of the batch, so a batch that is read twice has one file.
fn failures(work: &StoredWork, rows: &Rows) -> Result<ArrayRef> {
    let (surveyor, mut table) = (work.loaded.surveyor().map_err(failed)?, FailedRows::default());
    for (wkb, row) in rows.iter() {
        table.survey(&surveyor, wkb, row);
    }
    let part = table.write(&work.store).map_err(failed)?;
    let mut lengths = vec![0; rows.len()];
    if let (Some(first), Some(_)) = (lengths.first_mut(), &part) {
        *first = 1;
    }
    let names: StringArray = part.iter().map(|part| Some(&part.name)).collect();
    let lines: UInt64Array = part.iter().map(|part| Some(part.lines)).collect();
    let lost: UInt64Array = part.iter().map(|part| Some(part.lost)).collect();
    list(failure_fields(), lengths, vec![Arc::new(names), Arc::new(lines), Arc::new(lost)])
}

fn buildings(work: &StoredWork, rows: &Rows) -> Result<ArrayRef> {
    let (surveyor, threads) = (work.loaded.surveyor().map_err(failed)?, threads(0).map_err(failed)?);
    let (mut files, mut reasons) = (LargeBinaryBuilder::new(), StringBuilder::new());
    for at in 0..rows.len() {
        let Survey { footprints, problems } = surveyor.survey(rows.row(at));
        let mut why: Vec<String> = problems.into_iter().map(|problem| problem.reason).collect();
        // Positions are in metres around the first polygon.
        let made = footprints.first().and_then(|first| {
            let (frame, level) = (Frame::at(first.middle()), &work.loaded.levels[0]);
            let form = Form { shares_images: false, ..level.form(u64::MAX) };
            threads.install(|| content(&footprints, None, &frame, &level.rules, form))
        });
        let glb = made.and_then(|made| {
            why.extend(made.problems.into_iter().map(|problem| problem.reason));
            (!made.glb.is_empty()).then_some(made.glb)
        });
        if glb.is_none() && why.is_empty() {
            why.push("the rules make no face".to_owned());
        }
        files.append_option(glb);
        reasons.append_option((!why.is_empty()).then(|| why.join("; ")));
    }
    let columns: Vec<ArrayRef> = vec![Arc::new(files.finish()), Arc::new(reasons.finish())];
    Ok(Arc::new(StructArray::try_new(building_fields(), columns, None)?))
}

fn units(args: &[ArrayRef]) -> Result<ArrayRef> {
    let plan = plan_at(&address(&args[0])?).map_err(failed)?;
    let [keys, classes] = [cast(&args[1], &DataType::UInt64)?, cast(&args[2], &DataType::UInt64)?];
    let (keys, classes) = (keys.as_primitive::<UInt64Type>(), classes.as_primitive::<UInt64Type>());
    let (mut lengths, mut units) = (Vec::with_capacity(keys.len()), Vec::with_capacity(keys.len()));
    for (key, class) in keys.iter().zip(classes) {
        // A class that is not known has the largest footprints.
        let class = class.map_or(u8::MAX, |class| class.min(u8::MAX.into()) as u8).min(DEEPEST as u8);
        let before = units.len();
        units.extend(key.into_iter().flat_map(|key| plan.index.units(key, class)).map(|unit| unit as u32));
        lengths.push(units.len() - before);
    }
    let (offsets, units) = (OffsetBuffer::from_lengths(lengths), Arc::new(UInt32Array::from(units)));
    Ok(Arc::new(ListArray::try_new(unit_item(), offsets, units, None)?))
}

/// The members of a list in a row.
fn members(column: &ArrayRef, row: usize) -> Result<ArrayRef> {
    if let Some(lists) = column.as_any().downcast_ref::<LargeListArray>() {
        return Ok(lists.value(row));
    }
    let lists = column.as_list_opt::<i32>().ok_or_else(|| failed("the footprints are not a list".to_owned()))?;
    Ok(lists.value(row))
}

fn tiles(args: &[ArrayRef]) -> Result<ArrayRef> {
    let plan = plan_at(&address(&args[0])?).map_err(failed)?;
    let units = cast(&args[1], &DataType::UInt32)?;
    let tile = |(row, unit): (usize, Option<u32>)| {
        let unit = unit.and_then(|unit| plan.index.plan.units.get(unit as usize));
        let unit = unit.ok_or_else(|| failed("the plan has no such unit".to_owned()))?;
        let footprints: LargeBinaryArray = cast(&members(&args[2], row)?, &DataType::LargeBinary)?.as_binary().clone();
        let lots = UnitLots::new(unit, footprints.iter().flatten()).map_err(failed)?;
        let (work, store) = (&plan.work.loaded, &plan.work.store);
        let maker = UnitMaker { work, store, threads: threads(0).map_err(failed)?, progress: &NoProgress };
        let made = maker.make(unit, &lots).map_err(failed)?;
        Ok(made.tally.levels.first().map_or(0, |near| near.buildings))
    };
    let made = units.as_primitive::<UInt32Type>().iter().enumerate().map(tile);
    Ok(Arc::new(UInt64Array::from(made.collect::<Result<Vec<u64>>>()?)))
}
