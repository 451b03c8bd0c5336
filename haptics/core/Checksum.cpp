// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/core/Checksum.h"

#include <array>
#include <bit>
#include <cstring>

namespace palpate
{
namespace
{

constexpr std::size_t bytesAtOnce = 8;

/// Row k has the remainder of a byte that k more bytes of zeros follow.
using ByteTables = std::array<std::array<std::uint32_t, 256>, bytesAtOnce>;

constexpr ByteTables makeByteTables() noexcept
{
  constexpr std::uint32_t reversedPolynomial = 0x82f63b78u;
  ByteTables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte)
  {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit)
    {
      rest = rest >> 1 ^ ((rest & 1u) != 0 ? reversedPolynomial : 0u);
    }
    tables[0][byte] = rest;
  }
  for (std::size_t row = 1; row < bytesAtOnce; ++row)
  {
    for (std::size_t byte = 0; byte < 256; ++byte)
    {
      const std::uint32_t before = tables[row - 1][byte];
      tables[row][byte] = before >> 8 ^ tables[0][before & 0xffu];
    }
  }
  return tables;
}

constexpr ByteTables byteTables = makeByteTables();

/// The checksum of the bytes before, continued with eight bytes at once ("slicing by eight").
std::uint32_t withEight(std::uint32_t rest, const char* bytes) noexcept
{
  static_assert(std::endian::native == std::endian::little);
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof(word));
  word ^= rest;
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < bytesAtOnce; ++i)
  {
    next ^= byteTables[bytesAtOnce - 1 - i][word >> 8 * i & 0xffu];
  }
  return next;
}

} // namespace

std::uint32_t crc32c(const char* bytes, std::size_t size) noexcept
{
  std::uint32_t rest = ~0u;
  for (; size >= bytesAtOnce; size -= bytesAtOnce, bytes += bytesAtOnce)
  {
    rest = withEight(rest, bytes);
  }
  for (; size > 0; --size, ++bytes)
  {
    rest = rest >> 8 ^ byteTables[0][(rest ^ static_cast<unsigned char>(*bytes)) & 0xffu];
  }
  return ~rest;
}

} // namespace palpate
