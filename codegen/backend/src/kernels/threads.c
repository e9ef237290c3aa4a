#if defined(BESSEMER_THREADS)
#include <pthread.h>

/* What a thread works with. */
typedef struct {
$members    uint32_t from;
} share_t;

static void *share_of_one(void *argument)
{
    const share_t *const share = argument;
$own    $work($of_share, share->from, BESSEMER_THREADS);
    return NULL;
}

/* The whole, on several threads; a share whose thread does not start is done here. Each column of the
   result is one thread's, and computed as it would be alone. */
static void by_threads($parameters)
{
    pthread_t threads[BESSEMER_THREADS];
    share_t shares[BESSEMER_THREADS];
    bool started[BESSEMER_THREADS];
    for (uint32_t index = 1U; index < BESSEMER_THREADS; index++) {
        const share_t share = {$shared, index};
        shares[index] = share;
        started[index] = pthread_create(&threads[index], NULL, share_of_one, &shares[index]) == 0;
    }
    $work($arguments, 0U, BESSEMER_THREADS);
    for (uint32_t index = 1U; index < BESSEMER_THREADS; index++) {
        if (started[index]) {
            (void)pthread_join(threads[index], NULL);
        } else {
            $work($arguments, index, BESSEMER_THREADS);
        }
    }
}
#endif
