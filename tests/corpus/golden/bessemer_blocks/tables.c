/* The C of blocks/src/tables.rs. Written by a test. */

/* tables.c */

static void axis_f32_10_between(const axis_f32_10_t *self, uint32_t below, float value,
    beyond_t beyond, place_f32_t *BESSEMER_RESTRICT place);
static void axis_f32_3_between(const axis_f32_3_t *self, uint32_t below, float value,
    beyond_t beyond, place_f32_t *BESSEMER_RESTRICT place);
static void axis_f64_5_between(const axis_f64_5_t *self, uint32_t below, double value,
    beyond_t beyond, place_f64_t *BESSEMER_RESTRICT place);
static float tables_limited_f32(float share, beyond_t beyond);
static double tables_limited_f64(double share, beyond_t beyond);

bool tables_ascends_f64_5(const double axis[5])
{
    bool ascends = true;
    for (uint32_t k = 1U; k < 5U; k++) {
        ascends = ascends && axis[k] > axis[k - 1U];
    }
    return ascends;
}

void uniform_axis_f32_3_place(const uniform_axis_f32_3_t *self, float value, beyond_t beyond,
    place_f32_t *BESSEMER_RESTRICT place)
{
    const float at = (value - self->first) / self->spacing;
    const float whole = floorf(min_f32(max_f32(at, 0.0F), 3.0F - 2.0F));
    const uint32_t below = u32_from_f32(whole);
    place->below = min_u32(below, 3U - 2U);
    place->share = tables_limited_f32(at - whole, beyond);
}

void uniform_axis_f64_4_place(const uniform_axis_f64_4_t *self, double value, beyond_t beyond,
    place_f64_t *BESSEMER_RESTRICT place)
{
    const double at = (value - self->first) / self->spacing;
    const double whole = floor(min_f64(max_f64(at, 0.0), 4.0 - 2.0));
    const uint32_t below = u32_from_f64(whole);
    place->below = min_u32(below, 4U - 2U);
    place->share = tables_limited_f64(at - whole, beyond);
}

void axis_f32_10_place(const axis_f32_10_t *self, float value, beyond_t beyond,
    place_f32_t *BESSEMER_RESTRICT place)
{
    uint32_t below = 0U;
    for (uint32_t k = 1U; k < 10U - 1U; k++) {
        if (value >= self->points[k]) {
            below = k;
        } else {
            break;
        }
    }
    axis_f32_10_between(self, below, value, beyond, place);
}

void axis_f32_3_place(const axis_f32_3_t *self, float value, beyond_t beyond,
    place_f32_t *BESSEMER_RESTRICT place)
{
    uint32_t below = 0U;
    for (uint32_t k = 1U; k < 3U - 1U; k++) {
        if (value >= self->points[k]) {
            below = k;
        } else {
            break;
        }
    }
    axis_f32_3_between(self, below, value, beyond, place);
}

void axis_f32_4_place(const axis_f32_4_t *self, float value, beyond_t beyond,
    place_f32_t *BESSEMER_RESTRICT place)
{
    uint32_t below = 0U;
    for (uint32_t k = 1U; k < 4U - 1U; k++) {
        if (value >= self->points[k]) {
            below = k;
        } else {
            break;
        }
    }
    axis_f32_4_between(self, below, value, beyond, place);
}

void axis_f64_5_place(const axis_f64_5_t *self, double value, beyond_t beyond,
    place_f64_t *BESSEMER_RESTRICT place)
{
    uint32_t below = 0U;
    for (uint32_t k = 1U; k < 5U - 1U; k++) {
        if (value >= self->points[k]) {
            below = k;
        } else {
            break;
        }
    }
    axis_f64_5_between(self, below, value, beyond, place);
}

/** Returns the position of a value from the point below it. */
static void axis_f32_10_between(const axis_f32_10_t *self, uint32_t below, float value,
    beyond_t beyond, place_f32_t *BESSEMER_RESTRICT place)
{
    const uint32_t below_2 = min_u32(below, 10U - 2U);
    const float low = self->points[below_2];
    const float high = self->points[below_2 + 1U];
    place->below = below_2;
    place->share = tables_limited_f32((value - low) / (high - low), beyond);
}

/** Returns the position of a value from the point below it. */
static void axis_f32_3_between(const axis_f32_3_t *self, uint32_t below, float value,
    beyond_t beyond, place_f32_t *BESSEMER_RESTRICT place)
{
    const uint32_t below_2 = min_u32(below, 3U - 2U);
    const float low = self->points[below_2];
    const float high = self->points[below_2 + 1U];
    place->below = below_2;
    place->share = tables_limited_f32((value - low) / (high - low), beyond);
}

