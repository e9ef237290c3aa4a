//! Units of another maker: each kind of number, arrays, enumerations, parameters, and units that fail.

use std::fs;
use std::path::Path;

use bessemer_computers::{Error, Leg, Unit, host};

/// Description of a unit with one of each kind of thing.
const DESCRIPTION: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="3.0" modelName="Other" instantiationToken="a &amp; b">
  <CoSimulation modelIdentifier="other"/>
  <TypeDefinitions>
    <EnumerationType name="Mode"><Item name="off" value="-3"/><Item name="on" value="7"/></EnumerationType>
  </TypeDefinitions>
  <ModelVariables>
    <Float64 name="time" valueReference="0" causality="independent" variability="continuous"/>
    <Int8 name="pair" valueReference="1" causality="input"><Dimension start="2"/></Int8>
    <Boolean name="doubles" valueReference="2" causality="input"/>
    <Enumeration name="mode" valueReference="3" causality="input" declaredType="Mode"/>
    <Float32 name="gain" valueReference="4" causality="parameter" variability="fixed"/>
    <Int8 name="sum" valueReference="5" causality="output"/>
    <Enumeration name="other" valueReference="6" causality="output" declaredType="Mode"/>
    <Float32 name="scaled" valueReference="7" causality="output"/>
    <Float64 name="now" valueReference="8" causality="output"/>
  </ModelVariables>
</fmiModelDescription>
"#;

/// The unit itself: the sum of the pair, doubled or not; the mode that `mode` is not; the sum by the gain; the time.
const SOURCE: &str = r#"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
typedef void log_t(void *, int, const char *, const char *);
static log_t *report;
static int8_t pair[2], sum;
static bool doubles;
static int64_t mode = -3, other;
static float gain, scaled;
static double end;
void *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *resources, bool visible, bool logging,
    bool events, bool early, const uint32_t *intermediate, size_t count, void *environment, log_t *log, void (*update)(void))
{
    (void)name; (void)resources; (void)visible; (void)logging; (void)events; (void)early; (void)intermediate; (void)count;
    (void)environment; (void)update;
    report = log;
    return strcmp(token, "a & b") == 0 ? &pair : NULL;
}
int fmi3EnterInitializationMode(void *unit, bool t, double u, double v, bool w, double x)
{
    (void)unit; (void)t; (void)u; (void)v; (void)w; (void)x;
    return 0;
}
int fmi3ExitInitializationMode(void *unit) { (void)unit; return 0; }
#define ACCESS(kind, type, place) \
    int fmi3Set##kind(void *unit, const uint32_t *of, size_t n, const type *v, size_t m) { (void)unit; (void)n; memcpy((place), v, m * sizeof *v); return 0; } \
    int fmi3Get##kind(void *unit, const uint32_t *of, size_t n, type *v, size_t m) { (void)unit; (void)n; memcpy(v, (place), m * sizeof *v); return 0; }
ACCESS(Int8, int8_t, *of == 1U ? pair : &sum)
ACCESS(Boolean, bool, ((void)of, &doubles))
ACCESS(Int64, int64_t, *of == 3U ? &mode : &other)
ACCESS(Float32, float, *of == 4U ? &gain : &scaled)
ACCESS(Float64, double, ((void)of, &end))
int fmi3DoStep(void *unit, double now, double step, bool back, bool *e, bool *f, bool *g, double *last)
{
    (void)unit; (void)back; (void)e; (void)f; (void)g;
    if (pair[0] == 99) { report(NULL, 3, "", "too much"); return 3; }
    if (pair[0] == 98) { abort(); }
    sum = (int8_t)((pair[0] + pair[1]) * (doubles ? 2 : 1));
    other = mode == -3 ? 7 : -3;
    scaled = gain * (float)sum;
    end = *last = now + step;
    return 0;
}
"#;

