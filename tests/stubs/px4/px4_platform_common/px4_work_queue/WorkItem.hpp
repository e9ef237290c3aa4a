// A stand-in for PX4's header of this name, for a test.
#pragma once

namespace px4
{
struct wq_config_t {
};

namespace wq_configurations
{
static constexpr wq_config_t rate_ctrl{};
}

class WorkItem
{
public:
	WorkItem(const char *, const wq_config_t &) {}
	virtual ~WorkItem() {}
	void ScheduleNow() { Run(); }

protected:
	virtual void Run() = 0;
};
}