void axis_f32_4_between(const axis_f32_4_t *self, uint32_t below, float value, beyond_t beyond,
    place_f32_t *BESSEMER_RESTRICT place)
{
    const uint32_t below_2 = min_u32(below, 4U - 2U);
    const float low = self->points[below_2];
    const float high = self->points[below_2 + 1U];
    place->below = below_2;
    place->share = tables_limited_f32((value - low) / (high - low), beyond);
}

/** Returns the position of a value from the point below it. */
static void axis_f64_5_between(const axis_f64_5_t *self, uint32_t below, double value,
    beyond_t beyond, place_f64_t *BESSEMER_RESTRICT place)
{
    const uint32_t below_2 = min_u32(below, 5U - 2U);
    const double low = self->points[below_2];
    const double high = self->points[below_2 + 1U];
    place->below = below_2;
    place->share = tables_limited_f64((value - low) / (high - low), beyond);
}

float tables_interpolated_f32_10(const float values[10], const place_f32_t *place)
{
    const uint32_t below = min_u32(place->below, 10U - 2U);
    const float low = values[below];
    const float high = values[below + 1U];
    return low + place->share * (high - low);
}

float tables_interpolated_f32_3(const float values[3], const place_f32_t *place)
{
    const uint32_t below = min_u32(place->below, 3U - 2U);
    const float low = values[below];
    const float high = values[below + 1U];
    return low + place->share * (high - low);
}

float tables_interpolated_f32_4(const float values[4], const place_f32_t *place)
{
    const uint32_t below = min_u32(place->below, 4U - 2U);
    const float low = values[below];
    const float high = values[below + 1U];
    return low + place->share * (high - low);
}

double tables_interpolated_f64_4(const double values[4], const place_f64_t *place)
{
    const uint32_t below = min_u32(place->below, 4U - 2U);
    const double low = values[below];
    const double high = values[below + 1U];
    return low + place->share * (high - low);
}

double tables_interpolated_f64_5(const double values[5], const place_f64_t *place)
{
    const uint32_t below = min_u32(place->below, 5U - 2U);
    const double low = values[below];
    const double high = values[below + 1U];
    return low + place->share * (high - low);
}

float tables_interpolated_2d_f32_4_3(const float values[4][3], const place_f32_t *row,
    const place_f32_t *column)
{
    const uint32_t below = min_u32(row->below, 4U - 2U);
    const float low = tables_interpolated_f32_3(values[below], column);
    const float high = tables_interpolated_f32_3(values[below + 1U], column);
    return low + row->share * (high - low);
}

/** Limits the fraction of a position; NaN becomes 0. */
static float tables_limited_f32(float share, beyond_t beyond)
{
    switch (beyond) {
    case BEYOND_HOLD:
        return min_f32(max_f32(share, 0.0F), 1.0F);
    case BEYOND_EXTEND:
    default:
        if (isnan(share) != 0) {
            return 0.0F;
        } else {
            return share;
        }
        break;
    }
}

/** Limits the fraction of a position; NaN becomes 0. */
static double tables_limited_f64(double share, beyond_t beyond)
{
    switch (beyond) {
    case BEYOND_HOLD:
        return min_f64(max_f64(share, 0.0), 1.0);
    case BEYOND_EXTEND:
    default:
        if (isnan(share) != 0) {
            return 0.0;
        } else {
            return share;
        }
        break;
    }
}

/* tables.h */

/** Values beyond the ends of an axis. */
typedef enum {
    /** The value of the end. */
    BEYOND_HOLD = 0,
    /** The line through the two points at the end, extended. */
    BEYOND_EXTEND = 1
} beyond_t;

/** Position on an axis, between the points `below` and `below + 1`. */
typedef struct {
    /** Index of the lower point. */
    uint32_t below;
    /**
     * Fraction of the distance: 0 at the lower point, 1 at the upper one; less or more beyond the ends.
     */
    float share;
} place_f32_t;

/** Position on an axis, between the points `below` and `below + 1`. */
typedef struct {
    /** Index of the lower point. */
    uint32_t below;
    /**
     * Fraction of the distance: 0 at the lower point, 1 at the upper one; less or more beyond the ends.
     */
    double share;
} place_f64_t;

/**
 * Axis of `N` points with equal spacing: a position in constant time.
 *
 * ```
 * use bessemer_blocks::{Beyond, UniformAxis, interpolated};
 *
 * let axis = UniformAxis::<f32, 3> { first: 10.0, spacing: 5.0 };
 * let table = [0.0, 1.0, 4.0];
 * assert_eq!(interpolated(&table, axis.place(17.5, Beyond::Hold)), 2.5);
 * assert_eq!(interpolated(&table, axis.place(25.0, Beyond::Hold)), 4.0);
 * assert_eq!(interpolated(&table, axis.place(25.0, Beyond::Extend)), 7.0);
 * ```
 */
