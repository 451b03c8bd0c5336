// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::test
{

/// Of a file, as they are.
inline std::vector<char> bytesOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/// CRC-32C by its definition, one bit after the other: the remainder of a division by Castagnoli's polynomial.
inline std::uint32_t plainCrc32c(const char* bytes, std::size_t size)
{
  std::uint32_t rest = 0xffffffffu;
  for (std::size_t bit = 0; bit < 8 * size; ++bit)
  {
    const std::uint32_t next = (static_cast<unsigned char>(bytes[bit / 8]) >> bit % 8 ^ rest) & 1u;
    rest = rest >> 1 ^ (next != 0 ? 0x82f63b78u : 0u);
  }
  return ~rest;
}

/// Bytes of the head of a chunk since format 8, and before its two checksums.
inline constexpr std::size_t checkedHead = 36, uncheckedHead = 28;

/// Where the chunks of a recording begin; 0: it has no whole header, or one of before there were checksums.
inline std::size_t checkedChunksBegin(const std::vector<char>& bytes)
{
  const std::string_view text(bytes.data(), std::min<std::size_t>(bytes.size(), 4096));
  const std::size_t end = text.find("\nend\n");
  const std::size_t line = text.substr(0, end).rfind("\ncheck: crc32c ");
  return end != std::string_view::npos && line != std::string_view::npos && end - line == 23 ? end + 5 : 0;
}

/// Where each chunk of a recording begins, and where the last one ends.
inline std::vector<std::size_t> chunkBegins(const std::vector<char>& bytes)
{
  std::vector<std::size_t> begins{ checkedChunksBegin(bytes) };
  while (begins.back() != 0 && begins.back() < bytes.size())
  {
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data() + begins.back() + 12, sizeof(size));
    begins.push_back(begins.back() + checkedHead + size);
  }
  return begins;
}

/// Writes the checksums that belong to bytes that were changed, as far as their heads lead from one chunk to the next.
template<class Checksum>
void repairChecks(std::vector<char>& bytes, const Checksum& checksum)
{
  std::size_t at = checkedChunksBegin(bytes);
  if (at == 0)
  {
    return;
  }
  const std::size_t digits = at - 13; // before the line that ends the header
  const std::uint32_t ofHeader = checksum(bytes.data(), digits);
  for (std::size_t i = 0; i < 8; ++i)
  {
    bytes[digits + i] = "0123456789abcdef"[ofHeader >> (28 - 4 * i) & 15u];
  }
  while (bytes.size() - at >= checkedHead)
  {
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data() + at + 12, sizeof(size));
    const bool whole = size <= bytes.size() - at - checkedHead;
    const std::uint32_t ofPayload = whole ? checksum(bytes.data() + at + checkedHead, size) : 0;
    std::memcpy(bytes.data() + at + uncheckedHead, &ofPayload, sizeof(ofPayload));
    const std::uint32_t ofHead = checksum(bytes.data() + at, uncheckedHead + 4);
    std::memcpy(bytes.data() + at + uncheckedHead + 4, &ofHead, sizeof(ofHead));
    at = whole ? at + checkedHead + size : bytes.size();
  }
}

} // namespace palpate::test
