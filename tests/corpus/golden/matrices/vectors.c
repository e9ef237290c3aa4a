/* The C of tests/corpus/src/programs/matrices/vectors.rs. Written by a test. */

/* vectors.c */

void vectors_velocity(const double velocity[3], const double force[3], double mass, double time,
    double result[BESSEMER_RESTRICT 3])
{
    const double acceleration[3] = {
        (force[0] - velocity[0] * 0.1) / mass,
        (force[1] - velocity[1] * 0.1) / mass,
        (force[2] - velocity[2] * 0.1) / mass
    };
    result[0] = velocity[0] + acceleration[0] * time;
    result[1] = velocity[1] + acceleration[1] * time;
    result[2] = velocity[2] + acceleration[2] * time;
}

double vectors_across(const double a[3], const double b[3])
{
    const double result_cross[3] = {
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0]
    };
    return sqrt(result_cross[0] * result_cross[0] + result_cross[1] * result_cross[1]
        + result_cross[2] * result_cross[2]);
}
