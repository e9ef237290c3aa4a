/* The C of tests/corpus/src/programs/functions/own_names.rs. Written by a test. */

/* own_names.c */

static void own_names_bank_get_mut(own_names_bank_t *BESSEMER_RESTRICT self, uint8_t index,
    result_u8_own_names_missing_t *BESSEMER_RESTRICT result);
static void own_names_bank_first_mut(const own_names_bank_t *self,
    option_u8_t *BESSEMER_RESTRICT result);
static uint8_t own_names_bank_swap(own_names_bank_t *self, uint8_t by);
static uint8_t own_names_bank_sort(const own_names_bank_t *self);
static uint8_t own_names_bank_chunks(const own_names_bank_t *self, uint8_t size);
static bool own_names_bank_total_cmp(const own_names_bank_t *self, const own_names_bank_t *other);

static void own_names_bank_get_mut(own_names_bank_t *BESSEMER_RESTRICT self, uint8_t index,
    result_u8_own_names_missing_t *BESSEMER_RESTRICT result)
{
    if (index >= 4U) {
        result->is_ok = false;
        result->as.error.index = index;
        return;
    }
    const uint32_t cell = (uint32_t)index;
    self->cells[cell] = (uint8_t)((uint32_t)self->cells[cell] + 1U);
    result->is_ok = true;
    result->as.value = self->cells[cell];
}

static void own_names_bank_first_mut(const own_names_bank_t *self,
    option_u8_t *BESSEMER_RESTRICT result)
{
    const bool condition = self->cells[0] > 7U;
    const uint8_t value = self->cells[0];
    if (condition) {
        result->is_some = true;
        result->value = value;
    } else {
        *result = (option_u8_t){.is_some = false};
    }
}

static uint8_t own_names_bank_swap(own_names_bank_t *self, uint8_t by)
{
    self->cells[0] = (uint8_t)(self->cells[0] ^ by);
    return self->cells[0];
}

static uint8_t own_names_bank_sort(const own_names_bank_t *self)
{
    return self->cells[3];
}

static uint8_t own_names_bank_chunks(const own_names_bank_t *self, uint8_t size)
{
    return (uint8_t)((uint32_t)self->cells[1] * (uint32_t)size);
}

static bool own_names_bank_total_cmp(const own_names_bank_t *self, const own_names_bank_t *other)
{
    return self->cells[2] > other->cells[2];
}

void own_names_use_all(own_names_bank_t *BESSEMER_RESTRICT bank, uint8_t index,
    result_u8_own_names_missing_t *BESSEMER_RESTRICT result)
{
    result_u8_own_names_missing_t cell_outcome;
    own_names_bank_get_mut(bank, index, &cell_outcome);
    if (!cell_outcome.is_ok) {
        result->is_ok = false;
        result->as.error = cell_outcome.as.error;
        return;
    }
    const uint8_t cell = cell_outcome.as.value;
    const own_names_bank_t other = *bank;
    const uint8_t sum_swap = own_names_bank_swap(bank, 3U);
    uint8_t sum = (uint8_t)((uint32_t)cell + (uint32_t)sum_swap
        + (uint32_t)own_names_bank_sort(bank));
    if (own_names_bank_total_cmp(bank, &other)) {
        sum = (uint8_t)((uint32_t)sum + (uint32_t)own_names_bank_chunks(bank, 5U));
    }
    result->is_ok = true;
    result->as.value = sum;
}

void own_names_much(const own_names_bank_t *bank, option_u8_t *BESSEMER_RESTRICT result)
{
    option_u8_t first_option;
    own_names_bank_first_mut(bank, &first_option);
    if (!first_option.is_some) {
        *result = (option_u8_t){.is_some = false};
        return;
    }
    const uint8_t first = first_option.value;
    result->is_some = true;
    result->value = (uint8_t)((uint32_t)first + 1U);
}

uint8_t own_names_turn(double x_y[BESSEMER_RESTRICT 2], const pair_u8_f64_t *turns_by)
{
    uint8_t turns = turns_by->first;
    const double by = turns_by->second;
    const double kept = x_y[0];
    x_y[0] = x_y[1];
    x_y[1] = kept;
    x_y[1] = by - x_y[1];
    turns = (uint8_t)((uint32_t)turns + 1U);
    return turns;
}

bessemer_status_t own_names_taken(uint8_t ring[BESSEMER_RESTRICT 4], uint64_t at, uint8_t by,
    uint8_t *BESSEMER_RESTRICT result)
{
    if (at >= UINT64_C(4)) {
        return BESSEMER_STATUS_INDEX;
    }
    if (by == 0U) {
        return BESSEMER_STATUS_DIVISION_BY_ZERO;
    }
    const uint8_t value = (uint8_t)(200U / by);
    const uint8_t kept = ring[at];
    ring[at] = value;
    *result = kept;
    return BESSEMER_STATUS_OK;
}

void own_names_moved_on(uint8_t ring[BESSEMER_RESTRICT 4], uint8_t start,
    pair_u8_u8_t *BESSEMER_RESTRICT result)
{
    uint32_t at = (uint32_t)(uint8_t)(start % 3U);
    const uint32_t place_index = at;
    at += 1U;
    const uint8_t value = (uint8_t)(start / 2U);
    const uint8_t kept = ring[place_index];
    ring[place_index] = value;
    const uint8_t before = kept;
    result->first = before;
    result->second = ring[at];
}

/* own_names.h */

/** A bank of a few numbers. */
typedef struct {
    uint8_t cells[4];
} own_names_bank_t;

/** The error for a missing value. */
typedef struct {
    uint8_t index;
} own_names_missing_t;

/** `Result<u8, Missing>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        uint8_t value;
        /** Reason why there is no value. */
        own_names_missing_t error;
    } as;
} result_u8_own_names_missing_t;
