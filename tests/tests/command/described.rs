//! Descriptions of the C for other tools, compared with the C. A foreign parser reads the ASAP2 file beside
//! `interface.json` and the symbols of linked firmware; the Python module is compared with the simulation.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_tests::toolchain::{self, Toolchain};
use cargo_bessemer::args::{A2l, Python};
use cargo_bessemer::{asap2, python};

use super::observer::{Observer, Tuning};
use super::{generated, printed, python_with};
use bessemer::prelude::*;

/// In a package that also has the observer.
pub fn run(package: &Path) {
    let (library, settings) = (package.join("src/lib.rs"), package.join("bessemer.toml"));
    let [model, sound] = [&library, &settings].map(|it| fs::read_to_string(it).expect("a file"));
    fs::write(&library, format!("{model}\npub mod observer;\n")).expect("the model");
    fs::write(package.join("src/observer.rs"), include_str!("observer.rs")).expect("the model");
    fs::write(&settings, format!("interface = true\n{sound}")).expect("the settings");
    generated(package, false).unwrap_or_else(|said| panic!("{said}"));
    calibrated(package);
    for layout in ["columns", "rows", "array"] {
        fs::write(&settings, format!("layout = {layout:?}\n{sound}")).expect("the settings");
        called_from_python(package, layout);
    }
    fs::write(&settings, sound).expect("the settings");
    fs::write(&library, model).expect("the model");
    fs::remove_file(package.join("src/observer.rs")).expect("the model");
    generated(package, false).unwrap_or_else(|said| panic!("{said}"));
}

/// In ASAP2, with the addresses of linked programs; what is said wrongly of one is reported.
fn calibrated(package: &Path) {
    let text = "#include \"motor.h\"\n#include \"observer.h\"\nint8_t before = 1;\nmotor_t controller;\ngains_t gains;\nobserver_t observer;\n\
        tuning_t tuning;\nint main(void)\n{\n    motor_init(&controller);\n    observer_init(&observer);\n    tuning_defaults(&tuning);\n    \
        return before;\n}\n";
    let source = package.join("calibrated.c");
    fs::write(&source, text).expect("a file");
    let bare = toolchain::BARE_A9;
    let bare = toolchain::is_asked_for(bare.compiler).then_some((bare, "short_enums"));
    for (compiler, enums) in [(toolchain::GCC, "int_enums")].into_iter().chain(bare) {
        let elf = linked(package, &source, &compiler);
        read_back(package, &elf, enums);
        if enums == "int_enums" {
            for (variable, said) in [
                ("controller", "it has no type"),
                ("controller=pump_t", "the C has no struct `pump_t`"),
                ("pump=motor_t", "the firmware has no variable `pump`"),
                ("gains=motor_t", "`gains` has 24 bytes, and a `motor_t` 8 or 8"),
            ] {
                let told = described(package, &elf, &[variable]).expect_err(variable);
                assert_eq!(told, format!("`{variable}`: {said}"));
            }
        }
        fs::remove_file(&elf).expect("the program");
    }
    fs::remove_file(&source).expect("the source");
}

fn linked(package: &Path, source: &Path, compiler: &Toolchain) -> PathBuf {
    let (folder, elf) = (package.join("generated"), package.join("calibrated"));
    let files = fs::read_dir(&folder).expect("the C").flatten().map(|it| it.path());
    let files = files.filter(|it| it.extension().is_some_and(|it| it == "c"));
    let sources: Vec<PathBuf> = files.chain([source.to_owned()]).collect();
    let include = format!("-I{}", folder.display());
    compiler.link(&sources, &elf, &[&include]).unwrap_or_else(|said| panic!("{said}"));
    elf
}

fn described(package: &Path, elf: &Path, variables: &[&str]) -> Result<String, String> {
    let variables = variables.iter().map(|&it| it.to_owned()).collect();
    let wanted = A2l { package: Default::default(), elf: elf.to_owned(), variables };
    asap2::run(package, &wanted, false).map_err(|error| error.to_string())
}

