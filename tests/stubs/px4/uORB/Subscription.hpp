// A stand-in for PX4's header of this name, for a test.
#pragma once

#include <stdint.h>

#include <uORB/Bus.hpp>

namespace uORB
{
class Subscription
{
public:
	Subscription(const char *, uint8_t) {}
	template <class T> bool update(T *message) { return newer(_seen, message); }

private:
	unsigned _seen{0};
};
}
