/* The C of tests/corpus/src/programs/faults/assertions.rs. Written by a test. */

/* assertions.c */

bessemer_status_t assertions_share(double part, double whole, double *result)
{
    if (!(whole > 0.0)) {
        return BESSEMER_STATUS_ASSERTION;
    }
    if (part == whole) {
        return BESSEMER_STATUS_ASSERTION;
    }
    *result = part / whole;
    return BESSEMER_STATUS_OK;
}
