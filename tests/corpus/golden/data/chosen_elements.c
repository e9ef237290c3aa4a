/* The C of tests/corpus/src/programs/data/chosen_elements.rs. Written by a test. */

/* chosen_elements.c */

void transfers_of(transfers_t *BESSEMER_RESTRICT self, uint8_t id,
    option_element_mut_transfer_t *BESSEMER_RESTRICT result)
{
    *result = (option_element_mut_transfer_t){.is_some = false};
    for (uint32_t i = 0U; i < 6U; i++) {
        if (self->all[i].busy && self->all[i].id == id) {
            result->is_some = true;
            result->value.index = i;
            break;
        }
    }
}

void transfers_at(transfers_t *BESSEMER_RESTRICT self, uint64_t index,
    result_element_mut_transfer_u8_t *BESSEMER_RESTRICT result)
{
    (void)self;
    option_element_mut_transfer_t result_found = {.is_some = false};
    if (index < UINT64_C(6)) {
        result_found.is_some = true;
        result_found.value.index = index;
    }
    result->is_ok = false;
    result->as.error = 3U;
    if (result_found.is_some) {
        result->is_ok = true;
        result->as.value = result_found.value;
    }
}

void transfers_worst(transfers_t *BESSEMER_RESTRICT self,
    element_mut_transfer_t *BESSEMER_RESTRICT result)
{
    uint32_t at = 0U;
    for (uint32_t i = 1U; i < 6U; i++) {
        if (self->all[i].tries > self->all[at].tries) {
            at = i;
        }
    }
    if (self->all[at].tries < 3U) {
        result->index = UINT64_C(0);
        return;
    }
    result->index = at;
}

void transfers_busy(const transfers_t *self, transfer_t *BESSEMER_RESTRICT transfer)
{
    for (uint32_t i = 0U; i < 6U; i++) {
        if (self->all[i].busy) {
            *transfer = self->all[i];
            return;
        }
    }
    *transfer = self->all[0];
}

void transfers_begun(transfers_t *BESSEMER_RESTRICT self, uint8_t id,
    option_element_mut_transfer_t *BESSEMER_RESTRICT result)
{
    option_element_mut_transfer_t free = {.is_some = false};
    for (uint32_t i = 0U; i < 6U; i++) {
        if (!self->all[i].busy) {
            free.is_some = true;
            free.value.index = i;
            break;
        }
    }
    if (!free.is_some) {
        *result = (option_element_mut_transfer_t){.is_some = false};
        return;
    }
    self->all[free.value.index].busy = true;
    self->all[free.value.index].id = id;
    result->is_some = true;
    result->value.index = free.value.index;
}

bool chosen_elements_try_again(transfers_t *transfers, uint8_t id)
{
    option_element_mut_transfer_t transfer;
    transfers_of(transfers, id, &transfer);
    if (transfer.is_some) {
        transfers->all[transfer.value.index].tries = saturating_add_u16(
            transfers->all[transfer.value.index].tries, 1U);
        return true;
    } else {
        return false;
    }
}

uint16_t chosen_elements_begin(transfers_t *transfers, uint8_t id)
{
    option_element_mut_transfer_t begun;
    transfers_begun(transfers, id, &begun);
    if (begun.is_some) {
        transfers->all[begun.value.index].tries = 1U;
        return 0U;
    }
    option_element_mut_transfer_t least = {.is_some = false};
    option_u16_t least_2 = {.is_some = false};
    for (uint32_t i = 0U; i < 6U; i++) {
        const uint16_t key = transfers->all[i].tries;
        if (least_2.is_some) {
            if (key < least_2.value) {
                least_2.is_some = true;
                least_2.value = key;
                least.is_some = true;
                least.value.index = i;
            }
        } else {
            least_2.is_some = true;
            least_2.value = key;
            least.is_some = true;
            least.value.index = i;
        }
    }
    if (least.is_some) {
        transfers->all[least.value.index].id = id;
        return transfers->all[least.value.index].tries;
    } else {
        return 9U;
    }
}

uint16_t chosen_elements_give_up(transfers_t *transfers)
{
    element_mut_transfer_t transfer;
    transfers_worst(transfers, &transfer);
    transfers->all[transfer.index].busy = false;
    const uint16_t tries = transfers->all[transfer.index].tries;
    element_mut_transfer_t transfer_2;
    transfers_worst(transfers, &transfer_2);
    transfers->all[transfer_2.index].tries = 0U;
    return tries;
}

uint16_t chosen_elements_mark(transfers_t *transfers, uint8_t id)
{
    option_element_mut_transfer_t most = {.is_some = false};
    for (uint32_t i = 0U; i < 6U; i++) {
        bool value_holds = false;
        if (transfers->all[i].busy) {
            bool value_choice;
            if (most.is_some) {
                value_choice = transfers->all[i].tries >= transfers->all[most.value.index].tries;
            } else {
                value_choice = true;
            }
            value_holds = value_choice;
        }
        if (value_holds) {
            most.is_some = true;
            most.value.index = i;
        }
    }
    if (most.is_some) {
        transfers->all[most.value.index].id = id;
        return transfers->all[most.value.index].tries;
    } else {
        return 0U;
    }
}

void chosen_elements_first(const transfers_t *transfers, pair_u8_u16_t *BESSEMER_RESTRICT result)
{
    transfer_t transfer;
    transfers_busy(transfers, &transfer);
    transfer_t transfer_2;
    transfers_busy(transfers, &transfer_2);
    result->first = transfer.id;
    result->second = transfer_2.tries;
}

