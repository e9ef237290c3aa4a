/* The C of tests/corpus/src/programs/data/checked_parts.rs. Written by a test. */

/* checked_parts.c */

void checked_parts_parity(const uint8_t line[8], uint64_t from, uint64_t to,
    option_u8_t *BESSEMER_RESTRICT result)
{
    if (!(from <= to && to <= UINT64_C(8))) {
        *result = (option_u8_t){.is_some = false};
        return;
    }
    uint8_t sum = 0U;
    for (uint64_t i = from; i < to; i++) {
        sum = (uint8_t)(sum ^ line[i]);
    }
    result->is_some = true;
    result->value = sum;
}

uint32_t checked_parts_payload_sum(const uint8_t frame[8])
{
    const uint32_t value_to = 2U + (uint32_t)frame[1];
    if (!(2U <= value_to && value_to <= 8U)) {
        return 0U;
    }
    uint32_t sum = 0U;
    for (uint32_t i = 2U; i < value_to; i++) {
        sum += (uint32_t)frame[i];
    }
    return sum;
}

void checked_parts_behind(const uint8_t line[8], uint64_t from,
    option_usize_t *BESSEMER_RESTRICT result)
{
    (void)line;
    if (from > UINT64_C(8)) {
        *result = (option_usize_t){.is_some = false};
        return;
    }
    result->is_some = true;
    result->value = UINT64_C(8) - from;
}

bool checked_parts_clear_up_to(uint8_t line[8], uint64_t last)
{
    const uint64_t result_to = saturating_add_u64(last, UINT64_C(1));
    if (result_to <= UINT64_C(8)) {
        for (uint64_t i = UINT64_C(0); i < result_to; i++) {
            line[i] = 0U;
        }
        return true;
    } else {
        return false;
    }
}

void checked_parts_count_up(uint8_t line[BESSEMER_RESTRICT 8], uint64_t index,
    option_u8_t *BESSEMER_RESTRICT result)
{
    if (index >= UINT64_C(8)) {
        *result = (option_u8_t){.is_some = false};
        return;
    }
    line[index] = (uint8_t)((uint32_t)line[index] + 1U);
    result->is_some = true;
    result->value = line[index];
}

uint16_t checked_parts_few(const list4_u8_t *values)
{
    if (min_u64(values->length, UINT64_C(4)) == UINT64_C(1)) {
        return (uint16_t)values->items[0];
    } else if (min_u64(values->length, UINT64_C(4)) == UINT64_C(2)) {
        return (uint16_t)((uint16_t)((uint16_t)values->items[0] * 256U)
            + (uint16_t)values->items[1]);
    } else {
        return 0U;
    }
}

bessemer_status_t checked_parts_number(const uint8_t frame[6], uint64_t at,
    result_u16_checked_parts_missing_t *BESSEMER_RESTRICT result)
{
    if (at > UINT64_C(0xFFFFFFFFFFFFFFFD)) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    const uint64_t value_to = at + UINT64_C(2);
    if (!(at <= value_to && value_to <= UINT64_C(6))) {
        result->is_ok = false;
        result->as.error = (checked_parts_missing_t){.tag = MISSING_TAG_SHORT};
        return BESSEMER_STATUS_OK;
    }
    if (at >= UINT64_C(6)) {
        return BESSEMER_STATUS_INDEX;
    }
    const uint8_t result_element = frame[at];
    if (at + UINT64_C(1) >= UINT64_C(6)) {
        return BESSEMER_STATUS_INDEX;
    }
    const uint8_t result_bytes[2] = {result_element, frame[at + UINT64_C(1)]};
    result->is_ok = true;
    result->as.value = (uint16_t)(result_bytes[0] | ((uint32_t)result_bytes[1] << 8U));
    return BESSEMER_STATUS_OK;
}

void checked_parts_sum_up_to(const uint8_t frame[6], uint64_t end,
    result_u16_checked_parts_missing_t *BESSEMER_RESTRICT result)
{
    if (end > UINT64_C(6)) {
        result->is_ok = false;
        result->as.error.tag = MISSING_TAG_BEYOND;
        result->as.error.beyond = end;
        return;
    }
    uint16_t sum = 0U;
    for (uint64_t i = UINT64_C(0); i < end; i++) {
        sum = (uint16_t)(sum + (uint16_t)frame[i]);
    }
    result->is_ok = true;
    result->as.value = sum;
}

void checked_parts_speed_on(const list4_checked_parts_leg_t *route, uint64_t index,
    option_f64_t *BESSEMER_RESTRICT result)
{
    if (index >= min_u64(route->length, UINT64_C(4))) {
        *result = (option_f64_t){.is_some = false};
        return;
    }
    result->is_some = true;
    result->value = route->items[index].way / route->items[index].time;
}

bessemer_status_t checked_parts_last_time(const checked_parts_leg_t route[2], uint64_t count,
    result_f64_checked_parts_missing_t *BESSEMER_RESTRICT result)
{
    if (count > UINT64_C(2)) {
        return BESSEMER_STATUS_INDEX;
    }
    if (count <= UINT64_C(0)) {
        result->is_ok = false;
        result->as.error = (checked_parts_missing_t){.tag = MISSING_TAG_SHORT};
        return BESSEMER_STATUS_OK;
    }
    result->is_ok = true;
    result->as.value = route[count - UINT64_C(1)].time;
    return BESSEMER_STATUS_OK;
}

/* checked_parts.h */

/** Which variant of `Missing`. */
typedef enum {
    /** The frame is too short. */
    MISSING_TAG_SHORT = 0,
    /** The position is out of range. */
    MISSING_TAG_BEYOND = 1
} missing_tag_t;

/** Reason why a field is missing. */
typedef struct {
    /** Which variant it is. */
    missing_tag_t tag;
    /** The position is out of range. */
    uint64_t beyond;
} checked_parts_missing_t;

/** `Result<f64, Missing>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        double value;
        /** Reason why there is no value. */
        checked_parts_missing_t error;
    } as;
} result_f64_checked_parts_missing_t;

/** `Result<u16, Missing>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        uint16_t value;
        /** Reason why there is no value. */
        checked_parts_missing_t error;
    } as;
} result_u16_checked_parts_missing_t;

/** A distance, and the time that it takes. */
typedef struct {
    /** Distance, m. */
    double way;
    /** Time, s. */
    double time;
} checked_parts_leg_t;

/** `List<Leg, 4>`: elements and their number. */
typedef struct {
    /** Number of elements. */
    uint64_t length;
    /** The elements; those behind the length mean nothing. */
    checked_parts_leg_t items[4];
} list4_checked_parts_leg_t;
