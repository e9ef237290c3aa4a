/*
 * main.c: the onboard software on a computer with sockets: sensors and motors on one, the ground on the other.
 *
 *     onboard BUS_PORT
 *
 * BUS_PORT is where the aircraft listens, on loopback, as is the port at which the ground is listened to: any that is
 * free; the first datagram on the bus is "ready" and that port, two bytes, least significant first. The first line of
 * standard input is the key, 32 hexadecimal digits, or empty. The program ends when standard input does: then whoever
 * started it is gone. A silent bus does not end it: the machine may be busy.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#define _POSIX_C_SOURCE 200112L

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "computer.h"

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
    memset(&there, 0, sizeof there);
    there.sin_family = AF_INET;
    there.sin_port = htons(port);
    there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(bus, (const struct sockaddr *)&there, sizeof there) != 0) {
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
    key->is_set = true;
    return true;
}

/** Waits for a datagram on the bus; false if whoever started the program is gone. */
static bool wait_for(int bus)
{
    struct pollfd ends[2] = {{bus, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}};
    for (;;) {
        if (poll(ends, 2U, -1) < 0) {
            if (errno != EINTR) {
                perror("onboard: poll");
                return false;
            }
            continue;
        }
        if (ends[1].revents != 0) {
            /* Nothing more is to be said there but its end. */
            char rest[80];
            if (read(STDIN_FILENO, rest, sizeof rest) <= 0) {
                return false;
            }
        }
        if (ends[0].revents != 0) {
            return true;
        }
    }
}

/** A sender as a number: its address above its port. */
static uint64_t station(const struct sockaddr_in *sender)
{
    return ((uint64_t)ntohl(sender->sin_addr.s_addr) << 16U) | ntohs(sender->sin_port);
}

/** Takes in every datagram that has come from the ground. */
static void listen_to(computer_t *computer, int ground)
{
    for (;;) {
        struct sockaddr_in from;
        socklen_t size = sizeof from;
        /* A byte more than a packet has: what is longer is none. */
        uint8_t bytes[sizeof computer->downlink.bytes + 1U];
        const ssize_t length =
            recvfrom(ground, bytes, sizeof bytes, MSG_DONTWAIT, (struct sockaddr *)&from, &size);
        if (length < 0) {
            return;
        }
        computer_hear(computer, station(&from), bytes, (size_t)length);
    }
}

/** Sends down what goes to the station. */
static void speak(const computer_t *computer, int ground)
{
    struct sockaddr_in there;
    memset(&there, 0, sizeof there);
    there.sin_family = AF_INET;
    there.sin_port = htons((uint16_t)(computer->ground.station & 0xFFFFU));
    there.sin_addr.s_addr = htonl((uint32_t)((computer->ground.station >> 16U) & 0xFFFFFFFFU));
    (void)sendto(ground, computer->downlink.bytes, (size_t)computer->downlink.length, 0,
        (const struct sockaddr *)&there, sizeof there);
}

static uint16_t port(const char *text)
{
    return (uint16_t)(strtoul(text, NULL, 10) & 0xFFFFU);
}

/** Says that it is there, and where the ground reaches it. */
static void say_ready(int bus, int ground)
{
    struct sockaddr_in here;
    socklen_t size = sizeof here;
    uint8_t ready[7] = {'r', 'e', 'a', 'd', 'y', 0U, 0U};
    if (getsockname(ground, (struct sockaddr *)&here, &size) != 0) {
        perror("onboard: ground");
        exit(1);
    }
    const uint16_t number = ntohs(here.sin_port);
    ready[5] = (uint8_t)(number & 0xFFU);
    ready[6] = (uint8_t)(number >> 8U);
    (void)send(bus, ready, sizeof ready, 0);
}

int main(int argc, char **argv)
{
    static computer_t computer;
    /* A byte more than a datagram has: what is longer is none. */
    static uint8_t in[COMPUTER_MOST + 1U];
    siphash_key_t key;

    if (argc != 2 || !read_key(&key)) {
        (void)fprintf(stderr, "usage: onboard BUS_PORT, with a key or an empty line on standard input\n");
        return 2;
    }
    const int bus = opened();
    const int ground = opened();
    reach(bus, port(argv[1]));
    computer_begin(&computer, &key);
    say_ready(bus, ground);

    while (wait_for(bus)) {
        const ssize_t length = recv(bus, in, sizeof in, 0);
        if (length < 0) {
            /* The other end of the bus is closed. */
            return 0;
        }
        if (computer_is_period((size_t)length)) {
            listen_to(&computer, ground);
        }
        const size_t size = computer_take(&computer, in, (size_t)length);
        /* What goes down comes first: whoever has the answer finds it there. */
        if (computer.downlink.length > 0U) {
            speak(&computer, ground);
        }
        if (size > 0U) {
            (void)send(bus, computer.answer, size, 0);
        }
    }
    return 0;
}
