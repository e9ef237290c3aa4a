/* The C of tests/corpus/src/programs/faults/clamps.rs. Written by a test. */

/* clamps.c */

bessemer_status_t clamps_within(double value, double low, double high, double *result)
{
    if (!(low <= high)) {
        return BESSEMER_STATUS_CLAMP;
    }
    *result = clamp_f64(value, low, high);
    return BESSEMER_STATUS_OK;
}
