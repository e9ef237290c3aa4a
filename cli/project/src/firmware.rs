//! Example firmware around an entry point: variables with static lifetime, their initialisation, and the call in each
//! period.
//!
//! Invariant: the same C gives the same text. It must not know what the C computes.

use std::fmt::Write as _;

use bessemer_backend::c::interface::{Entry, Interface, Parameter, Struct, Value};
use bessemer_backend::c::names::Passing;
use bessemer_backend::c::{CFile, comment_text};

/// An entry point in the form in which firmware calls it.
pub struct Call<'f> {
    /// The entry point.
    pub entry: &'f Entry,
    /// Variables with static lifetime: the state, and data with defaults.
    pub kept: Vec<(&'f str, &'f Value)>,
    /// The work struct of the call.
    pub scratch: Option<(&'f str, &'f Value)>,
    /// Other variables, for inputs and outputs of each period.
    pub passing: Vec<(&'f str, &'f Value, Passing)>,
    /// Statements that initialise the static variables, one for each.
    pub begin: Vec<String>,
}

/// Returns the entry points that can be called without a length that only the caller knows.
pub fn calls(face: &Interface) -> impl Iterator<Item = Call<'_>> {
    let fixed = |it: &&Entry| it.parameters.iter().all(|it| !it.value.dimensions.contains(&None));
    face.entries.iter().filter(fixed).map(|entry| {
        let (mut kept, mut passing, mut begin) = (Vec::new(), Vec::new(), Vec::new());
        let mut scratch = None;
        for it in &entry.parameters {
            if face.structure(&it.value.ty).is_some_and(|it| it.scratch) {
                scratch = Some((it.name.as_str(), &it.value));
                continue;
            }
            let set_by = face.structure(&it.value.ty).and_then(|it| it.set_by.as_ref());
            match set_by.filter(|_| it.value.dimensions.is_empty() && it.passing != Passing::Output)
            {
                Some(set_by) => {
                    begin.push(format!("{set_by}(&{});", it.name));
                    kept.push((it.name.as_str(), &it.value));
                }
                None => passing.push((it.name.as_str(), &it.value, it.passing)),
            }
        }
        Call { entry, kept, scratch, passing, begin }
    })
}

/// Formats a declaration such as `double place[3]`.
pub fn declared(name: &str, value: &Value) -> String {
    let dimensions: String =
        value.dimensions.iter().flatten().map(|count| format!("[{count}]")).collect();
    format!("{} {name}{dimensions}", value.ty)
}

/// Formats an argument from the variable at `place`. C converts no pointer to arrays to one to constant arrays.
pub fn argument(parameter: &Parameter, place: &str) -> String {
    let Value { ty, dimensions, .. } = &parameter.value;
    let inner: String = dimensions.iter().skip(1).flatten().map(|it| format!("[{it}]")).collect();
    match parameter.passing {
        Passing::Value => place.to_owned(),
        _ if dimensions.is_empty() => format!("&{place}"),
        Passing::Input if !inner.is_empty() => format!("(const {ty} (*){inner}){place}"),
        _ => place.to_owned(),
    }
}

impl Call<'_> {
    /// Formats the call, with its result in `result`.
    pub fn text(&self) -> String {
        let arguments = self.entry.parameters.iter().map(|it| argument(it, &it.name));
        let call = format!("{}({})", self.entry.name, arguments.collect::<Vec<_>>().join(", "));
        match (&self.entry.result, self.entry.status) {
            (Some(value), _) => format!("const {} result = {call};", value.ty),
            (None, true) => format!("const int status = (int){call};"),
            (None, false) => format!("{call};"),
        }
    }

    /// The definitions of the static variables that a call uses.
    pub fn statics(&self) -> String {
        self.kept
            .iter()
            .map(|(name, value)| format!("static {};\n", declared(name, value)))
            .collect()
    }

    /// Formats the statements of one period: inputs, call, and use of the results. `indent` begins each line.
    pub fn period(&self, indent: &str) -> String {
        let mut text = String::new();
        if let Some((name, value)) = &self.scratch {
            let line = declared(name, value);
            let _ = writeln!(text, "{indent}/* The call works in it. */\n{indent}static {line};");
        }
        for (name, value, passing) in &self.passing {
            let said = match passing {
                Passing::Output => "It goes to your actuators.",
                Passing::InOut => "The call reads and changes it.",
                Passing::Value | Passing::Input => "It comes from your sensors.",
            };
            let unit =
                value.unit.as_ref().map(|unit| format!(" Unit: {unit}.")).unwrap_or_default();
            let zero = if is_number(value) { " = 0" } else { "" };
            let line = declared(name, value);
            let _ = writeln!(text, "{indent}/* {said}{unit} */\n{indent}static {line}{zero};");
        }
        let _ = writeln!(text, "{indent}{}", self.text());
        let given = match (&self.entry.result, self.entry.status) {
            (Some(value), _) => {
                let unit = value.unit.as_ref().map(|unit| format!(" Unit: {unit}."));
                Some(("result", format!("It goes to your actuators.{}", unit.unwrap_or_default())))
            }
            (None, true) => {
                Some(("status", "Other than 0 it names a fault: stop safely.".to_owned()))
            }
            (None, false) => None,
        };
        if let Some((name, said)) = given {
            let _ = writeln!(text, "{indent}/* {said} */\n{indent}(void){name};");
        }
        text
    }

    /// Formats a whole program around the call. `around` precedes the headers of the C, `wait` ends a period.
    pub fn main(&self, around: &str, wait: &str) -> String {
        let begin: String = self.begin.iter().map(|it| format!("    {it}\n")).collect();
        format!(
            "/* An example of the firmware around {}: replace what is marked. */\n{around}#include \"{}\"\n\n{}\n\
             int main(void)\n{{\n{begin}    for (;;) {{\n{}        {wait}\n    }}\n}}\n",
            self.entry.rust,
            self.entry.header,
            self.statics(),
            self.period("        ")
        )
    }
}

