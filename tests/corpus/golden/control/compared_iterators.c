/* The C of tests/corpus/src/programs/control/compared_iterators.rs. Written by a test. */

/* compared_iterators.c */

void compared_iterators_compared(const int16_t a[5], const int16_t b[4],
    triple_ordering_bool_bool_t *BESSEMER_RESTRICT result)
{
    uint32_t others_taken = 0U;
    ordering_t order = ORDERING_EQUAL;
    for (uint32_t i = 0U; i < 5U; i++) {
        order = ORDERING_GREATER;
        option_i16_t other = {.is_some = false};
        if (others_taken < 4U) {
            const uint32_t index = others_taken;
            others_taken = index + 1U;
            other.is_some = true;
            other.value = b[index];
        }
        if (other.is_some) {
            if (a[i] < other.value) {
                order = ORDERING_LESS;
            } else if (a[i] == other.value) {
                order = ORDERING_EQUAL;
            } else {
                /* Nothing. */
            }
        }
        if (order != ORDERING_EQUAL) {
            break;
        }
    }
    bool result_holds = false;
    if (order == ORDERING_EQUAL) {
        option_i16_t next = {.is_some = false};
        if (others_taken < 4U) {
            const uint32_t index = others_taken;
            others_taken = index + 1U;
            next.is_some = true;
            next.value = b[index];
        }
        result_holds = next.is_some;
    }
    if (result_holds) {
        order = ORDERING_LESS;
    }
    uint32_t others_taken_2 = 0U;
    bool greater = false;
    bool same = true;
    for (uint32_t i = 0U; i < 5U; i++) {
        greater = true;
        same = false;
        option_i16_t other = {.is_some = false};
        if (others_taken_2 < 4U) {
            const uint32_t index = others_taken_2;
            others_taken_2 = index + 1U;
            other.is_some = true;
            other.value = b[index];
        }
        if (other.is_some) {
            greater = a[i] > other.value;
            same = a[i] == other.value;
        }
        if (!same) {
            break;
        }
    }
    bool second = true;
    if (!greater) {
        bool result_holds_2 = false;
        if (same) {
            option_i16_t next = {.is_some = false};
            if (others_taken_2 < 4U) {
                const uint32_t index = others_taken_2;
                others_taken_2 = index + 1U;
                next.is_some = true;
                next.value = b[index];
            }
            result_holds_2 = !next.is_some;
        }
        second = result_holds_2;
    }
    uint32_t others_taken_3 = 0U;
    bool same_2 = true;
    for (uint32_t i = 1U; i < 5U; i++) {
        option_i16_t next = {.is_some = false};
        if (others_taken_3 < 4U) {
            const uint32_t index = others_taken_3;
            others_taken_3 = index + 1U;
            next.is_some = true;
            next.value = b[index];
        }
        same_2 = next.is_some && a[i] == next.value;
        if (!same_2) {
            break;
        }
    }
    bool third = false;
    if (same_2) {
        option_i16_t next = {.is_some = false};
        if (others_taken_3 < 4U) {
            const uint32_t index = others_taken_3;
            others_taken_3 = index + 1U;
            next.is_some = true;
            next.value = b[index];
        }
        third = !next.is_some;
    }
    result->first = order;
    result->second = second;
    result->third = third;
}

