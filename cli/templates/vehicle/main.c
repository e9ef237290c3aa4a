/* A stub of the firmware: call both controllers once in each period. */
#include "@NAME@.h"
#include "cruise.h"
#include "lane.h"

#include <stdio.h>

int main(void)
{
    static cruise_t cruise;
    static lane_t lane;
    static tuning_t tuning;

    cruise_init(&cruise);
    lane_init(&lane);
    tuning_defaults(&tuning);
    for (int i = 0; i < 3; i++) {
        /* Speed, offset and heading come from your sensors. */
        const double force = cruise_step(&cruise, &tuning, 25.0, 15.0);
        const double steering = lane_step(&lane, &tuning, 1.0, 0.0);
        (void)printf("%.17g %.17g\n", force, steering);
    }
    return 0;
}
