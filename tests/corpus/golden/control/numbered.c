/* The C of tests/corpus/src/programs/control/numbered.rs. Written by a test. */

/* numbered.c */

float bin_take(bin_t *self)
{
    const float a = self->parts[0];
    const float b = self->parts[1];
    self->parts[0] = 0.0F;
    self->parts[1] = 0.0F;
    return a * a + b * b;
}

void numbered_strongest(bin_t bins[BESSEMER_RESTRICT 4],
    option_pair_usize_f32_t *BESSEMER_RESTRICT result)
{
    *result = (option_pair_usize_f32_t){.is_some = false};
    for (uint32_t i = 0U; i < 4U; i++) {
        const float b = bin_take(&bins[i]);
        if (result->is_some) {
            if (!sort_below_f32(b, result->value.second)) {
                result->is_some = true;
                result->value.first = i;
                result->value.second = b;
            }
        } else {
            result->is_some = true;
            result->value.first = i;
            result->value.second = b;
        }
    }
}

bessemer_status_t numbered_weighted(const int16_t values[6], int16_t least,
    int64_t *BESSEMER_RESTRICT sum)
{
    int64_t sum_value = INT64_C(0);
    uint32_t next = 0U;
    for (uint32_t i = 0U; i < 6U; i++) {
        if (values[i] > least) {
            const uint32_t rank = next;
            next += 1U;
            const int64_t sum_product = ((int64_t)rank + INT64_C(1)) * (int64_t)values[i];
            if ((sum_product >= INT64_C(0) && sum_value > INT64_MAX - sum_product)
                    || (sum_product <= INT64_C(0) && sum_value < INT64_MIN - sum_product)) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            sum_value += sum_product;
        }
    }
    *sum = sum_value;
    return BESSEMER_STATUS_OK;
}

uint32_t numbered_every_second(uint8_t count)
{
    uint32_t a = 0U;
    for (uint32_t at = 0U; at < (uint32_t)count; at++) {
        const uint32_t x = at;
        const uint32_t b = x * x;
        if (at % 2U == 1U) {
            a ^= b;
        }
    }
    return a;
}

float numbered_gathered(bin_t first[BESSEMER_RESTRICT 2], bin_t second[BESSEMER_RESTRICT 3],
    float x)
{
    float sum = 0.0F;
    for (uint32_t i = 0U; i < 2U; i++) {
        if (first[i].parts[0] < 0.0F) {
            continue;
        }
        first[i].parts[1] += x;
        const float sum_take = bin_take(&first[i]);
        sum += sum_take;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (second[i].parts[0] < 0.0F) {
            continue;
        }
        second[i].parts[1] += x;
        const float sum_take = bin_take(&second[i]);
        sum += sum_take;
    }
    return sum;
}

/* numbered.h */

/** A filter whose power can be taken once. */
typedef struct {
    /** The two parts of its state. */
    float parts[2];
} bin_t;
