//! `cargo bessemer a2l`: describes variables of a linked firmware in ASAP2, for measurement and calibration tools.
//!
//! Invariants: addresses and sizes come from the ELF's symbols; offsets, units, ranges and axes from the interface. A
//! variable is refused if no layout of its type has its size. It must not know what the C computes.

use std::fmt::Write as _;
use std::path::Path;

use bessemer_backend::c::interface::{Bytes, Enum, Interface, Leaf, Struct};
use bessemer_project::{Wanted, compile};
use object::read::elf::SectionHeader as _;
use object::{Object as _, ObjectSymbol as _};

use crate::args::A2l;
use crate::error::Error;

/// A variable of the firmware.
struct Variable<'f> {
    name: &'f str,
    ty: &'f Struct,
    address: u64,
    /// Chooses the layout of the firmware's compiler.
    bytes: fn(Bytes) -> u64,
}

/// The description, as text.
///
/// # Errors
/// Errors of the models or the system; a variable or a type that is not there, or whose sizes differ.
pub fn run(folder: &Path, wanted: &A2l, colour: bool) -> Result<String, Error> {
    let path = folder.join(&wanted.elf);
    let data = std::fs::read(&path).map_err(|source| Error::File { path: path.clone(), source })?;
    let elf = object::File::parse(&*data)
        .map_err(|why| Error::Elf { path: path.clone(), why: why.to_string() })?;
    let asked = Wanted { package: wanted.package.name(), colour, ..Wanted::default() };
    let (_, compiled) = compile(folder, asked)?;
    let face = &compiled.interface;
    let mut variables = Vec::new();
    for said in &wanted.variables {
        variables.push(variable(face, &elf, said)?);
    }
    Ok(text(&compiled.module.name, face, &variables, elf.is_little_endian()))
}

/// The variable that `name=type` names.
fn variable<'f>(
    face: &'f Interface,
    elf: &object::File<'_>,
    said: &'f str,
) -> Result<Variable<'f>, Error> {
    let wrong =
        |why: String, known: Vec<String>| Error::Variable { said: said.to_owned(), why, known };
    let (name, ty) =
        said.split_once('=').ok_or_else(|| wrong("it has no type".to_owned(), Vec::new()))?;
    let known = || face.structs.iter().map(|it| it.name.clone()).collect();
    let ty =
        face.structure(ty).ok_or_else(|| wrong(format!("the C has no struct `{ty}`"), known()))?;
    let symbol = elf
        .symbols()
        .find(|it| it.name() == Ok(name))
        .ok_or_else(|| wrong(format!("the firmware has no variable `{name}`"), Vec::new()))?;
    let bytes: fn(Bytes) -> u64 = match symbol.size() {
        // Fields may lie elsewhere although the whole is as large.
        size if size == ty.size.short_enums
            && (size != ty.size.int_enums || has_short_enums(elf)) =>
        {
            |it| it.short_enums
        }
        size if size == ty.size.int_enums => |it| it.int_enums,
        size => {
            let (one, other) = (ty.size.int_enums, ty.size.short_enums);
            let why = format!("`{name}` has {size} bytes, and a `{}` {one} or {other}", ty.name);
            return Err(wrong(why, Vec::new()));
        }
    };
    Ok(Variable { name, ty, address: symbol.address(), bytes })
}

/// Returns true if enums of the firmware are as short as their values allow: ARM's ABI stores that in
/// `Tag_ABI_enum_size`.
fn has_short_enums(elf: &object::File<'_>) -> bool {
    /// Attribute of ARM's ABI for enums of the smallest size.
    const ENUM_SIZE: (u64, u64) = (26, 1);
    let object::File::Elf32(elf) = elf else { return false };
    let attribute = || -> object::Result<bool> {
        let table = elf.elf_section_table();
        let endian = elf.endian();
        for section in
            table.iter().filter(|it| it.sh_type(endian) == object::elf::SHT_ARM_ATTRIBUTES)
        {
            let mut vendors = section.attributes(endian, elf.data())?.subsections()?;
            while let Some(vendor) = vendors.next()? {
                let mut parts = vendor.subsubsections();
                while let Some(part) = parts.next()? {
                    let mut reader = part.attributes();
                    while let Some(tag) = reader.read_tag()? {
                        match tag {
                            // Tag_CPU_raw_name, Tag_CPU_name, Tag_compatibility, and odd ones above it: texts.
                            4 | 5 => _ = reader.read_string()?,
                            32 => _ = (reader.read_integer()?, reader.read_string()?),
                            33.. if tag % 2 == 1 => _ = reader.read_string()?,
                            _ if (tag, reader.read_integer()?) == ENUM_SIZE => return Ok(true),
                            _ => {}
                        }
                    }
                }
            }
        }
        Ok(false)
    };
    attribute().unwrap_or(false)
}

