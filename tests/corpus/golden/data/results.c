/* The C of tests/corpus/src/programs/data/results.rs. Written by a test. */

/* results.c */

void results_payload(const uint8_t frame[3], uint8_t len,
    result_u16_refused_t *BESSEMER_RESTRICT result)
{
    if (len < 3U) {
        result->is_ok = false;
        result->as.error = REFUSED_SHORT;
        return;
    }
    if ((uint8_t)((uint32_t)frame[0] + (uint32_t)frame[1]) != frame[2]) {
        result->is_ok = false;
        result->as.error = REFUSED_CHECKSUM;
        return;
    }
    const uint8_t result_bytes[2] = {frame[0], frame[1]};
    result->is_ok = true;
    result->as.value = (uint16_t)(result_bytes[0] | ((uint32_t)result_bytes[1] << 8U));
}

/* results.h */

/** Reason why a frame is refused. */
typedef enum {
    /** Too few bytes were received. */
    REFUSED_SHORT = 0,
    /** The checksum is wrong. */
    REFUSED_CHECKSUM = 1
} refused_t;

/** `Result<u16, Refused>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        uint16_t value;
        /** Reason why there is no value. */
        refused_t error;
    } as;
} result_u16_refused_t;
