/* The C of blocks/src/bytes.rs. Written by a test. */

/* bytes.c */

static const uint64_t U64_MAX = UINT64_MAX;

static uint64_t bytes_mask_f32(const signal_f32_t *signal);
static uint64_t bytes_mask_f64(const signal_f64_t *signal);
static uint32_t bytes_shift_f32(const signal_f32_t *signal);
static uint32_t bytes_shift_f64(const signal_f64_t *signal);

uint8_t bytes_crc8(const uint8_t table[256], uint8_t sum, const uint8_t bytes[],
    uint64_t bytes_length)
{
    uint8_t sum_2 = sum;
    for (uint64_t i = UINT64_C(0); i < bytes_length; i++) {
        sum_2 = table[(uint8_t)(sum_2 ^ bytes[i])];
    }
    return sum_2;
}

uint16_t bytes_crc16(const uint16_t table[256], uint16_t sum, const uint8_t bytes[],
    uint64_t bytes_length)
{
    uint16_t sum_2 = sum;
    for (uint64_t i = UINT64_C(0); i < bytes_length; i++) {
        sum_2 = (uint16_t)(table[(uint8_t)((uint8_t)(sum_2 >> 8) ^ bytes[i])]
            ^ ((uint32_t)sum_2 << 8));
    }
    return sum_2;
}

uint32_t bytes_crc32(const uint32_t table[256], uint32_t sum, const uint8_t bytes[],
    uint64_t bytes_length)
{
    uint32_t sum_2 = sum;
    for (uint64_t i = UINT64_C(0); i < bytes_length; i++) {
        sum_2 = table[(uint8_t)((uint8_t)sum_2 ^ bytes[i])] ^ (sum_2 >> 8);
    }
    return sum_2;
}

float bytes_read_signal_f32(const uint8_t frame[8], const signal_f32_t *signal)
{
    uint64_t word;
    switch (signal->order) {
    case BYTES_ORDER_LITTLE:
        word = (uint64_t)frame[0] | ((uint64_t)frame[1] << 8U) | ((uint64_t)frame[2] << 16U)
            | ((uint64_t)frame[3] << 24U) | ((uint64_t)frame[4] << 32U)
            | ((uint64_t)frame[5] << 40U) | ((uint64_t)frame[6] << 48U)
            | ((uint64_t)frame[7] << 56U);
        break;
    case BYTES_ORDER_BIG:
    default:
        word = ((uint64_t)frame[0] << 56U) | ((uint64_t)frame[1] << 48U)
            | ((uint64_t)frame[2] << 40U) | ((uint64_t)frame[3] << 32U)
            | ((uint64_t)frame[4] << 24U) | ((uint64_t)frame[5] << 16U)
            | ((uint64_t)frame[6] << 8U) | (uint64_t)frame[7];
        break;
    }
    const uint64_t raw = (word >> bytes_shift_f32(signal)) & bytes_mask_f32(signal);
    const uint64_t top = (bytes_mask_f32(signal) >> 1) + UINT64_C(1);
    float number;
    if (signal->is_signed) {
        number = (float)wrap_i64((raw ^ top) - top);
    } else {
        number = (float)raw;
    }
    return number * signal->scale + signal->offset;
}

double bytes_read_signal_f64(const uint8_t frame[8], const signal_f64_t *signal)
{
    uint64_t word;
    switch (signal->order) {
    case BYTES_ORDER_LITTLE:
        word = (uint64_t)frame[0] | ((uint64_t)frame[1] << 8U) | ((uint64_t)frame[2] << 16U)
            | ((uint64_t)frame[3] << 24U) | ((uint64_t)frame[4] << 32U)
            | ((uint64_t)frame[5] << 40U) | ((uint64_t)frame[6] << 48U)
            | ((uint64_t)frame[7] << 56U);
        break;
    case BYTES_ORDER_BIG:
    default:
        word = ((uint64_t)frame[0] << 56U) | ((uint64_t)frame[1] << 48U)
            | ((uint64_t)frame[2] << 40U) | ((uint64_t)frame[3] << 32U)
            | ((uint64_t)frame[4] << 24U) | ((uint64_t)frame[5] << 16U)
            | ((uint64_t)frame[6] << 8U) | (uint64_t)frame[7];
        break;
    }
    const uint64_t raw = (word >> bytes_shift_f64(signal)) & bytes_mask_f64(signal);
    const uint64_t top = (bytes_mask_f64(signal) >> 1) + UINT64_C(1);
    double number;
    if (signal->is_signed) {
        number = (double)wrap_i64((raw ^ top) - top);
    } else {
        number = (double)raw;
    }
    return number * signal->scale + signal->offset;
}