typedef struct {
    /** The first point. */
    float first;
    /** Distance of the points, above 0. */
    float spacing;
} uniform_axis_f32_3_t;

/**
 * Axis of `N` points with equal spacing: a position in constant time.
 *
 * ```
 * use bessemer_blocks::{Beyond, UniformAxis, interpolated};
 *
 * let axis = UniformAxis::<f32, 3> { first: 10.0, spacing: 5.0 };
 * let table = [0.0, 1.0, 4.0];
 * assert_eq!(interpolated(&table, axis.place(17.5, Beyond::Hold)), 2.5);
 * assert_eq!(interpolated(&table, axis.place(25.0, Beyond::Hold)), 4.0);
 * assert_eq!(interpolated(&table, axis.place(25.0, Beyond::Extend)), 7.0);
 * ```
 */
typedef struct {
    /** The first point. */
    double first;
    /** Distance of the points, above 0. */
    double spacing;
} uniform_axis_f64_4_t;

/**
 * Axis of `N` points at any distances: a position by search.
 *
 * ```
 * use bessemer_blocks::{Axis, Beyond, interpolated};
 *
 * const AXIS: Axis<f64, 4> = Axis { points: [0.0, 1.0, 4.0, 9.0] };
 * assert_eq!(interpolated(&[0.0, 1.0, 2.0, 3.0], AXIS.place(2.5, Beyond::Hold)), 1.5);
 * ```
 */
typedef struct {
    /** The points, strictly ascending. */
    float points[10];
} axis_f32_10_t;

/**
 * Axis of `N` points at any distances: a position by search.
 *
 * ```
 * use bessemer_blocks::{Axis, Beyond, interpolated};
 *
 * const AXIS: Axis<f64, 4> = Axis { points: [0.0, 1.0, 4.0, 9.0] };
 * assert_eq!(interpolated(&[0.0, 1.0, 2.0, 3.0], AXIS.place(2.5, Beyond::Hold)), 1.5);
 * ```
 */
typedef struct {
    /** The points, strictly ascending. */
    float points[3];
} axis_f32_3_t;

/**
 * Axis of `N` points at any distances: a position by search.
 *
 * ```
 * use bessemer_blocks::{Axis, Beyond, interpolated};
 *
 * const AXIS: Axis<f64, 4> = Axis { points: [0.0, 1.0, 4.0, 9.0] };
 * assert_eq!(interpolated(&[0.0, 1.0, 2.0, 3.0], AXIS.place(2.5, Beyond::Hold)), 1.5);
 * ```
 */
typedef struct {
    /** The points, strictly ascending. */
    float points[4];
} axis_f32_4_t;

/**
 * Axis of `N` points at any distances: a position by search.
 *
 * ```
 * use bessemer_blocks::{Axis, Beyond, interpolated};
 *
 * const AXIS: Axis<f64, 4> = Axis { points: [0.0, 1.0, 4.0, 9.0] };
 * assert_eq!(interpolated(&[0.0, 1.0, 2.0, 3.0], AXIS.place(2.5, Beyond::Hold)), 1.5);
 * ```
 */
typedef struct {
    /** The points, strictly ascending. */
    double points[5];
} axis_f64_5_t;

/* tables_search.c */

void tables_search_init(tables_search_t *self)
{
    self->below = 0U;
}

void tables_search_place_f32_4(tables_search_t *BESSEMER_RESTRICT self, const axis_f32_4_t *axis,
    float value, beyond_t beyond, place_f32_t *BESSEMER_RESTRICT place)
{
    uint32_t below = self->below;
    for (uint32_t pass = 1U; pass < 4U; pass++) {
        const uint32_t here = min_u32(below, 4U - 2U);
        if (here < 4U - 2U && value >= axis->points[here + 1U]) {
            below = here + 1U;
        } else if (here > 0U && value < axis->points[here]) {
            below = here - 1U;
        } else {
            break;
        }
    }
    self->below = below;
    axis_f32_4_between(axis, below, value, beyond, place);
}

/* tables_search.h */

/**
 * Search with memory: it begins where the last one ended, so that a value that moves little takes few steps.
 *
 * Initialisation: `Default` begins at the first point. The results equal those of `Axis::place`.
 *
 * ```
 * use bessemer_blocks::{Axis, Beyond, Search};
 *
 * const AXIS: Axis<f64, 4> = Axis { points: [0.0, 1.0, 4.0, 9.0] };
 * let mut search = Search::default();
 * assert_eq!([5.0, 4.5, 0.5].map(|value| search.place(&AXIS, value, Beyond::Hold).below), [2, 2, 0]);
 * ```
 */
typedef struct {
    /** The point below the last value. */
    uint32_t below;
} tables_search_t;
