/* The C of tests/corpus/src/programs/control/if_values.rs. Written by a test. */

/* if_values.c */

double if_values_gain(bool fast, double error)
{
    double base;
    if (fast) {
        base = 2.0;
    } else {
        base = 0.5;
    }
    if (fabs(error) > 1.0) {
        return base * 2.0;
    } else if (fabs(error) > 0.1) {
        return base;
    } else {
        return 0.0;
    }
}
