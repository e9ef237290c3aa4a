//! The XML of a unit: its model, its terminals and its build, as the schemas of FMI 3.0 have them.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use bessemer_backend::c::interface::{Enum, Interface};
use bessemer_codegen::compile::Options;
use bessemer_project::build_files;

use super::Unit;
use super::variables::{self, Causality, Variable};

const HEAD: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/// The type of a variable in FMI.
pub fn kind(of: &Variable<'_>) -> &'static str {
    if of.enumeration.is_some() {
        return "Enumeration";
    }
    match of.value.ty.as_str() {
        "bool" => "Boolean",
        "float" => "Float32",
        "double" => "Float64",
        "int8_t" => "Int8",
        "int16_t" => "Int16",
        "int64_t" => "Int64",
        "uint8_t" => "UInt8",
        "uint16_t" => "UInt16",
        "uint32_t" => "UInt32",
        "uint64_t" => "UInt64",
        _ => "Int32",
    }
}

/// A word as the description has it: a number that reads back to the same bits.
fn shown(kind: &str, word: u64) -> String {
    match kind {
        "Boolean" => (word != 0).to_string(),
        "Float64" => number(f64::from_bits(word), |it| format!("{it:?}")),
        "Float32" => {
            let value = f32::from_bits(word as u32);
            number(f64::from(value), |_| format!("{value:?}"))
        }
        "UInt64" => word.to_string(),
        _ => (word as i64).to_string(),
    }
}

/// XML's words for NaN and the infinities.
fn number(value: f64, finite: impl Fn(f64) -> String) -> String {
    match value {
        it if it.is_nan() => "NaN".to_owned(),
        it if it.is_infinite() => if it > 0.0 { "INF" } else { "-INF" }.to_owned(),
        it => finite(it),
    }
}

/// The text of `modelDescription.xml`.
pub fn model(
    face: &Interface,
    unit: &Unit<'_>,
    variables: &[Variable<'_>],
    license: &str,
) -> String {
    let period = unit.period;
    let mut text = format!(
        "{HEAD}<fmiModelDescription fmiVersion=\"3.0\" modelName=\"{}\" \
         instantiationToken=\"{}\" description=\"{}\" license=\"{}\" generationTool=\"Bessemer\" \
         variableNamingConvention=\"structured\">\n  <CoSimulation modelIdentifier=\"{}\" canGetAndSetFMUState=\"true\" \
         canSerializeFMUState=\"true\" fixedInternalStepSize=\"{period:?}\"/>\n",
        escaped(&unit.rust),
        escaped(&unit.token),
        escaped(&unit.docs),
        escaped(license),
        unit.name
    );
    units(&mut text, variables);
    types(&mut text, face, variables);
    let time = variables::time(variables);
    let _ = write!(
        text,
        "  <DefaultExperiment stepSize=\"{period:?}\"/>\n  <ModelVariables>\n    \
         <Float64 name=\"{time}\" valueReference=\"0\" causality=\"independent\" variability=\"continuous\"/>\n"
    );
    for (reference, it) in (1..).zip(variables) {
        variable(&mut text, reference, it);
    }
    text += "  </ModelVariables>\n  <ModelStructure>\n";
    for element in ["Output", "InitialUnknown"] {
        for (reference, _) in
            (1..).zip(variables).filter(|(_, it)| it.causality == Causality::Output)
        {
            let _ = writeln!(text, "    <{element} valueReference=\"{reference}\"/>");
        }
    }
    text + "  </ModelStructure>\n</fmiModelDescription>\n"
}

fn units(text: &mut String, variables: &[Variable<'_>]) {
    let units: BTreeSet<&str> =
        variables.iter().filter_map(|it| it.value.unit.as_deref()).collect();
    if units.is_empty() {
        return;
    }
    *text += "  <UnitDefinitions>\n";
    for unit in units {
        let _ = writeln!(text, "    <Unit name=\"{}\"/>", escaped(unit));
    }
    *text += "  </UnitDefinitions>\n";
}

/// Enums, each an enumeration with its variants.
fn types(text: &mut String, face: &Interface, variables: &[Variable<'_>]) {
    let is_used =
        |of: &&Enum| variables.iter().any(|it| it.enumeration.is_some_and(|it| it.name == of.name));
    let used: Vec<&Enum> = face.enums.iter().filter(is_used).collect();
    if used.is_empty() {
        return;
    }
    *text += "  <TypeDefinitions>\n";
    for of in used {
        let _ = writeln!(
            text,
            "    <EnumerationType name=\"{}\"{}>",
            escaped(&of.name),
            described(&of.docs.join(" "))
        );
        for (name, value, docs) in &of.variants {
            let _ = writeln!(
                text,
                "      <Item name=\"{}\" value=\"{value}\"{}/>",
                escaped(name),
                described(&docs.join(" "))
            );
        }
        *text += "    </EnumerationType>\n";
    }
    *text += "  </TypeDefinitions>\n";
}

fn described(docs: &str) -> String {
    if docs.is_empty() { String::new() } else { format!(" description=\"{}\"", escaped(docs)) }
}

fn variable(text: &mut String, reference: u32, it: &Variable<'_>) {
    let kind = kind(it);
    let (causality, variability, starts) = match it.causality {
        Causality::Input => ("input", "discrete", true),
        Causality::Parameter => ("parameter", "tunable", true),
        Causality::Output => ("output", "discrete", false),
        Causality::Local => ("local", "discrete", false),
    };
    let _ = write!(
        text,
        "    <{kind} name=\"{}\" valueReference=\"{reference}\" causality=\"{causality}\" variability=\"{variability}\"{}",
        escaped(&it.name),
        described(&it.docs)
    );
    if let Some(of) = it.enumeration {
        let _ = write!(text, " declaredType=\"{}\"", escaped(&of.name));
    }
    if let (Some(unit), "Float32" | "Float64") = (&it.value.unit, kind) {
        let _ = write!(text, " unit=\"{}\"", escaped(unit));
    }
    // The unit takes any number where it clamps.
    let range = it.value.range.filter(|it| !it.clamps());
    if let (Some(range), "Float32" | "Float64") = (range, kind) {
        let _ = write!(text, " min=\"{:?}\" max=\"{:?}\"", range.low(), range.high());
    }
    if starts {
        let start: Vec<String> = it.start.iter().map(|word| shown(kind, *word)).collect();
        let _ = write!(text, " start=\"{}\"", start.join(" "));
    }
    if it.value.dimensions.is_empty() {
        *text += "/>\n";
    } else {
        *text += ">\n";
        for count in it.value.dimensions.iter().flatten() {
            let _ = writeln!(text, "      <Dimension start=\"{count}\"/>");
        }
        let _ = writeln!(text, "    </{kind}>");
    }
}

/// The text of `terminalsAndIcons.xml`: a struct that goes in or comes out is a terminal with its fields, so that a tool connects
/// it whole. None where there is no such struct.
pub fn terminals(unit: &Unit<'_>, variables: &[Variable<'_>]) -> Option<String> {
    let connects =
        |it: &&Variable<'_>| matches!(it.causality, Causality::Input | Causality::Output);
    let mut names: Vec<&str> = Vec::new();
    for it in variables.iter().filter(connects) {
        let name = it.part_of.as_deref();
        names.extend(name.filter(|name| !names.contains(name)));
    }
    if names.is_empty() {
        return None;
    }
    let mut text = format!("{HEAD}<fmiTerminalsAndIcons fmiVersion=\"3.0\">\n  <Terminals>\n");
    for name in names {
        let _ = writeln!(
            text,
            "    <Terminal name=\"{}\" matchingRule=\"bus\" description=\"{}\">",
            escaped(name),
            escaped(&format!("{} of {}", name, unit.rust))
        );
        for it in variables.iter().filter(|it| it.part_of.as_deref() == Some(name)) {
            let member = it.name.strip_prefix(name).unwrap_or(&it.name).trim_start_matches('.');
            let _ = writeln!(
                text,
                "      <TerminalMemberVariable variableName=\"{}\" memberName=\"{}\" variableKind=\"signal\"/>",
                escaped(&it.name),
                escaped(member)
            );
        }
        text += "    </Terminal>\n";
    }
    Some(text + "  </Terminals>\n</fmiTerminalsAndIcons>\n")
}

/// The text of `buildDescription.xml`.
pub fn build(name: &str, options: &Options, sources: &[&str]) -> String {
    let files: String =
        sources.iter().map(|it| format!("      <SourceFile name=\"{it}\"/>\n")).collect();
    let (language, flags) = (options.standard.iso(), build_files::flags(options));
    // Headers in their own folder are named relative to the folder of the sources.
    let include = match options.headers.is_empty() {
        true => "",
        false => "      <IncludeDirectory name=\".\"/>\n",
    };
    format!(
        "{HEAD}<fmiBuildDescription fmiVersion=\"3.0\">\n  \
         <BuildConfiguration modelIdentifier=\"{name}\">\n    \
         <SourceFileSet language=\"{language}\" compilerOptions=\"{flags}\">\n{files}{include}    </SourceFileSet>\n  \
         </BuildConfiguration>\n</fmiBuildDescription>\n"
    )
}

fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for letter in text.chars() {
        match letter {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            // XML has no other control characters, not even escaped.
            other if other.is_control() => escaped.push(' '),
            other => escaped.push(other),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;
    use bessemer_backend::c::interface::Value;
    use bessemer_ir::attributes::{Beyond, Range};

    /// Returns the description of an input with a range, in which `beyond` says what becomes of other numbers.
    fn input(beyond: Option<Beyond>) -> String {
        let range = beyond.and_then(|it| Some(Range::new(-2.0, 5.0)?.with(it)));
        let ty = "double".to_owned();
        let value = Value { ty, dimensions: Vec::new(), matrix: None, unit: None, range };
        let input = Variable {
            name: "gain".to_owned(),
            place: String::new(),
            causality: Causality::Input,
            value: &value,
            enumeration: None,
            docs: String::new(),
            start: vec![0],
            is_set: false,
            part_of: None,
        };
        let mut text = String::new();
        variable(&mut text, 7, &input);
        text
    }

    #[test]
    fn an_input_has_limits_unless_the_c_clamps_it() {
        let limits = " min=\"-2.0\" max=\"5.0\"";
        assert!(!input(None).contains("min="));
        assert!(input(Some(Beyond::Taken)).contains(limits));
        assert!(input(Some(Beyond::Reported)).contains(limits));
        assert!(!input(Some(Beyond::Clamped)).contains("min="));
    }
}
