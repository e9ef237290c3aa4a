/* The C of tests/corpus/src/programs/data/orders.rs. Written by a test. */

/* orders.c */

static void orders_sort_by_in_scheduled(orders_task_t values[], uint64_t values_length);

bessemer_status_t orders_towards(int16_t position, int16_t target, int16_t *result)
{
    switch (comparison_compare_i16(position, target)) {
    case ORDERING_LESS:
        if (position > 32766) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        *result = (int16_t)(position + 1);
        return BESSEMER_STATUS_OK;
    case ORDERING_EQUAL:
        *result = position;
        return BESSEMER_STATUS_OK;
    case ORDERING_GREATER:
    default:
        if (position < -32767) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        *result = (int16_t)(position - 1);
        return BESSEMER_STATUS_OK;
    }
}

ordering_t orders_first(const orders_task_t *one, const orders_task_t *other)
{
    const ordering_t value = comparison_then(comparison_compare_u8(one->priority, other->priority),
        comparison_compare_u32(one->deadline, other->deadline));
    if (value == ORDERING_EQUAL) {
        return comparison_total_f32(one->effort, other->effort);
    } else {
        return value;
    }
}

void orders_scheduled(const orders_task_t tasks[4], orders_task_t sorted[BESSEMER_RESTRICT 4])
{
    (void)memcpy(sorted, tasks, sizeof(orders_task_t[4]));
    orders_sort_by_in_scheduled(sorted, UINT64_C(4));
}

/**
 * Sorts `values` so that no element is `below` the one before it; equal elements keep their order.
 */
static void orders_sort_by_in_scheduled(orders_task_t values[], uint64_t values_length)
{
    for (uint64_t i = UINT64_C(1); i < values_length; i++) {
        for (uint64_t at = i; at-- > UINT64_C(0);) {
            const orders_task_t one = values[at];
            const orders_task_t next = values[at + UINT64_C(1)];
            const ordering_t order = orders_first(&next, &one);
            if (!comparison_is_less(order)) {
                break;
            }
            values[at] = next;
            values[at + UINT64_C(1)] = one;
        }
    }
}

bool orders_is_beyond(double reading, double limit)
{
    option_ordering_t option;
    comparison_partial_f64(reading, limit, &option);
    return option.is_some && comparison_is_greater(option.value);
}

void orders_longest(const orders_task_t tasks[4], option_orders_task_t *BESSEMER_RESTRICT result)
{
    *result = (option_orders_task_t){.is_some = false};
    for (uint32_t i = 0U; i < 4U; i++) {
        if (result->is_some) {
            if (comparison_is_at_most(comparison_then(
                    comparison_total_f32(result->value.effort, tasks[i].effort),
                    comparison_compare_u32(result->value.deadline, tasks[i].deadline)))) {
                result->is_some = true;
                result->value = tasks[i];
            }
        } else {
            result->is_some = true;
            result->value = tasks[i];
        }
    }
}

/* orders.h */

/** A task with its urgency and deadline. */
typedef struct {
    /** Priority; the lowest number is the most urgent. */
    uint8_t priority;
    /** Deadline, ms. */
    uint32_t deadline;
    /** Duration, s. */
    float effort;
} orders_task_t;

/** `Option<Task>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    orders_task_t value;
} option_orders_task_t;
