/* The C of tests/corpus/src/programs/numbers/wide_integers.rs. Written by a test. */

/* wide_integers.c */

static const u128_t LOW = {.high = UINT64_C(65535), .low = UINT64_MAX};
static const u128_t U128_MAX = {.high = UINT64_MAX, .low = UINT64_MAX};

uint64_t wide_integers_upper(uint64_t a, uint64_t b)
{
    u128_t number_value;
    u128_product_of_words(a, b, &number_value);
    u128_t number;
    u128_wrapping_shr(&number_value, 64U, &number);
    return number.low;
}

bessemer_status_t wide_integers_nanoseconds(uint64_t ticks, uint32_t frequency, uint64_t *result)
{
    u128_t number;
    u128_product_of_words(ticks, UINT64_C(1000000000), &number);
    const u128_t divisor = {.high = UINT64_C(0), .low = (uint64_t)frequency};
    if (divisor.high == UINT64_C(0) && divisor.low == UINT64_C(0)) {
        return BESSEMER_STATUS_DIVISION_BY_ZERO;
    }
    u128_t number_2;
    u128_quotient(&number, &divisor, &number_2);
    *result = number_2.low;
    return BESSEMER_STATUS_OK;
}

void wide_integers_small(uint64_t a, uint64_t b, uint32_t c, uint16_t d, pair_u64_u64_t *result)
{
    u128_t mean_number;
    u128_sum_of_words(a, b, &mean_number);
    const u128_t mean_divisor = {.high = UINT64_C(0), .low = UINT64_C(2)};
    u128_t mean;
    u128_quotient(&mean_number, &mean_divisor, &mean);
    const u128_t number = {.high = UINT64_C(0), .low = (uint64_t)c * (uint64_t)d};
    result->first = mean.low;
    result->second = number.low;
}

bessemer_status_t wide_integers_energy(const int32_t samples[4], u128_t *BESSEMER_RESTRICT sum)
{
    u128_t sum_value = {.high = UINT64_C(0), .low = UINT64_C(0)};
    for (uint32_t i = 0U; i < 4U; i++) {
        const u128_t magnitude = {
            .high = UINT64_C(0),
            .low = (uint64_t)unsigned_abs_i32(samples[i])
        };
        option_u128_t product;
        u128_checked_mul(&magnitude, &magnitude, &product);
        if (!product.is_some) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        option_u128_t sum_value_2;
        u128_checked_add(&sum_value, &product.value, &sum_value_2);
        if (!sum_value_2.is_some) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        sum_value = sum_value_2.value;
    }
    *sum = sum_value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t wide_integers_arithmetic(const u128_t *a, const u128_t *b, uint8_t bits,
    u128_t *BESSEMER_RESTRICT u128)
{
    const u128_t product_b = {.high = UINT64_C(0), .low = UINT64_C(3)};
    option_u128_t product;
    u128_checked_mul(a, &product_b, &product);
    if (!product.is_some) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    option_u128_t sum;
    u128_checked_add(&product.value, b, &sum);
    if (!sum.is_some) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    const u128_t sum_2 = sum.value;
    const u128_t divisor = {.high = b->high | UINT64_C(0), .low = b->low | UINT64_C(1)};
    if (divisor.high == UINT64_C(0) && divisor.low == UINT64_C(0)) {
        return BESSEMER_STATUS_DIVISION_BY_ZERO;
    }
    u128_t difference_a;
    u128_remainder(&sum_2, &divisor, &difference_a);
    const u128_t difference_divisor = {.high = UINT64_C(0), .low = UINT64_C(7)};
    u128_t difference_number;
    u128_quotient(&sum_2, &difference_divisor, &difference_number);
    u128_t difference_b;
    u128_wrapping_shr(&difference_number, 1U, &difference_b);
    option_u128_t difference;
    u128_checked_sub(&difference_a, &difference_b, &difference);
    if (!difference.is_some) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    const u128_t rest = difference.value;
    if ((uint64_t)bits > UINT64_C(127)) {
        return BESSEMER_STATUS_SHIFT;
    }
    u128_wrapping_shl(&rest, (uint32_t)bits, u128);
    return BESSEMER_STATUS_OK;
}

void wide_integers_masked(const u128_t *a, const u128_t *b, u128_t *BESSEMER_RESTRICT u128)
{
    const u128_t one = {.high = ~a->high, .low = ~a->low};
    const u128_t one_2 = {.high = one.high & LOW.high, .low = one.low & LOW.low};
    const u128_t other_number = {.high = UINT64_C(0), .low = UINT64_C(1)};
    u128_t other;
    u128_wrapping_shl(&other_number, 100U, &other);
    const u128_t other_2 = {.high = b->high | other.high, .low = b->low | other.low};
    const u128_t one_3 = {.high = one_2.high ^ other_2.high, .low = one_2.low ^ other_2.low};
    u128->high = one_3.high ^ UINT64_C(0);
    u128->low = one_3.low ^ UINT64_C(5);
}

uint32_t wide_integers_class(const u128_t *a, const u128_t *b)
{
    const bool result_holds = (a->high == b->high && a->low == b->low)
        || (a->high == U128_MAX.high && a->low == U128_MAX.low);
    if (result_holds) {
        return 0U;
    } else {
        const u128_t u128 = {.high = UINT64_C(54), .low = UINT64_C(0x35C9ADC5DEA00000)};
        bool result_holds_2 = false;
        if (a->high < u128.high || (a->high == u128.high && a->low < u128.low)) {
            u128_t u128_2;
            comparison_lesser_u128(a, b, &u128_2);
            const u128_t u128_3 = {.high = UINT64_C(0), .low = UINT64_C(0)};
            result_holds_2 = !(u128_2.high == u128_3.high && u128_2.low == u128_3.low);
        }
        if (result_holds_2) {
            return 1U;
        } else if (a->high > b->high || (a->high == b->high && a->low >= b->low)) {
            return 2U;
        } else {
            return 3U;
        }
    }
}

bessemer_status_t wide_integers_scaled(int64_t a, int64_t b, int64_t *result)
{
    i128_t sum_a;
    i128_product_of_words(a, b, &sum_a);
    const i128_t sum_number = {.high = INT64_C(0), .low = UINT64_C(1)};
    i128_t sum_b;
    i128_wrapping_shl(&sum_number, 30U, &sum_b);
    option_i128_t sum;
    i128_checked_add(&sum_a, &sum_b, &sum);
    if (!sum.is_some) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    i128_t number;
    i128_wrapping_shr(&sum.value, 31U, &number);
    *result = wrap_i64(number.low);
    return BESSEMER_STATUS_OK;
}
