/* The C of blocks/src/frames.rs. Written by a test. */

/* frames.c */

static const double ECCENTRICITY_SQUARED = 0.0066943799901413165;
static const double FLATTENING = 0.0033528106647474805;
static const double SEMI_MAJOR_AXIS = 6378137.0;
static const uint32_t STEPS = 3U;

void frames_ecef_from_geodetic_f64(const geodetic_f64_t *position,
    double result[BESSEMER_RESTRICT 3])
{
    pair_f64_f64_t sine_cosine;
    sine_sin_cos(position->latitude, &sine_cosine);
    pair_f64_f64_t pair;
    sine_sin_cos(position->longitude, &pair);
    const double eccentricity = ECCENTRICITY_SQUARED;
    const double normal = SEMI_MAJOR_AXIS
        / sqrt(1.0 - eccentricity * sine_cosine.first * sine_cosine.first);
    const double across = (normal + position->height) * sine_cosine.second;
    result[0] = across * pair.second;
    result[1] = across * pair.first;
    result[2] = (normal * (1.0 - eccentricity) + position->height) * sine_cosine.first;
}

void frames_geodetic_from_ecef_f64(const double position[3],
    geodetic_f64_t *BESSEMER_RESTRICT geodetic)
{
    const double semi_major = SEMI_MAJOR_AXIS;
    const double eccentricity = ECCENTRICITY_SQUARED;

    /* The semi-minor axis by the semi-major one, and the square of the second eccentricity. */
    const double ratio = 1.0 - FLATTENING;
    const double second = ECCENTRICITY_SQUARED / (1.0 - ECCENTRICITY_SQUARED);
    const double across = roots_hypot(position[0], position[1]);

    /* Direction of the parametric latitude. */
    double along = across * ratio;
    double up = position[2];
    double cosine = 1.0;
    double sine = 0.0;
    for (uint32_t pass = 0U; pass < STEPS; pass++) {
        const double length = roots_hypot(along, up);
        const double c = along / length;
        const double s = up / length;
        cosine = across - eccentricity * semi_major * c * c * c;
        sine = position[2] + second * semi_major * ratio * s * s * s;
        along = cosine;
        up = ratio * sine;
    }
    const double latitude = arctangent_atan2(sine, cosine);
    const double length = roots_hypot(cosine, sine);
    const double c = cosine / length;
    const double s = sine / length;
    const double surface = semi_major * sqrt(1.0 - eccentricity * s * s);
    geodetic->latitude = latitude;
    geodetic->longitude = arctangent_atan2(position[1], position[0]);
    geodetic->height = across * c + position[2] * s - surface;
}

void frames_enu_rotation_f32(const geodetic_f32_t *origin, float result[BESSEMER_RESTRICT 9])
{
    pair_f32_f32_t s_c;
    math_single_sin_cosf(origin->latitude, &s_c);
    pair_f32_f32_t sl_cl;
    math_single_sin_cosf(origin->longitude, &sl_cl);
    result[0 + 3 * 0] = -sl_cl.first;
    result[1 + 3 * 0] = -s_c.first * sl_cl.second;
    result[2 + 3 * 0] = s_c.second * sl_cl.second;
    result[0 + 3 * 1] = sl_cl.second;
    result[1 + 3 * 1] = -s_c.first * sl_cl.first;
    result[2 + 3 * 1] = s_c.second * sl_cl.first;
    result[0 + 3 * 2] = 0.0F;
    result[1 + 3 * 2] = s_c.second;
    result[2 + 3 * 2] = s_c.first;
}

void frames_enu_rotation_f64(const geodetic_f64_t *origin, double result[BESSEMER_RESTRICT 9])
{
    pair_f64_f64_t s_c;
    sine_sin_cos(origin->latitude, &s_c);
    pair_f64_f64_t sl_cl;
    sine_sin_cos(origin->longitude, &sl_cl);
    result[0 + 3 * 0] = -sl_cl.first;
    result[1 + 3 * 0] = -s_c.first * sl_cl.second;
    result[2 + 3 * 0] = s_c.second * sl_cl.second;
    result[0 + 3 * 1] = sl_cl.second;
    result[1 + 3 * 1] = -s_c.first * sl_cl.first;
    result[2 + 3 * 1] = s_c.second * sl_cl.first;
    result[0 + 3 * 2] = 0.0;
    result[1 + 3 * 2] = s_c.second;
    result[2 + 3 * 2] = s_c.first;
}

