// A stand-in for PX4's header of this name, for a test.
#pragma once

#include <px4_platform_common/px4_work_queue/WorkItem.hpp>

namespace uORB
{
class SubscriptionCallbackWorkItem
{
public:
	SubscriptionCallbackWorkItem(px4::WorkItem *, const char *) {}
	bool registerCallback() { return true; }
	void unregisterCallback() {}
	template <class T> bool update(T *) { return true; }
};
}
