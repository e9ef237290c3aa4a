// A part of the topic that PX4 makes of its message of this name, for a test.
#pragma once

#include <stdint.h>

struct vehicle_local_position_s {
	uint64_t timestamp;
	uint64_t timestamp_sample;
	bool xy_valid;
	bool z_valid;
	float x;
	float y;
	float z;
	uint8_t xy_reset_counter;
	float vx;
	float vy;
	float vz;
	float heading;
};
