/* The C of tests/corpus/src/programs/matrices/named_rows.rs. Written by a test. */

/* named_rows.c */

/** Row of the accelerometer's bias, m/s². */
static const uint64_t BIAS = UINT64_C(2);

/** Row of the position, m. */
static const uint64_t POSITION = UINT64_C(0);

/** Row of the velocity, m/s. */
static const uint64_t VELOCITY = UINT64_C(1);

void named_rows_moved(double state[BESSEMER_RESTRICT 3], double time,
    double advance[BESSEMER_RESTRICT 9])
{
    state[POSITION] += time * state[VELOCITY];
    state[VELOCITY] -= time * state[BIAS];
    static const double moved[9] = {
        1.0, 0.0, 0.0,
        0.0, 1.0, 0.0,
        0.0, 0.0, 1.0
    };
    (void)memcpy(advance, moved, sizeof(double[9]));
    advance[POSITION + 3U * VELOCITY] = time;
    advance[VELOCITY + 3U * BIAS] = -time;
}

double named_rows_shifted(double loads[BESSEMER_RESTRICT 2], const double shares[4], double load)
{
    loads[0] -= load;
    loads[1] += load;
    return shares[0 + 2 * 0] + shares[1 + 2 * 1];
}

/* named_rows.h */

/** A wheel. */
typedef enum {
    WHEEL_LEFT = 0,
    WHEEL_RIGHT = 1
} wheel_t;
