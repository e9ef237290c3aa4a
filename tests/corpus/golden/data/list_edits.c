/* The C of tests/corpus/src/programs/data/list_edits.rs. Written by a test. */

/* list_edits.c */

bessemer_status_t list_edits_queued(list6_u8_t *BESSEMER_RESTRICT jobs, uint8_t cost,
    uint64_t *BESSEMER_RESTRICT at)
{
    bessemer_status_t status;
    option_usize_t position = {.is_some = false};
    {
        const uint32_t end = (uint32_t)min_u64(jobs->length, UINT64_C(6));
        for (uint32_t i = 0U; i < end; i++) {
            if (jobs->items[i] > cost) {
                position.is_some = true;
                position.value = i;
                break;
            }
        }
    }
    uint64_t at_value = jobs->length;
    if (position.is_some) {
        at_value = position.value;
    }
    status = list_edit_insert_u8_6(jobs, at_value, cost);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    *at = at_value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t list_edits_served(list6_u8_t *BESSEMER_RESTRICT jobs, uint8_t limit,
    uint8_t *BESSEMER_RESTRICT first)
{
    bessemer_status_t status;
    uint8_t first_value;
    status = list_edit_remove_u8_6(jobs, UINT64_C(0), &first_value);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    uint32_t kept = 0U;
    {
        const uint64_t end = jobs->length;
        for (uint64_t at = UINT64_C(0); at < end; at++) {
            if (jobs->length > UINT64_C(6) || at >= jobs->length) {
                return BESSEMER_STATUS_INDEX;
            }
            const bool keeps = jobs->items[at] <= limit;
            if (keeps) {
                if (jobs->length > UINT64_C(6) || kept >= jobs->length) {
                    return BESSEMER_STATUS_INDEX;
                }
                jobs->items[kept] = jobs->items[at];
                kept += 1U;
            }
        }
    }
    if (kept < jobs->length) {
        jobs->length = kept;
    }
    *first = first_value;
    return BESSEMER_STATUS_OK;
}

void list_edits_message(uint16_t sequence, uint32_t value, list6_u8_t *bytes)
{
    bytes->length = UINT64_C(0);
    for (uint32_t i = 0U; i < 6U; i++) {
        bytes->items[i] = 0U;
    }
    const uint8_t elements[2] = {(uint8_t)(sequence >> 8U), (uint8_t)sequence};
    for (uint32_t i = 0U; i < 2U; i++) {
        bytes->items[bytes->length] = elements[i];
        bytes->length += UINT64_C(1);
    }
    const uint8_t elements_2[4] = {
        (uint8_t)(value >> 24U), (uint8_t)(value >> 16U), (uint8_t)(value >> 8U), (uint8_t)value
    };
    for (uint32_t i = 4U; i-- > 0U;) {
        bytes->items[bytes->length] = elements_2[i];
        bytes->length += UINT64_C(1);
    }
}

bessemer_status_t list_edits_without(const list6_u8_t *list, uint64_t at,
    list6_u8_t *BESSEMER_RESTRICT left)
{
    bessemer_status_t status;
    list6_u8_t left_value = *list;
    {
        uint8_t unused;
        status = list_edit_swap_remove_u8_6(&left_value, at, &unused);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
    }
    if (at > min_u64(list->length, UINT64_C(6))) {
        return BESSEMER_STATUS_INDEX;
    }
    status = list_edit_extend_from_slice_u8_6(&left_value, &list->items[at],
        min_u64(list->length, UINT64_C(6)) - at);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    *left = left_value;
    return BESSEMER_STATUS_OK;
}
