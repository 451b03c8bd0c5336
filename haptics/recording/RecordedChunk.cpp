// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordedChunk.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "haptics/core/Checksum.h"
#include "haptics/recording/Format5.h"
#include "haptics/recording/NamedParts.h"
#include "haptics/recording/RecordedStages.h"

namespace palpate
{
namespace
{

constexpr std::uint32_t versionWithPose = 2; ///< of a tick

void readStart(RecordedChunk& chunk, Recording& recording)
{
  while (chunk.payload.ok() && chunk.payload.left() > 0)
  {
    NamedPart part = nextPart(chunk.payload);
    if (part.name == parametersPart)
    {
      getParameters(part.payload, recording.parameters, recording.skipped);
    }
    else if (part.name == statePart)
    {
      getState(part.payload, recording.initialState, recording.skipped);
    }
    else
    {
      recording.skipped.note(part.name);
    }
    chunk.payload.failUnless(part.payload.ok());
  }
}

void readTick(RecordedChunk& chunk, Recording& recording)
{
  TickRecord record;
  inputFields(Get{ chunk.payload }, record);
  outputFields(Get{ chunk.payload }, record);
  if (chunk.version >= versionWithPose)
  {
    poseFields(Get{ chunk.payload }, record.pose.emplace());
  }
  recording.entries.emplace_back(record);
}

void readParameters5(ByteReader& in, RecordedChange& change)
{
  bool hasParameters = false;
  in.get(hasParameters);
  if (hasParameters)
  {
    getParameters5(in, change.parameters.emplace());
  }
}

void readParts(ByteReader& in, RecordedChange& change, SkippedParts& skipped)
{
  while (in.ok() && in.left() > 0)
  {
    NamedPart part = nextPart(in);
    if (part.name == parametersPart)
    {
      getParameters(part.payload, change.parameters.emplace(), skipped);
      in.failUnless(part.payload.ok());
    }
    else
    {
      skipped.note(part.name);
    }
  }
}

void readChange(RecordedChunk& chunk, Recording& recording)
{
  RecordedChange change;
  ByteReader& in = chunk.payload;
  layChange(Get{ in }, change);
  if (chunk.version == RecordedChunk::versionInFormat5)
  {
    readParameters5(in, change);
  }
  else
  {
    readParts(in, change, recording.skipped);
  }
  in.failUnless(!change.parameters || change.parameters->validate().empty());
  recording.entries.emplace_back(std::move(change));
}

const ChunkReader readers[] = {
  { chunks::start, readStart },
  { chunks::tick, readTick },
  { chunks::change, readChange },
  { chunks::end, [](RecordedChunk& c, Recording& recording) { c.payload.get(recording.lost); } },
};

void readHead5(ByteReader& in, RecordedChunk& chunk)
{
  std::uint32_t number = 0;
  in.get(number);
  chunk.name = chunkName5(number);
  chunk.version = RecordedChunk::versionInFormat5;
}

void readHead(ByteReader& in, RecordedChunk& chunk)
{
  for (std::size_t i = 0; i < ChunkKind::nameSize; ++i)
  {
    char letter = 0;
    in.get(letter);
    chunk.name += letter;
  }
  chunk.name.erase(std::min(chunk.name.find('\0'), chunk.name.size()));
  in.get(chunk.version);
}

/// Whether what comes next is the checksum of the bytes from `begin` up to it. Where nothing comes it is none that is
/// wrong.
bool isNextCheck(ByteReader& in, const char* begin)
{
  const char* const end = in.at();
  std::uint32_t check = 0;
  in.get(check);
  return !in.ok() || check == crc32c(begin, static_cast<std::size_t>(end - begin));
}

} // namespace

RecordedChunk nextChunk(ByteReader& in, int format)
{
  RecordedChunk chunk;
  std::uint64_t size = 0;
  std::uint32_t payloadCheck = 0;
  const char* const head = in.at();
  const bool checked = format >= Recording::checkedFormatVersion;
  format == 5 ? readHead5(in, chunk) : readHead(in, chunk);
  in.get(size);
  if (checked)
  {
    in.get(payloadCheck);
    chunk.headDamaged = !isNextCheck(in, head);
  }
  if (!chunk.headDamaged && in.has(size))
  {
    chunk.payload = ByteReader(in.at(), size);
    chunk.payloadDamaged = checked && crc32c(in.at(), size) != payloadCheck;
    in.skip(size);
  }
  return chunk;
}

std::optional<ChunkReader> readerOf(const std::string& name)
{
  const auto isIt = [&name](const auto& reader) { return reader.kind.name == name; };
  const auto* const reader = std::find_if(std::begin(readers), std::end(readers), isIt);
  std::optional<ChunkReader> found = reader != std::end(readers) ? std::optional(*reader) : std::nullopt;
  TickInputs::forEach(
    [&]<class K>(std::type_identity<K>)
    {
      for (const input::InputReader<K>& own : input::readersOf<K>())
      {
        const auto read = [own](RecordedChunk& c, Recording& recording) { own.read(c.payload, c.version, recording); };
        found = isIt(own) ? std::optional(ChunkReader{ own.kind, read }) : found;
      }
    });
  return found;
}

} // namespace palpate