/// Returns true if a value is a single number, not an enum or a struct.
fn is_number(value: &Value) -> bool {
    let known = ["bool", "float", "double"].contains(&value.ty.as_str());
    let integer = value.ty.trim_start_matches('u').strip_prefix("int");
    let bits = integer.and_then(|it| it.strip_suffix("_t")).map(str::parse::<u32>);
    value.dimensions.is_empty() && (known || matches!(bits, Some(Ok(_))))
}

/// A program around each component that calls all of its entry points in turn, with the stem of the component's names:
/// `motor` of `motor_t`.
pub fn examples(face: &Interface, license: &str) -> Vec<(String, CFile)> {
    let components = face.structs.iter().filter(|it| it.component);
    let example = |component: &Struct| {
        let state = |it: &&Call<'_>| {
            it.entry.parameters.first().is_some_and(|it| it.value.ty == component.name)
        };
        let mut all: Vec<Call<'_>> = Vec::new();
        for call in calls(face).filter(|it| state(&it)) {
            // Variables of one name are one variable.
            let differs = |(name, value): &(&str, &Value)| {
                let mut kept = all.iter().flat_map(|it| &it.kept);
                kept.any(|(known, other)| known == name && other.ty != value.ty)
            };
            if !call.kept.iter().any(differs) {
                all.push(call);
            }
        }
        let first = all.first()?;
        let stem = component.name.strip_suffix("_t").unwrap_or(&component.name).to_owned();
        let name = first.entry.rust.split("::").next().unwrap_or(&stem);
        let file = CFile {
            name: format!("{stem}_example_main.c"),
            text: program(name, license, &all),
            map: Vec::new(),
        };
        Some((stem, file))
    };
    components.filter_map(example).collect()
}

fn program(component: &str, license: &str, calls: &[Call<'_>]) -> String {
    let mut headers: Vec<&str> = calls.iter().map(|it| it.entry.header.as_str()).collect();
    headers.sort_unstable();
    headers.dedup();
    let headers: String = headers.iter().map(|it| format!("#include \"{it}\"\n")).collect();
    let (mut statics, mut begin): (Vec<String>, Vec<&str>) = (Vec::new(), Vec::new());
    for call in calls {
        for ((name, value), set) in call.kept.iter().zip(&call.begin) {
            let line = format!("static {};", declared(name, value));
            if !statics.contains(&line) {
                statics.push(line);
                begin.push(set);
            }
        }
    }
    let mut periods = String::new();
    for call in calls {
        let docs = call.entry.docs.first().map_or(call.entry.rust.as_str(), String::as_str);
        let docs = comment_text(docs);
        let _ = write!(
            periods,
            "\n        /* {docs} */\n        {{\n{}        }}\n",
            call.period("            ")
        );
    }
    let begin: String = begin.iter().map(|it| format!("    {it}\n")).collect();
    format!(
        "\
/*
 * An example of the firmware around {component}: a program to begin yours with. Replace what its comments name.
 *
 * Generated by Bessemer, and written anew with the C: copy it before you change it.
 * SPDX-License-Identifier: {license}
 */
{headers}
/* These live as long as the firmware: the state, and data that begins with its defaults. */
{}

int main(void)
{{
    /* Once, before anything else. */
{begin}
    for (;;) {{
        /* Wait here for the next control period. */
{periods}    }}
}}
",
        statics.join("\n")
    )
}