fn text(package: &str, face: &Interface, variables: &[Variable], little: bool) -> String {
    let name = package.replace('-', "_");
    let order = if little { "MSB_LAST" } else { "MSB_FIRST" };
    let mut text = format!(
        // The mark tells readers that it is UTF-8.
        "\u{feff}ASAP2_VERSION 1 71\n/begin PROJECT {name} \"\"\n  /begin MODULE {name} \"\"\n    /begin MOD_COMMON \"\"\n      \
         BYTE_ORDER {order}\n    /end MOD_COMMON\n"
    );
    // A flag is a byte.
    for (_, ty, ..) in TYPES.iter().skip(1) {
        let _ = writeln!(
            text,
            "    /begin RECORD_LAYOUT AS_{ty} FNC_VALUES 1 {ty} COLUMN_DIR DIRECT /end RECORD_LAYOUT\n    \
             /begin RECORD_LAYOUT AXIS_{ty} AXIS_PTS_X 1 {ty} INDEX_INCR DIRECT /end RECORD_LAYOUT"
        );
    }
    // Which units there are, each with a conversion of its own.
    let mut units: Vec<&str> = vec![""];
    for it in variables {
        for leaf in face.leaves(it.ty) {
            let unit = leaf.value.unit.as_deref().unwrap_or_default();
            if !units.contains(&unit) {
                units.push(unit);
            }
        }
    }
    for (number, unit) in units.iter().enumerate() {
        let _ = writeln!(
            text,
            "    /begin COMPU_METHOD UNIT_{number} \"\" IDENTICAL \"%.17\" {} /end COMPU_METHOD",
            quoted(unit)
        );
    }
    for it in &face.enums {
        names(&mut text, it);
    }
    for it in variables {
        let leaves = face.leaves(it.ty);
        for leaf in &leaves {
            one(&mut text, face, (it, &leaves), leaf, &units);
        }
    }
    text += "  /end MODULE\n/end PROJECT\n";
    text
}

/// The types of numbers: in C, in ASAP2, and the least and the greatest.
const TYPES: [(&str, &str, f64, f64); 11] = [
    ("bool", "UBYTE", 0.0, 1.0),
    ("int8_t", "SBYTE", -128.0, 127.0),
    ("uint8_t", "UBYTE", 0.0, 255.0),
    ("int16_t", "SWORD", -32768.0, 32767.0),
    ("uint16_t", "UWORD", 0.0, 65535.0),
    ("int32_t", "SLONG", -2147483648.0, 2147483647.0),
    ("uint32_t", "ULONG", 0.0, 4294967295.0),
    ("int64_t", "A_INT64", -9223372036854775808.0, 9223372036854775807.0),
    ("uint64_t", "A_UINT64", 0.0, 18446744073709551615.0),
    ("float", "FLOAT32_IEEE", f32::MIN as f64, f32::MAX as f64),
    ("double", "FLOAT64_IEEE", f64::MIN, f64::MAX),
];

fn names(text: &mut String, it: &Enum) {
    let values: String =
        it.variants.iter().map(|(name, value, _)| format!(" {value} {}", quoted(name))).collect();
    let _ = writeln!(
        text,
        "    /begin COMPU_VTAB {}_NAMES \"\" TAB_VERB {}{values} /end COMPU_VTAB\n    \
         /begin COMPU_METHOD {} \"\" TAB_VERB \"%.0\" \"\" COMPU_TAB_REF {0}_NAMES /end COMPU_METHOD",
        it.name,
        it.variants.len(),
        it.name
    );
}

/// Type, limits and conversion of a number.
struct Number {
    ty: &'static str,
    low: f64,
    high: f64,
    conversion: String,
}

