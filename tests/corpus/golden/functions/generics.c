/* The C of tests/corpus/src/programs/functions/generics.rs. Written by a test. */

/* generics.c */

static float generics_mean_f32_3(const float values[3]);
static double generics_mean_f64_4(const double values[4]);
static double generics_larger_f64(double a, double b);
static int32_t generics_larger_i32(int32_t a, int32_t b);

/** The mean of some values; 0 if there are none. */
static float generics_mean_f32_3(const float values[3])
{
    float sum = 0.0F;
    for (uint32_t i = 0U; i < 3U; i++) {
        sum += values[i];
    }
    return sum / 3.0F;
}

/** The mean of some values; 0 if there are none. */
static double generics_mean_f64_4(const double values[4])
{
    double sum = 0.0;
    for (uint32_t i = 0U; i < 4U; i++) {
        sum += values[i];
    }
    return sum / 4.0;
}

/** The larger of two values. */
static double generics_larger_f64(double a, double b)
{
    if (b > a) {
        return b;
    } else {
        return a;
    }
}

/** The larger of two values. */
static int32_t generics_larger_i32(int32_t a, int32_t b)
{
    if (b > a) {
        return b;
    } else {
        return a;
    }
}

double generics_level(const float coarse[3], const double fine[4], int32_t least)
{
    const int32_t least_2 = generics_larger_i32(least, -100);
    return generics_larger_f64(generics_larger_f64((double)generics_mean_f32_3(coarse),
        generics_mean_f64_4(fine)), (double)least_2);
}
