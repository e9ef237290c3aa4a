/* The C of tests/corpus/src/programs/data/ordered_payloads.rs. Written by a test. */

/* ordered_payloads.c */

void ordered_payloads_sensor_report(uint8_t kind, int32_t level, sensor_report_t *sensor_report)
{
    switch ((uint8_t)(kind % 5U)) {
    case 0U:
        sensor_report->tag = SENSOR_REPORT_TAG_LEVEL;
        sensor_report->as.level = level;
        break;
    case 1U:
        sensor_report->tag = SENSOR_REPORT_TAG_MISSING;
        break;
    case 2U:
        sensor_report->tag = SENSOR_REPORT_TAG_WINDOW;
        sensor_report->as.window.first[0] = 1;
        sensor_report->as.window.first[1] = 2;
        sensor_report->as.window.first[2] = 3;
        sensor_report->as.window.first[3] = 4;
        sensor_report->as.window.first[4] = wrap_i16((uint16_t)level);
        sensor_report->as.window.first[5] = wrap_i16(u16_from_i32(level / 7));
        sensor_report->as.window.second = level > 0;
        break;
    case 3U:
        sensor_report->tag = SENSOR_REPORT_TAG_SPAN;
        sensor_report->as.span.low = f32_from_i32(level % 3) / 0.0F;
        sensor_report->as.span.high = (float)level;
        break;
    default: {
        uint8_t rows[9][2];
        for (uint32_t i = 0U; i < 9U; i++) {
            rows[i][0] = 3U;
            rows[i][1] = 3U;
        }
        rows[8][0] = u8_from_i32(level % 2);
        rows[8][1] = u8_from_i32(level % 5);
        sensor_report->tag = SENSOR_REPORT_TAG_ROWS;
        (void)memcpy(sensor_report->as.rows, rows, sizeof(uint8_t[9][2]));
        break;
    }
    }
}

uint8_t ordered_payloads_orders_of_reports(uint8_t kinds, int32_t x, int32_t y)
{
    sensor_report_t a = {0};
    ordered_payloads_sensor_report((uint8_t)(kinds % 5U), x, &a);
    sensor_report_t b = {0};
    ordered_payloads_sensor_report((uint8_t)(kinds / 5U), y, &b);
    uint8_t bits = 0U;
    const bool elements[4] = {
        sensor_report_less(&a, &b), sensor_report_less_or_equal(&a, &b), sensor_report_less(&b, &a),
        sensor_report_less_or_equal(&b, &a)
    };
    for (uint32_t i = 0U; i < 4U; i++) {
        bits = (uint8_t)(((uint32_t)bits << 1) | (uint8_t)elements[i]);
    }
    return bits;
}

uint8_t ordered_payloads_orders_of_optional_reports(uint8_t kinds, int32_t x, int32_t y)
{
    const uint8_t kind = (uint8_t)(kinds % 6U);
    option_sensor_report_t a = {0};
    if (kind < 5U) {
        sensor_report_t a_value = {0};
        ordered_payloads_sensor_report(kind, x, &a_value);
        a.is_some = true;
        a.value = a_value;
    } else {
        a.is_some = false;
        a.value.tag = SENSOR_REPORT_TAG_LEVEL;
        a.value.as.level = 0;
    }
    const uint8_t kind_2 = (uint8_t)((uint8_t)(kinds / 6U) % 6U);
    option_sensor_report_t b = {0};
    if (kind_2 < 5U) {
        sensor_report_t b_value = {0};
        ordered_payloads_sensor_report(kind_2, y, &b_value);
        b.is_some = true;
        b.value = b_value;
    } else {
        b.is_some = false;
        b.value.tag = SENSOR_REPORT_TAG_LEVEL;
        b.value.as.level = 0;
    }
    return (uint8_t)(((uint32_t)option_sensor_report_less(&a, &b) << 1)
        | (uint8_t)option_sensor_report_less_or_equal(&b, &a));
}

bessemer_status_t ordered_payloads_orders_of_results(uint8_t kinds, int32_t x, int32_t y,
    uint8_t *result)
{
    const uint8_t kind = (uint8_t)(kinds % 6U);
    result_sensor_report_i32x3_t a = {0};
    if (kind < 5U) {
        sensor_report_t a_value = {0};
        ordered_payloads_sensor_report(kind, x, &a_value);
        a.is_ok = true;
        a.as.value = a_value;
    } else {
        if (x == INT32_MIN) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        a.is_ok = false;
        a.as.error[0] = x;
        a.as.error[1] = -x;
        a.as.error[2] = 3;
    }
    const uint8_t kind_2 = (uint8_t)((uint8_t)(kinds / 6U) % 6U);
    result_sensor_report_i32x3_t b = {0};
    if (kind_2 < 5U) {
        sensor_report_t b_value = {0};
        ordered_payloads_sensor_report(kind_2, y, &b_value);
        b.is_ok = true;
        b.as.value = b_value;
    } else {
        if (y == INT32_MIN) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        b.is_ok = false;
        b.as.error[0] = y;
        b.as.error[1] = -y;
        b.as.error[2] = 3;
    }
    *result = (uint8_t)(((uint32_t)result_sensor_report_i32x3_less_or_equal(&a, &b) << 1)
        | (uint8_t)result_sensor_report_i32x3_less(&b, &a));
    return BESSEMER_STATUS_OK;
}

