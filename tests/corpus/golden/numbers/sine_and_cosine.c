/* The C of tests/corpus/src/programs/numbers/sine_and_cosine.rs. Written by a test. */

/* sine_and_cosine.c */

void sine_and_cosine_turned(double x, double y, double angle, double result[2])
{
    pair_f64_f64_t sine_cosine;
    sine_sin_cos(angle, &sine_cosine);
    result[0] = sine_cosine.second * x - sine_cosine.first * y;
    result[1] = sine_cosine.first * x + sine_cosine.second * y;
}

void sine_and_cosine_turned_f32(float x, float y, float angle, float result[2])
{
    pair_f32_f32_t sine_cosine;
    math_single_sin_cosf(angle, &sine_cosine);
    result[0] = sine_cosine.second * x - sine_cosine.first * y;
    result[1] = sine_cosine.first * x + sine_cosine.second * y;
}
