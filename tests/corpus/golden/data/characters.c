/* The C of tests/corpus/src/programs/data/characters.rs. Written by a test. */

/* characters.c */

static const uint32_t KEYS[4][3] = {
    {49U, 50U, 51U},
    {52U, 53U, 54U},
    {55U, 56U, 57U},
    {42U, 48U, 35U}
};

void characters_key(uint64_t row, uint64_t column, option_u32_t *result)
{
    if (row >= UINT64_C(4)) {
        *result = (option_u32_t){.is_some = false};
        return;
    }
    option_u32_t result_found = {.is_some = false};
    if (column < UINT64_C(3)) {
        result_found.is_some = true;
        result_found.value = KEYS[row][column];
    }
    *result = result_found;
}

uint8_t characters_class(uint32_t code)
{
    option_u32_t letter;
    ascii_from_code(code, &letter);
    if (!letter.is_some) {
        return 0U;
    }
    if (letter.value >= 48U && letter.value <= 57U) {
        return 1U;
    } else if ((letter.value >= 97U && letter.value <= 122U)
            || (letter.value >= 65U && letter.value <= 90U) || letter.value == 95U) {
        return 2U;
    } else if (letter.value == 32U || letter.value == 9U || letter.value == 10U) {
        return 3U;
    } else if (letter.value == 228U || letter.value == 176U) {
        return 4U;
    } else if (letter.value > 127U) {
        return 5U;
    } else {
        return 6U;
    }
}

bessemer_status_t characters_value(const uint8_t bytes[4], uint8_t base,
    uint32_t *BESSEMER_RESTRICT value)
{
    bessemer_status_t status;
    const uint32_t base_2 = ((uint32_t)base & 0xFU) + 2U;
    uint32_t value_value = 0U;
    for (uint32_t i = 0U; i < 4U; i++) {
        option_u32_t digit;
        status = ascii_to_digit((uint32_t)bytes[i], base_2, &digit);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        if (!digit.is_some) {
            break;
        }
        if ((uint64_t)value_value * (uint64_t)base_2 > UINT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        if (i64_from_u32(value_value * base_2) + (int64_t)digit.value > (int64_t)UINT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        value_value = value_value * base_2 + digit.value;
    }
    *value = value_value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t characters_is_sixteenth(uint8_t byte, bool *result)
{
    bessemer_status_t status;
    status = ascii_is_digit_of((uint32_t)byte, 16U, result);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    return BESSEMER_STATUS_OK;
}

bessemer_status_t characters_digit(uint32_t value, uint8_t *result)
{
    bessemer_status_t status;
    option_u32_t shown_option;
    status = ascii_from_digit(value, 36U, &shown_option);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    uint32_t shown = 63U;
    if (shown_option.is_some) {
        shown = shown_option.value;
    }
    if (ascii_char_is_lowercase(shown)) {
        uint32_t result_char_to_uppercase;
        status = ascii_char_to_uppercase(shown, &result_char_to_uppercase);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        *result = (uint8_t)result_char_to_uppercase;
        return BESSEMER_STATUS_OK;
    } else {
        *result = (uint8_t)shown;
        return BESSEMER_STATUS_OK;
    }
}

/* listener.c */

void listener_init(listener_t *self)
{
    self->last.is_some = false;
    self->last.value = 0U;
    self->count = 0U;
}

uint32_t listener_hear(listener_t *self, uint8_t byte)
{
    const uint32_t letter = (uint32_t)byte;
    if (!ascii_char_is_alphanumeric(letter) || letter == 120U) {
        return 0U;
    }
    const option_u32_t value_before = self->last;
    self->last.is_some = true;
    self->last.value = letter;
    if (value_before.is_some && value_before.value == letter) {
        self->count = saturating_add_u8(self->count, 1U);
    } else {
        self->count = 1U;
    }
    return letter + (uint32_t)ascii_char_is_hexdigit(letter);
}

/* listener.h */

/** The last letter received, and how often it was received in a row. */
typedef struct {
    /** The last letter received. */
    option_u32_t last;
    /** Number of occurrences. */
    uint8_t count;
} listener_t;
