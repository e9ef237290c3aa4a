/* The C of tests/corpus/src/programs/numbers/narrowing.rs. Written by a test. */

/* narrowing.c */

static const uint8_t U8_MAX = 255U;

uint8_t narrowing_level(int32_t x)
{
    result_u8_unit_t result_narrowed = {.is_ok = false};
    if (x >= 0 && x <= 255) {
        result_narrowed.is_ok = true;
        result_narrowed.value = (uint8_t)x;
    }
    uint8_t result_choice;
    if (x < 0) {
        result_choice = 0U;
    } else {
        result_choice = U8_MAX;
    }
    uint8_t result = result_choice;
    if (result_narrowed.is_ok) {
        result = result_narrowed.value;
    }
    return result;
}

void narrowing_steps(int64_t x, option_i16_t *result)
{
    result_i16_unit_t result_narrowed = {.is_ok = false};
    if (x >= -INT64_C(32768) && x <= INT64_C(32767)) {
        result_narrowed.is_ok = true;
        result_narrowed.value = wrap_i16((uint16_t)x);
    }
    *result = (option_i16_t){.is_some = false};
    if (result_narrowed.is_ok) {
        result->is_some = true;
        result->value = result_narrowed.value;
    }
}

void narrowing_index(int8_t x, option_usize_t *result)
{
    result_usize_unit_t index = {.is_ok = false};
    if (x >= 0) {
        index.is_ok = true;
        index.value = (uint64_t)x;
    }
    if (!index.is_ok) {
        *result = (option_usize_t){.is_some = false};
        return;
    }
    if (index.value < UINT64_C(12)) {
        result->is_some = true;
        result->value = index.value;
    } else {
        *result = (option_usize_t){.is_some = false};
    }
}

bool narrowing_fits(uint32_t count)
{
    result_u8_unit_t narrow = {.is_ok = false};
    if (count <= 255U) {
        narrow.is_ok = true;
        narrow.value = (uint8_t)count;
    }
    return narrow.is_ok;
}

bessemer_status_t narrowing_difference(uint32_t now, uint32_t before, int32_t *result)
{
    const int64_t now_2 = (int64_t)now;
    const int64_t before_2 = (int64_t)before;
    const int64_t selector = now_2 - before_2;
    result_i32_unit_t result_narrowed = {.is_ok = false};
    if (selector >= INT32_MIN && selector <= INT32_MAX) {
        result_narrowed.is_ok = true;
        result_narrowed.value = wrap_i32((uint32_t)selector);
    }
    if (!result_narrowed.is_ok) {
        return BESSEMER_STATUS_ABSENT;
    }
    *result = result_narrowed.value;
    return BESSEMER_STATUS_OK;
}
