// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "haptics/recording/bytes/ByteStream.h"

namespace palpate
{

/// The first bytes of a recording, before the number of its format.
inline constexpr std::string_view recordingMagic = "PALPATE-RECORDING ";

/// The last lines of its header: "check: crc32c " and, in eight digits 0 to f, the checksum of all before those digits.
inline constexpr std::string_view headerCheck = "\ncheck: crc32c ", headerEnd = "\nend\n";
inline constexpr std::size_t headerCheckDigits = 8;

/// The digits of a checksum in a header.
[[nodiscard]] inline std::string checkDigits(std::uint32_t checksum)
{
  std::string digits;
  for (std::size_t i = headerCheckDigits; i-- > 0;)
  {
    digits += "0123456789abcdef"[checksum >> 4 * i & 0xfu];
  }
  return digits;
}

/// The kind of a chunk of a recording, by its name in the file, and the version that this program writes and reads. In
/// the file a chunk is its head (name, version u32, size of the payload u64, number of the chunk from 1 on u64, CRC-32C
/// of the payload u32, CRC-32C of the head's bytes so far u32), then its payload. The head has a checksum of its own: a
/// size must be believed before the payload can be found. The number shows a chunk that is missing, that is there twice
/// or that stands elsewhere: each of these has right checksums.
struct ChunkKind
{
  static constexpr std::size_t nameSize = 8; ///< in the file, filled up with zeros

  std::string_view name;
  std::uint32_t version = 1;
};

/// A chunk that has no place in a recording yet.
struct NewChunk
{
  ChunkKind kind;
  ByteWriter payload;
};

/// Those that are no input of the tick; of inputs see recording/inputs.
namespace chunks
{
inline constexpr ChunkKind start{ "start" };   ///< first parameters and state; before all that follow
inline constexpr ChunkKind tick{ "tick", 2 };  ///< TickRecord
inline constexpr ChunkKind change{ "change" }; ///< RecordedChange
inline constexpr ChunkKind end{ "end" };       ///< ticks that were lost; nothing follows
} // namespace chunks

/// The parts of a start and of a change.
inline constexpr std::string_view parametersPart = "parameters", statePart = "state";

/// Puts or gets, so that each value is named once, for writing and for reading alike.
struct Put
{
  ByteWriter& stream;
  template<class T>
  void operator()(const T& value) const
  {
    this->stream.put(value);
  }
  template<class T>
  void operator()(const char* /*name*/, const T& value) const
  {
    this->stream.put(value);
  }
};

struct Get
{
  ByteReader& stream;
  template<class T>
  void operator()(T& value) const
  {
    this->stream.get(value);
  }
  template<class T>
  void operator()(const char* /*name*/, T& value) const
  {
    this->stream.get(value);
  }
};

template<class Io, class T>
void layChange(const Io& io, T& c)
{
  io(c.event.tick);
  io(c.event.kind);
  io(c.event.value);
  io(c.sceneHash);
  io(c.sceneRevision);
}

template<class Io, class T>
void layMaterial(const Io& io, T& m)
{
  io(m.stiffness_N_per_m);
  io(m.frictionStatic);
  io(m.frictionKinetic);
}

} // namespace palpate
