// A stand-in for ArduPilot's header of this name, for a test.
#pragma once

#include <stdint.h>

#include <AP_Common/AP_Common.h>
