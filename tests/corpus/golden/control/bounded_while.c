/* The C of tests/corpus/src/programs/control/bounded_while.rs. Written by a test. */

/* bounded_while.c */

bessemer_status_t bounded_while_root(double x, double tolerance, double *guess)
{
    double guess_value = max_f64(x, 1.0);
    for (uint32_t pass = 0U; pass <= 40U; pass++) {
        if (!(guess_value * guess_value - x > tolerance)) {
            break;
        }
        if (pass >= 40U) {
            return BESSEMER_STATUS_BOUND;
        }
        guess_value = (guess_value + x / guess_value) / 2.0;
    }
    *guess = guess_value;
    return BESSEMER_STATUS_OK;
}
