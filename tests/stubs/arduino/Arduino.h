// A stand-in for Arduino's header of this name, for a test: the sketch is compiled behind it, as Arduino does.
#pragma once

#include <stdint.h>

static inline void delay(unsigned long) {}
