/* The C of tests/corpus/src/programs/data/nested_equality.rs. Written by a test. */

/* nested_equality.c */

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

/** Fields of the variant Turn of AxisWish. */
typedef struct {
    float to;
    option_u16_t within;
} axis_wish_turn_t;

/** Commands of an axis. */
typedef struct {
    /** Which variant it is. */
    axis_wish_tag_t tag;
    /** What it holds. */
    union {
        float hold[2];
        axis_wish_turn_t turn;
    } as;
} axis_wish_t;

/** `List<AxisWish, 3>`: elements and their number. */
typedef struct {
    /** Number of elements. */
    uint64_t length;
    /** The elements; those behind the length mean nothing. */
    axis_wish_t items[3];
} list3_axis_wish_t;

/** A point of a route. */
typedef struct {
    float place[2];
    axis_wish_t wish;
} route_point_t;

/** `Option<RoutePoint>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    route_point_t value;
} option_route_point_t;

/** A route of three points. */
typedef struct {
    route_point_t points[3];
    option_route_point_t home;
    unit_quaternion_f64_t turned;
} route_t;
