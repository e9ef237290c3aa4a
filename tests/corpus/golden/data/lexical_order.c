/* The C of tests/corpus/src/programs/data/lexical_order.rs. Written by a test. */

/* lexical_order.c */

static void lexical_order_sort_by_in_queue(message_t values[], uint64_t values_length);
static void lexical_order_sort_by_in_archive(message_t values[], uint64_t values_length);

bool lexical_order_is_older(const triple_u8_u8_u16_t *version, const triple_u8_u8_u16_t *other)
{
    return version->first < other->first
        || (version->first == other->first
        && (version->second < other->second
        || (version->second == other->second && version->third < other->third)));
}

ordering_t lexical_order_order(const uint8_t one[3], const uint8_t other[3])
{
    return comparison_compare_u8_3(one, other);
}

void lexical_order_queue(message_t messages[4])
{
    lexical_order_sort_by_in_queue(messages, UINT64_C(4));
}

/**
 * Sorts `values` so that no element is `below` the one before it; equal elements keep their order.
 */
static void lexical_order_sort_by_in_queue(message_t values[], uint64_t values_length)
{
    for (uint64_t i = UINT64_C(1); i < values_length; i++) {
        for (uint64_t at = i; at-- > UINT64_C(0);) {
            const message_t one = values[at];
            const message_t next = values[at + UINT64_C(1)];
            const ordering_t value_choice = comparison_then(
                comparison_compare_urgency(one.urgency, next.urgency),
                comparison_compare_u16(next.sequence, one.sequence));
            if (!comparison_is_less(value_choice)) {
                break;
            }
            values[at] = next;
            values[at + UINT64_C(1)] = one;
        }
    }
}

void lexical_order_archive(message_t messages[4])
{
    lexical_order_sort_by_in_archive(messages, UINT64_C(4));
}

/**
 * Sorts `values` so that no element is `below` the one before it; equal elements keep their order.
 */
static void lexical_order_sort_by_in_archive(message_t values[], uint64_t values_length)
{
    for (uint64_t i = UINT64_C(1); i < values_length; i++) {
        for (uint64_t at = i; at-- > UINT64_C(0);) {
            const message_t one = values[at];
            const message_t next = values[at + UINT64_C(1)];
            const pair_u16_urgency_t value_choice = {
                .first = next.sequence,
                .second = next.urgency
            };
            const pair_u16_urgency_t value_choice_2 = {
                .first = one.sequence,
                .second = one.urgency
            };
            if (!(value_choice.first < value_choice_2.first
                    || (value_choice.first == value_choice_2.first
                    && value_choice.second < value_choice_2.second))) {
                break;
            }
            values[at] = next;
            values[at + UINT64_C(1)] = one;
        }
    }
}

void lexical_order_before(const pair_f64_f64_t *one, const pair_f64_f64_t *other,
    pair_bool_bool_t *BESSEMER_RESTRICT result)
{
    result->first = one->first < other->first
        || (one->first == other->first && one->second < other->second);
    result->second = one->first > other->first
        || (one->first == other->first && one->second >= other->second);
}

uint16_t lexical_order_matched(uint8_t row, uint8_t column)
{
    const pair_u8_u8_t pair = {.first = row, .second = column};
    if (pair.first == 0U) {
        return 0U;
    } else if (pair.first == 1U && pair.second == 1U) {
        return (uint16_t)((uint16_t)pair.first + 100U);
    } else {
        return (uint16_t)((uint16_t)((uint16_t)pair.first * 16U) + (uint16_t)pair.second);
    }
}

/* lexical_order.h */

/** Urgency of a message. */
typedef enum {
    /** Can wait. */
    URGENCY_LOW = 0,
    /** Is sent next. */
    URGENCY_HIGH = 1,
    /** Is sent immediately. */
    URGENCY_ALARM = 2
} urgency_t;

/** `(u16, Urgency)`. */
typedef struct {
    uint16_t first;
    urgency_t second;
} pair_u16_urgency_t;

/** A message. */
typedef struct {
    urgency_t urgency;
    uint16_t sequence;
} message_t;
