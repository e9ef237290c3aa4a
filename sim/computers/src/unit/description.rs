//! The description of a unit, `modelDescription.xml`: what of it an importer needs.
//!
//! Knows no library and no process.

use std::collections::BTreeMap;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

/// Kinds of variables in the order of `host.c`; an enumeration is passed as an `Int64`.
const KINDS: [&str; 11] = [
    "Float32", "Float64", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64",
    "Boolean",
];

/// Index of `Int64` in [`KINDS`].
const INT64: usize = 8;

/// A variable that is set or read.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    pub name: String,
    /// Index of the kind in [`KINDS`].
    pub kind: usize,
    pub reference: u32,
    /// Number of elements.
    pub elements: usize,
    /// True for a parameter that keeps its first value.
    pub is_fixed: bool,
    /// Values of the items, if it is an enumeration. Its word is the index of the item.
    pub items: Option<Vec<i64>>,
}

/// Description of a unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Description {
    /// Name of the library, without its ending.
    pub library: String,
    pub token: String,
    /// Inputs and parameters, in the order of the description.
    pub inputs: Vec<Variable>,
    /// Outputs, in the order of the description.
    pub outputs: Vec<Variable>,
    /// The step that the unit recommends or fixes, s.
    pub step: Option<f64>,
}

/// Reads the text of a description.
///
/// # Errors
///
/// It is no XML or not of a unit of FMI 3.0 for co-simulation, or an input or output has no fixed number of words.
pub fn read(text: &str) -> Result<Description, String> {
    let mut reader = Reader::from_str(text);
    let mut found = Description::default();
    let mut version = String::new();
    let mut enums: BTreeMap<String, Vec<i64>> = BTreeMap::new();
    let mut of_enum = String::new();
    // Variables may have children with their dimensions.
    let mut open: Option<(Variable, Way)> = None;
    let mut in_variables = false;
    let mut types: Vec<(String, String)> = Vec::new();
    loop {
        let (element, is_whole) = match reader.read_event().map_err(|why| why.to_string())? {
            Event::Eof => break,
            Event::Start(it) => (it, false),
            Event::Empty(it) => (it, true),
            Event::End(it) => {
                let name = it.name();
                if name.as_ref() == b"ModelVariables" {
                    in_variables = false;
                } else if KINDS.iter().any(|kind| kind.as_bytes() == name.as_ref())
                    || name.as_ref() == b"Enumeration"
                {
                    open.take().into_iter().for_each(|it| found.add(it));
                }
                continue;
            }
            _ => continue,
        };
        let name = String::from_utf8_lossy(element.name().as_ref()).into_owned();
        match name.as_str() {
            "fmiModelDescription" => {
                version = attribute(&element, "fmiVersion")?.unwrap_or_default();
                found.token = attribute(&element, "instantiationToken")?.unwrap_or_default();
            }
            "CoSimulation" => {
                found.library = attribute(&element, "modelIdentifier")?.unwrap_or_default();
                found.step = found.step.or(number(&element, "fixedInternalStepSize")?);
            }
            "DefaultExperiment" => found.step = found.step.or(number(&element, "stepSize")?),
            "EnumerationType" => of_enum = attribute(&element, "name")?.unwrap_or_default(),
            "Item" => {
                let value = attribute(&element, "value")?.unwrap_or_default();
                let value =
                    value.parse().map_err(|_| format!("the item `{value}` is no number"))?;
                enums.entry(of_enum.clone()).or_default().push(value);
            }
            "ModelVariables" => in_variables = true,
            "Dimension" => {
                if let Some((variable, _)) = &mut open {
                    let count =
                        attribute(&element, "start")?.and_then(|it| it.parse::<usize>().ok());
                    let count = count.ok_or_else(|| {
                        format!(
                            "`{}` has a size that a parameter sets, which this cannot",
                            variable.name
                        )
                    })?;
                    variable.elements = variable.elements.saturating_mul(count);
                }
            }
            kind if in_variables => {
                let Some(way) = Way::of(&element)? else { continue };
                let own = attribute(&element, "name")?.unwrap_or_default();
                let index = match kind {
                    "Enumeration" => Some(INT64),
                    kind => KINDS.iter().position(|it| *it == kind),
                };
                let index =
                    index.ok_or_else(|| format!("`{own}` is a {kind}, which is no number"))?;
                if kind == "Enumeration" {
                    let of = attribute(&element, "declaredType")?.unwrap_or_default();
                    types.push((own.clone(), of));
                }
                let reference = attribute(&element, "valueReference")?.unwrap_or_default();
                let reference =
                    reference.parse().map_err(|_| format!("`{own}` has no value reference"))?;
                let is_fixed = way == Way::Parameter
                    && attribute(&element, "variability")?.as_deref() != Some("tunable");
                let (name, kind) = (own, index);
                let variable =
                    Variable { name, kind, reference, elements: 1, is_fixed, items: None };
                if is_whole {
                    found.add((variable, way));
                } else {
                    open = Some((variable, way));
                }
            }
            _ => {}
        }
    }
    if !version.starts_with("3.") {
        return Err(format!("it is of FMI {version}; export it for FMI 3.0"));
    }
    if found.library.is_empty() {
        return Err("it is not for co-simulation; export it so".to_owned());
    }
    for variable in found.inputs.iter_mut().chain(&mut found.outputs) {
        let of = types.iter().find(|(name, _)| *name == variable.name);
        variable.items = of.and_then(|(_, of)| enums.get(of).cloned());
    }
    Ok(found)
}

/// Role of a variable.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Input,
    Parameter,
    Output,
}

impl Way {
    fn of(element: &BytesStart<'_>) -> Result<Option<Self>, String> {
        Ok(match attribute(element, "causality")?.as_deref() {
            Some("input") => Some(Self::Input),
            Some("parameter") => Some(Self::Parameter),
            Some("output") => Some(Self::Output),
            _ => None,
        })
    }
}

impl Description {
    fn add(&mut self, (variable, way): (Variable, Way)) {
        if way == Way::Output {
            self.outputs.push(variable);
        } else {
            self.inputs.push(variable);
        }
    }
}

fn number(element: &BytesStart<'_>, key: &str) -> Result<Option<f64>, String> {
    Ok(attribute(element, key)?.and_then(|it| it.parse().ok()))
}

fn attribute(element: &BytesStart<'_>, key: &str) -> Result<Option<String>, String> {
    let found = element.try_get_attribute(key).map_err(|why| why.to_string())?;
    let Some(found) = found else { return Ok(None) };
    let raw = String::from_utf8_lossy(&found.value);
    let text = quick_xml::escape::unescape(&raw).map_err(|why| why.to_string())?;
    Ok(Some(text.into_owned()))
}
