/* The C of tests/corpus/src/programs/data/nested_equality.rs. Written by a test. */

/* nested_equality.c */

/** Whether the two are equal, part by part. */
static inline bool option_u16_equal(const option_u16_t *one, const option_u16_t *other)
{
    return one->is_some == other->is_some && (!one->is_some || one->value == other->value);
}

/** Whether the two are equal, part by part. */
static inline bool axis_wish_turn_equal(const axis_wish_turn_t *one, const axis_wish_turn_t *other)
{
    return one->to == other->to && option_u16_equal(&one->within, &other->within);
}

/** Whether the two are equal, part by part. */
static inline bool axis_wish_equal(const axis_wish_t *one, const axis_wish_t *other)
{
    return one->tag == other->tag && (one->tag != AXIS_WISH_TAG_HOLD
        || (one->as.hold[0] == other->as.hold[0] && one->as.hold[1] == other->as.hold[1]))
        && (one->tag != AXIS_WISH_TAG_TURN
        || axis_wish_turn_equal(&one->as.turn, &other->as.turn));
}

/** Whether the two are equal, part by part. */
static inline bool route_point_equal(const route_point_t *one, const route_point_t *other)
{
    return one->place[0] == other->place[0] && one->place[1] == other->place[1]
        && axis_wish_equal(&one->wish, &other->wish);
}

/** Whether the two are equal, part by part. */
static inline bool option_route_point_equal(const option_route_point_t *one,
    const option_route_point_t *other)
{
    return one->is_some == other->is_some
        && (!one->is_some || route_point_equal(&one->value, &other->value));
}

/** Whether the two are equal, part by part. */
static inline bool unit_quaternion_f64_equal(const unit_quaternion_f64_t *one,
    const unit_quaternion_f64_t *other)
{
    return (one->i == other->i && one->j == other->j && one->k == other->k && one->w == other->w)
        || (one->i == -other->i && one->j == -other->j && one->k == -other->k
        && one->w == -other->w);
}

/** Whether the two are equal, part by part. */
static inline bool route_equal(const route_t *one, const route_t *other)
{
    bool all_equal = true;
    for (uint32_t i = 0U; i < 3U; i++) {
        if (!route_point_equal(&one->points[i], &other->points[i])) {
            all_equal = false;
            break;
        }
    }
    return all_equal && option_route_point_equal(&one->home, &other->home)
        && unit_quaternion_f64_equal(&one->turned, &other->turned);
}

/** Whether the two are equal, part by part. */
static inline bool list3_axis_wish_equal(const list3_axis_wish_t *one,
    const list3_axis_wish_t *other)
{
    bool all_equal = false;
    bool all_holds = one->length == other->length;
    if (all_holds) {
        all_equal = true;
        {
            const uint32_t end = (uint32_t)min_u64(one->length, UINT64_C(3));
            for (uint32_t i = 0U; i < end; i++) {
                if (!axis_wish_equal(&one->items[i], &other->items[i])) {
                    all_equal = false;
                    break;
                }
            }
        }
        all_holds = all_equal;
    }
    return all_holds;
}

bool nested_equality_is_changed(const route_t *old, const route_t *new_)
{
    return !route_equal(old, new_);
}

uint32_t nested_equality_count(const route_t *route, const route_point_t *point)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < 3U; i++) {
        if (route_point_equal(&route->points[i], point)) {
            count += 1U;
        }
    }
    if (route->home.is_some && route_point_equal(&route->home.value, point)) {
        return count + 1U;
    } else {
        return count;
    }
}

bool nested_equality_same_lists(const list3_axis_wish_t *one, const list3_axis_wish_t *other)
{
    return list3_axis_wish_equal(one, other);
}

/* nested_equality.h */

/** Which variant of `AxisWish`. */
typedef enum {
    AXIS_WISH_TAG_REST = 0,
    AXIS_WISH_TAG_HOLD = 1,
    AXIS_WISH_TAG_TURN = 2
} axis_wish_tag_t;

/** What a `AxisWish::Turn` holds. */
typedef struct {
    float to;
    option_u16_t within;
} axis_wish_turn_t;

/** What an axis is asked to do. */
typedef struct {
    /** Which variant it is. */
    axis_wish_tag_t tag;
    /** What it holds. */
    union {
        float hold[2];
        axis_wish_turn_t turn;
    } as;
} axis_wish_t;

/** `List<AxisWish, 3>`: elements, and how many. */
typedef struct {
    /** How many elements there are. */
    uint64_t length;
    /** The elements; those behind the length mean nothing. */
    axis_wish_t items[3];
} list3_axis_wish_t;

/** A point on the way. */
typedef struct {
    float place[2];
    axis_wish_t wish;
} route_point_t;

/** `Option<RoutePoint>`: a value, or none. */
typedef struct {
    /** Whether there is a value. */
    bool is_some;
    /** The value, if there is one. */
    route_point_t value;
} option_route_point_t;

/** A way of three points. */
typedef struct {
    route_point_t points[3];
    option_route_point_t home;
    unit_quaternion_f64_t turned;
} route_t;
