/* The C of tests/corpus/src/programs/data/result_methods.rs. Written by a test. */

/* result_methods.c */

void result_methods_value(const uint8_t frame[4],
    result_u16_frame_error_t *BESSEMER_RESTRICT result)
{
    if (frame[0] < 2U) {
        result->is_ok = false;
        result->as.error = FRAME_ERROR_SHORT;
        return;
    }
    if ((uint8_t)(frame[1] ^ frame[2]) != frame[3]) {
        result->is_ok = false;
        result->as.error = FRAME_ERROR_CHECKSUM;
        return;
    }
    const uint8_t result_bytes[2] = {frame[1], frame[2]};
    result->is_ok = true;
    result->as.value = (uint16_t)(((uint32_t)result_bytes[0] << 8U) | result_bytes[1]);
}

void result_methods_volts(const uint8_t frame[4], result_f32_link_error_t *BESSEMER_RESTRICT result)
{
    result_f32_frame_error_t result_choice = {0};
    result_u16_frame_error_t raw;
    result_methods_value(frame, &raw);
    if (raw.is_ok) {
        result_choice.is_ok = true;
        result_choice.as.value = (float)raw.as.value * 0.001F;
    } else {
        result_choice.is_ok = false;
        result_choice.as.error = raw.as.error;
    }
    if (result_choice.is_ok) {
        result->is_ok = true;
        result->as.value = result_choice.as.value;
    } else {
        const frame_error_t error = result_choice.as.error;
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
        result->is_ok = false;
        result->as.error = result_choice_2;
    }
}

void result_methods_total(const uint8_t one[4], const uint8_t other[4],
    result_u16_frame_error_t *BESSEMER_RESTRICT result)
{
    result_u16_frame_error_t one_outcome;
    result_methods_value(one, &one_outcome);
    if (!one_outcome.is_ok) {
        result->is_ok = false;
        result->as.error = one_outcome.as.error;
        return;
    }
    const uint16_t one_2 = one_outcome.as.value;
    result_u16_frame_error_t other_2;
    result_methods_value(other, &other_2);
    if (other_2.is_ok) {
        option_u16_t value;
        math_checked_add_u16(one_2, other_2.as.value, &value);
        if (value.is_some) {
            result->is_ok = true;
            result->as.value = value.value;
        } else {
            result->is_ok = false;
            result->as.error = FRAME_ERROR_CHECKSUM;
        }
    } else {
        result->is_ok = false;
        result->as.error = other_2.as.error;
    }
}

uint16_t result_methods_shown(const uint8_t frame[4])
{
    result_u16_frame_error_t value;
    result_methods_value(frame, &value);
    if (value.is_ok) {
        return value.as.value;
    } else {
        switch (value.as.error) {
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
    /** What it holds. */
    union {
        /** The value, if there is one. */
        float value;
        /** Reason why there is no value. */
        frame_error_t error;
    } as;
} result_f32_frame_error_t;

/** `Result<u16, FrameError>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        uint16_t value;
        /** Reason why there is no value. */
        frame_error_t error;
    } as;
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
    /** What it holds. */
    union {
        /** The value, if there is one. */
        float value;
        /** Reason why there is no value. */
        link_error_t error;
    } as;
} result_f32_link_error_t;
