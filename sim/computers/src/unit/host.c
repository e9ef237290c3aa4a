/*
 * host.c: a process that runs one co-simulation unit of FMI 3.0. What a unit breaks, it breaks here.
 *
 * Arguments: the unit's library, its token, and the URI or the path of its resources. Words of 64 bits, least significant byte first, come in:
 * the period's bits; the number of variables that are set, and for each its kind, reference, elements, and 1 if only the first
 * call sets it; the same for those that are read, without that flag. Then the words of each call. For each call
 * go out: 0 and the words, or 1 more than the length of a message and its bytes, each a word.
 *
 * The prototypes are those of the standard, with pointers to void for pointers to numbers.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#include <dlfcn.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef void log_message_t(void *environment, int status, const char *category, const char *message);
typedef void *instantiate_t(const char *name, const char *token, const char *resources, bool visible, bool logging, bool events,
    bool early, const uint32_t *intermediate, size_t count, void *environment, log_message_t *log, void (*update)(void));
typedef int begin_t(void *unit, bool tolerant, double tolerance, double start, bool ends, double stop);
typedef int end_begin_t(void *unit);
typedef int copy_t(void *unit, const uint32_t *references, size_t count, void *values, size_t elements);
typedef int do_step_t(void *unit, double now, double step, bool never_back, bool *events, bool *ends, bool *early, double *last);

/* The kinds of variables, in the order of their numbers; an enumeration is an Int64. */
static const char *const KINDS[] = {"Float32", "Float64", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64",
    "UInt64", "Boolean"};
static const size_t SIZES[] = {4U, 8U, 1U, 1U, 2U, 2U, 4U, 4U, 8U, 8U, sizeof(bool)};
#define KIND_COUNT (sizeof KINDS / sizeof KINDS[0])
#define KIND_BOOLEAN 10U

typedef struct {
    size_t kind;
    uint32_t reference;
    size_t elements;
    bool once;
    copy_t *copy;
    unsigned char *bytes;
} variable_t;

static char said[4096];

static void log_message(void *environment, int status, const char *category, const char *message)
{
    (void)environment;
    (void)category;
    if (status > 1 && message != NULL) {
        (void)snprintf(said, sizeof said, "%s", message);
    }
}

static uint64_t get(void)
{
    uint64_t word = 0U;
    for (unsigned shift = 0U; shift < 64U; shift += 8U) {
        const int byte = getchar();
        if (byte == EOF) {
            exit(0);
        }
        word |= (uint64_t)(unsigned char)byte << shift;
    }
    return word;
}

static void put(uint64_t word)
{
    for (unsigned shift = 0U; shift < 64U; shift += 8U) {
        (void)putchar((int)(word >> shift & 0xFFU));
    }
}

/* Says what is wrong, and ends. */
static void wrong(const char *what)
{
    const char *const message = said[0] != '\0' ? said : what;
    put((uint64_t)strlen(message) + 1U);
    for (size_t i = 0U; message[i] != '\0'; i++) {
        put((uint64_t)(unsigned char)message[i]);
    }
    (void)fflush(stdout);
    exit(1);
}

/* A function of the library: ISO C has no conversion of an object's pointer. */
static void find(void *library, const char *name, void *function)
{
    void *const symbol = dlsym(library, name);
    if (symbol == NULL) {
        (void)snprintf(said, sizeof said, "the library has no function %s", name);
        wrong("");
    }
    memcpy(function, &symbol, sizeof symbol);
}

static variable_t *variables(void *library, const char *way, bool sets, size_t *count)
{
    *count = (size_t)get();
    variable_t *const all = calloc(*count + 1U, sizeof *all);
    if (all == NULL) {
        wrong("there is no memory left");
    }
    for (size_t i = 0U; i < *count; i++) {
        variable_t *const it = &all[i];
        it->kind = (size_t)get();
        it->reference = (uint32_t)get();
        it->elements = (size_t)get();
        it->once = sets && get() != 0U;
        if (it->kind >= KIND_COUNT) {
            wrong("a variable has a kind that is not known");
        }
        char name[32];
        (void)snprintf(name, sizeof name, "fmi3%s%s", way, KINDS[it->kind]);
        find(library, name, &it->copy);
        it->bytes = calloc(it->elements + 1U, SIZES[it->kind]);
        if (it->bytes == NULL) {
            wrong("there is no memory left");
        }
    }
    return all;
}