void bytes_write_signal_f32(uint8_t frame[BESSEMER_RESTRICT 8], const signal_f32_t *signal,
    float value)
{
    const uint32_t shift = bytes_shift_f32(signal);
    const uint64_t mask = bytes_mask_f32(signal);
    const float number = roundf((value - signal->offset) / signal->scale);
    uint64_t raw;
    if (signal->is_signed) {
        const int64_t highest = wrap_i64(mask >> 1);
        const int64_t number_2 = i64_from_f32(number);
        raw = (uint64_t)min_i64(max_i64(number_2, -INT64_C(1) - highest), highest);
    } else {
        const uint64_t number_2 = u64_from_f32(number);
        raw = min_u64(number_2, mask);
    }
    uint64_t word;
    switch (signal->order) {
    case BYTES_ORDER_LITTLE:
        word = (uint64_t)frame[0] | ((uint64_t)frame[1] << 8U) | ((uint64_t)frame[2] << 16U)
            | ((uint64_t)frame[3] << 24U) | ((uint64_t)frame[4] << 32U)
            | ((uint64_t)frame[5] << 40U) | ((uint64_t)frame[6] << 48U)
            | ((uint64_t)frame[7] << 56U);
        break;
    case BYTES_ORDER_BIG:
    default:
        word = ((uint64_t)frame[0] << 56U) | ((uint64_t)frame[1] << 48U)
            | ((uint64_t)frame[2] << 40U) | ((uint64_t)frame[3] << 32U)
            | ((uint64_t)frame[4] << 24U) | ((uint64_t)frame[5] << 16U)
            | ((uint64_t)frame[6] << 8U) | (uint64_t)frame[7];
        break;
    }
    const uint64_t word_2 = (word & ~(mask << shift)) | ((raw & mask) << shift);
    switch (signal->order) {
    case BYTES_ORDER_LITTLE:
        frame[0] = (uint8_t)word_2;
        frame[1] = (uint8_t)(word_2 >> 8U);
        frame[2] = (uint8_t)(word_2 >> 16U);
        frame[3] = (uint8_t)(word_2 >> 24U);
        frame[4] = (uint8_t)(word_2 >> 32U);
        frame[5] = (uint8_t)(word_2 >> 40U);
        frame[6] = (uint8_t)(word_2 >> 48U);
        frame[7] = (uint8_t)(word_2 >> 56U);
        break;
    case BYTES_ORDER_BIG:
    default:
        frame[0] = (uint8_t)(word_2 >> 56U);
        frame[1] = (uint8_t)(word_2 >> 48U);
        frame[2] = (uint8_t)(word_2 >> 40U);
        frame[3] = (uint8_t)(word_2 >> 32U);
        frame[4] = (uint8_t)(word_2 >> 24U);
        frame[5] = (uint8_t)(word_2 >> 16U);
        frame[6] = (uint8_t)(word_2 >> 8U);
        frame[7] = (uint8_t)word_2;
        break;
    }
}

