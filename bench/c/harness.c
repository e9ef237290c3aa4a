/*
 * Runs the cases of one contender.
 *
 *   program count [NAME…]   each case once, between bench_begin and bench_end
 *   program serve           reads requests from standard input:
 *     time NAME REPETITIONS   the nanoseconds of so many runs
 *     result NAME             the words of the result, in hexadecimal
 */
#define _POSIX_C_SOURCE 199309L

#include "case.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

numbers_t matrix;
numbers_t second;
numbers_t vector;
numbers_t result;

double next_number(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return (double)((*state * UINT64_C(2685821657736338717)) >> 11) * 0x1p-53;
}

static void put(numbers_t *place, int single, size_t index, double value)
{
    if (single) {
        place->f32[index] = (float)value;
    } else {
        place->f64[index] = value;
    }
}

static double get(const numbers_t *place, int single, size_t index)
{
    return single ? (double)place->f32[index] : place->f64[index];
}

/* Numbers of one kind; those of f32 are cut to 24 bits, so that no rounding makes them 1. */
static void fill(numbers_t *place, int single, size_t count, uint64_t seed)
{
    uint64_t state = seed;
    for (size_t i = 0; i < count; i++) {
        double number = next_number(&state);
        if (single) {
            number = (double)(uint32_t)(number * 16777216.0) * 0x1p-24;
        }
        put(place, single, i, number);
    }
}

/* Symmetric and positive definite: a + aᵀ, and on the diagonal the size more. */
static void make_definite(numbers_t *place, int single, size_t n)
{
    for (size_t column = 0; column < n; column++) {
        for (size_t row = 0; row <= column; row++) {
            const double sum =
                get(place, single, row + n * column) + get(place, single, column + n * row);
            put(place, single, row + n * column, sum);
            put(place, single, column + n * row, sum);
        }
    }
    for (size_t i = 0; i < n; i++) {
        put(place, single, i + n * i, get(place, single, i + n * i) + (double)n);
    }
}

static void prepare(const case_t *job)
{
    const size_t n = job->size;
    fill(&matrix, job->single, n * n, UINT64_C(0x9E3779B97F4A7C15) + n);
    fill(&second, job->single, n * n, UINT64_C(0xD1B54A32D192ED03) + n);
    fill(&vector, job->single, n, UINT64_C(0x8CB92BA72F3D8DD7) + n);
    if (job->routine == CHOLESKY_SOLVE) {
        make_definite(&matrix, job->single, n);
    }
    memset(&result, 0, sizeof result);
}

static void load(const case_t *job)
{
    if (job->load != NULL) {
        job->load();
    }
}

static size_t result_count(const case_t *job)
{
    const int solve = job->routine == LU_SOLVE || job->routine == CHOLESKY_SOLVE;
    return solve ? job->size : (size_t)job->size * job->size;
}

/* The counting plugin looks for these two names. */
__attribute__((noinline)) void bench_begin(const char *name)
{
    __asm__ volatile("" : : "r"(name) : "memory");
}

__attribute__((noinline)) void bench_end(const char *name)
{
    __asm__ volatile("" : : "r"(name) : "memory");
}

static void nothing(void)
{
    __asm__ volatile("" : : : "memory");
}

/* What the bracket itself costs. */
static const case_t EMPTY = {"nothing", NOTHING, 1, 0, NULL, nothing, NULL};

static void count(const case_t *job)
{
    prepare(job);
    load(job);
    bench_begin(job->name);
    job->run();
    bench_end(job->name);
    puts(job->name);
    fflush(stdout);
}

static const case_t *find(const char *name)
{
    for (size_t i = 0; i < CASE_COUNT; i++) {
        if (strcmp(CASES[i].name, name) == 0) {
            return &CASES[i];
        }
    }
    return NULL;
}

static int64_t now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (int64_t)time.tv_sec * 1000000000 + time.tv_nsec;
}

/* Where a stack may begin: at 16 bytes, so at four places of a line of the cache. */
#define PLACES 4U

/* Nanoseconds of so many runs with the stack so many bytes lower. The first run brings the caches back to this contender; it
   does not count. */
__attribute__((noinline)) static int64_t run_lower(const case_t *job, unsigned long repetitions, size_t bytes)
{
    char room[bytes];
    __asm__ volatile("" : : "r"(room) : "memory");
    job->run();
    const int64_t start = now();
    for (unsigned long i = 0; i < repetitions; i++) {
        job->run();
    }
    return now() - start;
}

/* Copies on the stack take up to three times as long where a wide store crosses a line of the cache, and every start of a program
   has its stack elsewhere: each place counts alike. */
static int64_t measure(const case_t *job, unsigned long repetitions)
{
    int64_t total = 0;
    if (job->load != NULL) {
        job->load();
        job->run();
        for (unsigned long i = 0; i < repetitions; i++) {
            job->load();
            const int64_t start = now();
            job->run();
            total += now() - start;
        }
    } else {
        for (unsigned long place = 0; place < PLACES; place++) {
            const unsigned long runs = (repetitions + place) / PLACES;
            total += (runs > 0) ? run_lower(job, runs, 16U * (place + 1U)) : 0;
        }
    }
    return total;
}

static void print_result(const case_t *job)
{
    prepare(job);
    load(job);
    job->run();
    if (job->store != NULL) {
        job->store();
    }
    for (size_t i = 0; i < result_count(job); i++) {
        uint64_t word = 0;
        if (job->single) {
            uint32_t half;
            memcpy(&half, &result.f32[i], sizeof half);
            word = half;
        } else {
            memcpy(&word, &result.f64[i], sizeof word);
        }
        printf("%" PRIx64 " ", word);
    }
    puts("");
}

static void serve(void)
{
    char verb[16];
    char name[64];
    const case_t *prepared = NULL;
    while (scanf("%15s %63s", verb, name) == 2) {
        const case_t *job = find(name);
        unsigned long repetitions = 0;
        if (strcmp(verb, "time") == 0 && scanf("%lu", &repetitions) != 1) {
            return;
        }
        if (job == NULL) {
            puts("unknown");
        } else if (repetitions == 0) {
            print_result(job);
            prepared = NULL;
        } else {
            if (prepared != job) {
                prepare(job);
                prepared = job;
            }
            printf("%" PRId64 "\n", measure(job, repetitions));
        }
        fflush(stdout);
    }
}

int main(int arguments, char **argument)
{
    if (arguments > 1 && strcmp(argument[1], "serve") == 0) {
        serve();
        return 0;
    }
    count(&EMPTY);
    if (arguments > 2) {
        for (int i = 2; i < arguments; i++) {
            const case_t *job = find(argument[i]);
            if (job != NULL) {
                count(job);
            }
        }
    } else {
        for (size_t i = 0; i < CASE_COUNT; i++) {
            count(&CASES[i]);
        }
    }
    return 0;
}