/// Each number of the variables is there once, with address, type, limits, unit and names, and nothing else is.
fn read_back(package: &Path, elf: &Path, enums: &str) {
    let variables =
        ["controller=motor_t", "gains=gains_t", "observer=observer_t", "tuning=tuning_t"];
    let text = described(package, elf, &variables).unwrap_or_else(|said| panic!("{said}"));
    assert_eq!(text.matches("/begin").count(), text.matches("/end").count());
    // Fewer than three dimensions are an error for readers of ASAP2 before 1.70.
    let arrays: Vec<_> = text.split("MATRIX_DIM ").skip(1).collect();
    assert!(!arrays.is_empty(), "{text}");
    for array in arrays {
        let numbers = array.split_whitespace().take_while(|it| it.parse::<u32>().is_ok());
        assert_eq!(numbers.count(), 3, "{array}");
    }
    let Some(mut python) = python_with("pya2l") else { return };
    let file = package.join("calibrated.a2l");
    fs::write(&file, text).expect("the description");
    let symbols = Command::new("nm").arg(elf).output().expect("nm");
    fs::write(package.join("symbols.txt"), symbols.stdout).expect("the symbols");
    python.current_dir(package).env("ENUMS", enums).env("VARIABLES", variables.join(" "));
    let said = printed(&mut python, READ_BACK);
    assert_eq!(said.lines().last(), Some("37 numbers and arrays"), "{said}");
    for name in ["calibrated.a2l", "symbols.txt"] {
        fs::remove_file(package.join(name)).expect("a file");
    }
}

/// Script that computes the expected values from the interface and the symbols only.
const READ_BACK: &str = r#"
import json, os, sys
import pya2l
from pya2l import model

NUMBERS = {
    "bool": ("UBYTE", 0, 1), "int8_t": ("SBYTE", -2**7, 2**7 - 1), "uint8_t": ("UBYTE", 0, 2**8 - 1),
    "int16_t": ("SWORD", -2**15, 2**15 - 1), "uint16_t": ("UWORD", 0, 2**16 - 1), "int32_t": ("SLONG", -2**31, 2**31 - 1),
    "uint32_t": ("ULONG", 0, 2**32 - 1), "int64_t": ("A_INT64", -2**63, 2**63 - 1), "uint64_t": ("A_UINT64", 0, 2**64 - 1),
    "float": ("FLOAT32_IEEE", -3.4028234663852886e38, 3.4028234663852886e38),
    "double": ("FLOAT64_IEEE", -sys.float_info.max, sys.float_info.max),
}
ENUMS = os.environ["ENUMS"]
face = json.load(open("generated/interface.json", encoding="utf-8"))
structs = {it["name"]: it for it in face["structs"]}
enums = {it["name"]: it for it in face["enums"]}
words = (line.split() for line in open("symbols.txt"))
symbols = {it[2]: int(it[0], 16) for it in words if len(it) == 3}

def leaves(struct, name, address):
    for field in structs[struct]["fields"]:
        path, at, dimensions = name + "." + field["name"], address + field["offset"][ENUMS], field.get("dimensions", [])
        if field["type"] in structs:
            assert len(dimensions) <= 1
            for n in range(dimensions[0] if dimensions else 1):
                element = f"{path}[{n}]" if dimensions else path
                yield from leaves(field["type"], element, at + n * structs[field["type"]]["size"][ENUMS])
        else:
            yield path, at, field, dimensions

expected = {}
for variable in os.environ["VARIABLES"].split():
    name, struct = variable.split("=")
    kind = "MEASUREMENT" if structs[struct]["component"] else "CHARACTERISTIC"
    for path, at, field, dimensions in leaves(struct, name, symbols[name]):
        if field["type"] in enums:
            values = {it["value"]: it["name"] for it in enums[field["type"]]["variants"]}
            size = enums[field["type"]]["size"][ENUMS]
            ty, low, high, meaning = {1: "UBYTE", 4: "SLONG"}[size], min(values), max(values), values
        else:
            ty, low, high = NUMBERS[field["type"]]
            low, high = field.get("range", (low, high))
            meaning = field.get("unit", "")
        axes = [path.rsplit(".", 1)[0] + "." + axis for axis in field.get("axes", [])]
        comment = field.get("comment", "").replace("\n", " ")
        # At least three, so that readers of older versions accept the file.
        filled = dimensions + [1] * (3 - len(dimensions)) if dimensions else []
        expected[path] = (kind, at, ty, float(low), float(high), filled, meaning, comment, axes)
points = {axis for it in expected.values() if it[0] == "CHARACTERISTIC" for axis in it[-1]}
for name, it in expected.items():
    if name in points:
        expected[name] = ("AXIS_PTS", *it[1:])
    elif it[0] == "MEASUREMENT":
        expected[name] = (*it[:-1], [])

