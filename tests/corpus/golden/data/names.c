/* The C of tests/corpus/src/programs/data/names.rs. Written by a test. */

/* display.c */

void display_init(display_t *self)
{
    self->shown.name = NAME_NOTHING;
    self->shown.value = 0.0;
    self->reason.is_some = false;
    self->reason.value = 0U;
    self->mode = PROGRAMS_DATA_NAMES_MODE_IDLE;
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t display_show(display_t *BESSEMER_RESTRICT self, programs_data_names_mode_t mode,
    double value, bool *BESSEMER_RESTRICT result)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    if ((uint32_t)mode >= 3U) {
        self->fault = BESSEMER_STATUS_VARIANT;
        return BESSEMER_STATUS_VARIANT;
    }
    if (self->mode != mode) {
        signal_new(programs_data_names_mode_name(mode), &self->shown);
    }
    self->mode = mode;
    result_f64_str_t value_2;
    programs_data_names_positive(value, &value_2);
    if (value_2.is_ok) {
        self->shown.value = value_2.as.value;
    } else {
        self->reason.is_some = true;
        self->reason.value = value_2.as.error;
    }
    *result = self->shown.name == NAME_IDLE;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t display_reason(const display_t *self, uint32_t *BESSEMER_RESTRICT result)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    uint32_t result_value = NAME_EMPTY;
    if (self->reason.is_some) {
        result_value = self->reason.value;
    }
    *result = result_value;
    return BESSEMER_STATUS_OK;
}

/* display.h */

/** The state of a display. */
typedef struct {
    /** Signal on the display. */
    signal_t shown;
    /** Reason of the last fault. */
    option_str_t reason;
    /** The mode. */
    programs_data_names_mode_t mode;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} display_t;

/* programs_data_names.c */

static const uint32_t AXES[3] = {NAME_X, NAME_Y, NAME_Z};
static const uint32_t MACHINE = NAME_HYDRAULIC_PRESS;
static const signal_t SIGNALS[2] = {
    {.name = NAME_PUMP, .value = 1.0},
    {.name = NAME_VALVE, .value = 2.0}
};

void signal_new(uint32_t name, signal_t *signal)
{
    signal->name = name;
    signal->value = 0.0;
}

uint32_t programs_data_names_mode_name(programs_data_names_mode_t self)
{
    switch (self) {
    case PROGRAMS_DATA_NAMES_MODE_IDLE:
        return NAME_IDLE;
    case PROGRAMS_DATA_NAMES_MODE_PRESSING:
        return NAME_PRESSING_FORWARDS;
    case PROGRAMS_DATA_NAMES_MODE_STOPPED:
    default:
        return NAME_STOPPED_OVER_TEMPERATURE;
    }
}

void programs_data_names_mode_of(uint32_t name, option_names_mode_t *result)
{
    if (name == NAME_IDLE) {
        result->is_some = true;
        result->value = PROGRAMS_DATA_NAMES_MODE_IDLE;
    } else if (name == NAME_PRESSING_FORWARDS || name == NAME_PRESS) {
        result->is_some = true;
        result->value = PROGRAMS_DATA_NAMES_MODE_PRESSING;
    } else {
        *result = (option_names_mode_t){.is_some = false};
    }
}

void programs_data_names_positive(double value, result_f64_str_t *result)
{
    if (isnan(value) != 0) {
        result->is_ok = false;
        result->as.error = NAME_NOT_A_NUMBER;
        return;
    }
    if (value > 0.0) {
        result->is_ok = true;
        result->as.value = value;
    } else {
        result->is_ok = false;
        result->as.error = NAME_NOT_POSITIVE;
    }
}

uint32_t programs_data_names_axis(uint64_t index)
{
    return AXES[index % UINT64_C(3)];
}

void programs_data_names_value(uint64_t index, option_f64_t *result)
{
    uint32_t name;
    if (index % UINT64_C(2) == UINT64_C(0)) {
        name = NAME_PUMP;
    } else {
        name = NAME_MOTOR;
    }
    option_names_signal_t found = {.is_some = false};
    for (uint32_t i = 0U; i < 2U; i++) {
        if (SIGNALS[i].name == name) {
            found.is_some = true;
            found.value = SIGNALS[i];
            break;
        }
    }
    if (!found.is_some) {
        *result = (option_f64_t){.is_some = false};
        return;
    }
    result->is_some = true;
    result->value = found.value.value;
}

void programs_data_names_there_and_back(programs_data_names_mode_t mode,
    option_names_mode_t *result)
{
    programs_data_names_mode_of(programs_data_names_mode_name(mode), result);
}

void programs_data_names_same(uint32_t one, uint32_t other, bool result[4])
{
    const uint32_t local = NAME_C;
    result[0] = one == other;
    result[1] = one != other;
    result[2] = other == MACHINE;
    result[3] = local == one || other == NAME_EMPTY;
}

/* programs_data_names.h */

/** A signal of a display. */
typedef struct {
    /** The name on the display. */
    uint32_t name;
    /** Its value. */
    double value;
} signal_t;

/** `Option<Signal>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    signal_t value;
} option_names_signal_t;

/** Activity of the machine. */
typedef enum {
    /** Nothing. */
    PROGRAMS_DATA_NAMES_MODE_IDLE = 0,
    /** Pressing. */
    PROGRAMS_DATA_NAMES_MODE_PRESSING = 1,
    /** Stopped. */
    PROGRAMS_DATA_NAMES_MODE_STOPPED = 2
} programs_data_names_mode_t;

/** `Option<Mode>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    programs_data_names_mode_t value;
} option_names_mode_t;
