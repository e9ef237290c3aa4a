/* The C of tests/corpus/src/programs/faults/atomic.rs. Written by a test. */

/* tanks.c */

void tanks_init(tanks_t *self)
{
    self->levels[0] = 0U;
    self->levels[1] = 0U;
    self->transfers = 0U;
}

bessemer_status_t tanks_transfer(tanks_t *BESSEMER_RESTRICT self, uint64_t to, uint8_t amount,
    uint8_t *BESSEMER_RESTRICT log, uint8_t *BESSEMER_RESTRICT result)
{
    tanks_t next = *self;
    uint8_t next_log = *log;
    if (next.transfers > 0xFFFFFFFEU) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    next.transfers += 1U;
    next_log = amount;
    if (to > UINT64_C(1)) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    if (amount > next.levels[UINT64_C(1) - to]) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    next.levels[UINT64_C(1) - to] = (uint8_t)(next.levels[UINT64_C(1) - to] - amount);
    if ((int64_t)next.levels[to] + (int64_t)amount > INT64_C(255)) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    next.levels[to] = (uint8_t)(next.levels[to] + amount);
    if (amount == 0U) {
        *self = next;
        *log = next_log;
        *result = 0U;
        return BESSEMER_STATUS_OK;
    }
    const uint8_t outcome = (uint8_t)(next.levels[to] / amount);
    *self = next;
    *log = next_log;
    *result = outcome;
    return BESSEMER_STATUS_OK;
}

/* tanks.h */

/** Transfers between two tanks. */
typedef struct {
    uint8_t levels[2];
    uint32_t transfers;
} tanks_t;
