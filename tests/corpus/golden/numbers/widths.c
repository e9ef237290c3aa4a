/* The C of tests/corpus/src/programs/numbers/widths.rs. Written by a test. */

/* widths.c */

int64_t widths_products(int8_t a, int16_t b, int32_t c, int64_t d)
{
    const int16_t small = (int16_t)((int16_t)a * 3);
    const int32_t medium = (int32_t)b * (int32_t)small;
    const int64_t large = (int64_t)c * i64_from_i32(medium % 1000);
    return wrap_i64((uint64_t)large + (uint64_t)d);
}

bessemer_status_t widths_bucket(uint64_t hash, uint64_t buckets, uint64_t *result)
{
    if (buckets == UINT64_C(0)) {
        return BESSEMER_STATUS_DIVISION_BY_ZERO;
    }
    *result = hash % buckets;
    return BESSEMER_STATUS_OK;
}
