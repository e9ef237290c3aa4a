//! The bridge of an entry point to the topics of PX4, as `[inputs.…]` and `[outputs.…]` of `bessemer.toml` map them.
//!
//! Invariants: each number of a parameter has exactly one source; a topic is subscribed once for each entry point, and the
//! one that is mapped first triggers the call. It must not know which topics PX4 has: its compiler does.

use bessemer_project::inputs::{Inputs, Part};
use bessemer_project::outputs::{Outputs, Sink, Value};
use serde::Serialize;

use super::fields::Field;

/// A mistake in the mapping.
#[derive(Debug, thiserror::Error)]
pub enum Wrong {
    /// A table is of no entry point.
    #[error("bessemer.toml:{line}: there is no entry point `{name}`")]
    Entry {
        /// Line in the file.
        line: u32,
        /// Name of the table.
        name: String,
        /// The names that exist.
        known: String,
    },
    /// Outputs are mapped without inputs.
    #[error("bessemer.toml:{line}: `[outputs.{name}]` needs the topics of the inputs")]
    NoInputs {
        /// Line in the file.
        line: u32,
        /// Name of the table.
        name: String,
    },
    /// A name cannot be a topic or a field of uORB.
    #[error("bessemer.toml:{line}: `{name}` is no {kind} of PX4")]
    Name {
        /// Line in the file.
        line: u32,
        /// The name.
        name: String,
        /// Topic or field.
        kind: &'static str,
        /// An example.
        such: &'static str,
    },
    /// A key or a value is no number of the entry point.
    #[error("bessemer.toml:{line}: there is no `{path}` that a topic can hold")]
    Path {
        /// Line in the file.
        line: u32,
        /// The path.
        path: String,
        /// The paths that exist.
        known: String,
    },
    /// A key has another number of sources than numbers.
    #[error("bessemer.toml:{line}: `{path}` has {wanted} numbers, and its value {found}")]
    Length {
        /// Line in the file.
        line: u32,
        /// The path.
        path: String,
        /// Number of numbers.
        wanted: usize,
        /// Number of sources.
        found: usize,
    },
    /// A number has two sources.
    #[error("bessemer.toml:{line}: `{path}` has a source already")]
    Twice {
        /// Line in the file.
        line: u32,
        /// The path.
        path: String,
    },
    /// A parameter has no source.
    #[error("bessemer.toml:{line}: `{entry}` has no source for {missing}")]
    Missing {
        /// Line in the file.
        line: u32,
        /// Name of the table.
        entry: String,
        /// The parameters.
        missing: String,
    },
    /// No topic triggers the call.
    #[error("bessemer.toml:{line}: all inputs of `{entry}` are numbers")]
    NoTopic {
        /// Line in the file.
        line: u32,
        /// Name of the table.
        entry: String,
    },
}

impl Wrong {
    /// Returns a step that resolves the mistake.
    pub fn remedy(&self) -> String {
        match self {
            Self::Entry { known, .. } | Self::Path { known, .. } => format!("choose from {known}"),
            Self::NoInputs { name, .. } => {
                format!("write `[inputs.{name}]`, as for a flight log (docs/book/flight-logs.md)")
            }
            Self::Name { such, .. } => {
                format!("write small letters, digits and `_`, such as `{such}`")
            }
            Self::Length { .. } => "write a list with a source for each".to_owned(),
            Self::Twice { .. } => "remove one of them".to_owned(),
            Self::Missing { entry, .. } => format!("map it in `[inputs.{entry}]`"),
            Self::NoTopic { .. } => "map one to a topic, which then triggers the call".to_owned(),
        }
    }
}

/// A bridge.
#[derive(Debug, Serialize)]
pub struct Bridge {
    /// Topics that are read; the first one triggers the call.
    pub topics: Vec<Topic>,
    /// Conditions under which an input holds no enumerator.
    pub refused: Vec<String>,
    /// Statements that read the topics.
    pub taken: Vec<String>,
    /// Topics that are written.
    pub messages: Vec<Message>,
}

/// A topic that is read.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Topic {
    /// Name of the topic, without its instance.
    pub name: String,
    /// Number of its instance.
    pub instance: u32,
    /// Name of the variable with the last message.
    pub variable: String,
}

/// A topic that is written.
#[derive(Debug, Serialize)]
pub struct Message {
    /// Name of the topic.
    pub name: String,
    /// Statements that fill it.
    pub filled: Vec<String>,
}

