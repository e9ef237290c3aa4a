/* The C of tests/corpus/src/programs/numbers/float_kinds.rs. Written by a test. */

/* float_kinds.c */

/* The size of one number with the sign of another; a NaN counts as positive. */
static double copysign_f64(double size, double sign)
{
    return isnan(sign) ? fabs(size) : copysign(size, sign);
}

double float_kinds_usable(double measured, double before)
{
    if (isfinite(measured) != 0) {
        return measured;
    } else {
        return before;
    }
}

double float_kinds_direction(double command)
{
    return copysign_f64(1.0, command);
}
