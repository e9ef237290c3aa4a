/* The C of tests/corpus/src/programs/data/sorted.rs. Written by a test. */

/* sorted.c */

static void sorted_sort_by_in_median(double values[], uint64_t values_length);
static void sorted_sort_by_in_schedule(switching_t values[], uint64_t values_length);
static void sorted_sort_by_in_latest_first(switching_t values[], uint64_t values_length);
static void sorted_sort_by_in_downwards(float values[], uint64_t values_length);

double sorted_median(const double values[9])
{
    double sorted[9];
    (void)memcpy(sorted, values, sizeof(double[9]));
    sorted_sort_by_in_median(sorted, UINT64_C(9));
    return sorted[4];
}

/**
 * Sorts `values` so that no element is `below` the one before it; equal elements keep their order.
 */
static void sorted_sort_by_in_median(double values[], uint64_t values_length)
{
    for (uint64_t i = UINT64_C(1); i < values_length; i++) {
        for (uint64_t at = i; at-- > UINT64_C(0);) {
            const double one = values[at];
            const double next = values[at + UINT64_C(1)];
            if (!sort_below_f64(next, one)) {
                break;
            }
            values[at] = next;
            values[at + UINT64_C(1)] = one;
        }
    }
}

void sorted_middle(const list8_u16_t *values, option_u16_t *BESSEMER_RESTRICT result)
{
    list8_u16_t sorted = *values;
    sort_ascending_u16(sorted.items, min_u64(sorted.length, UINT64_C(8)));
    const uint64_t result_index = sorted.length / UINT64_C(2);
    *result = (option_u16_t){.is_some = false};
    if (result_index < min_u64(sorted.length, UINT64_C(8))) {
        result->is_some = true;
        result->value = sorted.items[result_index];
    }
}

void sorted_schedule(list5_switching_t *edges)
{
    sorted_sort_by_in_schedule(edges->items, min_u64(edges->length, UINT64_C(5)));
}

/**
 * Sorts `values` so that no element is `below` the one before it; equal elements keep their order.
 */
static void sorted_sort_by_in_schedule(switching_t values[], uint64_t values_length)
{
    for (uint64_t i = UINT64_C(1); i < values_length; i++) {
        for (uint64_t at = i; at-- > UINT64_C(0);) {
            const switching_t one = values[at];
            const switching_t next = values[at + UINT64_C(1)];
            const uint16_t value_choice = next.at;
            const uint16_t value_choice_2 = one.at;
            if (!(value_choice < value_choice_2)) {
                break;
            }
            values[at] = next;
            values[at + UINT64_C(1)] = one;
        }
    }
}

void sorted_latest_first(switching_t edges[6])
{
    sorted_sort_by_in_latest_first(edges, UINT64_C(6));
}

/**
 * Sorts `values` so that no element is `below` the one before it; equal elements keep their order.
 */
static void sorted_sort_by_in_latest_first(switching_t values[], uint64_t values_length)
{
    for (uint64_t i = UINT64_C(1); i < values_length; i++) {
        for (uint64_t at = i; at-- > UINT64_C(0);) {
            const switching_t one = values[at];
            const switching_t next = values[at + UINT64_C(1)];
            if (!(one.at < next.at)) {
                break;
            }
            values[at] = next;
            values[at + UINT64_C(1)] = one;
        }
    }
}

void sorted_downwards(float values[5])
{
    sorted_sort_by_in_downwards(&values[1], UINT64_C(4));
}

/**
 * Sorts `values` so that no element is `below` the one before it; equal elements keep their order.
 */
static void sorted_sort_by_in_downwards(float values[], uint64_t values_length)
{
    for (uint64_t i = UINT64_C(1); i < values_length; i++) {
        for (uint64_t at = i; at-- > UINT64_C(0);) {
            const float one = values[at];
            const float next = values[at + UINT64_C(1)];
            if (!sort_below_f32(one, next)) {
                break;
            }
            values[at] = next;
            values[at + UINT64_C(1)] = one;
        }
    }
}

void sorted_nearest(const double values[5], double guess, option_f64_t *BESSEMER_RESTRICT result)
{
    *result = (option_f64_t){.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        if (result->is_some) {
            if (sort_below_f64(fabs(values[i] - guess), fabs(result->value - guess))) {
                result->is_some = true;
                result->value = values[i];
            }
        } else {
            result->is_some = true;
            result->value = values[i];
        }
    }
}

/* sorted.h */

/** A change of the outputs at a time. */
typedef struct {
    /** Time, ticks. */
    uint16_t at;
    /** Mask of the outputs that change. */
    uint8_t outputs;
} switching_t;

/** `List<Switching, 5>`: elements and their number. */
typedef struct {
    /** Number of elements. */
    uint64_t length;
    /** The elements; those behind the length mean nothing. */
    switching_t items[5];
} list5_switching_t;
