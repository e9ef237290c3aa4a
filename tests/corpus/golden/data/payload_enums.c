/* The C of tests/corpus/src/programs/data/payload_enums.rs. Written by a test. */

/* payload_enums.c */

double payload_enums_speed(const command_t *command, double angle)
{
    switch (command->tag) {
    case COMMAND_TAG_COAST:
        return 0.0;
    case COMMAND_TAG_SPEED:
        return command->as.speed;
    case COMMAND_TAG_POSITION:
    default:
        return min_f64(max_f64(2.0 * (command->as.position.angle - angle),
            -command->as.position.limit), command->as.position.limit);
    }
}

void payload_enums_from_lever(double lever, command_t *command)
{
    if (fabs(lever) > 0.1) {
        command->tag = COMMAND_TAG_SPEED;
        command->as.speed = 10.0 * lever;
    } else {
        command->tag = COMMAND_TAG_COAST;
    }
}

void payload_enums_slower(command_t *command)
{
    switch (command->tag) {
    case COMMAND_TAG_SPEED:
        command->as.speed /= 2.0;
        break;
    case COMMAND_TAG_POSITION:
        command->as.position.limit /= 2.0;
        break;
    case COMMAND_TAG_COAST:
    default:
        break;
    }
}

/* payload_enums.h */

/** Fields of the variant Position of Command. */
typedef struct {
    /** Target angle, rad. */
    double angle;
    /** Largest speed, rad/s. */
    double limit;
} command_position_t;

/** Which variant of `Command`. */
typedef enum {
    /** No drive. */
    COMMAND_TAG_COAST = 0,
    /** Drive at a speed, rad/s. */
    COMMAND_TAG_SPEED = 1,
    /** Drive to a position. */
    COMMAND_TAG_POSITION = 2
} command_tag_t;

/** Commands of a motor. */
typedef struct {
    /** Which variant it is. */
    command_tag_t tag;
    /** What it holds. */
    union {
        /** Drive at a speed, rad/s. */
        double speed;
        /** Drive to a position. */
        command_position_t position;
    } as;
} command_t;
