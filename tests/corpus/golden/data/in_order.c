/* The C of tests/corpus/src/programs/data/in_order.rs. Written by a test. */

/* in_order.c */

bool in_order_is_usable(const breakpoints_t *table)
{
    const uint64_t count = clamp_u64((uint64_t)table->count, UINT64_C(2), UINT64_C(6));
    return sort_is_sorted_f64(table->at, count);
}

void in_order_ordered(uint8_t n, const pair_u8_f32_t pairs[3], bool result[BESSEMER_RESTRICT 3])
{
    list4_u8_t list = {.length = UINT64_C(0), .items = {0U, 0U, 0U, 0U}};
    for (uint8_t k = 0U; k < n % 4U; k++) {
        list.items[list.length] = (uint8_t)(k ^ 2U);
        list.length += UINT64_C(1);
    }
    const uint8_t elements[1] = {n};
    result[0] = sort_is_sorted_u8(list.items, min_u64(list.length, UINT64_C(4)));
    result[1] = sort_is_sorted_pair_u8_f32(pairs, UINT64_C(3));
    result[2] = sort_is_sorted_u8(elements, UINT64_C(1));
}

/* in_order.h */

/** The breakpoints of a table, and their number. */
typedef struct {
    /** The breakpoints. */
    double at[6];
    /** Number of breakpoints. */
    uint8_t count;
} breakpoints_t;
