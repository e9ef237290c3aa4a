/* The C of tests/corpus/src/programs/control/closures.rs. Written by a test. */

/* closures.c */

void closures_response(double gain, double corner, const double at[3],
    double result[BESSEMER_RESTRICT 3])
{
    for (uint32_t i = 0U; i < 3U; i++) {
        const double frequency = at[i];
        const double ratio = frequency / corner;
        const double mapped_choice = gain / sqrt(1.0 + ratio * ratio);
        const double ratio_2 = 2.0 * frequency / corner;
        const double mapped_choice_2 = gain / sqrt(1.0 + ratio_2 * ratio_2);
        result[i] = mapped_choice * mapped_choice_2;
    }
}

void closures_ramp(float low, float high, float result[5])
{
    const float step = (high - low) / 4.0F;
    for (uint32_t i = 0U; i < 5U; i++) {
        result[i] = low + step * (float)i;
    }
}
