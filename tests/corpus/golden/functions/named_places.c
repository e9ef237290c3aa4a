/* The C of tests/corpus/src/programs/functions/named_places.rs. Written by a test. */

/* programs_functions_named_places.c */

bessemer_status_t programs_functions_named_places_drive(
    programs_functions_named_places_motor_t motors[BESSEMER_RESTRICT 4], uint64_t which,
    float speed, bool *BESSEMER_RESTRICT result)
{
    if (which >= UINT64_C(4)) {
        return BESSEMER_STATUS_INDEX;
    }
    motors[which].speed = speed;
    motors[which].on = speed != 0.0F;
    *result = motors[which].on;
    return BESSEMER_STATUS_OK;
}

/* programs_functions_named_places.h */

/** A motor. */
typedef struct {
    float speed;
    bool on;
} programs_functions_named_places_motor_t;
