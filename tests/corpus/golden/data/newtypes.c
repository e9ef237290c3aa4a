/* The C of tests/corpus/src/programs/data/newtypes.rs. Written by a test. */

/* newtypes.c */

void newtypes_metres(const feet_t *feet, newtypes_metres_t *BESSEMER_RESTRICT metres)
{
    metres->value = feet->value * 0.3048;
}

double newtypes_speed(const newtypes_leg_t *leg)
{
    return leg->first.value / leg->second;
}

/* newtypes.h */

/** A length, m. */
typedef struct {
    double value;
} newtypes_metres_t;

/** A length, ft. */
typedef struct {
    double value;
} feet_t;

/** A distance and the time that it took, s. */
typedef struct {
    newtypes_metres_t first;
    double second;
} newtypes_leg_t;