/// Tables of an entry point, and the fields of its messages.
pub struct Mapped<'m> {
    /// The sources of its parameters.
    pub inputs: Option<&'m Inputs>,
    /// The topics of its results.
    pub outputs: &'m Outputs,
    /// Fields of its parameters.
    pub parameters: &'m [Field],
    /// Fields of its results.
    pub results: &'m [Field],
}

impl Mapped<'_> {
    /// Returns the bridge of the entry point.
    pub fn bridge(&self) -> Result<Bridge, Wrong> {
        let (name, line) = (self.outputs.name.clone(), self.outputs.line);
        let Some(inputs) = self.inputs else { return Err(Wrong::NoInputs { line, name }) };
        let mut reading = Reading { numbers: numbers(self.parameters), topics: Vec::new() };
        let sources = reading.sources(inputs)?;
        let missing: Vec<String> = (0..reading.numbers.len())
            .filter(|at| sources[*at].is_none())
            .map(|at| format!("`{}`", reading.numbers[at].path()))
            .collect();
        if !missing.is_empty() {
            let (line, entry) = (inputs.line, inputs.name.clone());
            return Err(Wrong::Missing { line, entry, missing: missing.join(", ") });
        }
        if reading.topics.is_empty() {
            return Err(Wrong::NoTopic { line: inputs.line, entry: inputs.name.clone() });
        }
        let (mut refused, mut taken) = (Vec::new(), Vec::new());
        for (number, source) in reading.numbers.iter().zip(sources.iter().flatten()) {
            let (statement, condition) = number.taken(source);
            taken.extend(statement);
            refused.extend(condition);
        }
        Ok(Bridge { topics: reading.topics, refused, taken, messages: self.messages()? })
    }

    fn messages(&self) -> Result<Vec<Message>, Wrong> {
        let results = numbers(self.results);
        let mut messages: Vec<Message> = Vec::new();
        for sink in &self.outputs.sinks {
            let Sink { topic, field, line, .. } = sink;
            named(topic, "topic", *line)?;
            named(field, "field", *line)?;
            let filled = filled(sink, &results)?;
            match messages.iter_mut().find(|it| it.name == *topic) {
                Some(message) => message.filled.extend(filled),
                None => messages.push(Message { name: topic.clone(), filled }),
            }
        }
        Ok(messages)
    }
}

/// A number of a message.
#[derive(Clone, Debug)]
struct Number<'f> {
    field: &'f Field,
    /// Element of an array.
    element: Option<u32>,
}

impl Number<'_> {
    /// Returns the path of the number, as an author writes it.
    fn path(&self) -> String {
        let at = self.element.map(|at| format!("[{at}]")).unwrap_or_default();
        format!("{}{at}", self.field.path)
    }

    /// Returns the place of the number in the C.
    fn place(&self) -> String {
        let at = self.element.map(|at| format!("[{at}]")).unwrap_or_default();
        format!("{}{at}", self.field.place)
    }

    /// Returns true if the number is at a path or within it.
    fn is_within(&self, path: &str) -> bool {
        let own = self.path();
        let rest = own.strip_prefix(path);
        rest.is_some_and(|it| it.is_empty() || it.starts_with(['.', '[']))
    }

    /// Returns the statement that reads the number, and the condition under which it is no enumerator. An array that has one
    /// source is read by the statement of its first element.
    fn taken(&self, source: &Read) -> (Option<String>, Option<String>) {
        let place = &self.field.place;
        if let Read::Whole { from, factor } = source {
            let statement = (self.element == Some(0)).then(|| {
                let value = scaled(&format!("{from}[i]"), *factor, &self.field.ty);
                let count = self.field.count.unwrap_or(1);
                format!(
                    "static_assert(sizeof({from}) == {count}U * sizeof({from}[0]), \"{from} has {count} elements\");\n\
                     \t\tfor (uint32_t i = 0U; i < {count}U; i++) {{ {place}[i] = {value}; }}"
                )
            });
            return (statement, None);
        }
        let (value, factor) = match source {
            Read::Number(text) => (constant(text), None),
            Read::Single { from, factor } | Read::Whole { from, factor } => (from.clone(), *factor),
        };
        if let Some((ty, values)) = &self.field.choice {
            let number = scaled(&value, factor, "int32_t");
            let each = values.iter().map(|it| format!("({number} != {it})"));
            let refused = each.collect::<Vec<_>>().join(" && ");
            let statement = format!("{} = static_cast<{ty}>({number});", self.place());
            return (Some(statement), Some(refused));
        }
        (Some(format!("{} = {};", self.place(), scaled(&value, factor, &self.field.ty))), None)
    }
}

