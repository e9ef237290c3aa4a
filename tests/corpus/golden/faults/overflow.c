/* The C of tests/corpus/src/programs/faults/overflow.rs. Written by a test. */

/* overflow.c */

bessemer_status_t overflow_distance(int32_t a, int32_t b, int32_t *result)
{
    if ((int64_t)a - (int64_t)b < INT32_MIN || (int64_t)a - (int64_t)b > INT32_MAX) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    if (a - b == INT32_MIN) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    *result = abs_i32(a - b);
    return BESSEMER_STATUS_OK;
}
