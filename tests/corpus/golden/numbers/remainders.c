/* The C of tests/corpus/src/programs/numbers/remainders.rs. Written by a test. */

/* remainders.c */

static const double TAU = 6.283185307179586;

/* The remainder of a / b that is 0 or more; b is not 0, and the quotient fits. */
static int32_t rem_euclid_i32(int32_t a, int32_t b)
{
    const int32_t remainder = a % b;
    if (remainder < 0) {
        return b > 0 ? remainder + b : remainder - b;
    }
    return remainder;
}

/* The remainder of a / b, from 0 to the size of b. */
static double rem_euclid_f64(double a, double b)
{
    const double remainder = fmod(a, b);
    return remainder < 0.0 ? remainder + fabs(b) : remainder;
}

int32_t remainders_in_ring(int32_t place, int8_t step)
{
    return rem_euclid_i32((place % 12) + (int32_t)step, 12);
}

double remainders_wrapped(double angle)
{
    return rem_euclid_f64(angle, TAU);
}
