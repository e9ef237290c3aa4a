// A stand-in for PX4's header of this name: as much of its interface as an emitted module needs, so that it compiles in a test.
#pragma once

#undef __EXPORT // newlib has one of its own
#define __EXPORT __attribute__((visibility("default")))
#define PRINT_MODULE_USAGE_NAME(name, category) (void)(name), (void)(category)
#define PRINT_MODULE_USAGE_COMMAND(command) (void)(command)
#define PRINT_MODULE_USAGE_DEFAULT_COMMANDS() (void)0

template <class T> struct Slot {
	T *held{nullptr};
	void store(T *value) { held = value; }
};

template <class T> class ModuleBase
{
public:
	static int main(int argc, char *argv[]) { return argc > 1 ? T::task_spawn(argc, argv) : T::print_usage(nullptr); }

protected:
	bool should_exit() const { return false; }
	void exit_and_cleanup() {}
	static const int task_id_is_work_queue = -2;
	static int _task_id;
	static Slot<T> _object;
};

template <class T> int ModuleBase<T>::_task_id;
template <class T> Slot<T> ModuleBase<T>::_object;
