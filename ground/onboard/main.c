/*
 * main.c: the onboard software on a computer with sockets: sensors and motors on one, the ground on the other.
 *
 *     onboard BUS_PORT
 *
 * BUS_PORT is where the aircraft listens, on loopback, as is the port at which the ground is listened to: any that is
 * free; the first datagram on the bus is "ready" and that port, two bytes, least significant first. The first line of standard input is the key, 32 hexadecimal digits, or empty. A period begins with the sensors'
 * datagram, as it would with their interrupt, and ends with the motors'. A longer datagram brings a recorded period
 * with what was heard from the ground in it. "image" is answered with the software's memory, and such an answer puts
 * it back: only for this very program. Without sensors for ten seconds the program ends.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#define _POSIX_C_SOURCE 200112L

#include <arpa/inet.h>
#include <netinet/in.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include "gate.h"
#include "onboard.h"
#include "packet.h"
#include "receiver.h"
#include "tuning.h"
#include "wire.h"

/** Packets that wait for their period. */
#define QUEUE 64U

/** After so many periods without a word, another ground station is listened to. */
#define DESERTED 400U

/** STOP of models::receiver. */
#define KIND_STOP 9U

/** The ground, as this side of the link sees it. */
typedef struct {
    int socket;
    siphash_key_t key;
    gate_t gate;
    /** Who commands: whom we heard first, until nothing is heard of it. */
    struct sockaddr_in station;
    bool known;
    unsigned silent;
    packet_t waiting[QUEUE];
    unsigned first;
    unsigned count;
} ground_t;

/** Everything that the software remembers. */
typedef struct {
    onboard_t onboard;
    settings_t settings;
    uint64_t count;
} image_t;

static int opened(void)
{
    struct sockaddr_in here;
    const int made = socket(AF_INET, SOCK_DGRAM, 0);
    memset(&here, 0, sizeof here);
    here.sin_family = AF_INET;
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (made < 0 || bind(made, (const struct sockaddr *)&here, sizeof here) != 0) {
        perror("onboard: socket");
        exit(1);
    }
    return made;
}

static void reach(int bus, uint16_t port)
{
    struct sockaddr_in there;
    const struct timeval patience = {10, 0};
    memset(&there, 0, sizeof there);
    there.sin_family = AF_INET;
    there.sin_port = htons(port);
    there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(bus, (const struct sockaddr *)&there, sizeof there) != 0 ||
        setsockopt(bus, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience) != 0) {
        perror("onboard: bus");
        exit(1);
    }
}

/** The key from the first line of standard input; false if the line is neither a key nor empty. */
static bool read_key(siphash_key_t *key)
{
    char line[80];
    memset(key, 0, sizeof *key);
    if (fgets(line, (int)sizeof line, stdin) == NULL || line[0] == '\n') {
        return true;
    }
    if (strspn(line, "0123456789abcdefABCDEF") != 32U) {
        return false;
    }
    for (unsigned n = 0U; n < 16U; ++n) {
        const char two[3] = {line[2U * n], line[2U * n + 1U], '\0'};
        key->halves[n / 8U] |= (uint64_t)strtoul(two, NULL, 16) << (8U * (n % 8U));
    }
    key->given = true;
    return true;
}

/** Puts a packet at the end of those that wait. One that stops the motors comes first: it makes the others moot. */
static void enqueue(ground_t *ground, const packet_t *packet)
{
    if (packet_kind(packet) == KIND_STOP) {
        ground->count = 0U;
    }
    if (ground->count < QUEUE) {
        ground->waiting[(ground->first + ground->count) % QUEUE] = *packet;
        ++ground->count;
    }
}

static bool same(const struct sockaddr_in *one, const struct sockaddr_in *other)
{
    return one->sin_port == other->sin_port && one->sin_addr.s_addr == other->sin_addr.s_addr;
}

