/* The C of tests/corpus/src/programs/faults/clamps.rs. Written by a test. */

/* clamps.c */

/* The number nearest to value from low to high; NaN stays NaN. */
static double clamp_f64(double value, double low, double high)
{
    if (value < low) {
        return low;
    }
    return value > high ? high : value;
}

bessemer_status_t clamps_within(double value, double low, double high, double *result)
{
    if (!(low <= high)) {
        return BESSEMER_STATUS_CLAMP;
    }
    *result = clamp_f64(value, low, high);
    return BESSEMER_STATUS_OK;
}
