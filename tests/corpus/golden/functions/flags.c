/* The C of tests/corpus/src/programs/functions/flags.rs. Written by a test. */

/* flags.c */

static const faults_t FAULTS_RANGE = {.value = 4U};
static const faults_t FAULTS_SILENT = {.value = 1U};
static const faults_t FAULTS_STUCK = {.value = 2U};

bool faults_contains(const faults_t *self, const faults_t *others)
{
    faults_t faults;
    faults_bitand(self, others, &faults);
    return faults.value == others->value;
}

void faults_set(faults_t *BESSEMER_RESTRICT self, const faults_t *others, bool there)
{
    if (there) {
        faults_bitor_assign(self, others);
    } else {
        faults_t other;
        faults_not(others, &other);
        faults_bitand_assign(self, &other);
    }
}

void faults_bitor(const faults_t *self, const faults_t *other, faults_t *BESSEMER_RESTRICT faults)
{
    faults->value = (uint16_t)(self->value | other->value);
}

void faults_bitand(const faults_t *self, const faults_t *other, faults_t *BESSEMER_RESTRICT faults)
{
    faults->value = (uint16_t)(self->value & other->value);
}

void faults_bitxor(const faults_t *self, const faults_t *other, faults_t *BESSEMER_RESTRICT faults)
{
    faults->value = (uint16_t)(self->value ^ other->value);
}

void faults_not(const faults_t *self, faults_t *BESSEMER_RESTRICT faults)
{
    faults->value = (uint16_t)~self->value;
}

void faults_bitor_assign(faults_t *BESSEMER_RESTRICT self, const faults_t *other)
{
    self->value = (uint16_t)(self->value | other->value);
}

void faults_bitand_assign(faults_t *BESSEMER_RESTRICT self, const faults_t *other)
{
    self->value = (uint16_t)(self->value & other->value);
}

bessemer_status_t faults_shl_u32(const faults_t *self, uint32_t places,
    faults_t *BESSEMER_RESTRICT faults)
{
    if (places >= 16U) {
        return BESSEMER_STATUS_SHIFT;
    }
    faults->value = (uint16_t)((uint32_t)self->value << places);
    return BESSEMER_STATUS_OK;
}

bessemer_status_t faults_shr_assign_u32(faults_t *self, uint32_t places)
{
    if (places >= 16U) {
        return BESSEMER_STATUS_SHIFT;
    }
    self->value = (uint16_t)(self->value >> places);
    return BESSEMER_STATUS_OK;
}

bessemer_status_t angle_rem(const angle_t *self, const angle_t *part,
    angle_t *BESSEMER_RESTRICT angle)
{
    if (part->value == 0) {
        return BESSEMER_STATUS_DIVISION_BY_ZERO;
    }
    if (self->value == INT32_MIN && part->value == -1) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    angle->value = self->value % part->value;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t angle_rem_assign_i32(angle_t *self, int32_t part)
{
    if (part == 0) {
        return BESSEMER_STATUS_DIVISION_BY_ZERO;
    }
    if (self->value == INT32_MIN && part == -1) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    self->value = self->value % part;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t flags_changed(const faults_t *before, const faults_t *now, const faults_t *asked,
    faults_t *BESSEMER_RESTRICT faults)
{
    bessemer_status_t status;
    faults_t quiet;
    faults_not(asked, &quiet);
    faults_t changes_self;
    faults_bitxor(before, now, &changes_self);
    faults_t changes_other;
    faults_not(&quiet, &changes_other);
    faults_t changes;
    faults_bitand(&changes_self, &changes_other, &changes);
    faults_t faults_other;
    status = faults_shl_u32(&changes, 3U, &faults_other);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    faults_bitor(&changes, &faults_other, faults);
    return BESSEMER_STATUS_OK;
}

bessemer_status_t flags_second(const faults_t *all, bool silent, faults_t *BESSEMER_RESTRICT faults)
{
    bessemer_status_t status;
    faults_t faults_value = *all;
    status = faults_shr_assign_u32(&faults_value, 3U);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    faults_t others;
    faults_bitor(&FAULTS_SILENT, &FAULTS_STUCK, &others);
    faults_set(&faults_value, &others, silent);
    const bool contains = faults_contains(&faults_value, &FAULTS_RANGE);
    if (!contains && !silent) {
        *faults = faults_value;
        return BESSEMER_STATUS_OK;
    } else {
        faults_bitor(&faults_value, &FAULTS_RANGE, faults);
        return BESSEMER_STATUS_OK;
    }
}

bessemer_status_t flags_within(const angle_t *angle, const angle_t *sector,
    angle_t *BESSEMER_RESTRICT rest)
{
    bessemer_status_t status;
    angle_t rest_value;
    status = angle_rem(angle, sector, &rest_value);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    status = angle_rem_assign_i32(&rest_value, 512);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    *rest = rest_value;
    return BESSEMER_STATUS_OK;
}

uint32_t flags_mixed(uint16_t word, uint8_t places)
{
    uint32_t sum = 0U;
    for (uint8_t place = 0U; place < 4U; place++) {
        sum ^= (uint32_t)(uint16_t)(((uint16_t)~word >> place) & 0xFU) << (uint8_t)(places % 8U);
        sum |= (uint32_t)1U << place;
    }
    return ~sum % 1000U;
}

/* flags.h */

/** Faults of a sensor, one bit each. */
typedef struct {
    uint16_t value;
} faults_t;

/** An angle in units of 1/65536 turn. */
typedef struct {
    int32_t value;
} angle_t;
