/* A stub of the firmware: the current loop runs in each period, the speed loop in each tenth. */
#include "@NAME@.h"
#include "current_loop.h"
#include "speed_loop.h"

#include <stdio.h>

int main(void)
{
    static speed_loop_t outer;
    static current_loop_t inner;
    static tuning_t tuning;
    double target = 0.0;

    speed_loop_init(&outer);
    current_loop_init(&inner);
    tuning_defaults(&tuning);
    for (int i = 0; i < 20; i++) {
        /* Speed and current come from your sensors, the voltage goes to your inverter. */
        const double speed = 0.0;
        const double current = 0.0;
        if (i % 10 == 0) {
            target = speed_loop_step(&outer, &tuning, 300.0, speed);
        }
        const double voltage = current_loop_step(&inner, &tuning, target, current);
        (void)printf("%.17g\n", voltage);
    }
    return 0;
}
