#if defined(BESSEMER_THREADS)
#include <pthread.h>

/* What a thread works with; its panel is its own. */
typedef struct {
    const $real *tiles;
    $real *a;
    const uint32_t *order;
    bool finite;
    uint32_t from;
} share_t;

static void *invert_share(void *argument)
{
    const share_t *const share = argument;
    $real panel_memory[$panel];
    invert_panels(share->tiles, aligned(panel_memory), share->a, share->order, share->finite, share->from,
        BESSEMER_THREADS);
    return NULL;
}

/* All panels, on several threads; a share whose thread does not start is done here. Each column of the
   inverse is one thread's, and computed as it would be alone. */
static void invert_by_threads(const $real *tiles, $real *panel, $real *a, const uint32_t *order, bool finite)
{
    pthread_t threads[BESSEMER_THREADS];
    share_t shares[BESSEMER_THREADS];
    bool started[BESSEMER_THREADS];
    for (uint32_t index = 1U; index < BESSEMER_THREADS; index++) {
        const share_t share = {tiles, a, order, finite, index};
        shares[index] = share;
        started[index] = pthread_create(&threads[index], NULL, invert_share, &shares[index]) == 0;
    }
    invert_panels(tiles, panel, a, order, finite, 0U, BESSEMER_THREADS);
    for (uint32_t index = 1U; index < BESSEMER_THREADS; index++) {
        if (started[index]) {
            (void)pthread_join(threads[index], NULL);
        } else {
            invert_panels(tiles, panel, a, order, finite, index, BESSEMER_THREADS);
        }
    }
}
#endif