void chosen_elements_end(transfers_t *BESSEMER_RESTRICT transfers, uint64_t index,
    result_u16_u8_t *BESSEMER_RESTRICT result)
{
    result_element_mut_transfer_u8_t outcome;
    transfers_at(transfers, index, &outcome);
    if (!outcome.is_ok) {
        result->is_ok = false;
        result->as.error = outcome.as.error;
        return;
    }
    transfers->all[outcome.as.value.index].busy = false;
    result->is_ok = true;
    result->as.value = transfers->all[outcome.as.value.index].tries;
}

uint64_t chosen_elements_halve(float readings[5], float most)
{
    option_pair_usize_element_mut_f32_t next = {.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        const pair_usize_element_mut_f32_t it = {.first = i, .second = {.index = i}};
        if (readings[it.second.index] > most) {
            next.is_some = true;
            next.value.first = i;
            next.value.second.index = i;
            break;
        }
    }
    if (next.is_some) {
        readings[next.value.second.index] *= 0.5F;
        return next.value.first;
    }
    option_element_mut_f32_t last = {.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        if (readings[i] < 0.0F) {
            last.is_some = true;
            last.value.index = i;
        }
    }
    if (last.is_some) {
        readings[last.value.index] = 0.0F;
    }
    return UINT64_C(5);
}

int32_t chosen_elements_largest(const int32_t values[7])
{
    uint32_t best = 0U;
    for (uint32_t i = 1U; i < 7U; i++) {
        if (values[i] > values[best]) {
            best = i;
        }
    }
    return values[best];
}

bessemer_status_t chosen_elements_set(float readings[5], uint64_t index, float to)
{
    option_element_mut_f32_t value_found = {.is_some = false};
    if (index < UINT64_C(5)) {
        value_found.is_some = true;
        value_found.value.index = index;
    }
    if (!value_found.is_some) {
        return BESSEMER_STATUS_ABSENT;
    }
    readings[value_found.value.index] = to;
    option_element_mut_f32_t find = {.is_some = false};
    for (uint32_t i = 5U; i-- > 0U;) {
        if (readings[i] > to) {
            find.is_some = true;
            find.value.index = i;
            break;
        }
    }
    if (!find.is_some) {
        return BESSEMER_STATUS_ABSENT;
    }
    readings[find.value.index] = to;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t chosen_elements_frame_put(chosen_elements_frame_t *BESSEMER_RESTRICT self,
    uint8_t byte, result_element_mut_chosen_elements_frame_u8_t *BESSEMER_RESTRICT result)
{
    const uint32_t value_index = (uint32_t)self->length;
    if (value_index < 5U) {
        self->bytes[value_index] = byte;
    } else {
        result->is_ok = false;
        result->as.error = self->length;
        return BESSEMER_STATUS_OK;
    }
    if (self->length > 254U) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    self->length = (uint8_t)(self->length + 1U);
    result->is_ok = true;
    result->as.value.index = UINT64_C(0);
    return BESSEMER_STATUS_OK;
}

bessemer_status_t chosen_elements_frame_put_word(chosen_elements_frame_t *BESSEMER_RESTRICT self,
    uint16_t word, result_element_mut_chosen_elements_frame_u8_t *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    const uint8_t elements[2] = {(uint8_t)(word >> 8U), (uint8_t)word};
    result_element_mut_chosen_elements_frame_u8_t outcome;
    status = chosen_elements_frame_put(self, elements[0], &outcome);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    if (!outcome.is_ok) {
        result->is_ok = false;
        result->as.error = outcome.as.error;
        return BESSEMER_STATUS_OK;
    }
    status = chosen_elements_frame_put(self, elements[1], result);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    return BESSEMER_STATUS_OK;
}

bessemer_status_t chosen_elements_framed(chosen_elements_frame_t *BESSEMER_RESTRICT frame,
    uint8_t command, uint16_t argument, result_u8_u8_t *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    result_element_mut_chosen_elements_frame_u8_t outcome;
    status = chosen_elements_frame_put(frame, command, &outcome);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    if (!outcome.is_ok) {
        result->is_ok = false;
        result->as.error = outcome.as.error;
        return BESSEMER_STATUS_OK;
    }
    result_element_mut_chosen_elements_frame_u8_t frame_outcome;
    status = chosen_elements_frame_put_word(frame, argument, &frame_outcome);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    if (!frame_outcome.is_ok) {
        result->is_ok = false;
        result->as.error = frame_outcome.as.error;
        return BESSEMER_STATUS_OK;
    }
    frame->bytes[0] = (uint8_t)(frame->bytes[0] | 0x80U);
    result->is_ok = true;
    result->as.value = frame->length;
    return BESSEMER_STATUS_OK;
}

/* chosen_elements.h */

/** A pending transfer. */
typedef struct {
    /** Identifies the transfer. */
    uint8_t id;
    /** True if the transfer is in progress. */
    bool busy;
    /** Number of attempts. */
    uint16_t tries;
} transfer_t;

/** All transfers. */
typedef struct {
    /** The transfers, in no particular order. */
    transfer_t all[6];
} transfers_t;

/** A transmitted frame, byte by byte. */
typedef struct {
    /** The bytes. */
    uint8_t bytes[5];
    /** Number of bytes. */
    uint8_t length;
} chosen_elements_frame_t;
