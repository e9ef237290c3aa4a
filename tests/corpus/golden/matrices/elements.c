/* The C of tests/corpus/src/programs/matrices/elements.rs. Written by a test. */

/* elements.c */

void elements_turn(double sine, double cosine, double matrix[9])
{
    static const double turn[9] = {
        1.0, 0.0, 0.0,
        0.0, 1.0, 0.0,
        0.0, 0.0, 1.0
    };
    (void)memcpy(matrix, turn, sizeof(double[9]));
    matrix[0 + 3 * 0] = cosine;
    matrix[0 + 3 * 1] = -sine;
    matrix[1 + 3 * 0] = sine;
    matrix[1 + 3 * 1] = cosine;
}

double elements_angle(const double turn[9])
{
    return arctangent_atan2(turn[1 + 3 * 0], turn[0 + 3 * 0]);
}

void elements_reordered(const float v[3], float result[BESSEMER_RESTRICT 3])
{
    result[0] = v[2];
    result[1] = v[0];
    result[2] = v[1];
}
