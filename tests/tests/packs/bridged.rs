//! The module of `cargo bessemer pack px4` that reads and writes the vehicle's topics: compiled and run against stand-ins of uORB.

use super::{Built, uorb};
use cargo_bessemer::args::{Pack, System};
use cargo_bessemer::pack;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Topics of PX4 for the inputs and the results of an entry point.
const TOPICS: &str = "
[inputs.new_watch_step]
measurement.attitude = \"vehicle_attitude.q\"
measurement.speed = \"vehicle_local_position.vx * -2\"
measurement.mode = \"vehicle_local_position.xy_reset_counter\"
\"measurement.axes[0]\" = [0.25, 1]
\"measurement.axes[1].slope\" = \"vehicle_attitude.q[3] * 0.5\"
\"measurement.axes[1].mode\" = 2
measurement.well = [true, false, \"vehicle_local_position.xy_valid\"]
measurement_speed = 1.0
timestamp = 7
input = \"vehicle_local_position.xy_reset_counter * -3\"

[outputs.\"Watch::step\"]
actuator_motors.control = [\"setpoint.torque[0] * 0.5\", \"setpoint.torque[1]\", 0.125]
actuator_motors.reversible_flags = \"setpoint.mode\"
";

/// Flies the module: publishes topics, and prints the commands after each.
const PX4: &str = r#"#include "NewWatchModule.cpp"
#include <stdio.h>

static void said(const char *after)
{
	const actuator_motors_s &motors = uORB::Bus<actuator_motors_s>::last;
	(void)printf("%s: %u", after, uORB::Bus<actuator_motors_s>::count);
	for (int n = 0; n < 4; ++n) {
		(void)printf(" %g", static_cast<double>(motors.control[n]));
	}
	(void)printf(" %u %d\n", motors.reversible_flags, motors.timestamp > 0U);
}

int main()
{
	char name[] = "new_watch", start[] = "start";
	char *arguments[] = {name, start};
	if (new_watch_main(2, arguments) != 0) {
		return 1;
	}
	uORB::Publication<vehicle_attitude_s> attitude{ORB_ID(vehicle_attitude)};
	uORB::Publication<vehicle_local_position_s> position{ORB_ID(vehicle_local_position)};
	vehicle_attitude_s turned{};
	vehicle_local_position_s place{};
	turned.timestamp = place.timestamp = 1;
	turned.q[0] = 0.5F;
	turned.q[1] = 0.25F;
	turned.q[3] = 1.0F;
	attitude.publish(turned);
	said("attitude alone");
	place.vx = -4.0F;
	place.xy_valid = true;
	place.xy_reset_counter = 1U;
	position.publish(place);
	said("place");
	attitude.publish(turned);
	said("attitude");
	place.xy_reset_counter = 9U;
	position.publish(place);
	attitude.publish(turned);
	said("no mode");
	return 0;
}
"#;

/// The module of PX4 that reads and writes the vehicle's topics: what it computes of them.
pub fn bridged(workspace: &Path, settings: &Path) {
    let before = fs::read_to_string(settings).expect("the settings");
    let packed = |topics: &str, folder: &str| {
        fs::write(settings, format!("{before}{topics}")).expect("the settings");
        let (package, system) = (Default::default(), System::Px4);
        pack::run(workspace, &Pack { package, system, output: workspace.join(folder) }, false)
    };
    let said = packed(TOPICS, "bridged").unwrap_or_else(|error| panic!("{error}"));
    assert!(said.contains("stop the module of PX4 that publishes the same topics"), "{said}");
    let built = Built { folder: workspace.join("bridged/models"), name: "px4" };
    assert!(!built.folder.join("msg/NewWatchStepInput.msg").exists());
    uorb(&built);
    built.write("main.cpp", PX4);
    let mut objects = Vec::new();
    for source in built.sources("src") {
        let object = format!("{source}.o");
        built.compile("gcc", &["-std=gnu11", "-c", "-Isrc", &source, "-o", &object]);
        objects.push(object);
    }
    let mut words = vec!["-std=c++14", "-I.", "-Isrc", "-Istub", "main.cpp"];
    words.extend(objects.iter().map(String::as_str));
    built.compile("g++", &[&words[..], &["-lm", "-o", "program"]].concat());
    let program = built.folder.join("program");
    if program.is_file() {
        let output = Command::new(program).output().expect("it runs");
        // Gains are 2: 0.5 · (2 · (8 − 1) + 0.5), and 0.5 + 0.25 − 3; the mode is `Run`. Nine is no mode.
        let expected = "attitude alone: 0 0 0 0 0 0 0\nplace: 0 0 0 0 0 0 0\n\
            attitude: 1 7.25 -2.25 0.125 nan 1 1\nno mode: 1 7.25 -2.25 0.125 nan 1 1\n";
        assert_eq!(String::from_utf8_lossy(&output.stdout), expected);
    }

    let topics = TOPICS.replace("Watch::step", "Watch::steps");
    let error = packed(&topics, "mistaken").expect_err("there is no such entry point");
    let line = before.lines().count() + 14;
    let known = "`new_motor_step`, `new_watch_step`, `new_watch_stop`";
    assert_eq!(
        (error.to_string(), error.remedy()),
        (
            format!("bessemer.toml:{line}: there is no entry point `Watch::steps`"),
            Some(format!("choose from {known}"))
        )
    );
    fs::write(settings, before).expect("the settings");
}
