/* The C of tests/corpus/src/programs/functions/calls.rs. Written by a test. */

/* calls.c */

double calls_sign(double x)
{
    if (x > 0.0) {
        return 1.0;
    } else if (x < 0.0) {
        return -1.0;
    } else {
        return 0.0;
    }
}

double calls_dead_band(double x, double width)
{
    return calls_sign(x) * max_f64(fabs(x) - width, 0.0);
}

double calls_deflection(double x)
{
    const double y = calls_dead_band(x, 0.05);
    return calls_sign(y) * y * y;
}
