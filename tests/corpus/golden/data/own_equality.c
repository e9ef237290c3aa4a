/* The C of tests/corpus/src/programs/data/own_equality.rs. Written by a test. */

/* own_equality.c */

static const float TAU = 6.2831855F;

static int8_t lever_direction(lever_t self);

bool bearing_eq(const bearing_t *self, const bearing_t *other)
{
    return own_equality_difference(self, other) < 0.001F;
}

float own_equality_difference(const bearing_t *one, const bearing_t *other)
{
    const float turn = TAU;
    const float apart = rem_euclid_f32(one->radians - other->radians, turn);
    return min_f32(apart, turn - apart);
}

bool lever_eq(lever_t self, lever_t other)
{
    return lever_direction(self) == lever_direction(other);
}

/** The sign of the speed. */
static int8_t lever_direction(lever_t self)
{
    switch (self) {
    case LEVER_PARKED:
    case LEVER_NEUTRAL:
        return 0;
    case LEVER_FORWARD:
        return 1;
    case LEVER_BACK:
    default:
        return -1;
    }
}

bool own_equality_is_new(const bearing_t *now, const bearing_t *before)
{
    return !bearing_eq(now, before);
}

bool own_equality_same_way(lever_t one, lever_t other)
{
    bool result = true;
    if (!lever_eq(one, other)) {
        const lever_t result_other = LEVER_NEUTRAL;
        bool result_2 = false;
        if (lever_eq(one, result_other)) {
            const lever_t result_other_2 = LEVER_BACK;
            result_2 = !lever_eq(other, result_other_2);
        }
        result = result_2;
    }
    return result;
}

bool own_equality_same_heading(const heading_t *one, const heading_t *other)
{
    return heading_equal(one, other);
}

void own_equality_place_of(const bearing_t bearings[3], const bearing_t *wanted,
    option_usize_t *BESSEMER_RESTRICT result)
{
    *result = (option_usize_t){.is_some = false};
    for (uint32_t i = 0U; i < 3U; i++) {
        if (bearing_eq(&bearings[i], wanted)) {
            result->is_some = true;
            result->value = i;
            break;
        }
    }
}

/* own_equality.h */

/** An angle, rad; angles that differ by whole turns are equal. */
typedef struct {
    /** Angle from north towards east. */
    float radians;
} bearing_t;

/** Positions of a lever; those that do not drive are equal. */
typedef enum {
    LEVER_PARKED = 0,
    LEVER_NEUTRAL = 1,
    LEVER_FORWARD = 2,
    LEVER_BACK = 3
} lever_t;

/** `Option<Lever>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    lever_t value;
} option_lever_t;

/** A part of a voyage, compared field by field by each field's own `==`. */
typedef struct {
    bearing_t to;
    lever_t lever;
    bearing_t turns[2];
    option_lever_t next;
} heading_t;
