// A part of the topic that PX4 makes of its message of this name, for a test.
#pragma once

#include <stdint.h>

struct actuator_motors_s {
	uint64_t timestamp;
	uint64_t timestamp_sample;
	uint16_t reversible_flags;
	float control[12];
};
