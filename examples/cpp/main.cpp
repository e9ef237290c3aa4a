/*
 * main.cpp: the emitted C from C++. A component is a struct and functions; here it becomes a class that cannot be used
 * before its initial state is set.
 *
 * The drone holds a height of 1 m for ten seconds: controller and plant are both emitted. What it prints is the same on
 * each machine, to the bit; `tests/tests/examples.rs` compares it with the Rust.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "airframe.h"
#include "controller.h"
#include "parameters.h"
#include "plant.h"

namespace {

/** The closed loop: the controller sees the plant as it is. */
class Drone {
public:
    Drone()
    {
        controller_init(&controller_);
        plant_init(&plant_);
        parameters_mambo(&parameters_);
        airframe_mambo(&airframe_);
    }

    /** One control period towards a target. */
    void step(const target_t &target)
    {
        const double feed_forward[8] = {};
        controller_step(&controller_, &parameters_, &estimate_, &target, feed_forward, &command_);
        motion_t motion;
        plant_step(&plant_, &airframe_, command_.speeds, parameters_.period, &motion);
        std::memcpy(estimate_.position, motion.position, sizeof motion.position);
        std::memcpy(estimate_.angles, motion.angles, sizeof motion.angles);
        std::memcpy(estimate_.velocity, motion.velocity, sizeof motion.velocity);
        std::memcpy(estimate_.rates, motion.rates, sizeof motion.rates);
    }

    /** The control period, s. */
    double period() const { return parameters_.period; }

    /** Above the start, m. */
    double height() const { return estimate_.position[2]; }

private:
    controller_t controller_;
    plant_t plant_;
    parameters_t parameters_;
    airframe_t airframe_;
    estimate_t estimate_ = {};
    command_t command_ = {};
};

} // namespace

int main()
{
    Drone drone;
    target_t target = {};
    target.position[2] = 1.0;
    const int periods = static_cast<int>(10.0 / drone.period());
    for (int n = 0; n < periods; ++n) {
        drone.step(target);
        if ((n + 1) % 200 == 0) {
            const double height = drone.height();
            std::uint64_t bits;
            std::memcpy(&bits, &height, sizeof bits);
            std::printf("%016llx %8.4f m\n", static_cast<unsigned long long>(bits), height);
        }
    }
    return 0;
}
