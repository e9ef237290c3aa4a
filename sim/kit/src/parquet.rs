//! Recordings as Parquet files, which DuckDB and pandas read, by the crate `parquet`.
//!
//! The column `time_ns` has the times; each channel is an optional column of its name. Its unit is in the file's metadata
//! under `unit.` and that name.

use std::sync::Arc;

use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::{DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type as Schema;

use crate::error::Error;
use crate::recording::Recording;

/// Name of the column with the times.
const TIME: &str = "time_ns";

/// Rows of a group: a reader needs a few megabytes for each.
const GROUP: usize = 100_000;

impl Recording {
    /// Formats the recording as a Parquet file: a row for each time, as in [`csv`](Recording::csv).
    ///
    /// The column `time_ns` has whole nanoseconds, the others have the bits of their channels; a cell is null if its channel has no
    /// sample at that time.
    ///
    /// # Errors
    ///
    /// A channel has the name `time_ns`, or the writer fails.
    pub fn parquet(&self) -> Result<Vec<u8>, Error> {
        if self.channel(TIME).is_ok() {
            return Err(Error::Twice { name: TIME.to_owned() });
        }
        self.table().map_err(|error| Error::Write(error.to_string()))
    }

    fn table(&self) -> Result<Vec<u8>, ParquetError> {
        let field = |name: &str, physical, repetition| {
            let field = Schema::primitive_type_builder(name, physical);
            field.with_repetition(repetition).build().map(Arc::new)
        };
        let mut fields = vec![field(TIME, Physical::INT64, Repetition::REQUIRED)?];
        let mut units = Vec::new();
        for channel in self.channels() {
            fields.push(field(channel.name(), Physical::DOUBLE, Repetition::OPTIONAL)?);
            let key = format!("unit.{}", channel.name());
            units.push(KeyValue { key, value: Some(channel.unit().to_owned()) });
        }
        let schema = Schema::group_type_builder("recording").with_fields(fields).build()?;
        let properties = WriterProperties::builder().set_key_value_metadata(Some(units)).build();
        let mut bytes = Vec::new();
        let mut writer =
            SerializedFileWriter::new(&mut bytes, Arc::new(schema), Arc::new(properties))?;
        let missing = || ParquetError::General("a column is missing in the schema".to_owned());
        let rows: Vec<(u64, Vec<Option<f64>>)> = self.rows().collect();
        for rows in rows.chunks(GROUP) {
            let mut group = writer.next_row_group()?;
            let times: Vec<i64> = rows.iter().map(|(time, _)| *time as i64).collect();
            let mut column = group.next_column()?.ok_or_else(missing)?;
            column.typed::<Int64Type>().write_batch(&times, None, None)?;
            column.close()?;
            for index in 0..self.channels().len() {
                let samples = rows.iter().map(|(_, samples)| samples.get(index).copied().flatten());
                let levels: Vec<i16> =
                    samples.clone().map(|sample| i16::from(sample.is_some())).collect();
                let values: Vec<f64> = samples.flatten().collect();
                let mut column = group.next_column()?.ok_or_else(missing)?;
                column.typed::<DoubleType>().write_batch(&values, Some(&levels), None)?;
                column.close()?;
            }
            group.close()?;
        }
        writer.close()?;
        Ok(bytes)
    }
}
