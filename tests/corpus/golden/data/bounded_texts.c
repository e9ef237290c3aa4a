/* The C of tests/corpus/src/programs/data/bounded_texts.rs. Written by a test. */

/* log_channel.c */

void log_channel_init(log_channel_t *self)
{
    self->name.length = UINT64_C(6);
    self->name.bytes[0] = 104U;
    self->name.bytes[1] = 101U;
    self->name.bytes[2] = 105U;
    self->name.bytes[3] = 103U;
    self->name.bytes[4] = 104U;
    self->name.bytes[5] = 116U;
    self->name.bytes[6] = 0U;
    self->name.bytes[7] = 0U;
    self->unit.length = UINT64_C(1);
    self->unit.bytes[0] = 109U;
    self->unit.bytes[1] = 0U;
    self->unit.bytes[2] = 0U;
    self->unit.bytes[3] = 0U;
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t log_channel_rename(log_channel_t *BESSEMER_RESTRICT self, const text_12_t *name)
{
    bessemer_status_t status;
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    text_8_clear(&self->name);
    uint8_t letters[12];
    text_12_bytes(name, letters);
    const uint64_t value_end = text_12_len(name);
    status = text_8_append(&self->name, letters, value_end);
    if (status != BESSEMER_STATUS_OK) {
        self->fault = status;
        return status;
    }
    return BESSEMER_STATUS_OK;
}

bessemer_status_t log_channel_number(log_channel_t *BESSEMER_RESTRICT self, uint8_t number,
    text_8_t *BESSEMER_RESTRICT text_8)
{
    bessemer_status_t status;
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    status = text_8_push(&self->name, (uint8_t)(48U + (uint8_t)(number % 10U)));
    if (status != BESSEMER_STATUS_OK) {
        self->fault = status;
        return status;
    }
    *text_8 = self->name;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t log_channel_is_length(log_channel_t *BESSEMER_RESTRICT self,
    bool *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    const uint8_t elements[1] = {109U};
    bool result_value = true;
    if (!text_4_is(&self->unit, elements, UINT64_C(1))) {
        const uint8_t elements_2[2] = {99U, 109U};
        text_4_t result_other;
        status = text_4_of(elements_2, UINT64_C(2), &result_other);
        if (status != BESSEMER_STATUS_OK) {
            self->fault = status;
            return status;
        }
        result_value = text_4_equal(&self->unit, &result_other);
    }
    *result = result_value;
    return BESSEMER_STATUS_OK;
}

/* log_channel.h */

/** A channel of the log. */
typedef struct {
    text_8_t name;
    text_4_t unit;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} log_channel_t;
