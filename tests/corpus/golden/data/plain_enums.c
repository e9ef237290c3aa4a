/* The C of tests/corpus/src/programs/data/plain_enums.rs. Written by a test. */

/* plain_enums.c */

lamp_t lamp_next(lamp_t self)
{
    switch (self) {
    case LAMP_OFF:
        return LAMP_BLINKING;
    case LAMP_BLINKING:
        return LAMP_ON;
    case LAMP_ON:
    default:
        return LAMP_OFF;
    }
}

lamp_t plain_enums_pressed(lamp_t lamp, uint8_t presses)
{
    lamp_t lamp_2 = lamp;
    for (uint8_t pass = 0U; pass < presses % 3U; pass++) {
        lamp_2 = lamp_next(lamp_2);
    }
    return lamp_2;
}

/* plain_enums.h */

/** State of the lamp. */
typedef enum {
    LAMP_OFF = 0,
    LAMP_BLINKING = 1,
    LAMP_ON = 2
} lamp_t;
