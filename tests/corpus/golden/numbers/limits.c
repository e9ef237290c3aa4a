/* The C of tests/corpus/src/programs/numbers/limits.rs. Written by a test. */

/* programs_numbers_limits.c */

static const uint8_t U8_MAX = 255U;

double programs_numbers_limits_allowed(double wanted, double limit)
{
    return max_f64(min_f64(wanted, limit), 0.0);
}

float programs_numbers_limits_throttle(float command)
{
    return clamp_f32(command, 0.0F, 1.0F);
}

uint8_t programs_numbers_limits_sum(uint8_t a, uint8_t b)
{
    return (uint8_t)min_u16((uint16_t)((uint16_t)a + (uint16_t)b), (uint16_t)U8_MAX);
}
