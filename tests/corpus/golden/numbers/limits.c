/* The C of tests/corpus/src/programs/numbers/limits.rs. Written by a test. */

/* corpus_programs_numbers_limits.c */

static const uint8_t U8_MAX = 255U;

/* The smaller of two integers. */
static uint16_t min_u16(uint16_t a, uint16_t b)
{
    return a < b ? a : b;
}

/* The smaller of two numbers: -0 < +0, and a NaN gives the other. */
static double min_f64(double a, double b)
{
    if (a < b || isnan(b)) {
        return a;
    }
    if (b < a || isnan(a)) {
        return b;
    }
    return signbit(a) ? a : b;
}

/* The larger of two numbers: -0 < +0, and a NaN gives the other. */
static double max_f64(double a, double b)
{
    if (a > b || isnan(b)) {
        return a;
    }
    if (b > a || isnan(a)) {
        return b;
    }
    return !signbit(a) ? a : b;
}

/* The number nearest to value from low to high; NaN stays NaN. */
static float clamp_f32(float value, float low, float high)
{
    if (value < low) {
        return low;
    }
    return value > high ? high : value;
}

double corpus_programs_numbers_limits_allowed(double wanted, double limit)
{
    return max_f64(min_f64(wanted, limit), 0.0);
}

float corpus_programs_numbers_limits_throttle(float command)
{
    return clamp_f32(command, 0.0F, 1.0F);
}

uint8_t corpus_programs_numbers_limits_sum(uint8_t a, uint8_t b)
{
    return (uint8_t)min_u16((uint16_t)((uint16_t)a + (uint16_t)b), (uint16_t)U8_MAX);
}
