/* The C of tests/corpus/src/programs/numbers/float_kinds.rs. Written by a test. */

/* float_kinds.c */

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
