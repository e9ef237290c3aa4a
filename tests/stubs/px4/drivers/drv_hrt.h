// A stand-in for PX4's header of this name, for a test: its clock counts the calls.
#pragma once

#include <stdint.h>

static inline uint64_t hrt_absolute_time()
{
	static uint64_t now = 1000;
	return ++now;
}
