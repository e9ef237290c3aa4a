#if defined(WORDS)
static inline four_t load_four(const $real *from)
{
    union {
        int64x1x4_t words;
        four_t four;
    } loaded;
    loaded.words = vld4_s64((const word_t *)from);
    return loaded.four;
}
#else
static inline four_t load_four(const $real *from)
{
    const four_t four = {from[0], from[1], from[2], from[3]};
    return four;
}
#endif

#if defined(QUAD)
static inline quad_lanes_t minus_quad(quad_lanes_t quad, $real factor, quad_lanes_t other)
{
    return quad - factor * other;
}

static inline quad_lanes_t times_quad(quad_lanes_t quad, $real factor)
{
    return quad * factor;
}

/* Four rows of four, so far apart, become columns. */
static inline void transpose(const $real *from, uint32_t apart, $real *to, uint32_t beside)
{
    store_square(to, &to[beside], &to[2U * beside], &to[3U * beside],
        turned(load_square(from, &from[apart], &from[2U * apart], &from[3U * apart])));
}
#else
static inline quad_lanes_t times_quad(quad_lanes_t quad, $real factor)
{
#if defined(HALF)
    const quad_lanes_t product = {quad.low * factor, quad.high * factor};
#else
    const quad_lanes_t product = {
        quad.a * factor, quad.b * factor, quad.c * factor, quad.d * factor};
#endif
    return product;
}

/* Four rows of four, so far apart, become columns. */
static inline void transpose(const $real *from, uint32_t apart, $real *to, uint32_t beside)
{
    const four_t a = load_four(from);
    const four_t b = load_four(&from[apart]);
    const four_t c = load_four(&from[2U * apart]);
    const four_t d = load_four(&from[3U * apart]);
    to[0] = a.a;
    to[1] = b.a;
    to[2] = c.a;
    to[3] = d.a;
    to[beside] = a.b;
    to[beside + 1U] = b.b;
    to[beside + 2U] = c.b;
    to[beside + 3U] = d.b;
    to[2U * beside] = a.c;
    to[2U * beside + 1U] = b.c;
    to[2U * beside + 2U] = c.c;
    to[2U * beside + 3U] = d.c;
    to[3U * beside] = a.d;
    to[3U * beside + 1U] = b.d;
    to[3U * beside + 2U] = c.d;
    to[3U * beside + 3U] = d.d;
}
#endif
