/* The C of tests/corpus/src/programs/data/values_that_borrow.rs. Written by a test. */

/* store.c */

static void values_that_borrow_store_held(const values_that_borrow_store_t *self,
    slice_f64_t *BESSEMER_RESTRICT result);

void values_that_borrow_store_init(values_that_borrow_store_t *self)
{
    self->values[0] = 0.0;
    self->values[1] = 0.0;
    self->values[2] = 0.0;
    self->values[3] = 0.0;
    self->count = UINT64_C(0);
    self->fault = BESSEMER_STATUS_OK;
}

/** The measurements so far. */
static void values_that_borrow_store_held(const values_that_borrow_store_t *self,
    slice_f64_t *BESSEMER_RESTRICT result)
{
    const uint32_t result_end = (uint32_t)min_u64(self->count, UINT64_C(4));
    result->from = UINT64_C(0);
    result->length = result_end;
}

bessemer_status_t values_that_borrow_store_step(values_that_borrow_store_t *BESSEMER_RESTRICT self,
    double value, double *BESSEMER_RESTRICT most)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    if (self->count < UINT64_C(4)) {
        self->values[self->count] = value;
        self->count += UINT64_C(1);
    }
    double most_value = -(double)INFINITY;
    slice_f64_t slice;
    values_that_borrow_store_held(self, &slice);
    for (uint64_t i = slice.from; i < slice.from + slice.length; i++) {
        if (self->values[i] > most_value) {
            most_value = self->values[i];
        }
    }
    *most = most_value;
    return BESSEMER_STATUS_OK;
}

/* store.h */

/** Stores measurements. */
typedef struct {
    double values[4];
    uint64_t count;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} values_that_borrow_store_t;

/* values_that_borrow.c */

static double loop_respond(loop_t *self, double error);

void values_that_borrow_reader_new(const uint8_t rest[], uint64_t rest_length,
    values_that_borrow_reader_t *BESSEMER_RESTRICT reader)
{
    (void)rest;
    reader->rest.from = UINT64_C(0);
    reader->rest.length = rest_length;
    reader->last.from = UINT64_C(0);
    reader->last.length = UINT64_C(0);
}

