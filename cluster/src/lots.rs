//! The files of lots: their geometries and their columns.

use std::sync::Arc;

use cga_geo::missing;
use cga_geo::reader::arrow::is_binary;
use cga_geo::reader::geoparquet::Geometry;
use cga_geo::survey::Columns;
use datafusion::arrow::datatypes::SchemaRef;
use datafusion::datasource::file_format::FileFormat as _;
use datafusion::datasource::file_format::parquet::ParquetFormat;
use datafusion::datasource::listing::{ListingOptions, ListingTable, ListingTableConfig, ListingTableUrl};
use datafusion::error::Result;
use datafusion::prelude::SessionContext;
use futures::{StreamExt as _, TryStreamExt as _};
use object_store::ObjectMeta;

use crate::columns::FileColumns;
use crate::sql::{columns_of, literal};

/// The table of all lots.
pub(crate) struct Lots {
    table: Arc<ListingTable>,
    columns: FileColumns,
    pub(crate) geometry: Geometry,
}

impl Lots {
    /// Opens files and folders of GeoParquet.
    ///
    /// # Errors
    /// A sentence about a file.
    pub(crate) async fn open(context: &SessionContext, addresses: &[String]) -> Result<Self, String> {
        let unread = |why: String| format!("cannot read the lots: {why}");
        let urls = addresses.iter().map(ListingTableUrl::parse).collect::<Result<Vec<_>>>();
        let urls = urls.map_err(|why| unread(why.to_string()))?;
        let (mut geometry, mut columns): (Option<Geometry>, _) = (None, FileColumns::default());
        for url in &urls {
            let found = schemas(context, url).await.map_err(|why| unread(format!("`{url}`: {why}")))?;
            for (file, schema) in found {
                columns.add(&file, &schema);
                let own = schema.metadata().get("geo").map(String::as_str);
                let own = Geometry::of(own).and_then(|own| own.check_wkb().map(|()| own));
                let own = own.map_err(|why| unread(format!("`{file}`: {why}")))?;
                if geometry.get_or_insert_with(|| own.clone()) != &own {
                    return Err(unread(format!(
                        "`{file}` has another coordinate system or another column of geometries than the first file; make jobs of their own"
                    )));
                }
            }
        }
        let geometry = geometry.ok_or_else(|| unread(format!("`{}` has no file .parquet", addresses.join("`, `"))))?;
        // Files have members `geo` of their own.
        let format = ParquetFormat::default().with_skip_metadata(true);
        let options = ListingOptions::new(Arc::new(format)).with_file_extension(".parquet");
        // DataFusion would take the columns of the first address alone.
        let config = ListingTableConfig::new_with_multi_paths(urls).with_listing_options(options);
        let config = config.with_schema(columns.schema());
        let table = ListingTable::try_new(config).map_err(|why| unread(why.to_string()))?;
        Ok(Lots { table: Arc::new(table), columns, geometry })
    }

    /// Registers the lots as the table `lots`. The result is the call of a function over their columns, for a work.
    ///
    /// # Errors
    /// A sentence: a column that the job names does not exist.
    pub(crate) fn register(
        &self,
        context: &SessionContext,
        columns: &Columns,
        names: &[String],
        work: &str,
    ) -> Result<impl Fn(&str) -> String + use<>, String> {
        names.iter().chain([&self.geometry.column]).try_for_each(|name| self.columns.check(name))?;
        let schema = datafusion::datasource::TableProvider::schema(&*self.table);
        let found: Vec<(String, String)> = schema.fields().iter().flat_map(|field| columns_of(field)).collect();
        let has = |name: &str| found.iter().any(|(known, _)| known == name);
        if let Some((_, name)) = columns.named().find(|(_, name)| !has(name)) {
            let known = found.iter().map(|(name, _)| name.as_str()).filter(|name| *name != self.geometry.column);
            let known = missing::names(name, "the lots", "columns", known);
            return Err(format!("no file of lots has the column `{name}`; {known}"));
        }
        let Some((_, geometry)) = found.iter().find(|(name, _)| *name == self.geometry.column) else {
            return Err(format!("the lots have no column `{}`", self.geometry.column));
        };
        if let Ok(field) = schema.field_with_name(&self.geometry.column)
            && !is_binary(field.data_type())
        {
            let (name, kind) = (field.name(), field.data_type());
            return Err(format!("the column `{name}` has the type {kind}; write it as WKB, which has the type Binary"));
        }
        let used = found.iter().filter(|(name, _)| *name != self.geometry.column && names.contains(name));
        let used: Vec<String> = used.map(|(name, sql)| format!("{}, {sql}", literal(name))).collect();
        // A group has at least one member, and a member without a value is left out of the rows.
        let group = if used.is_empty() { "'none', null".to_owned() } else { used.join(", ") };
        context.register_table("lots", self.table.clone()).map_err(|why| why.to_string())?;
        let arguments = format!("{}, {geometry}, named_struct({group})", literal(work));
        Ok(move |function: &str| format!("{function}({arguments})"))
    }
}

/// The files of an address, each with its columns and its metadata.
async fn schemas(context: &SessionContext, url: &ListingTableUrl) -> Result<Vec<(String, SchemaRef)>> {
    let state = context.state();
    let store = context.runtime_env().object_store(url)?;
    let files: Vec<ObjectMeta> = url.list_all_files(&state, &*store, ".parquet").await?.try_collect().await?;
    let format = ParquetFormat::default().with_skip_metadata(false);
    let read = |file: ObjectMeta| {
        let (format, state, store) = (&format, &state, &store);
        async move {
            let schema = format.infer_schema(state, store, std::slice::from_ref(&file)).await?;
            Ok((format!("{}{}", url.object_store(), file.location), schema))
        }
    };
    futures::stream::iter(files).map(read).buffered(16).try_collect().await
}