void bytes_write_signal_f64(uint8_t frame[BESSEMER_RESTRICT 8], const signal_f64_t *signal,
    double value)
{
    const uint32_t shift = bytes_shift_f64(signal);
    const uint64_t mask = bytes_mask_f64(signal);
    const double number = round((value - signal->offset) / signal->scale);
    uint64_t raw;
    if (signal->is_signed) {
        const int64_t highest = wrap_i64(mask >> 1);
        const int64_t number_2 = i64_from_f64(number);
        raw = (uint64_t)min_i64(max_i64(number_2, -INT64_C(1) - highest), highest);
    } else {
        const uint64_t number_2 = u64_from_f64(number);
        raw = min_u64(number_2, mask);
    }
    uint64_t word;
    switch (signal->order) {
    case BYTES_ORDER_LITTLE:
        word = (uint64_t)frame[0] | ((uint64_t)frame[1] << 8U) | ((uint64_t)frame[2] << 16U)
            | ((uint64_t)frame[3] << 24U) | ((uint64_t)frame[4] << 32U)
            | ((uint64_t)frame[5] << 40U) | ((uint64_t)frame[6] << 48U)
            | ((uint64_t)frame[7] << 56U);
        break;
    case BYTES_ORDER_BIG:
    default:
        word = ((uint64_t)frame[0] << 56U) | ((uint64_t)frame[1] << 48U)
            | ((uint64_t)frame[2] << 40U) | ((uint64_t)frame[3] << 32U)
            | ((uint64_t)frame[4] << 24U) | ((uint64_t)frame[5] << 16U)
            | ((uint64_t)frame[6] << 8U) | (uint64_t)frame[7];
        break;
    }
    const uint64_t word_2 = (word & ~(mask << shift)) | ((raw & mask) << shift);
    switch (signal->order) {
    case BYTES_ORDER_LITTLE:
        frame[0] = (uint8_t)word_2;
        frame[1] = (uint8_t)(word_2 >> 8U);
        frame[2] = (uint8_t)(word_2 >> 16U);
        frame[3] = (uint8_t)(word_2 >> 24U);
        frame[4] = (uint8_t)(word_2 >> 32U);
        frame[5] = (uint8_t)(word_2 >> 40U);
        frame[6] = (uint8_t)(word_2 >> 48U);
        frame[7] = (uint8_t)(word_2 >> 56U);
        break;
    case BYTES_ORDER_BIG:
    default:
        frame[0] = (uint8_t)(word_2 >> 56U);
        frame[1] = (uint8_t)(word_2 >> 48U);
        frame[2] = (uint8_t)(word_2 >> 40U);
        frame[3] = (uint8_t)(word_2 >> 32U);
        frame[4] = (uint8_t)(word_2 >> 24U);
        frame[5] = (uint8_t)(word_2 >> 16U);
        frame[6] = (uint8_t)(word_2 >> 8U);
        frame[7] = (uint8_t)word_2;
        break;
    }
}

/** Returns the mask of a signal's bits. */
static uint64_t bytes_mask_f32(const signal_f32_t *signal)
{
    return U64_MAX >> (64U - (uint32_t)min_u8(max_u8(signal->bits, 1U), 64U));
}

/** Returns the mask of a signal's bits. */
static uint64_t bytes_mask_f64(const signal_f64_t *signal)
{
    return U64_MAX >> (64U - (uint32_t)min_u8(max_u8(signal->bits, 1U), 64U));
}

/** Returns the number of bits below a signal in its word. */
static uint32_t bytes_shift_f32(const signal_f32_t *signal)
{
    const uint32_t start = (uint32_t)signal->start & 0x3FU;
    switch (signal->order) {
    case BYTES_ORDER_LITTLE:
        return start;
    case BYTES_ORDER_BIG:
    default: {
        /* Byte 0 is the highest of the word. */
        const uint32_t top = 56U - (start & 0x38U) + (start & 7U);
        return saturating_sub_u32(top + 1U, (uint32_t)signal->bits) & 0x3FU;
    }
    }
}

/** Returns the number of bits below a signal in its word. */
static uint32_t bytes_shift_f64(const signal_f64_t *signal)
{
    const uint32_t start = (uint32_t)signal->start & 0x3FU;
    switch (signal->order) {
    case BYTES_ORDER_LITTLE:
        return start;
    case BYTES_ORDER_BIG:
    default: {
        /* Byte 0 is the highest of the word. */
        const uint32_t top = 56U - (start & 0x38U) + (start & 7U);
        return saturating_sub_u32(top + 1U, (uint32_t)signal->bits) & 0x3FU;
    }
    }
}

