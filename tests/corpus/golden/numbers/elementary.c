/* The C of tests/corpus/src/programs/numbers/elementary.rs. Written by a test. */

/* elementary.c */

double elementary_arc(double radius, double one, double other)
{
    const double half = sine_sin((one - other) / 2.0);
    return 2.0 * radius * arctangent_asin(min_f64(fabs(half), 1.0));
}

float elementary_heading(float east, float north)
{
    return math_single_atan2f(east, north);
}
