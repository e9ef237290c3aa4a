//! The rows of a campaign as a Parquet file, by the crate `parquet`.
//!
//! Each column is optional: a run without a result has its reason in the column `failed`, and nothing in the others.

use crate::campaign::{Campaign, Column, Type, Value};
use crate::error::Error;
use crate::file::Table;
use crate::row::{FAILED, Row};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type as Schema;
use std::fs::File;
use std::path::Path;
use std::sync::Arc;

/// Rows of a group.
const GROUP: usize = 100_000;

/// Writes all rows, by seed, with the file's header in the metadata `bessemer-campaign`.
pub fn write(campaign: &dyn Campaign, table: &Table, path: &Path) -> Result<(), Error> {
    let failed = |error: ParquetError| Error::File {
        path: path.to_owned(),
        source: std::io::Error::other(error),
    };
    let file = File::create(path).map_err(Error::file(path))?;
    let header = crate::file::Header::of(campaign)?.lines();
    write_to(campaign, table, file, &header).map_err(failed)
}

fn write_to(
    campaign: &dyn Campaign,
    table: &Table,
    file: File,
    header: &str,
) -> Result<(), ParquetError> {
    let columns = campaign.columns();
    let mut fields = vec![field("seed", Physical::INT64, None, Repetition::REQUIRED)?];
    for Column { name, values, .. } in &columns {
        fields.push(match values {
            Type::Number => field(name, Physical::DOUBLE, None, Repetition::OPTIONAL)?,
            Type::Truth => field(name, Physical::BOOLEAN, None, Repetition::OPTIONAL)?,
            Type::Text => text(name)?,
        });
    }
    fields.push(text(FAILED)?);
    let schema = Schema::group_type_builder("campaign").with_fields(fields).build()?;
    let json = header.lines().next().unwrap_or_default().trim_start_matches(['#', ' ']);
    let note = KeyValue { key: "bessemer-campaign".to_owned(), value: Some(json.to_owned()) };
    let properties = WriterProperties::builder().set_key_value_metadata(Some(vec![note])).build();
    let mut writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))?;
    let rows: Vec<&Row> = table.rows.values().collect();
    for rows in rows.chunks(GROUP) {
        let mut group = writer.next_row_group()?;
        // Parquet's whole numbers are signed; a seed keeps its bits.
        let seeds = rows.iter().map(|row| Some(row.seed as i64));
        column::<Int64Type>(&mut group, seeds, false)?;
        for (at, it) in columns.iter().enumerate() {
            let values =
                rows.iter().map(|row| row.result.as_ref().ok().and_then(|all| all.get(at)));
            match it.values {
                Type::Number => {
                    let each = values.map(|value| match value {
                        Some(Value::Number(number)) => Some(*number),
                        _ => None,
                    });
                    column::<DoubleType>(&mut group, each, true)?;
                }
                Type::Truth => {
                    let each = values.map(|value| match value {
                        Some(Value::Truth(truth)) => Some(*truth),
                        _ => None,
                    });
                    column::<BoolType>(&mut group, each, true)?;
                }
                Type::Text => {
                    let each = values.map(|value| match value {
                        Some(Value::Text(text)) => Some(ByteArray::from(text.as_str())),
                        _ => None,
                    });
                    column::<ByteArrayType>(&mut group, each, true)?;
                }
            }
        }
        let reasons =
            rows.iter().map(|row| row.result.as_ref().err().map(|it| ByteArray::from(it.as_str())));
        column::<ByteArrayType>(&mut group, reasons, true)?;
        group.close()?;
    }
    writer.close()?;
    Ok(())
}

fn field(
    name: &str,
    physical: Physical,
    logical: Option<LogicalType>,
    repetition: Repetition,
) -> Result<Arc<Schema>, ParquetError> {
    let field = Schema::primitive_type_builder(name, physical);
    Ok(Arc::new(field.with_logical_type(logical).with_repetition(repetition).build()?))
}

fn text(name: &str) -> Result<Arc<Schema>, ParquetError> {
    field(name, Physical::BYTE_ARRAY, Some(LogicalType::String), Repetition::OPTIONAL)
}

fn column<T: DataType>(
    group: &mut SerializedRowGroupWriter<'_, File>,
    values: impl Iterator<Item = Option<T::T>>,
    is_optional: bool,
) -> Result<(), ParquetError> {
    let values: Vec<Option<T::T>> = values.collect();
    let levels: Vec<i16> = values.iter().map(|it| i16::from(it.is_some())).collect();
    let values: Vec<T::T> = values.into_iter().flatten().collect();
    let Some(mut writer) = group.next_column()? else {
        return Err(ParquetError::General("a column is missing in the schema".to_owned()));
    };
    writer.typed::<T>().write_batch(&values, is_optional.then_some(&levels), None)?;
    writer.close()
}