void frames_enu_from_ecef_f64(const geodetic_f64_t *origin, const double point[3],
    double result[BESSEMER_RESTRICT 3])
{
    double result_enu_rotation_f64[9];
    frames_enu_rotation_f64(origin, result_enu_rotation_f64);
    double result_ecef_from_geodetic_f64[3];
    frames_ecef_from_geodetic_f64(origin, result_ecef_from_geodetic_f64);
    const double result_difference[3] = {
        point[0] - result_ecef_from_geodetic_f64[0],
        point[1] - result_ecef_from_geodetic_f64[1],
        point[2] - result_ecef_from_geodetic_f64[2]
    };
    result[0] = result_enu_rotation_f64[0 + 3 * 0] * result_difference[0]
        + result_enu_rotation_f64[0 + 3 * 1] * result_difference[1]
        + result_enu_rotation_f64[0 + 3 * 2] * result_difference[2];
    result[1] = result_enu_rotation_f64[1 + 3 * 0] * result_difference[0]
        + result_enu_rotation_f64[1 + 3 * 1] * result_difference[1]
        + result_enu_rotation_f64[1 + 3 * 2] * result_difference[2];
    result[2] = result_enu_rotation_f64[2 + 3 * 0] * result_difference[0]
        + result_enu_rotation_f64[2 + 3 * 1] * result_difference[1]
        + result_enu_rotation_f64[2 + 3 * 2] * result_difference[2];
}

void frames_ecef_from_enu_f64(const geodetic_f64_t *origin, const double point[3],
    double result[BESSEMER_RESTRICT 3])
{
    double result_enu_rotation_f64[9];
    frames_enu_rotation_f64(origin, result_enu_rotation_f64);
    const double result_product[3] = {
        result_enu_rotation_f64[0 + 3 * 0] * point[0]
            + result_enu_rotation_f64[1 + 3 * 0] * point[1]
            + result_enu_rotation_f64[2 + 3 * 0] * point[2],
        result_enu_rotation_f64[0 + 3 * 1] * point[0]
            + result_enu_rotation_f64[1 + 3 * 1] * point[1]
            + result_enu_rotation_f64[2 + 3 * 1] * point[2],
        result_enu_rotation_f64[0 + 3 * 2] * point[0]
            + result_enu_rotation_f64[1 + 3 * 2] * point[1]
            + result_enu_rotation_f64[2 + 3 * 2] * point[2]
    };
    double result_ecef_from_geodetic_f64[3];
    frames_ecef_from_geodetic_f64(origin, result_ecef_from_geodetic_f64);
    result[0] = result_product[0] + result_ecef_from_geodetic_f64[0];
    result[1] = result_product[1] + result_ecef_from_geodetic_f64[1];
    result[2] = result_product[2] + result_ecef_from_geodetic_f64[2];
}

void frames_ned_from_enu_f64(const double vector[3], double result[BESSEMER_RESTRICT 3])
{
    result[0] = vector[1];
    result[1] = vector[0];
    result[2] = -vector[2];
}

/* frames.h */

/** Geodetic position. */
typedef struct {
    /** Latitude, −π/2 to π/2. Unit: rad. */
    float latitude;
    /** Longitude, −π to π. Unit: rad. */
    float longitude;
    /** Height above the ellipsoid. Unit: m. */
    float height;
} geodetic_f32_t;

/** Geodetic position. */
typedef struct {
    /** Latitude, −π/2 to π/2. Unit: rad. */
    double latitude;
    /** Longitude, −π to π. Unit: rad. */
    double longitude;
    /** Height above the ellipsoid. Unit: m. */
    double height;
} geodetic_f64_t;
