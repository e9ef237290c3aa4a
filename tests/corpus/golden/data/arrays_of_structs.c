/* The C of tests/corpus/src/programs/data/arrays_of_structs.rs. Written by a test. */

/* arrays_of_structs.c */

void arrays_of_structs_current(const waypoint_t plan[4], double time,
    waypoint_t *BESSEMER_RESTRICT found)
{
    *found = plan[0];
    for (uint32_t i = 1U; i < 4U; i++) {
        if (plan[i].time <= time) {
            *found = plan[i];
        }
    }
}

/* arrays_of_structs.h */

/** A setpoint and the time from which it is valid. */
typedef struct {
    /** Position, m. */
    double position[2];
    /** Start of its validity, s. */
    double time;
} waypoint_t;
