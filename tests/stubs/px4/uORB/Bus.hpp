// Carries the messages of the stand-ins for uORB: the last one of each type, and a call for who waits for a topic.
#pragma once

#include <string.h>
#include <vector>

#include <px4_platform_common/px4_work_queue/WorkItem.hpp>

#define ORB_ID(name) #name

namespace uORB
{
template <class T> struct Bus {
	static T last;
	static unsigned count;
};

template <class T> T Bus<T>::last{};
template <class T> unsigned Bus<T>::count = 0;

struct Listener {
	const char *topic;
	px4::WorkItem *item;
};

inline std::vector<Listener> &listeners()
{
	static std::vector<Listener> all;
	return all;
}

/** Copies the last message of a topic, if it is newer than what was seen. */
template <class T> bool newer(unsigned &seen, T *message)
{
	if (seen == Bus<T>::count) {
		return false;
	}
	seen = Bus<T>::count;
	*message = Bus<T>::last;
	return true;
}
}
