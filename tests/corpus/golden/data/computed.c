/* The C of tests/corpus/src/programs/data/computed.rs. Written by a test. */

/* computed.c */

/** The length of a day, s. In Rust: `24 * 3600`. */
static const uint32_t DAY = 86400U;

/** Proportional and derivative gain. In Rust: `Gains::damped(2.0, -0.5)`. */
static const computed_gains_t GAINS = {.proportional = 2.0, .derivative = -1.0};

/** The largest step. */
static const int16_t LARGEST = INT16_MAX;

/** A mask computed from another constant. In Rust: `1 << 24 | (DAY & 0xFF)`. */
static const uint32_t LEFT = 0x1000080U;

/** Contribution of each of the three motors. In Rust: `[0.25 * -SIXTH; 3]`. */
static const double SHARES[3] = {0.041666666666666664, 0.041666666666666664, 0.041666666666666664};

/** In Rust: `-1.0 / 6.0`. */
static const double SIXTH = -0.16666666666666666;

double computed_mixed(double x, int16_t step)
{
    const double time = f64_from_u32(DAY ^ LEFT);
    double bounded;
    if (step == LARGEST) {
        bounded = SIXTH;
    } else {
        bounded = SHARES[1];
    }
    return GAINS.proportional * x + GAINS.derivative * time + bounded;
}

void computed_gains(computed_gains_t *gains)
{
    *gains = GAINS;
}

/* computed.h */

/** Gains of a controller. */
typedef struct {
    double proportional;
    double derivative;
} computed_gains_t;
