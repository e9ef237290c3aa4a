/* The C of tests/corpus/src/programs/data/transposed.rs. Written by a test. */

/* transposed.c */

void transposed_checked(int16_t reading, result_i16_transposed_broken_t *result)
{
    if (reading <= -1) {
        *result = (result_i16_transposed_broken_t){
            .is_ok = false,
            .error = {.tag = BROKEN_TAG_BELOW, .below = reading}
        };
    } else if (reading <= 999) {
        *result = (result_i16_transposed_broken_t){.is_ok = true, .value = reading};
    } else {
        *result = (result_i16_transposed_broken_t){
            .is_ok = false,
            .error = {.tag = BROKEN_TAG_ABOVE}
        };
    }
}

void transposed_perhaps(const option_i16_t *reading,
    result_option_i16_transposed_broken_t *BESSEMER_RESTRICT result)
{
    result_option_i16_transposed_broken_t reading_choice;
    option_result_i16_transposed_broken_t reading_choice_2;
    if (reading->is_some) {
        const int16_t reading_2 = reading->value;
        result_i16_transposed_broken_t reading_choice_value;
        transposed_checked(reading_2, &reading_choice_value);
        reading_choice_2.is_some = true;
        reading_choice_2.value = reading_choice_value;
    } else {
        reading_choice_2 = (option_result_i16_transposed_broken_t){.is_some = false};
    }
    if (reading_choice_2.is_some && reading_choice_2.value.is_ok) {
        reading_choice = (result_option_i16_transposed_broken_t){
            .is_ok = true,
            .value = {.is_some = true, .value = reading_choice_2.value.value}
        };
    } else if (reading_choice_2.is_some && !reading_choice_2.value.is_ok) {
        reading_choice = (result_option_i16_transposed_broken_t){
            .is_ok = false,
            .error = reading_choice_2.value.error
        };
    } else {
        reading_choice = (result_option_i16_transposed_broken_t){
            .is_ok = true,
            .value = {.is_some = false}
        };
    }
    if (!reading_choice.is_ok) {
        *result = (result_option_i16_transposed_broken_t){
            .is_ok = false,
            .error = reading_choice.error
        };
        return;
    }
    const option_i16_t reading_2 = reading_choice.value;
    if (reading_2.is_some && reading_2.value > 10) {
        result->value.is_some = true;
        result->value.value = reading_2.value;
    } else {
        result->value = (option_i16_t){.is_some = false};
    }
    result->is_ok = true;
    result->error = (transposed_broken_t){.tag = BROKEN_TAG_ABOVE};
}

void transposed_some(const result_option_i16_transposed_broken_t *reading,
    option_result_i16_transposed_broken_t *BESSEMER_RESTRICT result)
{
    if (reading->is_ok && reading->value.is_some) {
        result->is_some = true;
        result->value = (result_i16_transposed_broken_t){
            .is_ok = true,
            .value = reading->value.value
        };
    } else if (reading->is_ok && !reading->value.is_some) {
        *result = (option_result_i16_transposed_broken_t){.is_some = false};
    } else {
        result->is_some = true;
        result->value = (result_i16_transposed_broken_t){.is_ok = false, .error = reading->error};
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
    /** The value, if there is one. */
    int16_t value;
    /** Reason why there is no value. */
    transposed_broken_t error;
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
    /** The value, if there is one. */
    option_i16_t value;
    /** Reason why there is no value. */
    transposed_broken_t error;
} result_option_i16_transposed_broken_t;
