/* The C of tests/corpus/src/programs/numbers/fused.rs. Written by a test. */

/* programs_numbers_fused.c */

double programs_numbers_fused_lost(double a, double b)
{
    return math_fused_mul_add(a, b, -(a * b));
}

float programs_numbers_fused_quadratic(float x, float a, float b, float c)
{
    return math_fused_mul_addf(math_fused_mul_addf(x, a, b), x, c);
}