/// Source of a number, as C++.
#[derive(Clone, Debug)]
enum Read {
    /// A number that holds in each call.
    Number(String),
    /// A number of a topic.
    Single { from: String, factor: Option<f64> },
    /// An element of an array that is read as a whole.
    Whole { from: String, factor: Option<f64> },
}

/// The inputs, as they are collected.
struct Reading<'f> {
    numbers: Vec<Number<'f>>,
    topics: Vec<Topic>,
}

impl Reading<'_> {
    /// Returns the source of each number.
    fn sources(&mut self, inputs: &Inputs) -> Result<Vec<Option<Read>>, Wrong> {
        let mut sources: Vec<Option<Read>> = vec![None; self.numbers.len()];
        for source in &inputs.sources {
            let (path, line) = (source.target.clone(), source.line);
            let is_target = |at: &usize| self.numbers[*at].is_within(&path);
            let targets: Vec<usize> = (0..self.numbers.len()).filter(is_target).collect();
            if targets.is_empty() {
                return Err(Wrong::Path { line, path, known: known(&self.numbers) });
            }
            let first = &self.numbers[targets[0]];
            let is_array = targets.len() > 1 && first.field.count == Some(targets.len() as u32);
            let (wanted, found) = (targets.len(), source.parts.len());
            if wanted != found && !(is_array && found == 1) {
                return Err(Wrong::Length { line, path, wanted, found });
            }
            for (n, at) in targets.into_iter().enumerate() {
                let part = &source.parts[n.min(found - 1)];
                let read = self.read(part, wanted != found, line)?;
                if sources[at].replace(read).is_some() {
                    return Err(Wrong::Twice { line, path: self.numbers[at].path() });
                }
            }
        }
        Ok(sources)
    }

    fn read(&mut self, part: &Part, whole: bool, line: u32) -> Result<Read, Wrong> {
        let (topic, field, factor) = match part {
            Part::Number(text) => return Ok(Read::Number(text.clone())),
            Part::Field { topic, field, factor } => (topic, field, *factor),
        };
        let split = topic.strip_suffix(']').and_then(|it| it.split_once('['));
        let (name, instance) = match split {
            Some((name, at)) => (name, at.parse().ok()),
            None => (topic.as_str(), Some(0)),
        };
        let Some(instance) = instance else {
            let (name, kind, such) = (topic.clone(), "topic", "sensor_gyro[1]");
            return Err(Wrong::Name { line, name, kind, such });
        };
        named(name, "topic", line)?;
        named(field, "field", line)?;
        let variable = if instance == 0 { name.to_owned() } else { format!("{name}_{instance}") };
        let topic = Topic { name: name.to_owned(), instance, variable };
        let from = format!("in_{}.{field}", topic.variable);
        if !self.topics.contains(&topic) {
            self.topics.push(topic);
        }
        Ok(if whole { Read::Whole { from, factor } } else { Read::Single { from, factor } })
    }
}

/// Returns the statements that fill a field of a topic.
fn filled(sink: &Sink, results: &[Number<'_>]) -> Result<Vec<String>, Wrong> {
    let Sink { topic, field, line, values } = sink;
    let to = format!("out_{topic}.{field}");
    let found = |path: &str| -> Result<Vec<&Number<'_>>, Wrong> {
        let all: Vec<&Number<'_>> = results.iter().filter(|it| it.is_within(path)).collect();
        let unknown = || Wrong::Path { line: *line, path: path.into(), known: known(results) };
        if all.is_empty() { Err(unknown()) } else { Ok(all) }
    };
    // One value for a field, or for each of its elements.
    let mut each = Vec::new();
    for value in values {
        match value {
            Value::Number(text) => each.push(constant(text)),
            Value::Result { path, factor } => {
                let all = found(path)?;
                if all.len() > 1 && values.len() > 1 {
                    let (wanted, path) = (all.len(), path.clone());
                    return Err(Wrong::Length { line: *line, path, wanted, found: 1 });
                }
                each.extend(all.iter().map(|it| match factor {
                    Some(factor) => format!("static_cast<double>({}) * {factor:?}", it.place()),
                    None => it.place(),
                }));
            }
        }
    }
    if let ([value], [_]) = (&each[..], &values[..]) {
        return Ok(vec![format!("put({to}, {value});")]);
    }
    let count = each.len();
    let mut statements = vec![
        format!(
            "static_assert({count}U * sizeof({to}[0]) <= sizeof({to}), \"{to} has {count} elements\");"
        ),
        format!("clear({to});"),
    ];
    statements
        .extend(each.iter().enumerate().map(|(at, value)| format!("put({to}[{at}], {value});")));
    Ok(statements)
}

