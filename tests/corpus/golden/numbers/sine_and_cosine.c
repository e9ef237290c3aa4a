/* The C of tests/corpus/src/programs/numbers/sine_and_cosine.rs. Written by a test. */

/* sine_and_cosine.c */

void sine_and_cosine_turned(double x, double y, double angle, double result[2])
{
    pair_f64_f64_t pair;
    sine_sin_cos(angle, &pair);
    result[0] = pair.second * x - pair.first * y;
    result[1] = pair.first * x + pair.second * y;
}

void sine_and_cosine_turned_f32(float x, float y, float angle, float result[2])
{
    pair_f32_f32_t pair;
    math_single_sin_cosf(angle, &pair);
    result[0] = pair.second * x - pair.first * y;
    result[1] = pair.first * x + pair.second * y;
}
