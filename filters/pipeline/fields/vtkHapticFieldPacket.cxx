// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFieldPacket.h"

#include "haptics/recording/bytes/RecordingLayout.h"
#include "haptics/recording/inputs/FieldBlocks.h"

namespace
{
/// Puts or gets all but the block, so that each value is named once.
template<class Stream, class Packet>
void Each(const Stream& stream, Packet& packet)
{
  stream(packet.Problem);
  stream(packet.Ends);
  stream(packet.Bounds);
  stream(packet.Made.centre_W);
  stream(packet.Made.reach_u);
  stream(packet.Made.problem);
  stream(packet.Made.smoothness.passes);
  stream(packet.Made.smoothness.noise);
  stream(packet.Made.smoothness.level);
  stream(packet.Made.smoothness.until);
  stream(packet.Made.error);
  stream(packet.Made.finerReach_u);
  stream(packet.Made.whyNoCells);
  stream(packet.Made.levels.gradient_per_u);
  stream(packet.Made.levels.bend_per_u2);
}
} // namespace

std::vector<char> vtkHapticPackField(const vtkHapticFieldPacket& packet)
{
  palpate::ByteWriter out;
  Each(palpate::Put{ out }, packet);
  out.put(packet.Made.brick != nullptr);
  if (packet.Made.brick)
  {
    palpate::putFieldBlock(out, *packet.Made.brick);
  }
  return out.bytes();
}

std::optional<vtkHapticFieldPacket> vtkHapticUnpackField(std::span<const char> bytes)
{
  palpate::ByteReader in(bytes.data(), bytes.size());
  vtkHapticFieldPacket packet;
  Each(palpate::Get{ in }, packet);
  bool hasFieldBlock = false;
  in.get(hasFieldBlock);
  packet.Made.brick = hasFieldBlock ? palpate::readFieldBlock(in) : nullptr;
  return in.ok() && in.left() == 0 ? std::optional(packet) : std::nullopt;
}