session = pya2l.import_a2l("calibrated.a2l", in_memory=True, encoding="utf-8-sig", loglevel="ERROR", progress_bar=False)
assert session.query(model.ModCommon).one().byte_order.byteOrder == "MSB_LAST"
tables = {it.name: {pair.inVal: pair.outVal for pair in it.pairs} for it in session.query(model.CompuVtab)}
methods = {it.name: it for it in session.query(model.CompuMethod)}
layouts = {it.name: (it.fnc_values or it.axis_pts_x).datatype for it in session.query(model.RecordLayout)}
directions = {it.name: it.fnc_values.indexMode for it in session.query(model.RecordLayout) if it.fnc_values}

def meaning(conversion):
    method = methods[conversion]
    if method.conversionType == "TAB_VERB":
        return tables[method.compu_tab_ref.conversionTable]
    assert method.conversionType == "IDENTICAL"
    return method.unit

def entry(kind, it, address, ty):
    dimensions = list(it.matrix_dim.numbers) if getattr(it, "matrix_dim", None) else []
    comment = it.longIdentifier.replace('\\"', '"').replace("\\\\", "\\")
    return kind, address, ty, it.lowerLimit, it.upperLimit, dimensions, meaning(it.conversion), comment, []

read = {}
for it in session.query(model.Measurement):
    read[it.name] = entry("MEASUREMENT", it, it.ecu_address.address, it.datatype)
for it in session.query(model.Characteristic):
    assert it.name not in read
    row = entry("CHARACTERISTIC", it, it.address, layouts[it.deposit])
    if it.axis_descr:
        # Elements of one row of the C, whose index is that of the first axis, are neighbours.
        assert it.type == [None, "CURVE", "MAP"][len(it.axis_descr)] and not it.matrix_dim
        assert directions[it.deposit] == "COLUMN_DIR"
        assert all(axis.attribute == "COM_AXIS" for axis in it.axis_descr)
        counts = [axis.maxAxisPoints for axis in it.axis_descr]
        row = (*row[:5], counts + [1] * (3 - len(counts)), *row[6:8], [axis.axis_pts_ref.axisPoints for axis in it.axis_descr])
        for axis in it.axis_descr:
            name = axis.axis_pts_ref.axisPoints
            assert (axis.lowerLimit, axis.upperLimit, meaning(axis.conversion)) == (expected[name][3], expected[name][4], expected[name][6])
    else:
        assert it.type == ("VAL_BLK" if it.matrix_dim else "VALUE")
    read[it.name] = row
for it in session.query(model.AxisPts):
    assert it.name not in read
    row = entry("AXIS_PTS", it, it.address, layouts[it.depositAttr])
    read[it.name] = (*row[:5], [it.maxAxisPoints, 1, 1], *row[6:])

for name in expected.keys() | read.keys():
    assert read.get(name) == expected.get(name), (name, read.get(name), expected.get(name))
print(len(read), "numbers and arrays")
"#;

/// As a module of Python, whose arrays are NumPy's.
fn called_from_python(package: &Path, layout: &str) {
    let Some(mut python) = python_with("numpy") else { return };
    let wanted = Python { package: Default::default(), output: package.join("python") };
    let said = python::run(package, &wanted, false).unwrap_or_else(|error| panic!("{error}"));
    assert!(said.contains("import motor"), "{said}");
    python.env("PYTHONPATH", &wanted.output);
    assert_eq!(printed(&mut python, OBSERVED), observed(), "{layout}");
    fs::remove_dir_all(&wanted.output).expect("the module");
}

/// The words of a simulation: what is given, by rows, what is written, and what is kept.
fn observed() -> String {
    let (mut observer, mut tuning) = (Observer::default(), Tuning::default());
    tuning.slopes[0] = 0.7;
    tuning.inertia[(1, 0)] = -0.9;
    let (mut drift, mut text) = (Vector3::new(0.1, -0.2, 0.3), String::new());
    for n in 0..255 {
        let at = f64::from(n);
        let measured = SMatrix::<f64, 2, 3>::from_fn(|r, c| (at + (3 * r + c) as f64) * 0.1);
        let weights = [0.3_f32, (at * 0.01) as f32, 0.999];
        let given = observer.step(&tuning, &measured, &mut drift, &weights, 5001);
        let by_rows = |it: &SMatrix<f64, 3, 2>| it.transpose().iter().copied().collect::<Vec<_>>();
        let place = observer.place.iter().chain(drift.iter()).copied();
        let slopes = observer.told[1].slopes.iter().map(|&it| f64::from(it));
        let words =
            by_rows(&given).into_iter().chain(place).chain(by_rows(&observer.gains)).chain(slopes);
        let words: Vec<String> = words.map(|it| format!("{:016x}", it.to_bits())).collect();
        let spread = observer.spread(n).to_bits();
        let (sign, calls) = (observer.sign, observer.calls);
        text += &format!("{} {spread:016x} {sign} {calls}\n", words.join(" "));
    }
    text + "faulted\n"
}

