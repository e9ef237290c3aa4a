/* The C of tests/corpus/src/programs/control/one_after_another.rs. Written by a test. */

/* one_after_another.c */

uint64_t one_after_another_low(const one_after_another_cell_t own[4],
    const one_after_another_cell_t added[3], float limit)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < 7U; i++) {
        one_after_another_cell_t cell;
        if (i < 4U) {
            cell = own[i];
        } else {
            cell = added[i - 4U];
        }
        if (cell.valid && cell.voltage < limit) {
            count += 1U;
        }
    }
    return count;
}

uint8_t one_after_another_checksum(const uint8_t header[3], const list6_u8_t *payload)
{
    uint8_t sum = 0xFFU;
    {
        const uint32_t end = (uint32_t)(min_u64(payload->length, UINT64_C(6)) + 3U);
        for (uint32_t i = 0U; i < end; i++) {
            uint8_t byte;
            if (i < 3U) {
                byte = header[i];
            } else {
                byte = payload->items[i - 3U];
            }
            sum = (uint8_t)((((uint32_t)sum << 1U) | (sum >> 7U)) ^ byte);
        }
    }
    return sum;
}

void one_after_another_first_zero(const int16_t before[3], const int16_t now[2],
    option_usize_t *BESSEMER_RESTRICT result)
{
    *result = (option_usize_t){.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        int16_t x;
        if (i < 3U) {
            x = before[i];
        } else {
            x = now[i - 3U];
        }
        if (x == 0) {
            result->is_some = true;
            result->value = i;
            break;
        }
    }
}

int32_t one_after_another_left(const int16_t samples[7])
{
    int32_t sum = 0;
    for (uint32_t i = 0U; i < 4U; i++) {
        sum += (int32_t)samples[i * 2U];
    }
    return sum;
}

bessemer_status_t one_after_another_right(const int16_t samples[7], int32_t *BESSEMER_RESTRICT sum)
{
    int32_t sum_value = 0;
    for (uint32_t i = 0U; i < 3U; i++) {
        const int32_t sum_product = (int32_t)samples[i * 2U + 1U] * ((int32_t)i + 1);
        if ((int64_t)sum_value + (int64_t)sum_product < INT32_MIN
                || (int64_t)sum_value + (int64_t)sum_product > INT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        sum_value += sum_product;
    }
    *sum = sum_value;
    return BESSEMER_STATUS_OK;
}

void one_after_another_marks(uint8_t length, pair_u8_u32_t *result)
{
    uint8_t count = 0U;
    uint32_t sum = 0U;
    const uint8_t place_passes = (uint8_t)((uint32_t)length / 5U + 1U);
    for (uint8_t pass = 0U; pass < place_passes; pass++) {
        const uint8_t place = (uint8_t)((uint32_t)pass * 5U);
        count = (uint8_t)(count + 1U);
        sum += (uint32_t)place;
    }
    result->first = count;
    result->second = sum;
}

/* one_after_another.h */

/** A reading of a cell. */
typedef struct {
    float voltage;
    bool valid;
} one_after_another_cell_t;