uint8_t ordered_payloads_orders_of_tuples(uint8_t kinds, int32_t x, int32_t y)
{
    sensor_report_t a = {0};
    ordered_payloads_sensor_report((uint8_t)(kinds % 5U), x, &a);
    sensor_report_t b = {0};
    ordered_payloads_sensor_report((uint8_t)(kinds / 5U), y, &b);
    const pair_i32_sensor_report_t by_level_one = {.first = x, .second = a};
    const pair_i32_sensor_report_t by_level_other = {.first = y, .second = b};
    const bool by_level = pair_i32_sensor_report_less(&by_level_one, &by_level_other);
    pair_sensor_report_i32x2_t by_report_one = {0};
    by_report_one.first = b;
    by_report_one.second[0] = y;
    by_report_one.second[1] = y;
    pair_sensor_report_i32x2_t by_report_other = {0};
    by_report_other.first = a;
    by_report_other.second[0] = x;
    by_report_other.second[1] = x;
    const bool by_report = pair_sensor_report_i32x2_less_or_equal(&by_report_one, &by_report_other);
    const pair_reverse_sensor_report_i32_t reversed_one = {.first = {.value = a}, .second = x};
    const pair_reverse_sensor_report_i32_t reversed_other = {.first = {.value = b}, .second = y};
    const bool reversed = pair_reverse_sensor_report_i32_less_or_equal(&reversed_one,
        &reversed_other);
    return (uint8_t)(((uint32_t)by_level << 2) | ((uint32_t)by_report << 1) | (uint8_t)reversed);
}

uint8_t ordered_payloads_orders_of_arrays(const uint8_t x[12], uint64_t at, uint8_t y)
{
    uint8_t other[12];
    (void)memcpy(other, x, sizeof(uint8_t[12]));
    other[at % UINT64_C(12)] = y;
    const pair_u8_f64_t pairs_element = {.first = 0U, .second = 0.0};
    pair_u8_f64_t pairs[5];
    for (uint32_t i = 0U; i < 5U; i++) {
        pairs[i] = pairs_element;
    }
    pairs[at % UINT64_C(5)].first = y;
    pairs[at % UINT64_C(5)].second = (double)y;
    bool result_in_order = false;
    for (uint32_t i = 0U; i < 12U; i++) {
        if (x[i] != other[i]) {
            result_in_order = x[i] < other[i];
            break;
        }
    }
    const uint8_t result_left = (uint8_t)((uint32_t)result_in_order << 2);
    bool result_in_order_2 = true;
    for (uint32_t i = 0U; i < 12U; i++) {
        if (x[i] != other[i]) {
            result_in_order_2 = x[i] > other[i];
            break;
        }
    }
    const uint8_t result_left_2 = (uint8_t)(result_left | ((uint32_t)result_in_order_2 << 1));
    const pair_u8_f64_t elements_element = {.first = x[0], .second = 7.0};
    pair_u8_f64_t elements[5];
    for (uint32_t i = 0U; i < 5U; i++) {
        elements[i] = elements_element;
    }
    bool result_in_order_3 = true;
    for (uint32_t i = 0U; i < 5U; i++) {
        if (!(pairs[i].first == elements[i].first && pairs[i].second == elements[i].second)) {
            result_in_order_3 = pairs[i].first < elements[i].first
                || (pairs[i].first == elements[i].first && pairs[i].second < elements[i].second);
            break;
        }
    }
    return (uint8_t)(result_left_2 | (uint8_t)result_in_order_3);
}

bool ordered_payloads_comes_in_time(uint8_t kinds, const int32_t levels[3], int32_t limit)
{
    bool every = true;
    for (uint32_t i = 0U; i < 3U; i++) {
        if (levels[i] > limit) {
            every = false;
            break;
        }
    }
    bool result = false;
    if (every) {
        sensor_report_t result_one = {0};
        ordered_payloads_sensor_report((uint8_t)(kinds % 5U), levels[0], &result_one);
        sensor_report_t result_other = {0};
        ordered_payloads_sensor_report((uint8_t)(kinds / 5U), levels[1], &result_other);
        result = sensor_report_less(&result_one, &result_other);
    }
    return result;
}

/* ordered_payloads.h */

/** A span of levels. */
typedef struct {
    /** The lowest level. */
    float low;
    /** The highest level. */
    float high;
} level_span_t;

/** Which variant of `SensorReport`. */
typedef enum {
    /** A level. */
    SENSOR_REPORT_TAG_LEVEL = 0,
    /** Nothing. */
    SENSOR_REPORT_TAG_MISSING = 1,
    /** Samples, and true if they are complete. */
    SENSOR_REPORT_TAG_WINDOW = 2,
    /** A span of levels. */
    SENSOR_REPORT_TAG_SPAN = 3,
    /** Two rows of samples. */
    SENSOR_REPORT_TAG_ROWS = 4
} sensor_report_tag_t;

/** Fields of the variant Window of SensorReport. */
typedef struct {
    int16_t first[6];
    bool second;
} sensor_report_window_t;

/** Report of a sensor. */
typedef struct {
    /** Which variant it is. */
    sensor_report_tag_t tag;
    /** What it holds. */
    union {
        /** A level. */
        int32_t level;
        /** Samples, and true if they are complete. */
        sensor_report_window_t window;
        /** A span of levels. */
        level_span_t span;
        /** Two rows of samples. */
        uint8_t rows[9][2];
    } as;
} sensor_report_t;

/** `Option<SensorReport>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    sensor_report_t value;
} option_sensor_report_t;

/** `(i32, SensorReport)`. */
typedef struct {
    int32_t first;
    sensor_report_t second;
} pair_i32_sensor_report_t;

/** `(SensorReport, [i32; 2])`. */
typedef struct {
    sensor_report_t first;
    int32_t second[2];
} pair_sensor_report_i32x2_t;

/** `Result<SensorReport, [i32; 3]>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        sensor_report_t value;
        /** Reason why there is no value. */
        int32_t error[3];
    } as;
} result_sensor_report_i32x3_t;