/* bytes.h */

/** Orders of the bits of a CAN signal. */
typedef enum {
    /** Least significant byte first, Intel; `start` is the least significant bit. */
    BYTES_ORDER_LITTLE = 0,
    /** Most significant byte first, Motorola; `start` is the most significant bit. */
    BYTES_ORDER_BIG = 1
} bytes_order_t;

/**
 * CAN signal: a row of a table, as in a DBC file. `Default` is one bit.
 *
 * value = raw · scale + offset. `start` is counted as in DBC files: bit 0 is the least significant of the first byte.
 */
typedef struct {
    /** Number of the start bit, 0 to 63. */
    uint8_t start;
    /** Number of bits, 1 to 64. The signal fits into the frame. */
    uint8_t bits;
    /** Order of the bits. */
    bytes_order_t order;
    /** True if the raw number has a sign (two's complement). */
    bool is_signed;
    /** Value of a step of the raw number, not 0. */
    float scale;
    /** Value of the raw number 0. */
    float offset;
} signal_f32_t;

/**
 * CAN signal: a row of a table, as in a DBC file. `Default` is one bit.
 *
 * value = raw · scale + offset. `start` is counted as in DBC files: bit 0 is the least significant of the first byte.
 */
typedef struct {
    /** Number of the start bit, 0 to 63. */
    uint8_t start;
    /** Number of bits, 1 to 64. The signal fits into the frame. */
    uint8_t bits;
    /** Order of the bits. */
    bytes_order_t order;
    /** True if the raw number has a sign (two's complement). */
    bool is_signed;
    /** Value of a step of the raw number, not 0. */
    double scale;
    /** Value of the raw number 0. */
    double offset;
} signal_f64_t;

/* ring_buffer_u16_4.c */

void ring_buffer_u16_4_init(ring_buffer_u16_4_t *self)
{
    self->values[0] = 0U;
    self->values[1] = 0U;
    self->values[2] = 0U;
    self->values[3] = 0U;
    self->oldest = 0U;
    self->count = 0U;
}

bool ring_buffer_u16_4_push(ring_buffer_u16_4_t *self, uint16_t value)
{
    const uint32_t oldest = self->oldest % 4U;
    const uint32_t count = min_u32(self->count, 4U);
    self->values[(oldest + count) % 4U] = value;
    const bool has_room = count < 4U;
    if (has_room) {
        self->count = count + 1U;
    } else {
        self->oldest = (oldest + 1U) % 4U;
    }
    return has_room;
}

void ring_buffer_u16_4_pop(ring_buffer_u16_4_t *BESSEMER_RESTRICT self,
    option_u16_t *BESSEMER_RESTRICT result)
{
    const uint32_t oldest = self->oldest % 4U;
    if (self->count == 0U) {
        *result = (option_u16_t){.is_some = false};
        return;
    }
    self->count -= 1U;
    self->oldest = (oldest + 1U) % 4U;
    result->is_some = true;
    result->value = self->values[oldest];
}

bool ring_buffer_u16_4_is_empty(const ring_buffer_u16_4_t *self)
{
    return self->count == 0U;
}

/* ring_buffer_u16_4.h */

/**
 * Ring buffer of at most `N` values, oldest first.
 *
 * Initialisation: `Default` is empty. Saturation: a value that is pushed into a full buffer replaces the oldest.
 *
 * ```
 * let mut ring = bessemer_blocks::RingBuffer::<u16, 2>::default();
 * assert_eq!([7, 8, 9].map(|value| ring.push(value)), [true, true, false]);
 * assert_eq!((ring.pop(), ring.len(), ring.pop(), ring.pop()), (Some(8), 1, Some(9), None));
 * ```
 */
typedef struct {
    /** The values. */
    uint16_t values[4];
    /** Index of the oldest. */
    uint32_t oldest;
    /** Number of values. */
    uint32_t count;
} ring_buffer_u16_4_t;
