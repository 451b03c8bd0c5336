// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "haptics/recording/ByteStream.h"

namespace palpate
{

/// What a recording begins with, before the number of its format.
inline constexpr std::string_view recordingMagic = "PALPATE-RECORDING ";

/// What a chunk of a recording holds, by its name in the file, and the newest version of it that this program knows. A
/// newer version only appends.
struct ChunkKind
{
  static constexpr std::size_t nameSize = 8; ///< in the file, filled up with zeros

  std::string_view name;
  std::uint32_t version = 1;
};

namespace chunks
{
inline constexpr ChunkKind start{ "start" };      ///< first parameters and state; before all that follow
inline constexpr ChunkKind tick{ "tick", 2 };     ///< TickRecord; from version 2 on with its PoseRecord
inline constexpr ChunkKind change{ "change" };    ///< RecordedChange
inline constexpr ChunkKind scene{ "scene" };      ///< RecordedScene
inline constexpr ChunkKind motion{ "motion" };    ///< RecordedMotion
inline constexpr ChunkKind brick{ "brick", 3 };   ///< putBrick(); from version 2 on with its lines, 3: a finer one
inline constexpr ChunkKind tool{ "tool", 3 };     ///< putTool(); from version 2 on with its ball, 3: its reach
inline constexpr ChunkKind body{ "body", 2 };     ///< putBody(); from version 2 on with what is beside it
inline constexpr ChunkKind mechanism{ "joined" }; ///< putMechanism()
inline constexpr ChunkKind end{ "end" };          ///< ticks that were lost; nothing follows
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
