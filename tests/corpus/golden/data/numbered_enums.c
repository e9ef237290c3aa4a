/* The C of tests/corpus/src/programs/data/numbered_enums.rs. Written by a test. */

/* numbered_enums.c */

uint8_t numbered_enums_byte_of(numbered_enums_kind_t kind)
{
    return (uint8_t)kind;
}

void numbered_enums_kind_of(uint8_t byte, option_numbered_enums_kind_t *result)
{
    switch (byte) {
    case 1U:
        result->is_some = true;
        result->value = NUMBERED_ENUMS_KIND_HEARTBEAT;
        break;
    case 33U:
        result->is_some = true;
        result->value = NUMBERED_ENUMS_KIND_POSITION;
        break;
    case 34U:
        result->is_some = true;
        result->value = NUMBERED_ENUMS_KIND_ATTITUDE;
        break;
    case 128U:
        result->is_some = true;
        result->value = NUMBERED_ENUMS_KIND_COMMAND;
        break;
    default:
        result->is_some = false;
        result->value = NUMBERED_ENUMS_KIND_HEARTBEAT;
        break;
    }
}

uint32_t numbered_enums_length(numbered_enums_kind_t kind)
{
    switch (kind) {
    case NUMBERED_ENUMS_KIND_HEARTBEAT:
    case NUMBERED_ENUMS_KIND_NOTHING:
        return 0U;
    case NUMBERED_ENUMS_KIND_POSITION:
    case NUMBERED_ENUMS_KIND_ATTITUDE:
        return 12U;
    case NUMBERED_ENUMS_KIND_COMMAND:
    default:
        return 1U;
    }
}

bool numbered_enums_before(numbered_enums_kind_t first, numbered_enums_kind_t second)
{
    return (int32_t)first < (int32_t)second;
}

void numbered_enums_numbers(numbered_enums_kind_t kind, turn_t turn,
    tuple4_i8_i64_u16_usize_t *result)
{
    result->first = wrap_i8((uint8_t)kind);
    result->second = (int64_t)turn;
    result->third = (uint16_t)turn;
    result->fourth = (uint64_t)kind;
}

bessemer_status_t numbered_enums_sum(const numbered_enums_frame_t *frame,
    int32_t *BESSEMER_RESTRICT sum)
{
    int32_t sum_value;
    if (frame->answer.is_some) {
        sum_value = 1;
    } else {
        sum_value = 0;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        const turn_t turn = frame->turns[i];
        if ((int64_t)sum_value + (int64_t)turn < INT32_MIN
                || (int64_t)sum_value + (int64_t)turn > INT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        sum_value += (int32_t)turn;
    }
    *sum = sum_value;
    return BESSEMER_STATUS_OK;
}

void numbered_enums_silent(numbered_enums_kind_t kind, bool right, numbered_enums_frame_t *frame)
{
    turn_t turn;
    if (right) {
        turn = TURN_RIGHT;
    } else {
        turn = TURN_LEFT;
    }
    frame->kind = kind;
    frame->answer.is_some = false;
    frame->answer.value = NUMBERED_ENUMS_KIND_HEARTBEAT;
    frame->turns[0] = turn;
    frame->turns[1] = TURN_STRAIGHT;
}

/* numbered_enums.h */

/** Contents of a frame. */
typedef enum {
    /** The sender is alive. */
    NUMBERED_ENUMS_KIND_HEARTBEAT = 1,
    /** Position. */
    NUMBERED_ENUMS_KIND_POSITION = 33,
    /** Attitude; its number is one more than the previous. */
    NUMBERED_ENUMS_KIND_ATTITUDE = 34,
    /** A command, with a constant as its number. */
    NUMBERED_ENUMS_KIND_COMMAND = 128,
    /** Empty frame. */
    NUMBERED_ENUMS_KIND_NOTHING = 0
} numbered_enums_kind_t;

/** `Option<Kind>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    numbered_enums_kind_t value;
} option_numbered_enums_kind_t;

/** An enum with a negative number. */
typedef enum {
    /** To the left. */
    TURN_LEFT = -1,
    /** No turn. */
    TURN_STRAIGHT = 0,
    /** To the right. */
    TURN_RIGHT = 1
} turn_t;

/** A frame. */
typedef struct {
    /** Contents. */
    numbered_enums_kind_t kind;
    /** Kind of the expected answer, if any. */
    option_numbered_enums_kind_t answer;
    /** The next turns. */
    turn_t turns[2];
} numbered_enums_frame_t;

/* numbered_enums_statistics.c */

void statistics_init(statistics_t *self)
{
    self->last = NUMBERED_ENUMS_KIND_NOTHING;
    for (uint32_t i = 0U; i < 129U; i++) {
        self->counts[i] = 0U;
    }
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t statistics_count(statistics_t *BESSEMER_RESTRICT self, numbered_enums_kind_t kind,
    uint32_t *BESSEMER_RESTRICT result)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    switch (kind) {
    case NUMBERED_ENUMS_KIND_HEARTBEAT:
    case NUMBERED_ENUMS_KIND_POSITION:
    case NUMBERED_ENUMS_KIND_ATTITUDE:
    case NUMBERED_ENUMS_KIND_COMMAND:
    case NUMBERED_ENUMS_KIND_NOTHING:
        break;
    default:
        self->fault = BESSEMER_STATUS_VARIANT;
        return BESSEMER_STATUS_VARIANT;
    }
    self->last = kind;
    self->counts[(uint64_t)(kind == NUMBERED_ENUMS_KIND_HEARTBEAT || kind == NUMBERED_ENUMS_KIND_POSITION || kind == NUMBERED_ENUMS_KIND_ATTITUDE || kind == NUMBERED_ENUMS_KIND_COMMAND
        ? kind : NUMBERED_ENUMS_KIND_NOTHING)] += 1U;
    *result = self->counts[(uint64_t)(kind == NUMBERED_ENUMS_KIND_HEARTBEAT || kind == NUMBERED_ENUMS_KIND_POSITION || kind == NUMBERED_ENUMS_KIND_ATTITUDE || kind == NUMBERED_ENUMS_KIND_COMMAND
        ? kind : NUMBERED_ENUMS_KIND_NOTHING)];
    return BESSEMER_STATUS_OK;
}

/* numbered_enums_statistics.h */

/** Number of occurrences of each kind. */
typedef struct {
    numbered_enums_kind_t last;
    uint32_t counts[129];
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} statistics_t;
