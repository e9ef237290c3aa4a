/*
 * Counts the bytes that memcpy, memmove and memset write between bench_begin and bench_end; writes the sum of all calls
 * to standard error at the end.
 */
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

static int inside;
static uint64_t moved;

void __tsan_init(void);
void bench_begin(void);
void bench_end(void);
void *__real_memcpy(void *to, const void *from, size_t size);
void *__real_memmove(void *to, const void *from, size_t size);
void *__real_memset(void *to, int byte, size_t size);
void *__wrap_memcpy(void *to, const void *from, size_t size);
void *__wrap_memmove(void *to, const void *from, size_t size);
void *__wrap_memset(void *to, int byte, size_t size);
void *__tsan_memcpy(void *to, const void *from, size_t size);
void *__tsan_memmove(void *to, const void *from, size_t size);
void *__tsan_memset(void *to, int byte, size_t size);

static void note(size_t size)
{
    if (inside) {
        moved += size;
    }
}

void __tsan_init(void) {}

void bench_begin(void)
{
    inside = 1;
}

void bench_end(void)
{
    inside = 0;
}

void *__wrap_memcpy(void *to, const void *from, size_t size)
{
    note(size);
    return __real_memcpy(to, from, size);
}

void *__wrap_memmove(void *to, const void *from, size_t size)
{
    note(size);
    return __real_memmove(to, from, size);
}

void *__wrap_memset(void *to, int byte, size_t size)
{
    note(size);
    return __real_memset(to, byte, size);
}

/* The names that later versions of clang call. */
void *__tsan_memcpy(void *to, const void *from, size_t size)
{
    return __wrap_memcpy(to, from, size);
}

void *__tsan_memmove(void *to, const void *from, size_t size)
{
    return __wrap_memmove(to, from, size);
}

void *__tsan_memset(void *to, int byte, size_t size)
{
    return __wrap_memset(to, byte, size);
}

__attribute__((destructor)) static void report(void)
{
    (void)fprintf(stderr, "%llu\n", (unsigned long long)moved);
}
