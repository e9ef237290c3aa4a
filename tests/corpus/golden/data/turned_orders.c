/* The C of tests/corpus/src/programs/data/turned_orders.rs. Written by a test. */

/* turned_orders.c */

static void turned_orders_sort_by_in_planned(turned_orders_job_t values[], uint64_t values_length);
static void turned_orders_sort_by_in_put_off(turned_orders_job_t values[], uint64_t values_length);

void turned_orders_planned(turned_orders_job_t jobs[5])
{
    turned_orders_sort_by_in_planned(jobs, UINT64_C(5));
}

/**
 * Sorts `values` so that no element is `below` the one before it; equal elements keep their order.
 */
static void turned_orders_sort_by_in_planned(turned_orders_job_t values[], uint64_t values_length)
{
    for (uint64_t i = UINT64_C(1); i < values_length; i++) {
        for (uint64_t at = i; at-- > UINT64_C(0);) {
            const turned_orders_job_t one = values[at];
            const turned_orders_job_t next = values[at + UINT64_C(1)];
            const pair_reverse_u8_i16_t value_choice = {
                .first = {.value = next.urgency},
                .second = next.due
            };
            const pair_reverse_u8_i16_t other = {
                .first = {.value = one.urgency},
                .second = one.due
            };
            if (!pair_reverse_u8_i16_less(&value_choice, &other)) {
                break;
            }
            values[at] = next;
            values[at + UINT64_C(1)] = one;
        }
    }
}

void turned_orders_put_off(turned_orders_job_t jobs[5])
{
    turned_orders_sort_by_in_put_off(jobs, UINT64_C(5));
}

/**
 * Sorts `values` so that no element is `below` the one before it; equal elements keep their order.
 */
static void turned_orders_sort_by_in_put_off(turned_orders_job_t values[], uint64_t values_length)
{
    for (uint64_t i = UINT64_C(1); i < values_length; i++) {
        for (uint64_t at = i; at-- > UINT64_C(0);) {
            const turned_orders_job_t one = values[at];
            const turned_orders_job_t next = values[at + UINT64_C(1)];
            const reverse_pair_reverse_u8_i16_t value_choice = {
                .value = {.first = {.value = next.urgency}, .second = next.due}
            };
            const reverse_pair_reverse_u8_i16_t value_choice_2 = {
                .value = {.first = {.value = one.urgency}, .second = one.due}
            };
            if (!pair_reverse_u8_i16_less(&value_choice_2.value, &value_choice.value)) {
                break;
            }
            values[at] = next;
            values[at + UINT64_C(1)] = one;
        }
    }
}

void turned_orders_ends(const turned_orders_job_t jobs[5],
    pair_option_turned_orders_job_option_turned_orders_job_t *BESSEMER_RESTRICT result)
{
    result->first = (option_turned_orders_job_t){.is_some = false};
    option_pair_u8_reverse_i16_t least = {.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        const pair_u8_reverse_i16_t key = {
            .first = jobs[i].urgency,
            .second = {.value = jobs[i].due}
        };
        if (least.is_some) {
            if (pair_u8_reverse_i16_less(&key, &least.value)) {
                least.is_some = true;
                least.value = key;
                result->first.is_some = true;
                result->first.value = jobs[i];
            }
        } else {
            least.is_some = true;
            least.value = key;
            result->first.is_some = true;
            result->first.value = jobs[i];
        }
    }
    result->second = (option_turned_orders_job_t){.is_some = false};
    option_reverse_u8_t least_2 = {.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        const reverse_u8_t key = {.value = jobs[i].urgency};
        if (least_2.is_some) {
            if (least_2.value.value < key.value) {
                least_2.is_some = true;
                least_2.value = key;
                result->second.is_some = true;
                result->second.value = jobs[i];
            }
        } else {
            least_2.is_some = true;
            least_2.value = key;
            result->second.is_some = true;
            result->second.value = jobs[i];
        }
    }
}

void turned_orders_compared(int16_t a, int16_t b,
    tuple6_bool_bool_bool_bool_bool_ordering_t *result)
{
    const reverse_i16_t one = {.value = a};
    const reverse_i16_t other = {.value = b};
    const ordering_t result_sixth = comparison_compare_reverse_i16(&one, &other);
    result->first = other.value < one.value;
    result->second = other.value <= one.value;
    result->third = other.value > one.value;
    result->fourth = other.value >= one.value;
    result->fifth = one.value == other.value;
    result->sixth = result_sixth;
}

void turned_orders_of_floats(double a, double b, tuple4_bool_bool_bool_option_ordering_t *result)
{
    const reverse_f64_t one = {.value = a};
    const reverse_f64_t other = {.value = b};
    comparison_partial_reverse_f64(&one, &other, &result->fourth);
    result->first = other.value < one.value;
    result->second = other.value >= one.value;
    result->third = !(one.value == other.value);
}

void turned_orders_least(const uint8_t values[4], uint8_t floor_,
    option_u8_t *BESSEMER_RESTRICT result)
{
    option_reverse_u8_t max = {.is_some = false};
    for (uint32_t i = 0U; i < 4U; i++) {
        const reverse_u8_t reverse_u8 = {.value = values[i]};
        if (max.is_some) {
            if (max.value.value >= reverse_u8.value) {
                max.is_some = true;
                max.value = reverse_u8;
            }
        } else {
            max.is_some = true;
            max.value = reverse_u8;
        }
    }
    if (!max.is_some) {
        *result = (option_u8_t){.is_some = false};
        return;
    }
    const reverse_u8_t reverse_u8_one = {.value = max.value.value};
    const reverse_u8_t reverse_u8_other = {.value = floor_};
    reverse_u8_t reverse_u8;
    comparison_lesser_reverse_u8(&reverse_u8_one, &reverse_u8_other, &reverse_u8);
    result->is_some = true;
    result->value = reverse_u8.value;
}

void turned_orders_first(const reverse_u8_2_t *held, const reverse_u8_2_t *lent,
    reverse_u8_2_t *BESSEMER_RESTRICT reverse_u8_2)
{
    if (lent->value[0] < held->value[0]
            || (lent->value[0] == held->value[0] && lent->value[1] < held->value[1])) {
        *reverse_u8_2 = *held;
    } else {
        *reverse_u8_2 = *lent;
    }
}

/* turned_orders.h */

/** A job with its urgency and due time. */
typedef struct {
    /** Urgency; the greatest is the most urgent. */
    uint8_t urgency;
    /** Due time, ms. */
    int16_t due;
    /** Serial number. */
    uint8_t number;
} turned_orders_job_t;

/** `Option<Job>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    turned_orders_job_t value;
} option_turned_orders_job_t;

/** `(Option<Job>, Option<Job>)`. */
typedef struct {
    option_turned_orders_job_t first;
    option_turned_orders_job_t second;
} pair_option_turned_orders_job_option_turned_orders_job_t;
