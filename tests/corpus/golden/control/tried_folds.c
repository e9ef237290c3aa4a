/* The C of tests/corpus/src/programs/control/tried_folds.rs. Written by a test. */

/* tried_folds.c */

void tried_folds_total(const uint8_t values[5], option_u8_t *BESSEMER_RESTRICT result)
{
    result->is_some = true;
    result->value = 0U;
    for (uint32_t i = 0U; i < 5U; i++) {
        const uint8_t sum = result->value;
        math_checked_add_u8(sum, values[i], result);
        if (!result->is_some) {
            break;
        }
    }
}

bessemer_status_t tried_folds_number(const uint8_t digits[4],
    result_u16_tried_folds_trouble_t *BESSEMER_RESTRICT result)
{
    result_u16_tried_folds_trouble_t tried = {.is_ok = true, .as.value = 0U};
    for (uint32_t i = 0U; i < 4U; i++) {
        const uint16_t value = tried.as.value;
        if (!ascii_is_digit(digits[i])) {
            tried_folds_return_letter(&tried);
        } else {
            option_u16_t tried_choice;
            option_u16_t tens;
            math_checked_mul_u16(value, 10U, &tens);
            if (tens.is_some) {
                if (digits[i] < 48U) {
                    return BESSEMER_STATUS_OVERFLOW;
                }
                math_checked_add_u16(tens.value, (uint16_t)(uint8_t)(digits[i] - 48U),
                    &tried_choice);
            } else {
                tried_choice = (option_u16_t){.is_some = false};
            }
            result_u16_tried_folds_trouble_t tried_choice_2 = {
                .is_ok = false,
                .as.error = TRIED_FOLDS_TROUBLE_BEYOND
            };
            if (tried_choice.is_some) {
                tried_choice_2.is_ok = true;
                tried_choice_2.as.value = tried_choice.value;
            }
            tried = tried_choice_2;
        }
        if (!tried.is_ok) {
            break;
        }
    }
    *result = tried;
    return BESSEMER_STATUS_OK;
}

void tried_folds_return_letter(result_u16_tried_folds_trouble_t *result)
{
    result->is_ok = false;
    result->as.error = TRIED_FOLDS_TROUBLE_LETTER;
}

void tried_folds_span(const float readings[4], option_pair_f32_f32_t *BESSEMER_RESTRICT result)
{
    result->is_some = true;
    result->value.first = INFINITY;
    result->value.second = -INFINITY;
    for (uint32_t i = 0U; i < 4U; i++) {
        const float least = result->value.first;
        const float greatest = result->value.second;
        if (isnan(readings[i]) != 0) {
            *result = (option_pair_f32_f32_t){.is_some = false};
        } else {
            result->is_some = true;
            result->value.first = min_f32(least, readings[i]);
            result->value.second = max_f32(greatest, readings[i]);
        }
        if (!result->is_some) {
            break;
        }
    }
}

/* tried_folds.h */

/** Reason why a text is not a number. */
typedef enum {
    /** The text contains a letter. */
    TRIED_FOLDS_TROUBLE_LETTER = 0,
    /** The number does not fit its type. */
    TRIED_FOLDS_TROUBLE_BEYOND = 1
} tried_folds_trouble_t;

/** `Result<u16, Trouble>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        uint16_t value;
        /** Reason why there is no value. */
        tried_folds_trouble_t error;
    } as;
} result_u16_tried_folds_trouble_t;
