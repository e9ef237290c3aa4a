/* The C of tests/corpus/src/programs/functions/phantom_types.rs. Written by a test. */

/* phantom_types.c */

static const drive_idle_t DRIVE_DEFAULT = {.value = 0.0};

void quantity_metres_new(double value, quantity_metres_t *quantity_metres)
{
    quantity_metres->value = value;
}

void quantity_seconds_new(double value, quantity_seconds_t *quantity_seconds)
{
    quantity_seconds->value = value;
}

void quantity_metres_plus(const quantity_metres_t *self, const quantity_metres_t *other,
    quantity_metres_t *BESSEMER_RESTRICT quantity_metres)
{
    quantity_metres->value = self->value + other->value;
}

double phantom_types_pace(double there, double back, double time)
{
    quantity_metres_t way_self;
    quantity_metres_new(there, &way_self);
    quantity_metres_t way_other;
    quantity_metres_new(back, &way_other);
    quantity_metres_t way;
    quantity_metres_plus(&way_self, &way_other, &way);
    quantity_seconds_t time_2;
    quantity_seconds_new(time, &time_2);
    return way.value / time_2.value;
}

void drive_idle_arm(const drive_idle_t *self, double speed,
    drive_armed_t *BESSEMER_RESTRICT drive_armed)
{
    const double before = self->value;
    drive_armed->value = before + speed;
}

double drive_armed_turn(drive_armed_t *self, double by)
{
    self->value += by;
    return self->value;
}

double phantom_types_started(double speed, double by)
{
    drive_armed_t drive;
    drive_idle_arm(&DRIVE_DEFAULT, speed, &drive);
    const double result_turn = drive_armed_turn(&drive, by);
    const double result_turn_2 = drive_armed_turn(&drive, -by);
    return result_turn * result_turn_2;
}

/* phantom_types.h */

/** A number with its unit. */
typedef struct {
    double value;
} quantity_metres_t;

/** A number with its unit. */
typedef struct {
    double value;
} quantity_seconds_t;

/** A drive that turns only if it is armed. */
typedef struct {
    double value;
} drive_armed_t;

/** A drive that turns only if it is armed. */
typedef struct {
    double value;
} drive_idle_t;
