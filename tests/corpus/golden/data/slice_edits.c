/* The C of tests/corpus/src/programs/data/slice_edits.rs. Written by a test. */

/* slice_edits.c */

void slice_edits_record(float samples[5], float sample)
{
    const float last = samples[4];
    for (uint32_t i = 5U; i-- > 1U;) {
        samples[i] = samples[i - 1U];
    }
    samples[0] = last;
    samples[0] = sample;
}

bessemer_status_t slice_edits_consume(uint8_t buffer[8], uint64_t read)
{
    if (read > UINT64_C(8)) {
        return BESSEMER_STATUS_INDEX;
    }
    for (uint64_t i = read; i < UINT64_C(8); i++) {
        buffer[i - read] = buffer[i];
    }
    return BESSEMER_STATUS_OK;
}

bool slice_edits_is_sentence(const uint8_t text[12])
{
    const uint8_t elements[3] = {36U, 71U, 80U};
    bool result = false;
    if (slice_edit_starts_with_u8(text, UINT64_C(12), elements, UINT64_C(3))) {
        const uint8_t elements_2[2] = {13U, 10U};
        result = slice_edit_ends_with_u8(text, UINT64_C(12), elements_2, UINT64_C(2));
    }
    return result;
}

void slice_edits_fields(const uint8_t frame[10], pair_u32_i16_t *BESSEMER_RESTRICT result)
{
    const uint8_t count_bytes[4] = {frame[2], frame[3], frame[4], frame[5]};
    const uint32_t count = ((uint32_t)count_bytes[0] << 24U) | ((uint32_t)count_bytes[1] << 16U)
        | ((uint32_t)count_bytes[2] << 8U) | (uint32_t)count_bytes[3];
    const uint8_t result_bytes[2] = {frame[6], frame[7]};
    result->first = count;
    result->second = wrap_i16((uint16_t)(((uint32_t)result_bytes[0] << 8U) | result_bytes[1]));
}

void slice_edits_field(const list16_u8_t *frame, uint64_t at,
    option_u32_t *BESSEMER_RESTRICT result)
{
    if (at > min_u64(frame->length, UINT64_C(16))) {
        *result = (option_u32_t){.is_some = false};
        return;
    }
    option_u8x4_t result_part = {.is_some = false};
    if (min_u64(frame->length, UINT64_C(16)) - at >= UINT64_C(4)) {
        result_part.is_some = true;
        result_part.value[0] = frame->items[at];
        result_part.value[1] = frame->items[at + UINT64_C(1)];
        result_part.value[2] = frame->items[at + UINT64_C(2)];
        result_part.value[3] = frame->items[at + UINT64_C(3)];
    }
    if (result_part.is_some) {
        result->is_some = true;
        result->value = (uint32_t)result_part.value[0] | ((uint32_t)result_part.value[1] << 8U)
            | ((uint32_t)result_part.value[2] << 16U) | ((uint32_t)result_part.value[3] << 24U);
    } else {
        *result = (option_u32_t){.is_some = false};
    }
}

void slice_edits_framed(const list12_u8_t *frame, option_pair_u16_bool_t *BESSEMER_RESTRICT result)
{
    if (min_u64(frame->length, UINT64_C(12)) < UINT64_C(2)) {
        *result = (option_pair_u16_bool_t){.is_some = false};
        return;
    }
    if (min_u64(frame->length, UINT64_C(12)) - UINT64_C(2) < UINT64_C(2)) {
        *result = (option_pair_u16_bool_t){.is_some = false};
        return;
    }
    uint16_t sum = 0U;
    {
        const uint32_t end = (uint32_t)(min_u64(frame->length, UINT64_C(12)) - 2U - 2U + 2U);
        for (uint32_t i = 2U; i < end; i++) {
            sum = (uint16_t)((uint32_t)sum + (uint32_t)frame->items[i]);
        }
    }
    const uint8_t result_bytes[2] = {frame->items[0], frame->items[1]};
    const uint16_t first = (uint16_t)(((uint32_t)result_bytes[0] << 8U) | result_bytes[1]);
    const uint8_t result_bytes_2[2] = {
        frame->items[min_u64(frame->length, UINT64_C(12)) - 2U - 2U + 2U],
        frame->items[min_u64(frame->length, UINT64_C(12)) - 2U - 2U + 2U + 1U]
    };
    result->is_some = true;
    result->value.first = first;
    result->value.second = sum == (uint16_t)(((uint32_t)result_bytes_2[0] << 8U)
        | result_bytes_2[1]);
}

void slice_edits_latest(const int16_t samples[5], pair_i16x3_usize_t *BESSEMER_RESTRICT result)
{
    result->first[0] = samples[2];
    result->first[1] = samples[3];
    result->first[2] = samples[4];
    result->second = UINT64_C(2);
}