/// Returns the numbers of fields, in their order.
fn numbers(fields: &[Field]) -> Vec<Number<'_>> {
    let each = fields.iter().flat_map(|field| {
        let elements = match field.count {
            None => vec![None],
            Some(count) => (0..count).map(Some).collect(),
        };
        elements.into_iter().map(move |element| Number { field, element })
    });
    each.collect()
}

/// The paths of fields, as a message lists them.
fn known(numbers: &[Number<'_>]) -> String {
    let first = numbers.iter().filter(|it| it.element.is_none_or(|at| at == 0));
    first.map(|it| format!("`{}`", it.field.path)).collect::<Vec<_>>().join(", ")
}

/// Refuses a name that uORB cannot have.
fn named(name: &str, kind: &'static str, line: u32) -> Result<(), Wrong> {
    let word = |it: char| it.is_ascii_lowercase() || it.is_ascii_digit() || it == '_';
    let begins = name.starts_with(|it: char| it.is_ascii_lowercase());
    let fits = match kind {
        "topic" => name.chars().all(word),
        _ => name.chars().all(|it| word(it) || matches!(it, '.' | '[' | ']')),
    };
    let such = if kind == "topic" { "vehicle_attitude" } else { "q[0]" };
    match begins && fits {
        true => Ok(()),
        false => Err(Wrong::Name { line, name: name.to_owned(), kind, such }),
    }
}

/// Returns a value of a type, times a factor in double precision.
fn scaled(value: &str, factor: Option<f64>, ty: &str) -> String {
    match factor {
        Some(factor) => format!("static_cast<{ty}>(static_cast<double>({value}) * {factor:?})"),
        None => format!("static_cast<{ty}>({value})"),
    }
}

/// Returns a number as C++.
fn constant(text: &str) -> String {
    match text {
        "NaN" => "NAN".to_owned(),
        "inf" => "INFINITY".to_owned(),
        "-inf" => "-INFINITY".to_owned(),
        number => number.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bessemer_project::file::{NAME, read};

    /// A field of a parameter or a result that is called `path`.
    fn field(path: &str, ty: &str, count: Option<u32>) -> Field {
        let choice = (ty == "mode_t").then(|| (ty.to_owned(), vec![0, 1]));
        let (name, class) = (path.to_owned(), path.to_owned());
        let (path, place, ty) = (path.to_owned(), format!("the_{path}"), ty.to_owned());
        Field { name, class, path, place, ty, message: "", fpp: "", count, unit: None, choice }
    }

    const SOUND: &str = "[inputs.step]
rates = \"vehicle_attitude.q\"
axis.slope = \"sensor_gyro[1].x * 2.5\"
axis.mode = \"vehicle_attitude.mode\"
on = true

[outputs.step]
actuator_motors.control = [\"torque[1] * 0.5\", \"torque[0]\", nan]
actuator_motors.flags = \"mode\"
x_y.z = \"torque\"
";

    /// The bridge of an entry point with some parameters and results.
    fn bridge(text: &str) -> Result<Bridge, Wrong> {
        let settings = read(NAME, text).unwrap_or_else(|wrong| panic!("{}", wrong[0].message));
        let parameters = [
            field("rates", "float", Some(4)),
            field("axis.slope", "double", None),
            field("axis.mode", "mode_t", None),
            field("on", "bool", None),
        ];
        let results = [field("torque", "double", Some(2)), field("mode", "int32_t", None)];
        let (inputs, outputs) = (settings.inputs.first(), &settings.outputs[0]);
        Mapped { inputs, outputs, parameters: &parameters, results: &results }.bridge()
    }

    #[test]
    fn topics_are_read_and_written_as_the_tables_say() {
        let bridge = bridge(SOUND).unwrap_or_else(|error| panic!("{error}"));
        let topic = |name: &str, instance, variable: &str| Topic {
            name: name.to_owned(),
            instance,
            variable: variable.to_owned(),
        };
        let topics = [
            topic("vehicle_attitude", 0, "vehicle_attitude"),
            topic("sensor_gyro", 1, "sensor_gyro_1"),
        ];
        assert_eq!(bridge.topics, topics);
        let taken = [
            "static_assert(sizeof(in_vehicle_attitude.q) == 4U * sizeof(in_vehicle_attitude.q[0]), \"in_vehicle_attitude.q has 4 elements\");\n\
             \t\tfor (uint32_t i = 0U; i < 4U; i++) { the_rates[i] = static_cast<float>(in_vehicle_attitude.q[i]); }",
            "the_axis.slope = static_cast<double>(static_cast<double>(in_sensor_gyro_1.x) * 2.5);",
            "the_axis.mode = static_cast<mode_t>(static_cast<int32_t>(in_vehicle_attitude.mode));",
            "the_on = static_cast<bool>(true);",
        ];
        assert_eq!(bridge.taken, taken);
        let refused = "(static_cast<int32_t>(in_vehicle_attitude.mode) != 0) && (static_cast<int32_t>(in_vehicle_attitude.mode) != 1)";
        assert_eq!(bridge.refused, [refused]);
        let filled: Vec<(&str, String)> =
            bridge.messages.iter().map(|it| (it.name.as_str(), it.filled.join("\n"))).collect();
        let motors = "static_assert(3U * sizeof(out_actuator_motors.control[0]) <= sizeof(out_actuator_motors.control), \"out_actuator_motors.control has 3 elements\");\n\
            clear(out_actuator_motors.control);\n\
            put(out_actuator_motors.control[0], static_cast<double>(the_torque[1]) * 0.5);\n\
            put(out_actuator_motors.control[1], the_torque[0]);\n\
            put(out_actuator_motors.control[2], NAN);\n\
            put(out_actuator_motors.flags, the_mode);";
        let whole = "static_assert(2U * sizeof(out_x_y.z[0]) <= sizeof(out_x_y.z), \"out_x_y.z has 2 elements\");\n\
            clear(out_x_y.z);\nput(out_x_y.z[0], the_torque[0]);\nput(out_x_y.z[1], the_torque[1]);";
        assert_eq!(filled, [("actuator_motors", motors.to_owned()), ("x_y", whole.to_owned())]);
    }

    #[test]
    fn a_mistake_is_reported_with_its_line_and_remedy() {
        let inputs = "`rates`, `axis.slope`, `axis.mode`, `on`";
        let cases = [
            (
                "sensor_gyro[1]",
                "IMU",
                "3: `IMU` is no topic of PX4",
                "write small letters, digits and `_`, such as `vehicle_attitude`",
            ),
            (
                "sensor_gyro[1]",
                "sensor_gyro[a]",
                "3: `sensor_gyro[a]` is no topic of PX4",
                "write small letters, digits and `_`, such as `sensor_gyro[1]`",
            ),
            (
                "[1].x",
                "[1].x()",
                "3: `x()` is no field of PX4",
                "write small letters, digits and `_`, such as `q[0]`",
            ),
            (
                "on = true",
                "off = true",
                "5: there is no `off` that a topic can hold",
                &format!("choose from {inputs}"),
            ),
            (
                "\"torque[0]\"",
                "\"force\"",
                "8: there is no `force` that a topic can hold",
                "choose from `torque`, `mode`",
            ),
            (
                "\"vehicle_attitude.q\"",
                "[1, 2]",
                "2: `rates` has 4 numbers, and its value 2",
                "write a list with a source for each",
            ),
            (
                "\"torque[0]\"",
                "\"torque\"",
                "8: `torque` has 2 numbers, and its value 1",
                "write a list with a source for each",
            ),
            (
                "on = true",
                "on = true\n\"rates[2]\" = 1",
                "6: `rates[2]` has a source already",
                "remove one of them",
            ),
            ("on = true\n", "", "1: `step` has no source for `on`", "map it in `[inputs.step]`"),
        ];
        for (from, to, wrong, remedy) in cases {
            let error = bridge(&SOUND.replacen(from, to, 1)).expect_err(wrong);
            let wrong = format!("bessemer.toml:{wrong}");
            assert_eq!((error.to_string(), error.remedy()), (wrong, remedy.to_owned()), "{to}");
        }
        let outputs = SOUND.split_once("\n\n").map(|it| it.1).expect("two tables");
        let error = bridge(outputs).expect_err("there are no inputs").to_string();
        assert_eq!(error, "bessemer.toml:1: `[outputs.step]` needs the topics of the inputs");
        let numbers =
            format!("[inputs.step]\nrates = [1, 2, 3, 4]\naxis = [1, 0]\non = true\n{outputs}");
        let error = bridge(&numbers).expect_err("nothing triggers it").to_string();
        assert_eq!(error, "bessemer.toml:1: all inputs of `step` are numbers");
    }
}
