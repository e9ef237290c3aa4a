/* The C of tests/corpus/src/programs/control/converted_errors.rs. Written by a test. */

/* converted_errors.c */

void drive_fault_from_frame_fault(const frame_fault_t *fault,
    drive_fault_t *BESSEMER_RESTRICT drive_fault)
{
    drive_fault->tag = DRIVE_FAULT_TAG_LINK;
    drive_fault->link = *fault;
}

void fault_code_from_drive_fault(const drive_fault_t *fault,
    fault_code_t *BESSEMER_RESTRICT fault_code)
{
    if (fault->tag == DRIVE_FAULT_TAG_OVERLOAD) {
        fault_code->value = 1U;
    } else if (fault->tag == DRIVE_FAULT_TAG_LINK && fault->link.tag == FRAME_FAULT_TAG_SHORT) {
        fault_code->value = 2U;
    } else {
        const uint8_t byte = fault->link.start;
        fault_code->value = (uint16_t)(0x100U + (uint16_t)byte);
    }
}

void converted_errors_payload(const uint8_t frame[3],
    result_u16_frame_fault_t *BESSEMER_RESTRICT result)
{
    if (frame[0] == 85U) {
        const uint8_t low = frame[1];
        const uint8_t high = frame[2];
        const uint8_t result_bytes[2] = {low, high};
        result->is_ok = true;
        result->as.value = (uint16_t)(result_bytes[0] | ((uint32_t)result_bytes[1] << 8U));
    } else if (frame[0] == 0U && frame[1] == 0U && frame[2] == 0U) {
        result->is_ok = false;
        result->as.error = (frame_fault_t){.tag = FRAME_FAULT_TAG_SHORT};
    } else {
        const uint8_t start = frame[0];
        result->is_ok = false;
        result->as.error.tag = FRAME_FAULT_TAG_START;
        result->as.error.start = start;
    }
}

void converted_errors_current(const uint8_t frame[3], float limit,
    result_f32_drive_fault_t *BESSEMER_RESTRICT result)
{
    result_u16_frame_fault_t current_outcome;
    converted_errors_payload(frame, &current_outcome);
    if (!current_outcome.is_ok) {
        drive_fault_t result_error;
        drive_fault_from_frame_fault(&current_outcome.as.error, &result_error);
        result->is_ok = false;
        result->as.error = result_error;
        return;
    }
    const float current = (float)current_outcome.as.value * 0.01F;
    if (current > limit) {
        result->is_ok = false;
        result->as.error = (drive_fault_t){.tag = DRIVE_FAULT_TAG_OVERLOAD};
        return;
    }
    result->is_ok = true;
    result->as.value = current;
}

void converted_errors_total(const uint8_t one[3], const uint8_t other[3], float limit,
    result_f32_fault_code_t *BESSEMER_RESTRICT result)
{
    result_f32_drive_fault_t outcome;
    converted_errors_current(one, limit, &outcome);
    if (!outcome.is_ok) {
        fault_code_t result_error;
        fault_code_from_drive_fault(&outcome.as.error, &result_error);
        result->is_ok = false;
        result->as.error = result_error;
        return;
    }
    result_f32_drive_fault_t other_outcome;
    converted_errors_current(other, limit, &other_outcome);
    if (!other_outcome.is_ok) {
        fault_code_t result_error;
        fault_code_from_drive_fault(&other_outcome.as.error, &result_error);
        result->is_ok = false;
        result->as.error = result_error;
        return;
    }
    result->is_ok = true;
    result->as.value = outcome.as.value + other_outcome.as.value;
}

/* converted_errors.h */

/** Which variant of `FrameFault`. */
typedef enum {
    FRAME_FAULT_TAG_SHORT = 0,
    /** The first byte is wrong: its value. */
    FRAME_FAULT_TAG_START = 1
} frame_fault_tag_t;

/** Faults of a frame. */
typedef struct {
    /** Which variant it is. */
    frame_fault_tag_t tag;
    /** The first byte is wrong: its value. */
    uint8_t start;
} frame_fault_t;

/** `Result<u16, FrameFault>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        uint16_t value;
        /** Reason why there is no value. */
        frame_fault_t error;
    } as;
} result_u16_frame_fault_t;

/** Which variant of `DriveFault`. */
typedef enum {
    DRIVE_FAULT_TAG_OVERLOAD = 0,
    /** The received frame is invalid. */
    DRIVE_FAULT_TAG_LINK = 1
} drive_fault_tag_t;

/** Faults of a drive. */
typedef struct {
    /** Which variant it is. */
    drive_fault_tag_t tag;
    /** The received frame is invalid. */
    frame_fault_t link;
} drive_fault_t;

/** `Result<f32, DriveFault>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        float value;
        /** Reason why there is no value. */
        drive_fault_t error;
    } as;
} result_f32_drive_fault_t;

/** The number of a fault for the display. */
typedef struct {
    uint16_t value;
} fault_code_t;

/** `Result<f32, FaultCode>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        float value;
        /** Reason why there is no value. */
        fault_code_t error;
    } as;
} result_f32_fault_code_t;
