/*
 * What is measured, and how a contender hands it in.
 *
 * A contender is a program of its own: the harness, the contender's routines, and a list of cases. A case
 * reads `matrix`, `second` and `vector`, leaves them as they are, and writes `result`, all by columns. The two
 * parts of Chapter 6 have a loader, as in the thesis: it copies the data to where the algorithm may destroy it.
 */
#ifndef CASE_H
#define CASE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Room for a matrix of 200 by 200. */
#define ROOM 40000

typedef union {
    double f64[ROOM];
    float f32[ROOM];
} numbers_t;

extern numbers_t matrix;
extern numbers_t second;
extern numbers_t vector;
extern numbers_t result;

typedef enum { NOTHING, LU_SOLVE, INVERSE, CHOLESKY_SOLVE, PRODUCT } routine_t;

typedef struct {
    const char *name;
    routine_t routine;
    uint32_t size;
    int single; /* f32 */
    void (*load)(void); /* before every run, not measured: the data in the contender's own memory; or null */
    void (*run)(void);
    void (*store)(void); /* not measured: the result as the harness wants it; or null */
} case_t;

extern const case_t CASES[];
extern const size_t CASE_COUNT;

/* Numbers in [0, 1), the same in every contender: xorshift64*, the highest 53 (or 24) bits. */
double next_number(uint64_t *state);

#ifdef __cplusplus
}
#endif

#endif
