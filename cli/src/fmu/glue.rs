//! The C around the entry points of a unit, which an importer calls.
//!
//! Must not know: names of variables.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use bessemer_backend::c::interface::{Enum, Interface, Parameter};
use bessemer_codegen::compile::Compiled;
use bessemer_project::firmware::argument;

use super::variables::{Causality, STATE, Variable, flag_place, parameter_place, result_place};
use super::{Call, Unit, description};

/// The C around the entry points.
const GLUE: &str = include_str!("../../templates/fmu/fmi3.c");

/// The text of `fmi3_unit.c`.
pub fn text(compiled: &Compiled, unit: &Unit<'_>, variables: &[Variable<'_>]) -> String {
    let face = &compiled.interface;
    let mut headers: BTreeSet<&str> =
        unit.calls.iter().map(|it| it.entry.header.as_str()).collect();
    headers.extend(face.structs.iter().map(|it| it.header.as_str()));
    let includes: String = headers.iter().map(|it| format!("#include \"{it}\"\n")).collect();
    let mut values = Values { face, values: String::new(), begin: String::new() };
    let state = unit.calls.first().and_then(|it| it.entry.parameters.first());
    if let Some(state) = state {
        values.add(state, STATE.0);
    }
    let mut body = String::new();
    let several = unit.calls.len() > 1;
    for (at, call) in unit.calls.iter().enumerate() {
        let text = one_call(&mut values, at, call, if several { "        " } else { "    " });
        if several {
            let flag = flag_place(at);
            let _ = writeln!(values.values, "    bool {flag};");
            let _ = writeln!(values.begin, "    values->{flag} = {};", call.starts);
            let _ = write!(
                body,
                "    if (values->{flag} && values->fmu_periods % {}U == 0U) {{\n{text}    }}\n",
                call.every
            );
        } else {
            body += &text;
        }
    }
    let Values { values, mut begin, .. } = values;
    // Enums that nothing sets begin with a variant.
    for it in variables.iter().filter(|it| it.enumeration.is_some() && !it.is_set) {
        let first = "[0]".repeat(it.value.dimensions.len());
        for (at, word) in it.start.iter().enumerate() {
            let value = format!("({})({})", it.value.ty, *word as i64);
            let _ = writeln!(begin, "    (&values->{}{first})[{at}] = {value};", it.place);
        }
    }
    let (items, table) = table(variables);
    GLUE.replace("@LICENSE@", &compiled.license)
        .replace("@INCLUDES@", &includes)
        .replace("@TOKEN@", &unit.token)
        .replace("@PERIOD@", &format!("{:?}", unit.period))
        .replace("@VALUES@", &values)
        .replace("@ITEMS@", &items)
        .replace("@VARIABLES@", &table)
        .replace("@BEGIN@", &begin)
        .replace("@PERIOD_BODY@", &body)
}

/// Declarations of an instance's values, and what sets them at the beginning.
struct Values<'f> {
    face: &'f Interface,
    values: String,
    begin: String,
}

impl Values<'_> {
    fn add(&mut self, of: &Parameter, place: &str) {
        let counts: Vec<u32> = of.value.dimensions.iter().flatten().copied().collect();
        let dimensions: String = counts.iter().map(|count| format!("[{count}]")).collect();
        let _ = writeln!(self.values, "    {} {place}{dimensions};", of.value.ty);
        let set_by = self.face.structure(&of.value.ty).and_then(|it| it.set_by.as_ref());
        let Some(set_by) = set_by else { return };
        let all: u32 = counts.iter().product();
        let first = "[0]".repeat(counts.len());
        let _ = match counts.len() {
            0 => writeln!(self.begin, "    {set_by}(&values->{place});"),
            _ => writeln!(
                self.begin,
                "    for (size_t i = 0U; i < {all}U; i++) {{\n        {set_by}(&(&values->{place}{first})[i]);\n    }}"
            ),
        };
    }
}

/// The call of an entry point, which returns false if it faults.
fn one_call(values: &mut Values<'_>, at: usize, call: &Call<'_>, indent: &str) -> String {
    let entry = call.entry;
    let mut passed = Vec::new();
    for (number, it) in entry.parameters.iter().enumerate() {
        let place = if number == 0 { STATE.0.to_owned() } else { parameter_place(at, &it.name) };
        if number > 0 {
            values.add(it, &place);
        }
        passed.push(argument(it, &format!("values->{place}")));
    }
    let call = format!("{}({})", entry.name, passed.join(", "));
    match &entry.result {
        Some(value) => {
            let place = result_place(at);
            let _ = writeln!(values.values, "    {} {place};", value.ty);
            format!("{indent}values->{place} = {call};\n")
        }
        None if entry.status => {
            format!("{indent}if ({call} != 0) {{\n{indent}    return false;\n{indent}}}\n")
        }
        None => format!("{indent}{call};\n"),
    }
}

/// The values of enums, and the table of the variables by reference.
fn table(variables: &[Variable<'_>]) -> (String, String) {
    let mut enums: Vec<&Enum> = Vec::new();
    let mut items = String::new();
    let mut table = String::from(
        "    {FMU_FLOAT64, false, offsetof(fmu_values_t, fmu_time), sizeof(double), 1U, NULL, 0U},\n",
    );
    for it in variables {
        let kind = description::kind(it);
        let written = matches!(it.causality, Causality::Input | Causality::Parameter);
        let (of_enum, count) = match it.enumeration {
            None => ("NULL".to_owned(), 0),
            Some(of) => {
                let values: Vec<String> =
                    of.variants.iter().map(|(_, value, _)| value.to_string()).collect();
                let name = format!("FMU_ITEMS_{}", of.name.to_uppercase());
                if !enums.iter().any(|it| it.name == of.name) {
                    enums.push(of);
                    let _ = writeln!(
                        items,
                        "static const int64_t {name}[] = {{{}}};",
                        values.join(", ")
                    );
                }
                (name, values.len())
            }
        };
        let _ = writeln!(
            table,
            "    {{FMU_{}, {written}, offsetof(fmu_values_t, {}), sizeof({}), {}U, {of_enum}, {count}U}},",
            kind.to_uppercase(),
            it.place,
            it.value.ty,
            it.start.len()
        );
    }
    (items, table)
}
