//! Errors of flight logs and of their mapping to an entry point, each with its place, what there is, and a remedy.

/// Error of a flight log or of the table that maps it.
#[derive(Debug, thiserror::Error)]
pub enum Wrong {
    /// The file is damaged, or of a kind that is not read.
    #[error("byte {at}: {said}")]
    Damaged {
        /// Offset in the file.
        at: usize,
        /// The defect.
        said: String,
    },
    /// No table of `bessemer.toml` maps the entry point.
    #[error(
        "bessemer.toml has no table `[inputs.{entry}]`, which maps the topics {topics} to {wanted}"
    )]
    NoTable {
        /// Name of the entry point in the C.
        entry: String,
        /// Topics of the log.
        topics: String,
        /// Parameters of the entry point.
        wanted: String,
    },
    /// A table maps an entry point that there is not.
    #[error("{place}: `[inputs.{name}]` is of no entry point; there are {known}")]
    NoEntry {
        /// Line of `bessemer.toml`.
        place: String,
        /// Name of the table.
        name: String,
        /// Names of entry points.
        known: String,
    },
    /// The period of the entry point is not set.
    #[error("bessemer.toml does not set the period of `{entry}`, to which the log is resampled")]
    NoPeriod {
        /// Name of the entry point in the C.
        entry: String,
    },
    /// A key of the table is no parameter.
    #[error("{place}: the entry point takes no `{target}`; it takes {known}")]
    Parameter {
        /// Line of `bessemer.toml`.
        place: String,
        /// The key.
        target: String,
        /// Names that it takes.
        known: String,
    },
    /// Two keys map one number.
    #[error("{place}: `{column}` is mapped already")]
    Twice {
        /// Line of `bessemer.toml`.
        place: String,
        /// The number.
        column: String,
    },
    /// No key maps a number, whose parameter has no defaults.
    #[error("`[inputs.{entry}]` does not map `{column}`")]
    Unmapped {
        /// Name of the table.
        entry: String,
        /// The first such number.
        column: String,
    },
    /// The log has no such topic.
    #[error("{place}: the log has no topic `{topic}`; it has {known}")]
    Topic {
        /// Line of `bessemer.toml`.
        place: String,
        /// The topic that is mapped.
        topic: String,
        /// Topics of the log.
        known: String,
    },
    /// A topic has no such field.
    #[error("{place}: `{topic}` has no field `{field}`; it has {known}")]
    Field {
        /// Line of `bessemer.toml`.
        place: String,
        /// The topic.
        topic: String,
        /// The field that is mapped.
        field: String,
        /// Fields of the topic.
        known: String,
    },
    /// A source has another number of numbers than its parameter.
    #[error("{place}: `{target}` takes {wanted} numbers, and {origin} has {found}")]
    Length {
        /// Line of `bessemer.toml`.
        place: String,
        /// The parameter.
        target: String,
        /// Numbers that it takes.
        wanted: usize,
        /// The source.
        origin: String,
        /// Numbers that the source has.
        found: usize,
    },
    /// The log has a topic's description and no sample.
    #[error("{place}: `{topic}` has no samples in this log")]
    NoSamples {
        /// Line of `bessemer.toml`.
        place: String,
        /// The topic.
        topic: String,
    },
    /// Samples of a topic have no time.
    #[error("{place}: the samples of `{topic}` have no time; its fields are {known}")]
    NoTime {
        /// Line of `bessemer.toml`.
        place: String,
        /// The topic.
        topic: String,
        /// Fields of the topic.
        known: String,
    },
    /// The time of a topic goes back.
    #[error("sample {sample} of `{topic}` is of {time} µs, and the one before of {before} µs")]
    Back {
        /// The topic.
        topic: String,
        /// Number of the sample, from 1.
        sample: usize,
        /// Time of the sample, µs.
        time: i128,
        /// Time of the sample before.
        before: i128,
    },
    /// The table maps no topic.
    #[error("`[inputs.{entry}]` maps no topic of the log; it has {known}")]
    Nothing {
        /// Name of the table.
        entry: String,
        /// Topics of the log.
        known: String,
    },
    /// The log is too long for its period.
    #[error("from {from} to {to} µs there are {calls} periods, more than {most}")]
    Long {
        /// Time of the first call, µs.
        from: i128,
        /// Time of the last sample, µs.
        to: i128,
        /// Number of calls.
        calls: i128,
        /// Most calls.
        most: i128,
    },
}

impl Wrong {
    /// A defect of the file at a place of it.
    pub fn damaged(at: usize, said: &str) -> Wrong {
        Wrong::Damaged { at, said: said.to_owned() }
    }

    /// A step that resolves the error.
    pub fn remedy(&self) -> String {
        match self {
            Wrong::Damaged { .. } => "load the log from the vehicle once more".to_owned(),
            Wrong::NoTable { entry, .. } => {
                format!(
                    "write `[inputs.{entry}]`, below it a line for each: `speed = \"topic.field\"`"
                )
            }
            Wrong::NoEntry { .. } => "name the table after an entry point".to_owned(),
            Wrong::NoPeriod { entry } => {
                format!(
                    "write `[periods]`, below it the seconds between two calls: `{entry} = 0.004`"
                )
            }
            Wrong::Parameter { .. } => "write one of these names".to_owned(),
            Wrong::Twice { .. } => "remove one of the two keys".to_owned(),
            Wrong::Unmapped { column, .. } => {
                format!("write `{column} = \"topic.field\"`, or a number that it always is")
            }
            Wrong::Topic { .. } => "write one of these topics, or log this one".to_owned(),
            Wrong::Field { .. } => "write one of these fields".to_owned(),
            Wrong::Length { target, .. } => {
                format!(
                    "write a list with a source for each number: `{target} = [\"topic.x\", \"topic.y\"]`"
                )
            }
            Wrong::NoSamples { .. } => "log this topic, or map another".to_owned(),
            Wrong::NoTime { .. } => "map a topic whose samples have a time".to_owned(),
            Wrong::Back { .. } => {
                "cut the log where the clock was set back, and verify its parts".to_owned()
            }
            Wrong::Nothing { .. } => {
                "map at least one parameter to a field: `speed = \"topic.field\"`".to_owned()
            }
            Wrong::Long { .. } => {
                "is the period in seconds? else cut the log where its time jumps".to_owned()
            }
        }
    }
}
