// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "haptics/recording/bytes/ByteStream.h"

namespace palpate
{

/// Bytes with a name, so that a recording may lack parts that were added later.
struct NamedPart
{
  std::string name;
  ByteReader payload{ nullptr, 0 };
};

/// Whether a name can be shown to a person as it is.
[[nodiscard]] inline bool isPartName(std::string_view name)
{
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

inline void putPart(ByteWriter& out, std::string_view name, const ByteWriter& payload)
{
  out.put(std::string(name));
  out.put(std::string(payload.bytes().begin(), payload.bytes().end()));
}

/// The next part of bytes that are not trusted; valid while in.ok().
[[nodiscard]] inline NamedPart nextPart(ByteReader& in)
{
  constexpr std::size_t longestName = 64;
  NamedPart part;
  std::uint32_t size = 0;
  in.get(part.name);
  in.get(size);
  if (part.name.size() > longestName || !isPartName(part.name))
  {
    in.fail();
  }
  if (in.has(size))
  {
    part.payload = ByteReader(in.at(), size);
    in.skip(size);
  }
  return part;
}

} // namespace palpate
