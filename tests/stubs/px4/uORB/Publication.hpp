// A stand-in for PX4's header of this name, for a test.
#pragma once

#define ORB_ID(name) #name

namespace uORB
{
template <class T> class Publication
{
public:
	Publication(const char *) {}
	bool publish(const T &) { return true; }
};
}
