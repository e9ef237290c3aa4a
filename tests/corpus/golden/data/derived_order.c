/* The C of tests/corpus/src/programs/data/derived_order.rs. Written by a test. */

/* derived_order.c */

static const uint8_t U8_MAX = 255U;

static void derived_order_sort_by_in_sorted(derived_order_key_t values[], uint64_t values_length);

bool derived_order_is_low(const height_t *height, const height_t *limit)
{
    bool result = true;
    if (!(height->value < limit->value)) {
        const height_t height_2 = {.value = 0.0};
        result = !(limit->value >= height_2.value);
    }
    return result;
}

void derived_order_lowest(const height_t heights[3], height_t *BESSEMER_RESTRICT least)
{
    *least = heights[0];
    for (uint32_t i = 0U; i < 3U; i++) {
        const height_t height = heights[i];
        if (height.value < least->value) {
            *least = height;
        }
    }
}

bool derived_order_is_read(const derived_order_version_t *one, const derived_order_version_t *by)
{
    return (one->major < by->major || (one->major == by->major
        && (one->minor < by->minor || (one->minor == by->minor && one->patch <= by->patch))))
        && one->major == by->major;
}

bessemer_status_t derived_order_newer(const derived_order_version_t *one,
    const derived_order_version_t *other, derived_order_version_t *BESSEMER_RESTRICT version)
{
    bessemer_status_t status;
    const derived_order_version_t first = {.major = 1U, .minor = 2U, .patch = 0U};
    derived_order_version_t version_value;
    comparison_greater_version(one, other, &version_value);
    const derived_order_version_t version_high = {
        .major = U8_MAX,
        .minor = first.minor,
        .patch = first.patch
    };
    status = comparison_limited_version(&version_value, &first, &version_high, version);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    return BESSEMER_STATUS_OK;
}

ordering_t derived_order_order(const derived_order_key_t *one, const derived_order_key_t *other)
{
    const ordering_t ordering_order = comparison_compare_key(one, other);
    return comparison_reversed(ordering_order);
}

void derived_order_sorted(const derived_order_key_t keys[4],
    derived_order_key_t sorted[BESSEMER_RESTRICT 4])
{
    (void)memcpy(sorted, keys, sizeof(derived_order_key_t[4]));
    derived_order_sort_by_in_sorted(sorted, UINT64_C(4));
}

/**
 * Sorts `values` so that no element is `below` the one before it; equal elements keep their order.
 */
static void derived_order_sort_by_in_sorted(derived_order_key_t values[], uint64_t values_length)
{
    for (uint64_t i = UINT64_C(1); i < values_length; i++) {
        for (uint64_t at = i; at-- > UINT64_C(0);) {
            const derived_order_key_t one = values[at];
            const derived_order_key_t *const next = &values[at + UINT64_C(1)];
            if (!derived_order_key_less(next, &one)) {
                break;
            }
            values[at] = *next;
            values[at + UINT64_C(1)] = one;
        }
    }
}

void derived_order_place_of(const derived_order_key_t keys[4], const derived_order_key_t *limit,
    option_usize_t *BESSEMER_RESTRICT result)
{
    *result = (option_usize_t){.is_some = false};
    for (uint32_t i = 4U; i-- > 0U;) {
        if (derived_order_key_less_or_equal(&keys[i], limit)) {
            result->is_some = true;
            result->value = i;
            break;
        }
    }
}

void derived_order_compared(const height_t *one, const height_t *other,
    option_ordering_t *BESSEMER_RESTRICT result)
{
    comparison_partial_height(one, other, result);
}

/* derived_order.h */

/** A height above the ground, m. */
typedef struct {
    double value;
} height_t;

/** A version of the firmware. */
typedef struct {
    /** Changes when compatibility breaks. */
    uint8_t major;
    /** Changes when functions are added. */
    uint8_t minor;
    /** Changes when errors are corrected. */
    uint16_t patch;
} derived_order_version_t;

/** Source of a message. */
typedef enum {
    /** Sent by the pilot. */
    SOURCE_PILOT = 0,
    /** Sent by the ground station. */
    SOURCE_GROUND = 1
} source_t;

/** Key by which messages are ordered. */
typedef struct {
    /** First criterion: the pilot's messages precede the ground's. */
    source_t source;
    /** Second criterion. */
    derived_order_version_t version;
    /** Third criterion. */
    int16_t numbers[2];
} derived_order_key_t;