bessemer_status_t values_that_borrow_reader_take(
    values_that_borrow_reader_t *BESSEMER_RESTRICT self, const uint8_t self_rest[],
    uint64_t self_rest_length, uint64_t count, option_slice_u8_t *BESSEMER_RESTRICT result)
{
    (void)self_rest;
    (void)self_rest_length;
    if (count > self->rest.length) {
        *result = (option_slice_u8_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
    const uint64_t rest_from = self->rest.from;
    if (rest_from > UINT64_MAX - count) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    const slice_u8_t rest_next = {.from = rest_from + count, .length = self->rest.length - count};
    self->rest = rest_next;
    self->last.from = rest_from;
    self->last.length = count;
    result->is_some = true;
    result->value.from = rest_from;
    result->value.length = count;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t values_that_borrow_reader_byte(
    values_that_borrow_reader_t *BESSEMER_RESTRICT self, const uint8_t self_rest[],
    uint64_t self_rest_length, option_u8_t *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    option_slice_u8_t byte;
    status = values_that_borrow_reader_take(self, self_rest, self_rest_length, UINT64_C(1), &byte);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    if (!byte.is_some) {
        *result = (option_u8_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
    if (byte.value.length == UINT64_C(0)) {
        return BESSEMER_STATUS_INDEX;
    }
    if (byte.value.from >= self_rest_length) {
        return BESSEMER_STATUS_INDEX;
    }
    result->is_some = true;
    result->value = self_rest[byte.value.from];
    return BESSEMER_STATUS_OK;
}

bessemer_status_t values_that_borrow_reader_word(
    values_that_borrow_reader_t *BESSEMER_RESTRICT self, const uint8_t self_rest[],
    uint64_t self_rest_length, option_u16_t *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    option_slice_u8_t option;
    status = values_that_borrow_reader_take(self, self_rest, self_rest_length, UINT64_C(2),
        &option);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    if (!option.is_some) {
        *result = (option_u16_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
    if (option.value.length == UINT64_C(2)) {
        if (option.value.from >= self_rest_length) {
            return BESSEMER_STATUS_INDEX;
        }
        if (option.value.from + UINT64_C(1) >= self_rest_length) {
            return BESSEMER_STATUS_INDEX;
        }
        result->is_some = true;
        result->value = (uint16_t)(((uint32_t)self_rest[option.value.from] << 8)
            | self_rest[option.value.from + UINT64_C(1)]);
        return BESSEMER_STATUS_OK;
    } else {
        *result = (option_u16_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
}

bessemer_status_t values_that_borrow_understood(const uint8_t packet[], uint64_t packet_length,
    option_result_values_that_borrow_packet_u8_t *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    values_that_borrow_reader_t reader;
    values_that_borrow_reader_new(packet, packet_length, &reader);
    option_u8_t kind_option;
    status = values_that_borrow_reader_byte(&reader, packet, packet_length, &kind_option);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    if (!kind_option.is_some) {
        *result = (option_result_values_that_borrow_packet_u8_t){.is_some = false};
        return BESSEMER_STATUS_OK;
    }
    const uint8_t kind = kind_option.value;
    result_values_that_borrow_packet_u8_t result_choice = {0};
    switch (kind) {
    case 1U: {
        option_u16_t option;
        status = values_that_borrow_reader_word(&reader, packet, packet_length, &option);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        if (!option.is_some) {
            *result = (option_result_values_that_borrow_packet_u8_t){.is_some = false};
            return BESSEMER_STATUS_OK;
        }
        result_choice.is_ok = true;
        result_choice.as.value.tag = VALUES_THAT_BORROW_PACKET_TAG_SET;
        result_choice.as.value.as.set = option.value;
        break;
    }
    case 2U: {
        option_u8_t address_option;
        status = values_that_borrow_reader_byte(&reader, packet, packet_length, &address_option);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        if (!address_option.is_some) {
            *result = (option_result_values_that_borrow_packet_u8_t){.is_some = false};
            return BESSEMER_STATUS_OK;
        }
        const uint8_t address = address_option.value;
        option_u8_t count_option;
        status = values_that_borrow_reader_byte(&reader, packet, packet_length, &count_option);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        if (!count_option.is_some) {
            *result = (option_result_values_that_borrow_packet_u8_t){.is_some = false};
            return BESSEMER_STATUS_OK;
        }
        const uint32_t count = (uint32_t)count_option.value;
        option_slice_u8_t reader_option;
        status = values_that_borrow_reader_take(&reader, packet, packet_length, count,
            &reader_option);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        if (!reader_option.is_some) {
            *result = (option_result_values_that_borrow_packet_u8_t){.is_some = false};
            return BESSEMER_STATUS_OK;
        }
        result_choice.is_ok = true;
        result_choice.as.value.tag = VALUES_THAT_BORROW_PACKET_TAG_LOAD;
        result_choice.as.value.as.load.address = address;
        result_choice.as.value.as.load.bytes = reader_option.value;
        break;
    }
    default: {
        const uint8_t other = kind;
        result_choice.is_ok = false;
        result_choice.as.error = other;
        break;
    }
    }
    result->is_some = true;
    result->value = result_choice;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t values_that_borrow_outcome(const uint8_t packet[8],
    uint32_t *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    option_result_values_that_borrow_packet_u8_t option = {0};
    status = values_that_borrow_understood(packet, UINT64_C(8), &option);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    if (!option.is_some) {
        *result = 1U;
        return BESSEMER_STATUS_OK;
    } else if (!option.value.is_ok) {
        *result = 1000U + (uint32_t)option.value.as.error;
        return BESSEMER_STATUS_OK;
    } else if (option.value.as.value.tag == VALUES_THAT_BORROW_PACKET_TAG_SET) {
        *result = 2000U + (uint32_t)option.value.as.value.as.set;
        return BESSEMER_STATUS_OK;
    } else {
        uint32_t sum = (uint32_t)option.value.as.value.as.load.address;
        for (uint64_t i = UINT64_C(0); i < option.value.as.value.as.load.bytes.length; i++) {
            if ((uint32_t)i > 0xFFFFFFFEU) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            if (option.value.as.value.as.load.bytes.from > UINT64_MAX - i) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            if (option.value.as.value.as.load.bytes.from + i >= UINT64_C(8)) {
                return BESSEMER_STATUS_INDEX;
            }
            const uint32_t sum_product = ((uint32_t)i + 1U)
                * (uint32_t)packet[option.value.as.value.as.load.bytes.from + i];
            if ((int64_t)sum + (int64_t)sum_product > (int64_t)UINT32_MAX) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            sum += sum_product;
        }
        *result = sum;
        return BESSEMER_STATUS_OK;
    }
}

bessemer_status_t values_that_borrow_outcome_behind(const uint8_t packets[12], uint64_t from,
    uint32_t *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    if (from > UINT64_C(12)) {
        return BESSEMER_STATUS_INDEX;
    }
    option_result_values_that_borrow_packet_u8_t option = {0};
    status = values_that_borrow_understood(&packets[from], UINT64_C(12) - from, &option);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    if (option.is_some) {
        if (option.value.is_ok) {
            if (option.value.as.value.tag == VALUES_THAT_BORROW_PACKET_TAG_LOAD) {
                if (option.value.as.value.as.load.bytes.from > UINT64_MAX - from) {
                    return BESSEMER_STATUS_OVERFLOW;
                }
                option.value.as.value.as.load.bytes.from += from;
            }
        }
    }
    if (option.is_some && (option.value.is_ok
            && option.value.as.value.tag == VALUES_THAT_BORROW_PACKET_TAG_LOAD)) {
        if (option.value.as.value.as.load.bytes.length > UINT64_C(0)) {
            if (option.value.as.value.as.load.bytes.from >= UINT64_C(12)) {
                return BESSEMER_STATUS_INDEX;
            }
            *result = (uint32_t)packets[option.value.as.value.as.load.bytes.from];
            return BESSEMER_STATUS_OK;
        } else {
            *result = 7U;
            return BESSEMER_STATUS_OK;
        }
    } else if (option.is_some && (option.value.is_ok
            && option.value.as.value.tag == VALUES_THAT_BORROW_PACKET_TAG_SET)) {
        *result = (uint32_t)option.value.as.value.as.set;
        return BESSEMER_STATUS_OK;
    } else {
        *result = 0U;
        return BESSEMER_STATUS_OK;
    }
}

void values_that_borrow_halves(const double values[], uint64_t values_length,
    pair_slice_f64_slice_f64_t *BESSEMER_RESTRICT result)
{
    (void)values;
    const uint64_t result_middle = values_length / UINT64_C(2);
    result->first.from = UINT64_C(0);
    result->first.length = result_middle;
    result->second.from = result_middle;
    result->second.length = values_length - result_middle;
}

bessemer_status_t values_that_borrow_above(const double values[], uint64_t values_length,
    double limit, slice_f64_t *BESSEMER_RESTRICT result)
{
    slice_f64_t values_left = {.from = UINT64_C(0), .length = values_length};
    for (uint32_t pass = 0U; pass <= 64U; pass++) {
        if (values_left.length <= UINT64_C(0)) {
            break;
        }
        if (pass >= 64U) {
            return BESSEMER_STATUS_BOUND;
        }
        if (values_left.from >= values_length) {
            return BESSEMER_STATUS_INDEX;
        }
        if (values[values_left.from] > limit) {
            break;
        }
        const slice_f64_t values_left_next = {
            .from = values_left.from + UINT64_C(1),
            .length = values_left.length - UINT64_C(1)
        };
        values_left = values_left_next;
    }
    for (uint32_t pass = 0U; pass <= 64U; pass++) {
        if (values_left.length <= UINT64_C(0)) {
            break;
        }
        if (pass >= 64U) {
            return BESSEMER_STATUS_BOUND;
        }
        if (values_left.from > UINT64_MAX - values_left.length) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        const uint64_t values_index = values_left.from + values_left.length - UINT64_C(1);
        if (values_index >= values_length) {
            return BESSEMER_STATUS_INDEX;
        }
        if (values[values_index] > limit) {
            break;
        }
        const slice_f64_t values_left_next = {
            .from = values_left.from,
            .length = values_left.length - UINT64_C(1)
        };
        values_left = values_left_next;
    }
    result->from = values_left.from;
    result->length = values_left.length;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t values_that_borrow_seen(const double values[6],
    pair_f64_usize_t *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    pair_slice_f64_slice_f64_t early_late;
    values_that_borrow_halves(values, UINT64_C(6), &early_late);
    slice_f64_t longer;
    if (early_late.second.length == UINT64_C(0)) {
        return BESSEMER_STATUS_INDEX;
    }
    if (early_late.second.from >= UINT64_C(6)) {
        return BESSEMER_STATUS_INDEX;
    }
    const double longer_left = values[early_late.second.from];
    if (early_late.first.length == UINT64_C(0)) {
        return BESSEMER_STATUS_INDEX;
    }
    if (longer_left > values[early_late.first.from]) {
        slice_f64_t slice;
        status = values_that_borrow_above(&values[early_late.second.from], early_late.second.length,
            0.5 * values[early_late.second.from], &slice);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        if (slice.from > UINT64_MAX - early_late.second.from) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        slice.from += early_late.second.from;
        longer = slice;
    } else {
        slice_f64_t slice;
        status = values_that_borrow_above(&values[early_late.first.from], early_late.first.length,
            0.0, &slice);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
        slice.from += early_late.first.from;
        longer = slice;
    }
    result->first = values[early_late.second.from];
    result->second = longer.length;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t writer_put(writer_t *BESSEMER_RESTRICT self,
    uint8_t self_buffer[BESSEMER_RESTRICT], uint64_t self_buffer_length, const uint8_t bytes[],
    uint64_t bytes_length, bool *BESSEMER_RESTRICT result)
{
    if (self->length > self->buffer.length) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    if (bytes_length > self->buffer.length - self->length) {
        *result = false;
        return BESSEMER_STATUS_OK;
    }
    for (uint64_t i = UINT64_C(0); i < bytes_length; i++) {
        const uint8_t buffer_operand = bytes[i];
        if (self->length >= self->buffer.length) {
            return BESSEMER_STATUS_INDEX;
        }
        if (self->buffer.from > UINT64_MAX - self->length) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        if (self->buffer.from + self->length >= self_buffer_length) {
            return BESSEMER_STATUS_INDEX;
        }
        self_buffer[self->buffer.from + self->length] = buffer_operand;
        self->length += UINT64_C(1);
    }
    *result = true;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t writer_finish(const writer_t *self, uint8_t self_buffer[BESSEMER_RESTRICT],
    uint64_t self_buffer_length, slice_u8_t *BESSEMER_RESTRICT result)
{
    (void)self_buffer;
    (void)self_buffer_length;
    if (self->length > self->buffer.length) {
        return BESSEMER_STATUS_INDEX;
    }
    result->from = self->buffer.from;
    result->length = self->length;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t values_that_borrow_answer(const uint8_t packet[4],
    uint8_t room[BESSEMER_RESTRICT 6], uint32_t *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    writer_t writer = {
        .buffer = {.from = UINT64_C(0), .length = UINT64_C(6)},
        .length = UINT64_C(0)
    };
    const uint8_t count = (uint8_t)(packet[0] % 8U);
    const uint8_t elements[2] = {count, 0U};
    bool well;
    status = writer_put(&writer, room, UINT64_C(6), elements, UINT64_C(2), &well);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    bool well_holds = false;
    if (well) {
        const uint32_t well_end = (uint32_t)min_u64((uint64_t)count, UINT64_C(4));
        status = writer_put(&writer, room, UINT64_C(6), packet, well_end, &well_holds);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
    }
    well = well_holds;
    bool well_holds_2 = false;
    if (well) {
        const uint8_t elements_2[1] = {packet[3]};
        status = writer_put(&writer, room, UINT64_C(6), elements_2, UINT64_C(1), &well_holds_2);
        if (status != BESSEMER_STATUS_OK) {
            return status;
        }
    }
    well = well_holds_2;
    slice_u8_t slice_u8;
    status = writer_finish(&writer, room, UINT64_C(6), &slice_u8);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    uint32_t sum = 0U;
    if (slice_u8.from > UINT64_MAX - slice_u8.length) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    for (uint64_t i = slice_u8.from; i < slice_u8.from + slice_u8.length; i++) {
        if (i >= UINT64_C(6)) {
            return BESSEMER_STATUS_INDEX;
        }
        if ((int64_t)sum + (int64_t)room[i] > (int64_t)UINT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        sum += (uint32_t)room[i];
    }
    if (well) {
        *result = sum;
        return BESSEMER_STATUS_OK;
    } else {
        if (sum > 0xFFFFFC17U) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        *result = 1000U + sum;
        return BESSEMER_STATUS_OK;
    }
}

static double loop_respond(loop_t *self, double error)
{
    self->sum += error;
    return self->gains.proportional * error + self->gains.integral * self->sum;
}

double values_that_borrow_cascade(const values_that_borrow_gains_t *outer,
    const values_that_borrow_gains_t *inner, double error)
{
    loop_t first = {.gains = *outer, .sum = 0.0};
    const values_that_borrow_gains_t before = first.gains;
    const double rate = loop_respond(&first, error);
    if (rate > 0.0) {
        first.gains = *inner;
    }
    const double result_respond = loop_respond(&first, rate);
    return result_respond + before.integral;
}

/* values_that_borrow.h */

/** Reads a packet from the front. */
typedef struct {
    slice_u8_t rest;
    /** The bytes that were read last. */
    slice_u8_t last;
} values_that_borrow_reader_t;

/** Which variant of `Packet`. */
typedef enum {
    /** A word. */
    VALUES_THAT_BORROW_PACKET_TAG_SET = 0,
    /** Bytes for an address. */
    VALUES_THAT_BORROW_PACKET_TAG_LOAD = 1
} values_that_borrow_packet_tag_t;

/** Fields of the variant Load of Packet. */
typedef struct {
    /** Destination address. */
    uint8_t address;
    /** The bytes. */
    slice_u8_t bytes;
} packet_load_t;

/** A parsed packet. */
typedef struct {
    /** Which variant it is. */
    values_that_borrow_packet_tag_t tag;
    /** What it holds. */
    union {
        /** A word. */
        uint16_t set;
        /** Bytes for an address. */
        packet_load_t load;
    } as;
} values_that_borrow_packet_t;

/** `Result<Packet, u8>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        values_that_borrow_packet_t value;
        /** Reason why there is no value. */
        uint8_t error;
    } as;
} result_values_that_borrow_packet_u8_t;

/** `Option<Result<Packet, u8>>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    result_values_that_borrow_packet_u8_t value;
} option_result_values_that_borrow_packet_u8_t;

/** Appends to a borrowed array. */
typedef struct {
    slice_mut_u8_t buffer;
    uint64_t length;
} writer_t;

/** The gains of an axis. */
typedef struct {
    /** Gain of the error. */
    double proportional;
    /** Gain of its integral. */
    double integral;
} values_that_borrow_gains_t;

/** A control loop with borrowed gains. */
typedef struct {
    values_that_borrow_gains_t gains;
    double sum;
} loop_t;