const OBSERVED: &str = r#"
import motor, numpy
words = lambda *arrays: " ".join(
    format(it, "016x") for array in arrays for it in numpy.array(array, dtype="float64", order="C").ravel().view("uint64"))
observer, tuning = motor.observer_t(), motor.tuning_t()
assert all(type(it) is numpy.ndarray for it in (observer.place, observer.gains, tuning.slopes))
assert observer.gains.shape == (3, 2) and tuning.slopes.dtype == numpy.float32
tuning.slopes[0] = 0.7
tuning.inertia[1, 0] = -0.9
drift = numpy.array([0.1, -0.2, 0.3])

def refused(error, said, *arguments):
    try:
        observer.step(*arguments)
    except error as it:
        assert said in str(it), it
        return
    raise AssertionError(said)

measured, weights = numpy.zeros((2, 3)), [0.3, 0.0, 0.999]
refused(ValueError, "`measured` is an array of the shape (2, 3), not (3, 2)", tuning, measured.T, drift, weights, 0)
refused(ValueError, "`weights` is an array of the shape (3,), not (2,)", tuning, measured, drift, [1, 2], 0)
refused(ValueError, "`drift` is written", tuning, measured, [1.0, 2.0, 3.0], weights, 0)
refused(OverflowError, "`least` is from 0 to 65535, not -1", tuning, measured, drift, weights, -1)
refused(TypeError, "'float'", tuning, measured, drift, weights, 0.5)

def not_set(error, said, of, name, value):
    try:
        setattr(of, name, value)
    except error as it:
        assert said in str(it), it
        return
    raise AssertionError(said)

not_set(AttributeError, "`tuning_t` has no field `slope`; it has ", tuning, "slope", 1.0)
not_set(ValueError, "`period` is from 1 to 5000, not 0", tuning, "period", 0)
not_set(OverflowError, "`sign` is from -128 to 127, not 200", observer, "sign", 200)
not_set(ValueError, "`slopes` is from -1.5 to 2.5, not [0.0, 3.0, 0.0]", tuning, "slopes", [0.0, 3.0, 0.0])
not_set(ValueError, "`slopes` is from -1.5 to 2.5, not [0.0, nan, 0.0]", tuning, "slopes", [0.0, float("nan"), 0.0])
not_set(ValueError, "2 is not a valid observer_mode_t", tuning, "mode", 2)
try:
    motor.tuning_t(perod=1)
    raise AssertionError("an unknown name was taken")
except AttributeError as it:
    assert "has no field `perod`" in str(it), it
assert tuning.mode is motor.observer_mode_t.OBSERVER_MODE_TUNED and tuning.mode == motor.OBSERVER_MODE_TUNED == 1
tuning.mode = motor.observer_mode_t.OBSERVER_MODE_OFF
assert "mode=observer_mode_t.OBSERVER_MODE_OFF" in repr(tuning) and repr(tuning).startswith("tuning_t(") and "period=5000" in repr(tuning), repr(tuning)
assert "=[tuning_t(" in repr(observer), repr(observer)
tuning.mode = 1
kept = tuning.slopes[1]
tuning.slopes[1] = 3.0
refused(ValueError, "`slopes` is from -1.5 to 2.5", tuning, measured, drift, weights, 0)
tuning.slopes[1] = kept
refused(Exception, "tuning_t", observer, measured, drift, weights, 0)
for n in range(255):
    measured = numpy.array([[(n + 3 * r + c) * 0.1 for c in range(3)] for r in range(2)])
    # A view, too, whose elements lie in another order.
    measured = measured if n % 2 else numpy.asfortranarray(measured)
    weights = numpy.array([0.3, n * 0.01, 0.999], dtype="float32")
    given = observer.step(tuning, measured, drift, weights, 5001)
    assert given.shape == (3, 2)
    print(words(given, observer.place, drift, observer.gains, observer.told[1].slopes, [observer.spread(n)]), observer.sign, observer.calls)
try:
    observer.step(tuning, measured, drift, weights, 5001)
except motor.Fault as fault:
    assert "OVERFLOW" in str(fault), fault
    print("faulted")
"#;