/** Takes in every datagram that has come from the ground. */
static void listen_to(ground_t *ground)
{
    if (ground->silent < DESERTED) {
        ++ground->silent;
    }
    for (;;) {
        struct sockaddr_in from;
        socklen_t size = sizeof from;
        packet_t packet;
        packet_t inner;
        memset(&packet, 0, sizeof packet);
        /* A byte more than a packet has: what is longer is none. */
        uint8_t bytes[sizeof packet.bytes + 1U];
        const ssize_t length = recvfrom(ground->socket, bytes, sizeof bytes, MSG_DONTWAIT,
            (struct sockaddr *)&from, &size);
        if (length < 0) {
            return;
        }
        packet.length = (uint64_t)length;
        memcpy(packet.bytes, bytes, sizeof packet.bytes < (size_t)length ? sizeof packet.bytes : (size_t)length);
        const bool stranger = ground->known && ground->silent < DESERTED && !same(&from, &ground->station);
        if (stranger && packet_kind(&packet) != KIND_STOP) {
            /* It is looked at only so that it is counted: whoever it comes from, nothing moves by it. */
            gate_t other = ground->gate;
            gate_step(&other, &ground->key, &packet, &inner);
            ground->gate.refused = other.refused;
            continue;
        }
        gate_step(&ground->gate, &ground->key, &packet, &inner);
        if (inner.length == 0U) {
            continue;
        }
        if (!stranger && packet_is_sound(&inner)) {
            ground->station = from;
            ground->known = true;
            ground->silent = 0U;
        }
        enqueue(ground, &inner);
    }
}

/** The packet of this period. */
static void next(ground_t *ground, packet_t *packet)
{
    if (ground->count == 0U) {
        packet_none(packet);
        return;
    }
    *packet = ground->waiting[ground->first];
    ground->first = (ground->first + 1U) % QUEUE;
    --ground->count;
}

static uint16_t port(const char *text)
{
    return (uint16_t)(strtoul(text, NULL, 10) & 0xFFFFU);
}

/** Says that it is there, and where the ground reaches it. */
static void say_ready(int bus, int link)
{
    struct sockaddr_in here;
    socklen_t size = sizeof here;
    uint8_t ready[7] = {'r', 'e', 'a', 'd', 'y', 0U, 0U};
    if (getsockname(link, (struct sockaddr *)&here, &size) != 0) {
        perror("onboard: link");
        exit(1);
    }
    const uint16_t number = ntohs(here.sin_port);
    ready[5] = (uint8_t)(number & 0xFFU);
    ready[6] = (uint8_t)(number >> 8U);
    (void)send(bus, ready, sizeof ready, 0);
}

int main(int argc, char **argv)
{
    static image_t image;
    static onboard_step_work_t step_work;
    static inputs_t inputs;
    static outputs_t outputs;
    static ground_t ground;
    static uint8_t in[sizeof(image_t)];
    static uint8_t out[WIRE_OUT];

    if (argc != 2 || !read_key(&ground.key)) {
        (void)fprintf(stderr, "usage: onboard BUS_PORT, with a key or an empty line on standard input\n");
        return 2;
    }
    const int bus = opened();
    ground.socket = opened();
    reach(bus, port(argv[1]));
    gate_init(&ground.gate);
    onboard_init(&image.onboard);
    settings_mambo(&image.settings);
    say_ready(bus, ground.socket);

    for (;;) {
        uint64_t number;
        const ssize_t length = recv(bus, in, sizeof in, 0);
        if (length < 0) {
            return 0;
        }
        if (length == 5 && memcmp(in, "image", 5U) == 0) {
            (void)send(bus, &image, sizeof image, 0);
            continue;
        }
        if (length == (ssize_t)sizeof image) {
            memcpy(&image, in, sizeof image);
            continue;
        }
        if (length == WIRE_AGAIN) {
            wire_read_again(in, &number, &inputs);
        } else if (length == WIRE_IN) {
            wire_read(in, &number, &inputs);
            listen_to(&ground);
            next(&ground, &inputs.uplink);
            inputs.refused = ground.gate.refused;
        } else {
            continue;
        }
        onboard_step(&image.onboard, &image.settings, &inputs, &step_work, &outputs);
        (void)settings_grant(&image.settings, &outputs.wish, outputs.reference.motors);
        const size_t size = wire_write(out, number, image.count, &inputs, &outputs);
        (void)send(bus, out, size, 0);
        ++image.count;
        if (outputs.downlink.length > 0U && ground.known) {
            (void)sendto(ground.socket, outputs.downlink.bytes, (size_t)outputs.downlink.length, 0,
                (const struct sockaddr *)&ground.station, sizeof ground.station);
        }
    }
}
