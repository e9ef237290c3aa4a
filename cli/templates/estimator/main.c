/* A stub of the firmware: call estimator and monitor once in each period. */
#include "@NAME@.h"
#include "height_estimator.h"
#include "sensor_monitor.h"

#include <stdio.h>

int main(void)
{
    static height_estimator_t estimator;
    static sensor_monitor_t monitor;
    static tuning_t tuning;
    estimate_t estimate;

    height_estimator_init(&estimator);
    sensor_monitor_init(&monitor);
    tuning_defaults(&tuning);
    for (int i = 0; i < 3; i++) {
        /* Acceleration and height come from your sensors. */
        height_estimator_step(&estimator, &tuning, 0.0, 1.0, &estimate);
        const bool trusted = sensor_monitor_step(&monitor, &tuning, estimate.innovation);
        (void)printf("%.17g %d\n", estimate.height, (int)trusted);
    }
    return 0;
}
