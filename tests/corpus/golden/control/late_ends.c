/* The C of tests/corpus/src/programs/control/late_ends.rs. Written by a test. */

/* late_ends.c */

bessemer_status_t late_ends_digits(uint32_t n, uint32_t *count)
{
    uint32_t rest = n;
    uint32_t count_value = 0U;
    while (true) {
        if (count_value > 0xFFFFFFFEU) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        count_value += 1U;
        rest /= 10U;
        if (rest == 0U) {
            break;
        }
    }
    *count = count_value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t late_ends_power_above(uint32_t n, uint32_t *power)
{
    uint32_t power_value = 1U;
    while (power_value < n) {
        if (power_value > 0x7FFFFFFFU) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        power_value *= 2U;
    }
    *power = power_value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t late_ends_turned(const list5_u8_t *values, list5_u8_t *BESSEMER_RESTRICT turned)
{
    list5_u8_t left = *values;
    list5_u8_t turned_value = {.length = UINT64_C(0), .items = {0U, 0U, 0U, 0U, 0U}};
    while (true) {
        option_u8_t value = {.is_some = false};
        if (left.length > UINT64_C(0) && left.length <= UINT64_C(5)) {
            left.length -= UINT64_C(1);
            value.is_some = true;
            value.value = left.items[left.length];
        }
        if (!value.is_some) {
            break;
        }
        if (turned_value.length >= UINT64_C(5)) {
            return BESSEMER_STATUS_CAPACITY;
        }
        turned_value.items[turned_value.length] = value.value;
        turned_value.length += UINT64_C(1);
    }
    *turned = turned_value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t late_ends_trimmed(const list5_u8_t *values, uint64_t *BESSEMER_RESTRICT result)
{
    list5_u8_t left = *values;
    while (left.length != UINT64_C(0)) {
        const uint64_t value_index = left.length - UINT64_C(1);
        if (left.length > UINT64_C(5) || value_index >= left.length) {
            return BESSEMER_STATUS_INDEX;
        }
        if (left.items[value_index] != 0U) {
            *result = left.length;
            return BESSEMER_STATUS_OK;
        }
        if (left.length > UINT64_C(0)) {
            left.length -= UINT64_C(1);
        }
    }
    *result = UINT64_C(0);
    return BESSEMER_STATUS_OK;
}
