/* The C of tests/corpus/src/programs/numbers/letters.rs. Written by a test. */

/* letters.c */

bessemer_status_t letters_digit(uint8_t byte, option_u8_t *result)
{
    bessemer_status_t status;
    if (ascii_is_digit(byte)) {
        if (byte < 48U) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        result->is_some = true;
        result->value = (uint8_t)(byte - 48U);
        return BESSEMER_STATUS_OK;
    } else if (ascii_is_hexdigit(byte)) {
        uint8_t result_to_uppercase;
        status = ascii_to_uppercase(byte, &result_to_uppercase);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        if (result_to_uppercase < 65U) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        result->is_some = true;
        result->value = (uint8_t)((uint8_t)(result_to_uppercase - 65U) + 10U);
        return BESSEMER_STATUS_OK;
    } else {
        *result = (option_u8_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
}

bessemer_status_t letters_kind(uint8_t byte, uint8_t *result)
{
    bessemer_status_t status;
    if (ascii_is_whitespace(byte)) {
        *result = 0U;
        return BESSEMER_STATUS_OK;
    } else if (ascii_is_lowercase(byte)) {
        *result = 1U;
        return BESSEMER_STATUS_OK;
    } else if (ascii_is_uppercase(byte)) {
        *result = 2U;
        return BESSEMER_STATUS_OK;
    } else if (ascii_is_alphanumeric(byte)) {
        *result = 3U;
        return BESSEMER_STATUS_OK;
    } else {
        status = ascii_to_lowercase(byte, result);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        return BESSEMER_STATUS_OK;
    }
}
