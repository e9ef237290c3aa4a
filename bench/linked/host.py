"""Runs the flight software in wasmtime: host.py linked.wasm < words of settings and inputs > words of results."""

import sys

from wasmtime import Instance, Module, Store

store = Store()
instance = Instance(store, Module.from_file(store.engine, sys.argv[1]), [])
exports = instance.exports(store)
memory = exports["memory"]


def call(name, *arguments):
    return exports["linked_" + name](store, *arguments)


place = call("memory")
call("init", place)
words = call("words", place)
taken, given = 8 * call("arguments"), 8 * call("results")
while arguments := sys.stdin.buffer.read(taken):
    memory.write(store, arguments, words)
    for name in ["take", "step", "height", "give"]:
        call(name, place)
    sys.stdout.buffer.write(memory.read(store, words, words + given))
