//! A flight log as its readers give it: topics with named fields, and the samples of those topics that are wanted.
//!
//! Must not know: formats of files, and what a sample becomes.

use super::bytes::{Kind, Number};

/// A log.
#[derive(Default)]
pub(super) struct Log {
    pub topics: Vec<Topic>,
    /// Notes for the reader of the result: what was skipped or cut.
    pub notes: Vec<String>,
}

/// Messages of one kind, from one of its instances.
pub(super) struct Topic {
    /// Name of the topic; the second instance and later ones have their number behind it: `sensor_gyro[1]`.
    pub name: String,
    pub fields: Vec<Field>,
    /// The field that holds the time in microseconds, if there is one.
    pub time: Option<usize>,
    /// Number of its samples in the file, wanted or not.
    pub count: usize,
    pub samples: Vec<Sample>,
}

/// A number in each sample of a topic.
pub(super) struct Field {
    /// Name of the field: `accelerometer_m_s2[0]`, `esc[1].rpm`.
    pub name: String,
    pub kind: Kind,
}

/// Values of all fields at one time.
pub(super) struct Sample {
    pub numbers: Vec<Number>,
}

impl Field {
    /// Returns true for a field that only fills a gap.
    pub fn is_padding(&self) -> bool {
        self.name.rsplit('.').next().is_some_and(|it| it.starts_with("_padding"))
    }
}

impl Topic {
    /// A topic without samples; `time` names the field that holds the time.
    pub fn new(name: &str, instance: usize, fields: Vec<Field>, time: &str) -> Topic {
        let time = fields.iter().position(|field| field.name == time);
        Topic { name: named(name, instance), fields, time, count: 0, samples: Vec::new() }
    }
}

/// The name of an instance of a topic.
fn named(name: &str, instance: usize) -> String {
    match instance {
        0 => name.to_owned(),
        _ => format!("{name}[{instance}]"),
    }
}
