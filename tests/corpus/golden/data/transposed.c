/* The C of tests/corpus/src/programs/data/transposed.rs. Written by a test. */

/* transposed.c */

void transposed_checked(int16_t reading, result_i16_transposed_broken_t *result)
{
    if (reading <= -1) {
        result->is_ok = false;
        result->as.error.tag = BROKEN_TAG_BELOW;
        result->as.error.below = reading;
    } else if (reading <= 999) {
        result->is_ok = true;
        result->as.value = reading;
    } else {
        result->is_ok = false;
        result->as.error = (transposed_broken_t){.tag = BROKEN_TAG_ABOVE};
    }
}

void transposed_perhaps(const option_i16_t *reading,
    result_option_i16_transposed_broken_t *BESSEMER_RESTRICT result)
{
    result_option_i16_transposed_broken_t reading_choice = {0};
    option_result_i16_transposed_broken_t reading_choice_2 = {0};
    if (reading->is_some) {
        const int16_t reading_2 = reading->value;
        result_i16_transposed_broken_t reading_choice_value = {0};
        transposed_checked(reading_2, &reading_choice_value);
        reading_choice_2.is_some = true;
        reading_choice_2.value = reading_choice_value;
    } else {
        reading_choice_2 = (option_result_i16_transposed_broken_t){.is_some = false};
    }
    if (reading_choice_2.is_some && reading_choice_2.value.is_ok) {
        reading_choice.is_ok = true;
        reading_choice.as.value.is_some = true;
        reading_choice.as.value.value = reading_choice_2.value.as.value;
    } else if (reading_choice_2.is_some && !reading_choice_2.value.is_ok) {
        reading_choice.is_ok = false;
        reading_choice.as.error = reading_choice_2.value.as.error;
    } else {
        reading_choice.is_ok = true;
        reading_choice.as.value = (option_i16_t){.is_some = false};
    }
    if (!reading_choice.is_ok) {
        result->is_ok = false;
        result->as.error = reading_choice.as.error;
        return;
    }
    const option_i16_t reading_2 = reading_choice.as.value;
    option_i16_t result_choice;
    if (reading_2.is_some && reading_2.value > 10) {
        result_choice.is_some = true;
        result_choice.value = reading_2.value;
    } else {
        result_choice = (option_i16_t){.is_some = false};
    }
    result->is_ok = true;
    result->as.value = result_choice;
}

void transposed_some(const result_option_i16_transposed_broken_t *reading,
    option_result_i16_transposed_broken_t *BESSEMER_RESTRICT result)
{
    if (reading->is_ok && reading->as.value.is_some) {
        result->is_some = true;
        result->value.is_ok = true;
        result->value.as.value = reading->as.value.value;
    } else if (reading->is_ok && !reading->as.value.is_some) {
        *result = (option_result_i16_transposed_broken_t){.is_some = false};
    } else {
        result->is_some = true;
        result->value.is_ok = false;
        result->value.as.error = reading->as.error;
    }
}

void transposed_parts(const option_pair_u8_f32_t *pair,
    pair_option_u8_option_f32_t *BESSEMER_RESTRICT result)
{
    if (pair->is_some) {
        result->first.is_some = true;
        result->first.value = pair->value.first;
        result->second.is_some = true;
        result->second.value = pair->value.second;
    } else {
        static const pair_option_u8_option_f32_t parts = {
            .first = {.is_some = false},
            .second = {.is_some = false}
        };
        *result = parts;
    }
}

/* transposed.h */

/** Which variant of `Broken`. */
typedef enum {
    /** Above the range of the sensor. */
    BROKEN_TAG_ABOVE = 0,
    /** Below the range of the sensor: the reading. */
    BROKEN_TAG_BELOW = 1
} broken_tag_t;

/** Reason why a reading is invalid. */
typedef struct {
    /** Which variant it is. */
    broken_tag_t tag;
    /** Below the range of the sensor: the reading. */
    int16_t below;
} transposed_broken_t;

/** `Result<i16, Broken>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        int16_t value;
        /** Reason why there is no value. */
        transposed_broken_t error;
    } as;
} result_i16_transposed_broken_t;

/** `Option<Result<i16, Broken>>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    result_i16_transposed_broken_t value;
} option_result_i16_transposed_broken_t;

/** `Result<Option<i16>, Broken>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        option_i16_t value;
        /** Reason why there is no value. */
        transposed_broken_t error;
    } as;
} result_option_i16_transposed_broken_t;