void compared_iterators_floats(const double x[3], const double y[3], uint64_t n,
    bool result[BESSEMER_RESTRICT 4])
{
    const uint32_t count = (uint32_t)(n % UINT64_C(4));
    uint32_t others_taken = 0U;
    bool less = false;
    bool same = true;
    const uint32_t result_count = (uint32_t)min_u64((uint64_t)count, UINT64_C(3));
    for (uint32_t i = 0U; i < result_count; i++) {
        same = false;
        option_f64_t other = {.is_some = false};
        if (others_taken < 3U) {
            const uint32_t index = others_taken;
            others_taken = index + 1U;
            other.is_some = true;
            other.value = y[index];
        }
        if (other.is_some) {
            less = x[i] < other.value;
            same = x[i] == other.value;
        }
        if (!same) {
            break;
        }
    }
    bool result_holds = true;
    if (!less) {
        bool result_holds_2 = false;
        if (same) {
            option_f64_t next = {.is_some = false};
            if (others_taken < 3U) {
                const uint32_t index = others_taken;
                others_taken = index + 1U;
                next.is_some = true;
                next.value = y[index];
            }
            result_holds_2 = next.is_some;
        }
        result_holds = result_holds_2;
    }
    uint32_t others_taken_2 = 0U;
    bool less_2 = false;
    bool same_2 = true;
    const uint32_t result_count_2 = (uint32_t)min_u64((uint64_t)count, UINT64_C(3));
    for (uint32_t i = 0U; i < result_count_2; i++) {
        same_2 = false;
        option_f64_t other = {.is_some = false};
        if (others_taken_2 < 3U) {
            const uint32_t index = others_taken_2;
            others_taken_2 = index + 1U;
            other.is_some = true;
            other.value = y[index];
        }
        if (other.is_some) {
            less_2 = x[i] < other.value;
            same_2 = x[i] == other.value;
        }
        if (!same_2) {
            break;
        }
    }

    /* Rust asks for one more of the others. */
    bool more = false;
    if (same_2) {
        option_f64_t next = {.is_some = false};
        if (others_taken_2 < 3U) {
            const uint32_t index = others_taken_2;
            others_taken_2 = index + 1U;
            next.is_some = true;
            next.value = y[index];
        }
        more = next.is_some;
    }
    uint32_t others_taken_3 = 0U;
    bool greater = false;
    bool same_3 = true;
    const uint32_t result_count_3 = (uint32_t)min_u64((uint64_t)count, UINT64_C(3));
    for (uint32_t i = 0U; i < result_count_3; i++) {
        greater = true;
        same_3 = false;
        option_f64_t other = {.is_some = false};
        if (others_taken_3 < 3U) {
            const uint32_t index = others_taken_3;
            others_taken_3 = index + 1U;
            other.is_some = true;
            other.value = y[index];
        }
        if (other.is_some) {
            greater = x[i] > other.value;
            same_3 = x[i] == other.value;
        }
        if (!same_3) {
            break;
        }
    }

    /* Rust asks for one more of the others. */
    bool more_2 = false;
    if (same_3) {
        option_f64_t next = {.is_some = false};
        if (others_taken_3 < 3U) {
            const uint32_t index = others_taken_3;
            others_taken_3 = index + 1U;
            next.is_some = true;
            next.value = y[index];
        }
        more_2 = next.is_some;
    }
    uint32_t others_taken_4 = 0U;
    bool greater_2 = false;
    bool same_4 = true;
    const uint32_t result_count_4 = (uint32_t)min_u64((uint64_t)count, UINT64_C(3));
    for (uint32_t i = 0U; i < result_count_4; i++) {
        greater_2 = true;
        same_4 = false;
        option_f64_t other = {.is_some = false};
        if (others_taken_4 < 3U) {
            const uint32_t index = others_taken_4;
            others_taken_4 = index + 1U;
            other.is_some = true;
            other.value = y[index];
        }
        if (other.is_some) {
            greater_2 = x[i] > other.value;
            same_4 = x[i] == other.value;
        }
        if (!same_4) {
            break;
        }
    }
    bool result_holds_2 = true;
    if (!greater_2) {
        bool result_holds_3 = false;
        if (same_4) {
            option_f64_t next = {.is_some = false};
            if (others_taken_4 < 3U) {
                const uint32_t index = others_taken_4;
                others_taken_4 = index + 1U;
                next.is_some = true;
                next.value = y[index];
            }
            result_holds_3 = !next.is_some;
        }
        result_holds_2 = result_holds_3;
    }
    result[0] = result_holds;
    result[1] = less_2 || more || same_2;
    result[2] = greater && !more_2;
    result[3] = result_holds_2;
}

void compared_iterators_best(const int16_t a[5], const double x[4],
    tuple4_option_i16_option_f64_option_i16_option_usize_t *BESSEMER_RESTRICT result)
{
    result->first = (option_i16_t){.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        if ((int16_t)(a[i] % 2) == 1) {
            if (result->first.is_some) {
                if (a[i] > result->first.value) {
                    result->first.is_some = true;
                    result->first.value = a[i];
                }
            } else {
                result->first.is_some = true;
                result->first.value = a[i];
            }
        }
    }
    result->second = (option_f64_t){.is_some = false};
    for (uint32_t i = 0U; i < 4U; i++) {
        const double b = 0.5 * x[i];
        if (result->second.is_some) {
            if (!sort_below_f64(b, result->second.value)) {
                result->second.is_some = true;
                result->second.value = b;
            }
        } else {
            result->second.is_some = true;
            result->second.value = b;
        }
    }
    result->third = (option_i16_t){.is_some = false};
    option_i16_t largest = {.is_some = false};
    for (uint32_t i = 1U; i < 5U; i++) {
        const int16_t key = wrap_i16((uint16_t)((uint32_t)a[i] * 3U));
        if (largest.is_some) {
            if (key >= largest.value) {
                largest.is_some = true;
                largest.value = key;
                result->third.is_some = true;
                result->third.value = a[i];
            }
        } else {
            largest.is_some = true;
            largest.value = key;
            result->third.is_some = true;
            result->third.value = a[i];
        }
    }
    option_pair_usize_i16_t found = {.is_some = false};
    option_i16_t least = {.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        const int16_t key = a[i];
        if (least.is_some) {
            if (key < least.value) {
                least.is_some = true;
                least.value = key;
                found.is_some = true;
                found.value.first = i;
                found.value.second = a[i];
            }
        } else {
            least.is_some = true;
            least.value = key;
            found.is_some = true;
            found.value.first = i;
            found.value.second = a[i];
        }
    }
    if (found.is_some) {
        result->fourth.is_some = true;
        result->fourth.value = found.value.first;
    } else {
        result->fourth = (option_usize_t){.is_some = false};
    }
}

bool compared_iterators_raised(int16_t a[BESSEMER_RESTRICT 3], int16_t b[BESSEMER_RESTRICT 3],
    int16_t limit)
{
    bool chain_done = false;
    for (uint32_t i = 0U; i < 3U; i++) {
        if (a[i] > limit) {
            chain_done = true;
            break;
        }
        if (a[i] == limit) {
            return true;
        }
        a[i] = wrap_i16((uint16_t)((uint32_t)a[i] + 1U));
    }
    if (!chain_done) {
        for (uint32_t i = 0U; i < 3U; i++) {
            if (b[i] > limit) {
                chain_done = true;
                break;
            }
            if (b[i] == limit) {
                return true;
            }
            b[i] = wrap_i16((uint16_t)((uint32_t)b[i] + 1U));
        }
    }
    return false;
}