static void read_elements(const variable_t *it)
{
    for (size_t i = 0U; i < it->elements; i++) {
        const uint64_t word = get();
        unsigned char *const at = &it->bytes[i * SIZES[it->kind]];
        const uint8_t byte = (uint8_t)word;
        const uint16_t half = (uint16_t)word;
        const uint32_t single = (uint32_t)word;
        const bool flag = word != 0U;
        switch (SIZES[it->kind]) {
        case 1U: memcpy(at, it->kind == KIND_BOOLEAN ? (const void *)&flag : (const void *)&byte, 1U); break;
        case 2U: memcpy(at, &half, sizeof half); break;
        case 4U: memcpy(at, &single, sizeof single); break;
        default: memcpy(at, &word, sizeof word); break;
        }
    }
}

static void write_elements(const variable_t *it)
{
    /* Int8, Int16, Int32: their sign goes on. */
    const bool is_signed = it->kind == 2U || it->kind == 4U || it->kind == 6U;
    for (size_t i = 0U; i < it->elements; i++) {
        const unsigned char *const at = &it->bytes[i * SIZES[it->kind]];
        uint8_t byte = 0U;
        uint16_t half = 0U;
        uint32_t single = 0U;
        uint64_t word = 0U;
        switch (SIZES[it->kind]) {
        case 1U:
            memcpy(&byte, at, sizeof byte);
            word = is_signed ? (uint64_t)(int64_t)(int8_t)byte : byte;
            break;
        case 2U:
            memcpy(&half, at, sizeof half);
            word = is_signed ? (uint64_t)(int64_t)(int16_t)half : half;
            break;
        case 4U:
            memcpy(&single, at, sizeof single);
            word = is_signed ? (uint64_t)(int64_t)(int32_t)single : single;
            break;
        default: memcpy(&word, at, sizeof word); break;
        }
        put(word);
    }
}

static void copy(void *unit, const variable_t *it)
{
    if (it->copy(unit, &it->reference, 1U, it->bytes, it->elements) > 1) {
        wrong("a variable cannot be set or read");
    }
}

int main(int count, char **arguments)
{
    if (count < 4) {
        return 2;
    }
    void *const library = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) {
        (void)snprintf(said, sizeof said, "%s", dlerror());
        wrong("");
    }
    instantiate_t *instantiate = NULL;
    begin_t *begin = NULL;
    end_begin_t *end_begin = NULL;
    do_step_t *do_step = NULL;
    find(library, "fmi3InstantiateCoSimulation", &instantiate);
    find(library, "fmi3EnterInitializationMode", &begin);
    find(library, "fmi3ExitInitializationMode", &end_begin);
    find(library, "fmi3DoStep", &do_step);
    const uint64_t bits = get();
    double period = 0.0;
    memcpy(&period, &bits, sizeof period);
    size_t sets = 0U;
    size_t reads = 0U;
    variable_t *const set = variables(library, "Set", true, &sets);
    variable_t *const read = variables(library, "Get", false, &reads);
    void *const unit = instantiate("unit", arguments[2], arguments[3], false, true, false, false, NULL, 0U, NULL, log_message, NULL);
    if (unit == NULL || begin(unit, false, 0.0, 0.0, false, 0.0) > 1) {
        wrong("the unit cannot be instantiated");
    }
    for (uint64_t step = 0U;; step++) {
        for (size_t i = 0U; i < sets; i++) {
            read_elements(&set[i]);
            if (step == 0U || !set[i].once) {
                copy(unit, &set[i]);
            }
        }
        if (step == 0U && end_begin(unit) > 1) {
            wrong("the unit cannot be initialised");
        }
        bool events = false;
        bool ends = false;
        bool early = false;
        double last = 0.0;
        if (do_step(unit, (double)step * period, period, true, &events, &ends, &early, &last) > 1) {
            wrong("a step failed");
        }
        if (ends) {
            wrong("the unit ended the simulation");
        }
        put(0U);
        for (size_t i = 0U; i < reads; i++) {
            copy(unit, &read[i]);
            write_elements(&read[i]);
        }
        (void)fflush(stdout);
    }
}
