// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordingChunks.h"

#include <string_view>
#include <utility>

#include "haptics/core/Checksum.h"
#include "haptics/recording/NamedParts.h"
#include "haptics/recording/RecordedStages.h"

namespace palpate
{
namespace
{

std::uint32_t checksumOf(const ByteWriter& bytes)
{
  return crc32c(bytes.bytes().data(), bytes.bytes().size());
}

ByteWriter bytesOf(const HapticParameters& parameters)
{
  ByteWriter bytes;
  putParameters(bytes, parameters);
  return bytes;
}

} // namespace

std::vector<char> recordedChunk(const NewChunk& chunk, std::uint64_t number)
{
  const std::string_view name = chunk.kind.name;
  ByteWriter head;
  for (std::size_t i = 0; i < ChunkKind::nameSize; ++i)
  {
    head.put(i < name.size() ? name[i] : '\0');
  }
  head.put(chunk.kind.version);
  head.put(static_cast<std::uint64_t>(chunk.payload.bytes().size()));
  head.put(number);
  head.put(checksumOf(chunk.payload));
  head.put(checksumOf(head));
  std::vector<char> bytes = head.bytes();
  bytes.insert(bytes.end(), chunk.payload.bytes().begin(), chunk.payload.bytes().end());
  return bytes;
}

std::string recordingHeader(const std::string& device)
{
  const std::string text =
    std::string(recordingMagic) + std::to_string(Recording::formatVersion) +
    "\nunits: seconds, metres and newtons in the device frame; scene units in the scene\ndevice: " + device +
    "\nbinary: little-endian chunks (name of " + std::to_string(ChunkKind::nameSize) +
    " bytes, version u32, size u64, number u64, CRC-32C of the payload u32, CRC-32C of this head u32, payload)" +
    std::string(headerCheck);
  return text + checkDigits(crc32c(text.data(), text.size())) + std::string(headerEnd);
}

NewChunk startChunk(const HapticParameters& parameters, const RendererState& state)
{
  ByteWriter payload;
  putPart(payload, parametersPart, bytesOf(parameters));
  ByteWriter first;
  putState(first, state);
  putPart(payload, statePart, first);
  return { chunks::start, std::move(payload) };
}

NewChunk tickChunk(const TickRecord& record)
{
  ByteWriter payload;
  inputFields(Put{ payload }, record);
  outputFields(Put{ payload }, record);
  return { chunks::tick, std::move(payload) };
}

NewChunk changeChunk(const RecordedChange& change)
{
  ByteWriter payload;
  layChange(Put{ payload }, change);
  if (change.parameters)
  {
    putPart(payload, parametersPart, bytesOf(*change.parameters));
  }
  return { chunks::change, std::move(payload) };
}

NewChunk endChunk(std::uint64_t lost)
{
  ByteWriter payload;
  payload.put(lost);
  return { chunks::end, std::move(payload) };
}

} // namespace palpate
