//! Co-simulation units of models that bring what breaks them: names that meet, enums without a zero, several entry points with
//! periods of their own. FMPy holds each to the schemas of FMI 3.0 and steps it.

use std::fs;
use std::path::Path;

use cargo_bessemer::args::Fmu;
use cargo_bessemer::fmu;

use super::{printed, python_with};

/// A model in which the names of parameters, results, state and flags meet.
const MODEL: &str = r#"
use bessemer::prelude::*;

/// Mode of the <filter> & its "friends".
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Mode {
    /// Holds.
    #[default]
    Hold = 3,
    /// Follows.
    Follow = -7,
}

/// A place.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// To the east.
    #[unit("m")]
    pub x: f64,
    /// Mode of its sensor.
    pub mode: Mode,
}

/// Filters.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Filter {
    /// Sum.
    pub sum: f64,
    /// Latest result.
    pub result: f64,
    /// Mode.
    pub mode: Mode,
}

#[component]
impl Filter {
    /// Predicts.
    #[entry(infallible)]
    pub fn predict(&mut self, sum: f64, result: f32, time: f64, mode: Mode) -> f64 {
        self.mode = mode;
        self.sum += match mode {
            Mode::Hold => 0.0,
            Mode::Follow => sum + f64::from(result) + time,
        };
        self.sum
    }

    /// Corrects.
    #[entry]
    pub fn correct(&mut self, call: u8, place: &Place, table: &[[u8; 2]; 3]) -> Place {
        self.result = place.x + f64::from(call + 1) + f64::from(table[2][1]);
        Place { x: self.result, mode: place.mode }
    }

    /// Begins anew.
    #[entry(infallible)]
    pub fn time(&mut self) {
        self.sum = 0.0;
    }
}
"#;

/// In the package of the motor, which gets the model as a module.
pub fn run(package: &Path) {
    let (library, settings) = (package.join("src/lib.rs"), package.join("bessemer.toml"));
    let [model, sound] = [&library, &settings].map(|it| fs::read_to_string(it).expect("a file"));
    fs::write(&library, format!("{model}\npub mod filter;\n")).expect("the model");
    fs::write(package.join("src/filter.rs"), MODEL).expect("the model");
    let wanted = |entry: Option<&str>| Fmu {
        package: Default::default(),
        entry: entry.map(str::to_owned),
        period: None,
        output: package.join("fmu"),
    };
    let refused =
        |entry| fmu::run(package, &wanted(entry), false).expect_err("refused").to_string();
    fs::write(&settings, format!("{sound}\n[periods]\npredict = 1\n")).expect("the settings");
    assert_eq!(refused(None), "the package has several entry points");
    let missing = "the time between two calls of `filter_predict` is not set";
    assert_eq!(refused(Some("Filter")), missing);
    let periods = |correct: &str| {
        let own = format!("filter = 0.001\nfilter_predict = 0.001\nfilter_correct = {correct}\n");
        fs::write(&settings, format!("{sound}\n[periods]\n{own}")).expect("the settings");
    };
    periods("0.0025");
    let uneven = "`filter_correct` is called every 0.0025 s, which is no multiple of 0.001 s";
    assert!(refused(Some("Filter")).starts_with(uneven));
    periods("0.002");
    for entry in ["Filter", "Filter::predict", "filter_correct"] {
        let said = fmu::run(package, &wanted(Some(entry)), false);
        let said = said.unwrap_or_else(|error| panic!("{entry}: {error}"));
        if entry == "Filter" {
            let last = "Filter::time every 0.001 s, if the simulation sets its `call`\n";
            assert!(said.contains("filter.fmu: Filter with ") && said.ends_with(last), "{said}");
        }
    }
    if let Some(mut python) = python_with("fmpy") {
        python.current_dir(package.join("fmu"));
        assert_eq!(printed(&mut python, STEPS), "3 units, 1 with terminals\n");
    }
    fs::remove_dir_all(package.join("fmu")).expect("the units");
    fs::remove_file(package.join("src/filter.rs")).expect("the model");
    fs::write(&settings, sound).expect("the settings");
    fs::write(&library, model).expect("the model");
}

/// Holds each unit to the schemas, and steps the one of the component.
const STEPS: &str = r#"
import fmpy, glob, os, zipfile
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu
from lxml import etree

schemas = os.path.join(os.path.dirname(fmpy.__file__), "schema", "fmi3")
units, terminals = sorted(glob.glob("*.fmu")), 0
for unit in units:
    problems = validate_fmu(unit)
    assert not problems, (unit, problems)
    with zipfile.ZipFile(unit) as files:
        for file in files.namelist():
            if file.endswith(".xml"):
                name = os.path.basename(file)
                schema = "fmi3" + name[0].upper() + name[1:-3] + "xsd"
                etree.XMLSchema(file=os.path.join(schemas, schema)).assertValid(etree.fromstring(files.read(file)))
                terminals += name == "terminalsAndIcons.xml" and unit == "filter.fmu"
    about = fmpy.read_model_description(unit)
    names = [it.name for it in about.modelVariables]
    assert len(names) == len(set(names)), names
    assert "time_" in names if unit == "filter.fmu" else True, names

about = fmpy.read_model_description("filter.fmu")
variables = {it.name: it for it in about.modelVariables}
mode = variables["predict.mode"]
assert (mode.type, mode.start) == ("Enumeration", "3"), (mode.type, mode.start)
items = {it.name.rsplit("_", 1)[-1]: int(it.value) for it in mode.declaredType.items}
assert items == {"HOLD": 3, "FOLLOW": -7}, mode.declaredType.items
assert [variables[it].start for it in ("predict.call", "correct.call_", "time.call")] == ["true", "true", "false"]
place = {name: it.valueReference for name, it in variables.items()}
unit = FMU3Slave(guid=about.guid, unzipDirectory=fmpy.extract("filter.fmu"), modelIdentifier="filter", instanceName="one")
unit.instantiate()
unit.enterInitializationMode()
assert unit.getInt64([place["self.mode"], place["correct.place.mode"]]) == [3, 3]
unit.setInt64([place["predict.mode"], place["correct.place.mode"]], [-7, -7])
try:
    unit.setInt64([place["predict.mode"]], [0])
    raise SystemExit("an item that there is not was taken")
except fmpy.fmi1.FMICallException:
    pass
unit.setFloat64([place["predict.sum"], place["predict.time"], place["correct.place.x"]], [1.0, 0.5, 10.0])
unit.setUInt8([place["correct.call"]], [4])
unit.exitInitializationMode()
seen = []
for n in range(4):
    if n == 2:
        unit.setFloat64([place["correct.place.x"]], [20.0])
    if n == 3:
        unit.setBoolean([place["time.call"]], [True])
    unit.doStep(n * 0.001, 0.001)
    seen.append((unit.getFloat64([place["predict.result_"], place["self.sum"], place["correct.result.x"]]), unit.getInt64([place["correct.result.mode"]])))
unit.terminate()
unit.freeInstance()
expected = [([1.5, 1.5, 15.0], [-7]), ([3.0, 3.0, 15.0], [-7]), ([4.5, 4.5, 25.0], [-7]), ([6.0, 0.0, 25.0], [-7])]
assert seen == expected, seen
print(len(units), "units,", terminals, "with terminals")
"#;
