/* The C of tests/corpus/src/programs/control/optional_elements.rs. Written by a test. */

/* optional_elements.c */

uint32_t optional_elements_total(const option_u8_t readings[5])
{
    uint32_t sum = 0U;
    for (uint32_t i = 0U; i < 5U; i++) {
        if (readings[i].is_some) {
            sum += (uint32_t)readings[i].value;
        }
    }
    return sum;
}

void optional_elements_largest_half(const int32_t values[5], option_i32_t *BESSEMER_RESTRICT result)
{
    *result = (option_i32_t){.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        option_i32_t result_choice;
        if (values[i] % 2 == 0) {
            result_choice.is_some = true;
            result_choice.value = values[i] / 2;
        } else {
            result_choice = (option_i32_t){.is_some = false};
        }
        if (result_choice.is_some) {
            const int32_t value = result_choice.value;
            if (result->is_some) {
                if (value >= result->value) {
                    result->is_some = true;
                    result->value = value;
                }
            } else {
                result->is_some = true;
                result->value = value;
            }
        }
    }
}
