//! Units at the interface of entry points, for reports.

use bessemer_ir::{Function, Module, Type};

use super::names::{Names, OVERLAY};
use super::signature::{Param, Passing, Signature};

/// Role of a value for the caller of an entry point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Port {
    /// A parameter that is read.
    Input,
    /// A parameter that is read and written.
    Parameter,
    /// A part of the component's state.
    State,
    /// A result.
    Output,
}

impl Port {
    /// Returns the word that a report prints.
    pub fn word(self) -> &'static str {
        match self {
            Port::Input => "input",
            Port::Parameter => "parameter",
            Port::State => "state",
            Port::Output => "output",
        }
    }
}

/// A number at the interface of an entry point, and its unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Measured {
    /// Role for the caller.
    pub port: Port,
    /// Path in the C: `target.position`, `axes[].gain`.
    pub place: String,
    /// Unit of the value.
    pub unit: String,
}

/// Returns all numbers with a unit at the interface of an entry point, in the order of its parameters.
pub fn of_entry(
    module: &Module,
    names: &Names,
    function: &Function,
    signature: &Signature,
) -> Vec<Measured> {
    let mut list = Vec::new();
    let locals = function.parameters();
    for (index, param) in signature.params.iter().enumerate() {
        let local = locals.get(index);
        let port = match param.passing {
            Passing::Output => Port::Output,
            _ if index == 0 && local.is_some_and(|local| local.name == "self") => Port::State,
            Passing::InOut => Port::Parameter,
            Passing::Value | Passing::Input => Port::Input,
        };
        let given = match local {
            Some(local) => function.attributes.parameter(&local.name),
            None => Some(&function.attributes.result),
        };
        let unit = given.and_then(|given| given.unit.as_ref());
        let Param { name, ty, .. } = param;
        // What a caller knows of the state are its parts.
        let place = if port == Port::State { "" } else { name };
        within(&mut list, (module, names), (port, place), (ty, unit));
    }
    let returned = !signature.params.iter().any(|param| param.passing == Passing::Output);
    if returned {
        let unit = function.attributes.result.unit.as_ref();
        within(&mut list, (module, names), (Port::Output, "result"), (&function.result, unit));
    }
    list
}

fn within(
    list: &mut Vec<Measured>,
    (module, names): (&Module, &Names),
    (port, place): (Port, &str),
    (ty, unit): (&Type, Option<&String>),
) {
    if let Some(unit) = unit {
        list.push(Measured { port, place: place.to_owned(), unit: unit.clone() });
    }
    match ty {
        Type::Struct(id) => {
            let (item, own) = (&module.structs[id.index()], &names.structs[id.index()]);
            for (field, name) in item.fields.iter().zip(&own.fields) {
                let name = name.strip_prefix(OVERLAY).map_or(name.clone(), |it| format!("as.{it}"));
                let place = if place.is_empty() { name } else { format!("{place}.{name}") };
                let unit = field.given.unit.as_ref();
                within(list, (module, names), (port, &place), (&field.ty, unit));
            }
        }
        Type::Array { element, .. } | Type::Slice(element) => {
            within(list, (module, names), (port, &format!("{place}[]")), (element, None));
        }
        Type::Unit | Type::Scalar(_) | Type::Matrix { .. } | Type::Enum(_) => {}
    }
}
