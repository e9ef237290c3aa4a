/* A stub of the firmware: call the controller once in each control period. */
#include "@NAME@.h"

#include <stdio.h>

int main(void)
{
    static @NAME@_t controller;
    static gains_t gains;

    @NAME@_init(&controller);
    gains_defaults(&gains);
    for (int i = 0; i < 3; i++) {
        /* The speed comes from your sensor, the voltage goes to your inverter. */
        const double speed = 0.0;
        const double voltage = @NAME@_step(&controller, &gains, 100.0, speed);
        (void)printf("%.17g\n", voltage);
    }
    return 0;
}
