/* The C of tests/corpus/src/programs/faults/order.rs. Written by a test. */

/* ring.c */

void programs_faults_order_ring_init(programs_faults_order_ring_t *self)
{
    self->values[0] = 0.0F;
    self->values[1] = 0.0F;
    self->values[2] = 0.0F;
    self->values[3] = 0.0F;
    self->next = UINT64_C(0);
    self->taken = 0U;
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t programs_faults_order_ring_take(
    programs_faults_order_ring_t *BESSEMER_RESTRICT self, float value, uint64_t skip,
    uint8_t *BESSEMER_RESTRICT result)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    if (self->taken > 254U) {
        self->fault = BESSEMER_STATUS_OVERFLOW;
        return BESSEMER_STATUS_OVERFLOW;
    }
    self->taken = (uint8_t)(self->taken + 1U);
    if (self->next > UINT64_MAX - skip) {
        self->fault = BESSEMER_STATUS_OVERFLOW;
        return BESSEMER_STATUS_OVERFLOW;
    }
    if (self->next + skip >= UINT64_C(4)) {
        self->fault = BESSEMER_STATUS_INDEX;
        return BESSEMER_STATUS_INDEX;
    }
    self->values[self->next + skip] = value;
    self->next = (self->next + skip + UINT64_C(1)) % UINT64_C(4);
    *result = self->taken;
    return BESSEMER_STATUS_OK;
}

/* ring.h */

/** A ring buffer of measurements. */
typedef struct {
    float values[4];
    uint64_t next;
    uint8_t taken;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} programs_faults_order_ring_t;
