//! Variables of a unit: which there are, how they are called, and where they lie in the values of an instance.
//!
//! Invariant: no two variables have one name. State is below `self`, which no parameter is called; what an entry point returns
//! is `result`, and what no name of an author's may meet gets a `_` behind it where one does.

use bessemer_backend::c::interface::{Enum, Interface, Struct, Value};
use bessemer_backend::c::names::Passing;

use super::{Call, Unit};
use crate::error::Error;

/// Place of the state in the values of an instance, and the beginning of its names.
pub const STATE: (&str, &str) = ("fmu_state", "self");

/// Causality of a variable in FMI: the simulation sets inputs and parameters, the unit sets the others.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Causality {
    Input,
    Parameter,
    Output,
    Local,
}

/// A variable of the unit.
pub struct Variable<'f> {
    pub name: String,
    /// Its place in the values of an instance.
    pub place: String,
    pub causality: Causality,
    pub value: &'f Value,
    /// The enum that it is of.
    pub enumeration: Option<&'f Enum>,
    pub docs: String,
    /// The start values of its elements, as words.
    pub start: Vec<u64>,
    /// True if a function of the C sets it at the beginning.
    pub is_set: bool,
    /// The variable of which it is a part: `gains` of `gains.p`.
    pub part_of: Option<String>,
}

/// A flag that says in which periods an entry point is called.
pub static FLAG: std::sync::LazyLock<Value> = std::sync::LazyLock::new(|| Value {
    ty: "bool".to_owned(),
    dimensions: Vec::new(),
    matrix: None,
    unit: None,
    range: None,
});

/// Place of a parameter of an entry point, the number of which is `call`.
pub fn parameter_place(call: usize, name: &str) -> String {
    format!("call{call}_{name}")
}

/// Place of the result of an entry point.
pub fn result_place(call: usize) -> String {
    format!("result{call}")
}

/// Place of the flag of an entry point.
pub fn flag_place(call: usize) -> String {
    format!("wanted{call}")
}

/// The name, with a `_` behind it for each that is taken.
fn free(name: &str, taken: &[&str]) -> String {
    let mut name = name.to_owned();
    while taken.contains(&name.as_str()) {
        name.push('_');
    }
    name
}

/// The name of the variable with the time.
pub fn time(variables: &[Variable<'_>]) -> String {
    let roots: Vec<&str> =
        variables.iter().map(|it| it.name.split(['.', '[']).next().unwrap_or_default()).collect();
    free("time", &roots)
}

/// The variables, in the order of the entry points and their parameters; the state last.
///
/// # Errors
/// [`Error::Slice`] of a parameter whose length only its caller knows.
pub fn of<'f>(face: &'f Interface, unit: &Unit<'f>) -> Result<Vec<Variable<'f>>, Error> {
    let mut list = Vec::new();
    for (at, call) in unit.calls.iter().enumerate() {
        of_call(&mut list, face, (at, call), unit.calls.len() > 1)?;
    }
    let state = unit.calls.first().and_then(|it| it.entry.parameters.first());
    if let Some(state) = state {
        let (place, name) = STATE;
        within(&mut list, face, (name, place), Causality::Local, &state.value, &[]);
    }
    Ok(list)
}

fn of_call<'f>(
    list: &mut Vec<Variable<'f>>,
    face: &'f Interface,
    (at, call): (usize, &Call<'f>),
    has_flag: bool,
) -> Result<(), Error> {
    let entry = call.entry;
    let others = entry.parameters.get(1..).unwrap_or_default();
    let taken: Vec<&str> = others.iter().map(|it| it.name.as_str()).collect();
    let prefix = &call.prefix;
    if has_flag {
        list.push(Variable {
            name: format!("{prefix}{}", free("call", &taken)),
            place: flag_place(at),
            causality: Causality::Input,
            value: &FLAG,
            enumeration: None,
            docs: format!("Calls {} in each of its periods.", entry.rust),
            start: vec![call.starts.into()],
            is_set: false,
            part_of: None,
        });
    }
    let named = others
        .iter()
        .map(|it| (it.name.clone(), parameter_place(at, &it.name), it.passing, &it.value));
    let result = entry
        .result
        .iter()
        .map(|value| (free("result", &taken), result_place(at), Passing::Output, value));
    for (name, place, passing, value) in named.chain(result) {
        if value.dimensions.contains(&None) {
            return Err(Error::Slice { entry: entry.rust.clone(), name });
        }
        let of = face.structure(&value.ty);
        let causality = match (passing, of) {
            (Passing::Output | Passing::InOut, _) => Causality::Output,
            (_, Some(Struct { set_by: Some(_), component: false, .. })) => Causality::Parameter,
            _ => Causality::Input,
        };
        let name = format!("{prefix}{name}");
        within(list, face, (&name, &place), causality, value, &entry.docs);
    }
    Ok(())
}

/// The numbers of a value.
fn within<'f>(
    list: &mut Vec<Variable<'f>>,
    face: &'f Interface,
    (name, place): (&str, &str),
    causality: Causality,
    value: &'f Value,
    docs: &[String],
) {
    let Some(of) = face.structure(&value.ty) else {
        let docs = if causality == Causality::Output { docs.join(" ") } else { String::new() };
        let enumeration = face.enumeration(&value.ty);
        let start = vec![zero(enumeration); elements(value)];
        let (name, place) = (name.to_owned(), place.to_owned());
        list.push(Variable {
            name,
            place,
            causality,
            value,
            enumeration,
            docs,
            start,
            is_set: false,
            part_of: None,
        });
        return;
    };
    let mut places = vec![String::new()];
    for count in &value.dimensions {
        let each = |place: &String| {
            (0..count.unwrap_or(0)).map(|at| format!("{place}[{at}]")).collect::<Vec<_>>()
        };
        places = places.iter().flat_map(each).collect();
    }
    for at in places {
        let mut words = of.words.iter().flatten().copied();
        for leaf in face.leaves(of) {
            let enumeration = face.enumeration(&leaf.value.ty);
            let count = elements(leaf.value);
            let start = (0..count).map(|_| words.next().unwrap_or(zero(enumeration))).collect();
            list.push(Variable {
                name: format!("{name}{at}.{}", leaf.path),
                place: format!("{place}{at}.{}", leaf.path),
                causality,
                value: leaf.value,
                enumeration,
                docs: leaf.docs.join(" "),
                start,
                is_set: of.words.is_some(),
                part_of: Some(format!("{name}{at}")),
            });
        }
    }
}

/// The start value of a number that nothing sets; an enum has its first variant, since it need not have a variant 0.
fn zero(enumeration: Option<&Enum>) -> u64 {
    let first = enumeration.and_then(|it| it.variants.first());
    first.map_or(0, |(_, value, _)| i64::from(*value) as u64)
}

fn elements(value: &Value) -> usize {
    value.dimensions.iter().map(|it| it.unwrap_or(0) as usize).product()
}