impl Number {
    fn of(face: &Interface, of: &Variable, leaf: &Leaf, units: &[&str]) -> Option<Number> {
        if let Some(it) = face.enumeration(&leaf.value.ty) {
            let values = it.variants.iter().map(|(_, value, _)| f64::from(*value));
            let (low, high) = (values.clone().fold(0.0, f64::min), values.fold(0.0, f64::max));
            let ty = sized(low, high, (of.bytes)(it.size));
            return Some(Number { ty, low, high, conversion: it.name.clone() });
        }
        let (_, ty, low, high) = *TYPES.iter().find(|(c, ..)| *c == leaf.value.ty)?;
        let unit = leaf.value.unit.as_deref().unwrap_or_default();
        let unit = units.iter().position(|it| *it == unit).unwrap_or_default();
        let (low, high) = leaf.value.range.map_or((low, high), |range| (range.low(), range.high()));
        Some(Number { ty, low, high, conversion: format!("UNIT_{unit}") })
    }
}

fn name(of: &Variable, path: &str) -> String {
    format!("{}.{}", of.name, path.trim_start_matches("as."))
}

/// One number, or an array of them: fields of a component are measured, others are calibrated. An array with axes is a curve or
/// a map, and its axes are shared with other tables.
fn one(
    text: &mut String,
    face: &Interface,
    (of, all): (&Variable, &[Leaf]),
    leaf: &Leaf,
    units: &[&str],
) {
    let Some(number) = Number::of(face, of, leaf, units) else { return };
    let Number { ty, low, high, conversion } = number;
    let (said, address) = (quoted(&leaf.docs.join(" ")), of.address + (of.bytes)(leaf.offset));
    let name_of = |leaf: &Leaf| name(of, &leaf.path);
    let name = name_of(leaf);
    let counts: Vec<u32> = leaf.value.dimensions.iter().map(|it| it.unwrap_or(0)).collect();
    // ASAP2 has a list of them since 1.70, and three before; three are read by both kinds of readers.
    let filled = counts.iter().chain(std::iter::repeat(&1)).take(counts.len().max(3));
    let dimensions: String = filled.map(|count| format!(" {count}")).collect();
    let dimensions =
        if counts.is_empty() { String::new() } else { format!(" MATRIX_DIM{dimensions}") };
    let is_axis = all.iter().any(|table| table.axes.contains(&leaf.path));
    let axes: Vec<&Leaf> =
        leaf.axes.iter().filter_map(|path| all.iter().find(|it| it.path == *path)).collect();
    let _ = match () {
        () if of.ty.component => writeln!(
            text,
            "    /begin MEASUREMENT {name} {said} {ty} {conversion} 0 0 {low:?} {high:?} ECU_ADDRESS {address:#X}{dimensions} /end MEASUREMENT"
        ),
        () if is_axis => writeln!(
            text,
            "    /begin AXIS_PTS {name} {said} {address:#X} NO_INPUT_QUANTITY AXIS_{ty} 0 {conversion} {} {low:?} {high:?} /end AXIS_PTS",
            counts[0]
        ),
        () if !axes.is_empty() => {
            let kind = if axes.len() == 1 { "CURVE" } else { "MAP" };
            let _ = write!(
                text,
                "    /begin CHARACTERISTIC {name} {said} {kind} {address:#X} AS_{ty} 0 {conversion} {low:?} {high:?}"
            );
            for (axis, count) in axes.iter().zip(&counts) {
                let Some(it) = Number::of(face, of, axis, units) else { continue };
                let (low, high, conversion) = (it.low, it.high, it.conversion);
                let _ = write!(
                    text,
                    "\n      /begin AXIS_DESCR COM_AXIS NO_INPUT_QUANTITY {conversion} {count} {low:?} {high:?} AXIS_PTS_REF {} /end AXIS_DESCR",
                    name_of(axis)
                );
            }
            writeln!(text, "\n    /end CHARACTERISTIC")
        }
        () => writeln!(
            text,
            "    /begin CHARACTERISTIC {name} {said} {} {address:#X} AS_{ty} 0 {conversion} {low:?} {high:?}{dimensions} /end CHARACTERISTIC",
            if counts.is_empty() { "VALUE" } else { "VAL_BLK" }
        ),
    };
}

/// The type of an enum that takes so many bytes.
fn sized(low: f64, high: f64, bytes: u64) -> &'static str {
    match (low < 0.0, bytes) {
        (true, 1) => "SBYTE",
        (false, 1) => "UBYTE",
        (true, 2) => "SWORD",
        (false, 2) => "UWORD",
        // It is an `int`, unless its values need more.
        _ if high > 2147483647.0 => "ULONG",
        _ => "SLONG",
    }
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
