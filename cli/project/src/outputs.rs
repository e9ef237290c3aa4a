//! Reads the tables of `bessemer.toml` that map the results of entry points to topics of a vehicle: `[outputs.motor_step]`.
//!
//! A key is a field of a topic, `actuator_motors.control`. Its value is a result, `"command.motors"` or
//! `"command.motors * 0.002"`; a number or a flag; or a list of them, for the elements of the field.
//!
//! Must not know: entry points and topics; names are compared when a pack is written.

use toml::Spanned;
use toml::de::DeValue;

use crate::inputs::{Reader, Row, Wrong, number, scaled, tables};

/// Topics to which the results of an entry point go.
#[derive(Clone, Debug, PartialEq)]
pub struct Outputs {
    /// Name of the entry point or its component.
    pub name: String,
    /// Line in the file.
    pub line: u32,
    /// The values of each field.
    pub sinks: Vec<Sink>,
}

/// Field of a topic, and its values.
#[derive(Clone, Debug, PartialEq)]
pub struct Sink {
    /// The topic.
    pub topic: String,
    /// The field.
    pub field: String,
    /// Line in the file.
    pub line: u32,
    /// The values; one, unless it is a list.
    pub values: Vec<Value>,
}

/// Value of a field, or of an element of it.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number or a flag, as text.
    Number(String),
    /// A result of the entry point.
    Result {
        /// The result or its part: `command.motors[0]`.
        path: String,
        /// A factor of its numbers.
        factor: Option<f64>,
    },
}

/// Form of a value, for an author who wrote something else.
const VALUE: &str = "write a result, `\"command.motors\"` or `\"command.motors * 0.01\"`, a number, or a list of them";

/// Reads `[outputs.…]`; `line` returns the line of a place in the text.
pub(crate) fn outputs(
    found: &DeValue<'_>,
    at: usize,
    line: &dyn Fn(usize) -> u32,
) -> Result<Vec<Outputs>, Vec<Wrong>> {
    let read = tables("outputs", found, at, &Reader { line, part: &value, form: VALUE })?;
    let (mut all, mut mistakes) = (Vec::new(), Vec::new());
    for table in read {
        let mut sinks = Vec::new();
        for Row { key, line, parts } in table.rows {
            match key.split_once('.') {
                Some((topic, field)) => sinks.push(Sink {
                    topic: topic.to_owned(),
                    field: field.to_owned(),
                    line,
                    values: parts,
                }),
                None => {
                    let message =
                        format!("`{key}` of `outputs.{}` is a topic without a field", table.name);
                    let help = "write the field behind it, such as `actuator_motors.control`";
                    mistakes.push(Wrong::new(at, message, help));
                }
            }
        }
        all.push(Outputs { name: table.name, line: table.line, sinks });
    }
    if mistakes.is_empty() { Ok(all) } else { Err(mistakes) }
}

/// Reads a value; the error is its place.
fn value(found: &Spanned<DeValue<'_>>) -> Result<Value, usize> {
    let at = found.span().start;
    let DeValue::String(text) = found.get_ref() else { return number(found).map(Value::Number) };
    let (path, factor) = scaled(text).ok_or(at)?;
    let is_path = !path.is_empty() && !path.contains(char::is_whitespace);
    is_path.then(|| Value::Result { path: path.to_owned(), factor }).ok_or(at)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::file::{NAME, read};

    #[test]
    fn values_are_read_in_each_form() {
        let text = "[outputs.mixer]\nactuator_motors.control = [\"command.motors[0] * 0.5\", nan]\n\
            actuator_motors.reversible_flags = 0\n\"vehicle_status.is.on\" = true\nx.y = \"result\"\n";
        let settings = read(NAME, text).expect("it is sound");
        let [Outputs { name, line: 1, sinks }] = &settings.outputs[..] else {
            panic!("{:?}", settings.outputs)
        };
        let result = |path: &str, factor| Value::Result { path: path.to_owned(), factor };
        let number = |text: &str| Value::Number(text.to_owned());
        let expected = [
            (
                "actuator_motors",
                "control",
                vec![result("command.motors[0]", Some(0.5)), number("NaN")],
            ),
            ("actuator_motors", "reversible_flags", vec![number("0")]),
            ("vehicle_status", "is.on", vec![number("true")]),
            ("x", "y", vec![result("result", None)]),
        ];
        let sinks =
            sinks.iter().map(|it| (it.topic.as_str(), it.field.as_str(), it.values.clone()));
        assert_eq!((name.as_str(), sinks.collect::<Vec<_>>()), ("mixer", expected.to_vec()));
    }

    #[test]
    fn a_malformed_value_is_reported() {
        let cases = [
            ("outputs = 1\n", "`outputs` is a section"),
            ("[outputs]\nmotor = 1\n", "`outputs.motor` is a section"),
            ("[outputs.m]\na = \"b\"\n", "`a` of `outputs.m` is a topic without a field"),
            ("[outputs.m]\na.b = \"c * x\"\n", "`a.b` has no source that can be read"),
            ("[outputs.m]\na.b = [\"c\", \"\"]\n", "`a.b` has no source that can be read"),
            ("[outputs.m]\na.b = 1979-05-27\n", "`a.b` has no source that can be read"),
        ];
        for (text, expected) in cases {
            let wrong = read(NAME, text).expect_err("it is wrong");
            let wrong: Vec<&str> = wrong.iter().map(|it| it.message.as_str()).collect();
            assert_eq!(wrong, [expected], "{text}");
        }
    }
}
