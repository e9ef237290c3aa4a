/* The C of tests/corpus/src/programs/functions/external.rs. Written by a test. */

/* external.c */

float external_mean(uint16_t one, uint16_t other)
{
    const float result_linear = sensor_linear(one);
    const float result_linear_2 = sensor_linear(other);
    return (result_linear + result_linear_2) / 2.0F;
}

void external_rates(const float raw[3], float scale, float axes[BESSEMER_RESTRICT 3])
{
    axes[0] = 0.0F;
    axes[1] = 0.0F;
    axes[2] = 0.0F;
    sensor_axes(raw, scale, axes);
}
