/*
 * Runs the flight software as rustc compiles it: reads the words of settings and inputs of each period, and writes those of
 * its results.
 *
 * "words.h" is written by whoever builds this: get and put move a word, and instructions between bench_begin and
 * bench_end are counted. WASM2C or W2C2 is defined if "linked.h" and its source are what these make of the WebAssembly.
 */
#include "words.h"

#if defined(WASM2C)
#include "linked.h"

static Z_linked_instance_t module;

#define OF_NONE(name) Z_linkedZ_linked_##name(&module)
#define OF(name) Z_linkedZ_linked_##name(&module, place)
#define AT(address) ((void *)(module.w2c_memory.data + (address)))

typedef u32 place_t;

static place_t start(void)
{
    wasm_rt_init();
    Z_linked_init_module();
    Z_linked_instantiate(&module);
    return OF_NONE(memory);
}
#elif defined(W2C2)
#include "linked.h"

static linkedInstance module;

#define OF_NONE(name) linked_linked_##name(&module)
#define OF(name) linked_linked_##name(&module, place)
#define AT(address) ((void *)(module.m0->data + (address)))

typedef U32 place_t;

void trap(Trap trap)
{
    exit((int)trap + 1);
}

static void *resolved(const char *from, const char *name)
{
    (void)from;
    (void)name;
    return NULL;
}

static place_t start(void)
{
    linkedInstantiate(&module, resolved);
    return OF_NONE(memory);
}
#else
size_t linked_size(void);
size_t linked_arguments(void);
size_t linked_results(void);
void linked_init(void *place);
uint64_t *linked_words(void *place);
void linked_take(void *place);
void linked_step(void *place);
void linked_height(void *place);
void linked_give(void *place);

#define OF_NONE(name) linked_##name()
#define OF(name) linked_##name(place)
#define AT(address) (address)

typedef void *place_t;

static place_t start(void)
{
    static uint64_t memory[4096];
    if (OF_NONE(size) > sizeof(memory)) {
        exit(2);
    }
    return memory;
}
#endif

int main(void)
{
    place_t place = start();
    OF(init);
    for (;;) {
        uint64_t *words = AT(OF(words));
        size_t n;
        for (n = 0; n < OF_NONE(arguments); ++n) {
            words[n] = get();
        }
        OF(take);
        bench_begin();
        OF(step);
        bench_end();
        bench_begin();
        OF(height);
        bench_end();
        OF(give);
        for (n = 0; n < OF_NONE(results); ++n) {
            put(words[n]);
        }
    }
}