/// Writes the unit as a folder.
fn written(folder: &Path) {
    let binaries = format!("binaries/{}-{}", std::env::consts::ARCH, std::env::consts::OS);
    let (binaries, source) = (folder.join(binaries), folder.join("other.c"));
    fs::create_dir_all(&binaries).expect("a folder");
    fs::write(folder.join("modelDescription.xml"), DESCRIPTION).expect("the description");
    fs::write(&source, SOURCE).expect("the source");
    let library = binaries.join(format!("other{}", std::env::consts::DLL_SUFFIX));
    let flags = ["-shared", "-fPIC", "-Wno-missing-prototypes"];
    let linked = host().expect("a compiler").link(&[source], &library, &flags);
    linked.unwrap_or_else(|said| panic!("{said}"));
}

fn call(unit: &mut Unit, pair: [i8; 2], doubles: bool, mode: u64) -> Result<Vec<u64>, Error> {
    let [a, b] = pair.map(|it| it as u64);
    unit.call(&[a, b, doubles.into(), mode, 0.5_f32.to_bits().into()])
}

fn result(sum: i8, other: u64, now: f64) -> Vec<u64> {
    vec![sum as u64, other, (0.5 * f32::from(sum)).to_bits().into(), now.to_bits()]
}

#[test]
fn a_unit_of_another_maker_runs() {
    let folder = tempfile::tempdir().expect("a folder");
    written(folder.path());
    let open = || Unit::open(folder.path(), 0.25).unwrap_or_else(|error| panic!("{error}"));
    let mut unit = open();
    let names = [("pair", 2), ("doubles", 1), ("mode", 1), ("gain", 1)];
    assert_eq!(unit.inputs().collect::<Vec<_>>(), names);
    assert_eq!(call(&mut unit, [-5, 2], false, 0).expect("a step"), result(-3, 1, 0.25));
    assert_eq!(call(&mut unit, [-5, 2], true, 1).expect("a step"), result(-6, 0, 0.5));

    let said = |called: Result<Vec<u64>, Error>| called.expect_err("it fails").to_string();
    let short = said(unit.call(&[0]));
    assert!(short.starts_with("`other` takes 5 words"), "{short}");
    let fixed = said(unit.call(&[0, 0, 0, 0, 0]));
    assert_eq!(
        fixed,
        "the unit failed in period 2: the parameter `gain` is fixed; keep its first value"
    );
    let item = said(call(&mut unit, [0, 0], false, 2));
    assert!(item.ends_with("`mode` has no item 2; they count from 0"), "{item}");
    assert_eq!(said(call(&mut unit, [99, 0], false, 0)), "the unit failed in period 2: too much");
    // A unit that dies ends nothing else.
    let died = said(call(&mut open(), [98, 0], false, 0));
    assert!(died.starts_with("the unit failed in period 0: its process ended: signal"), "{died}");
}

/// Each unit that cannot run is an error with a remedy.
#[test]
fn what_is_no_such_unit_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    written(folder.path());
    let said = |from: &str, to: &str| {
        let text = DESCRIPTION.replace(from, to);
        fs::write(folder.path().join("modelDescription.xml"), text).expect("the description");
        let mut unit = match Unit::open(folder.path(), 0.25) {
            Ok(unit) => unit,
            Err(error) => return error.to_string(),
        };
        call(&mut unit, [0, 0], false, 0).expect_err("it fails").to_string()
    };
    let refused = [
        ("fmiVersion=\"3.0\"", "fmiVersion=\"2.0\"", "it is of FMI 2.0; export it for FMI 3.0"),
        ("CoSimulation", "ModelExchange", "it is not for co-simulation; export it so"),
        ("a &amp; b", "b", "the unit cannot be instantiated"),
        ("\"other\"/>", "\"none\"/>", "build it from its sources, or export it on this machine"),
        ("<Dimension start=\"2\"/>", "<Dimension valueReference=\"4\"/>", "which this cannot"),
        ("<Float64 name=\"now\"", "<UInt64 name=\"now\"", "has no function fmi3GetUInt64"),
        ("<Float64 name=\"now\"", "<String name=\"now\"", "`now` is a String, which is no number"),
        ("</fmiModelDescription>", "</fmi>", "expected `</fmiModelDescription>`"),
    ];
    for (from, to, expected) in refused {
        let error = said(from, to);
        assert!(error.contains(expected), "{error}");
    }
}
