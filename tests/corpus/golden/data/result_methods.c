/* The C of tests/corpus/src/programs/data/result_methods.rs. Written by a test. */

/* result_methods.c */

void result_methods_value(const uint8_t frame[4],
    result_u16_frame_error_t *BESSEMER_RESTRICT result)
{
    if (frame[0] < 2U) {
        *result = (result_u16_frame_error_t){.is_ok = false, .error = FRAME_ERROR_SHORT};
        return;
    }
    if ((uint8_t)(frame[1] ^ frame[2]) != frame[3]) {
        *result = (result_u16_frame_error_t){.is_ok = false, .error = FRAME_ERROR_CHECKSUM};
        return;
    }
    const uint8_t result_bytes[2] = {frame[1], frame[2]};
    *result = (result_u16_frame_error_t){
        .is_ok = true,
        .value = (uint16_t)(((uint32_t)result_bytes[0] << 8U) | result_bytes[1])
    };
}

void result_methods_volts(const uint8_t frame[4], result_f32_link_error_t *BESSEMER_RESTRICT result)
{
    result_f32_frame_error_t result_choice;
    result_u16_frame_error_t raw;
    result_methods_value(frame, &raw);
    if (raw.is_ok) {
        result_choice = (result_f32_frame_error_t){
            .is_ok = true,
            .value = (float)raw.value * 0.001F
        };
    } else {
        result_choice = (result_f32_frame_error_t){.is_ok = false, .error = raw.error};
    }
    if (result_choice.is_ok) {
        *result = (result_f32_link_error_t){.is_ok = true, .value = result_choice.value};
    } else {
        const frame_error_t error = result_choice.error;
        link_error_t result_choice_2;
        switch (error) {
        case FRAME_ERROR_SHORT:
            result_choice_2 = (link_error_t){.tag = LINK_ERROR_TAG_SILENT};
            break;
        case FRAME_ERROR_CHECKSUM:
        default:
            result_choice_2.tag = LINK_ERROR_TAG_DAMAGED;
            result_choice_2.damaged = frame[0];
            break;
        }
        *result = (result_f32_link_error_t){.is_ok = false, .error = result_choice_2};
    }
}

void result_methods_total(const uint8_t one[4], const uint8_t other[4],
    result_u16_frame_error_t *BESSEMER_RESTRICT result)
{
    result_u16_frame_error_t one_outcome;
    result_methods_value(one, &one_outcome);
    if (!one_outcome.is_ok) {
        *result = (result_u16_frame_error_t){.is_ok = false, .error = one_outcome.error};
        return;
    }
    const uint16_t one_2 = one_outcome.value;
    result_u16_frame_error_t other_2;
    result_methods_value(other, &other_2);
    if (other_2.is_ok) {
        option_u16_t value;
        math_checked_add_u16(one_2, other_2.value, &value);
        if (value.is_some) {
            *result = (result_u16_frame_error_t){.is_ok = true, .value = value.value};
        } else {
            *result = (result_u16_frame_error_t){.is_ok = false, .error = FRAME_ERROR_CHECKSUM};
        }
    } else {
        *result = (result_u16_frame_error_t){.is_ok = false, .error = other_2.error};
    }
}

uint16_t result_methods_shown(const uint8_t frame[4])
{
    result_u16_frame_error_t value;
    result_methods_value(frame, &value);
    if (value.is_ok) {
        return value.value;
    } else {
        switch (value.error) {
        case FRAME_ERROR_SHORT:
            return 1U;
        case FRAME_ERROR_CHECKSUM:
        default:
            return 2U;
        }
    }
}

/* result_methods.h */

/** Errors of a frame. */
typedef enum {
    FRAME_ERROR_SHORT = 0,
    FRAME_ERROR_CHECKSUM = 1
} frame_error_t;

/** `Result<f32, FrameError>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** The value, if there is one. */
    float value;
    /** Reason why there is no value. */
    frame_error_t error;
} result_f32_frame_error_t;

/** `Result<u16, FrameError>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** The value, if there is one. */
    uint16_t value;
    /** Reason why there is no value. */
    frame_error_t error;
} result_u16_frame_error_t;

/** Which variant of `LinkError`. */
typedef enum {
    LINK_ERROR_TAG_SILENT = 0,
    /** A damaged frame: its number. */
    LINK_ERROR_TAG_DAMAGED = 1
} link_error_tag_t;

/** Errors reported to the ground. */
typedef struct {
    /** Which variant it is. */
    link_error_tag_t tag;
    /** A damaged frame: its number. */
    uint8_t damaged;
} link_error_t;

/** `Result<f32, LinkError>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** The value, if there is one. */
    float value;
    /** Reason why there is no value. */
    link_error_t error;
} result_f32_link_error_t;
