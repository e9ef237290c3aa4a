// A stand-in for F´'s basic types and the arrays of its autocoder, for a test.
#pragma once

#include <cstddef>
#include <cstdint>

using F32 = float;
using F64 = double;
using I8 = int8_t;
using I16 = int16_t;
using I32 = int32_t;
using I64 = int64_t;
using U8 = uint8_t;
using U16 = uint16_t;
using U32 = uint32_t;
using U64 = uint64_t;
using FwIndexType = int16_t;

template <class T, size_t N> class StubArray
{
public:
  T &operator[](size_t at) { return elements[at]; }
  const T &operator[](size_t at) const { return elements[at]; }

private:
  T elements[N]{};
};
