/* The C of tests/corpus/src/programs/control/while_let.rs. Written by a test. */

/* while_let.c */

void while_let_halved(uint32_t n, option_u32_t *result)
{
    if (n % 2U == 0U && n > 0U) {
        result->is_some = true;
        result->value = n / 2U;
    } else {
        *result = (option_u32_t){.is_some = false};
    }
}

bessemer_status_t while_let_odd_part(uint32_t n, uint32_t *odd)
{
    uint32_t odd_value = n;
    for (uint32_t pass = 0U; pass <= 32U; pass++) {
        option_u32_t half;
        while_let_halved(odd_value, &half);
        if (!half.is_some) {
            break;
        }
        if (pass >= 32U) {
            return BESSEMER_STATUS_BOUND;
        }
        odd_value = half.value;
    }
    *odd = odd_value;
    return BESSEMER_STATUS_OK;
}
