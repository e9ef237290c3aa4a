/* The C of tests/corpus/src/programs/data/sorted_searches.rs. Written by a test. */

/* sorted_searches.c */

static uint64_t sorted_searches_partition_point_in_below(const double values[],
    uint64_t values_length, double x);
static void sorted_searches_binary_search_by_key_in_value(const sorted_searches_point_t values[],
    uint64_t values_length, uint16_t wanted, result_usize_usize_t *BESSEMER_RESTRICT result);
static void sorted_searches_binary_search_by_in_nearest(const float values[],
    uint64_t values_length, float x, result_usize_usize_t *BESSEMER_RESTRICT result);

uint64_t sorted_searches_below(const double steps[6], double x)
{
    return sorted_searches_partition_point_in_below(steps, UINT64_C(6), x);
}

/**
 * The index of the first element for which `is_first` does not hold; it must hold for all elements before.
 */
static uint64_t sorted_searches_partition_point_in_below(const double values[],
    uint64_t values_length, double x)
{
    uint64_t from = UINT64_C(0);
    uint64_t left = values_length;
    for (int32_t pass = 0; pass < 64; pass++) {
        const uint64_t middle = from + left / UINT64_C(2);
        if (left == UINT64_C(0) || middle >= values_length) {
            break;
        }
        const double value = values[middle];
        if (value < x) {
            from = middle + UINT64_C(1);
            left = left - left / UINT64_C(2) - UINT64_C(1);
        } else {
            left /= UINT64_C(2);
        }
    }
    return from;
}

void sorted_searches_place(const uint8_t codes[7], uint8_t code,
    result_usize_usize_t *BESSEMER_RESTRICT result)
{
    bessemer_search_binary_search_u8(codes, UINT64_C(7), code, result);
}

bessemer_status_t sorted_searches_value(const list5_sorted_searches_point_t *points, uint16_t code,
    option_f64_t *BESSEMER_RESTRICT result)
{
    result_usize_usize_t at_outcome;
    sorted_searches_binary_search_by_key_in_value(points->items,
        min_u64(points->length, UINT64_C(5)), code, &at_outcome);
    option_usize_t at_choice = {.is_some = false};
    if (at_outcome.is_ok) {
        at_choice.is_some = true;
        at_choice.value = at_outcome.as.value;
    }
    if (!at_choice.is_some) {
        *result = (option_f64_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
    const uint64_t at = at_choice.value;
    if (points->length > UINT64_C(5) || at >= points->length) {
        return BESSEMER_STATUS_INDEX;
    }
    result->is_some = true;
    result->value = points->items[at].value;
    return BESSEMER_STATUS_OK;
}

/**
 * The index of an element whose key is `wanted`.
 *
 * # Errors
 *
 * The index at which such an element could be inserted, if there is none.
 */
static void sorted_searches_binary_search_by_key_in_value(const sorted_searches_point_t values[],
    uint64_t values_length, uint16_t wanted, result_usize_usize_t *BESSEMER_RESTRICT result)
{
    uint64_t from = UINT64_C(0);
    uint64_t left = values_length;
    for (int32_t pass = 0; pass < 64; pass++) {
        const uint64_t middle = from + left / UINT64_C(2);
        if (left == UINT64_C(0) || middle >= values_length) {
            break;
        }
        const sorted_searches_point_t value = values[middle];
        const uint16_t found = value.code;
        if (found == wanted) {
            result->is_ok = true;
            result->as.value = middle;
            return;
        }
        if (found < wanted) {
            from = middle + UINT64_C(1);
            left = left - left / UINT64_C(2) - UINT64_C(1);
        } else {
            left /= UINT64_C(2);
        }
    }
    result->is_ok = false;
    result->as.error = from;
}

uint64_t sorted_searches_nearest(const float sorted[5], float x)
{
    result_usize_usize_t at;
    sorted_searches_binary_search_by_in_nearest(sorted, UINT64_C(5), x, &at);
    if (at.is_ok) {
        return at.as.value;
    } else if (at.as.error == UINT64_C(0)) {
        return UINT64_C(0);
    } else {
        return at.as.error - UINT64_C(1);
    }
}

/**
 * The index of an element for which the function returns `Equal`.
 *
 * # Errors
 *
 * The index at which such an element could be inserted, if there is none.
 */
static void sorted_searches_binary_search_by_in_nearest(const float values[],
    uint64_t values_length, float x, result_usize_usize_t *BESSEMER_RESTRICT result)
{
    uint64_t from = UINT64_C(0);
    uint64_t left = values_length;

    /* No more can be halved than there are bits. */
    for (int32_t pass = 0; pass < 64; pass++) {
        const uint64_t middle = from + left / UINT64_C(2);
        if (left == UINT64_C(0) || middle >= values_length) {
            break;
        }
        const float value = values[middle];
        switch (comparison_total_f32(value, x)) {
        case ORDERING_EQUAL:
            result->is_ok = true;
            result->as.value = middle;
            return;
        case ORDERING_LESS:
            from = middle + UINT64_C(1);
            left = left - left / UINT64_C(2) - UINT64_C(1);
            break;
        case ORDERING_GREATER:
        default:
            left /= UINT64_C(2);
            break;
        }
    }
    result->is_ok = false;
    result->as.error = from;
}

/* sorted_searches.h */

/** A point of a curve. */
typedef struct {
    uint16_t code;
    double value;
} sorted_searches_point_t;

/** `List<Point, 5>`: elements and their number. */
typedef struct {
    /** Number of elements. */
    uint64_t length;
    /** The elements; those behind the length mean nothing. */
    sorted_searches_point_t items[5];
} list5_sorted_searches_point_t;
