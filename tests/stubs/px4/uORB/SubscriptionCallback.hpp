// A stand-in for PX4's header of this name, for a test.
#pragma once

#include <stdint.h>

#include <uORB/Bus.hpp>

namespace uORB
{
class SubscriptionCallbackWorkItem
{
public:
	SubscriptionCallbackWorkItem(px4::WorkItem *item, const char *topic, uint8_t = 0) : _item(item), _topic(topic) {}
	bool registerCallback()
	{
		listeners().push_back({_topic, _item});
		return true;
	}
	void unregisterCallback() {}
	template <class T> bool update(T *message) { return newer(_seen, message); }

private:
	px4::WorkItem *_item;
	const char *_topic;
	unsigned _seen{0};
};
}
