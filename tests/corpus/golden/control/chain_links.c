/* The C of tests/corpus/src/programs/control/chain_links.rs. Written by a test. */

/* chain_links.c */

double chain_links_energy(const double samples[8], double threshold)
{
    double sum = -0.0;
    bool skipping = true;
    for (uint32_t i = 0U; i < 8U; i++) {
        if (skipping) {
            skipping = fabs(samples[i]) < threshold;
        }
        if (!skipping) {
            sum += samples[i] * samples[i];
        }
    }
    return sum;
}

bessemer_status_t chain_links_leading_number(const uint8_t text[6],
    uint32_t *BESSEMER_RESTRICT result)
{
    uint32_t value = 0U;
    for (uint32_t i = 0U; i < 6U; i++) {
        option_u8_t result_choice;
        if (ascii_is_digit(text[i])) {
            if (text[i] < 48U) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            result_choice.is_some = true;
            result_choice.value = (uint8_t)(text[i] - 48U);
        } else {
            result_choice = (option_u8_t){.is_some = false};
        }
        if (result_choice.is_some) {
            const uint8_t digit = result_choice.value;
            if (value > 0x19999999U) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            if (i64_from_u32(10U * value) + (int64_t)digit > (int64_t)UINT32_MAX) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            value = 10U * value + (uint32_t)digit;
        } else {
            break;
        }
    }
    *result = value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t chain_links_highest(const int32_t flows[6], int32_t start,
    option_i32_t *BESSEMER_RESTRICT result)
{
    option_i32_t max = {.is_some = false};
    int32_t level = start;
    for (uint32_t i = 0U; i < 6U; i++) {
        option_i32_t result_choice;
        if ((int64_t)level + (int64_t)flows[i] < INT32_MIN
                || (int64_t)level + (int64_t)flows[i] > INT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        level += flows[i];
        if (level >= 0) {
            result_choice.is_some = true;
            result_choice.value = level;
        } else {
            result_choice = (option_i32_t){.is_some = false};
        }
        if (result_choice.is_some) {
            const int32_t value = result_choice.value;
            if (max.is_some) {
                if (value >= max.value) {
                    max.is_some = true;
                    max.value = value;
                }
            } else {
                max.is_some = true;
                max.value = value;
            }
        } else {
            break;
        }
    }
    *result = max;
    return BESSEMER_STATUS_OK;
}

float chain_links_folded(const float samples[4], const float coefficients[4])
{
    float sum = -0.0F;
    for (uint32_t i = 0U; i < 4U; i++) {
        sum += samples[i] * coefficients[3U - i];
    }
    return sum;
}

void chain_links_places(const uint16_t readings[6],
    pair_option_u16_option_usize_t *BESSEMER_RESTRICT result)
{
    uint32_t left = 1U;
    result->first = (option_u16_t){.is_some = false};
    for (uint32_t i = 0U; i < 6U; i++) {
        if (readings[i] < 4096U) {
            if (left == 0U) {
                result->first.is_some = true;
                result->first.value = readings[i];
                break;
            }
            left -= 1U;
        }
    }
    result->second = (option_usize_t){.is_some = false};
    for (uint32_t i = 6U; i-- > 0U;) {
        if (readings[i] == 0U) {
            result->second.is_some = true;
            result->second.value = i;
            break;
        }
    }
}
