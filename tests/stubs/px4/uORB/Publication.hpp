// A stand-in for PX4's header of this name, for a test.
#pragma once

#include <uORB/Bus.hpp>

namespace uORB
{
template <class T> class Publication
{
public:
	Publication(const char *topic) : _topic(topic) {}
	bool publish(const T &message)
	{
		Bus<T>::last = message;
		++Bus<T>::count;
		for (const Listener &it : listeners()) {
			if (strcmp(it.topic, _topic) == 0) {
				it.item->ScheduleNow();
			}
		}
		return true;
	}

private:
	const char *_topic;
};
}
