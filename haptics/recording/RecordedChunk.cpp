// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordedChunk.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "haptics/core/Checksum.h"
#include "haptics/recording/NamedParts.h"
#include "haptics/recording/RecordedStages.h"

namespace palpate
{
namespace
{

void readStart(RecordedChunk& chunk, Recording& recording)
{
  while (chunk.payload.ok() && chunk.payload.left() > 0)
  {
    NamedPart part = nextPart(chunk.payload);
    if (part.name == parametersPart)
    {
      getParameters(part.payload, recording.parameters);
    }
    else if (part.name == statePart)
    {
      getState(part.payload, recording.initialState);
    }
    else
    {
      chunk.payload.fail();
    }
    chunk.payload.failUnless(part.payload.ok());
  }
}

void readTick(RecordedChunk& chunk, Recording& recording)
{
  TickRecord record;
  inputFields(Get{ chunk.payload }, record);
  outputFields(Get{ chunk.payload }, record);
  recording.entries.emplace_back(record);
}

void readChange(RecordedChunk& chunk, Recording& recording)
{
  RecordedChange change;
  ByteReader& in = chunk.payload;
  layChange(Get{ in }, change);
  while (in.ok() && in.left() > 0)
  {
    NamedPart part = nextPart(in);
    in.failUnless(part.name == parametersPart);
    getParameters(part.payload, change.parameters.emplace());
    in.failUnless(part.payload.ok());
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

/// Whether the next four bytes are the checksum of the bytes from `begin` up to them. At the end of the bytes no
/// checksum is wrong.
bool isNextCheck(ByteReader& in, const char* begin)
{
  const char* const end = in.at();
  std::uint32_t check = 0;
  in.get(check);
  return !in.ok() || check == crc32c(begin, static_cast<std::size_t>(end - begin));
}

} // namespace

RecordedChunk nextChunk(ByteReader& in)
{
  RecordedChunk chunk;
  std::uint64_t size = 0;
  std::uint32_t payloadCheck = 0;
  const char* const head = in.at();
  readHead(in, chunk);
  in.get(size);
  in.get(chunk.number);
  in.get(payloadCheck);
  chunk.headDamaged = !isNextCheck(in, head);
  if (!chunk.headDamaged && in.has(size))
  {
    chunk.payload = ByteReader(in.at(), size);
    chunk.payloadDamaged = crc32c(in.at(), size) != payloadCheck;
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
        const auto read = [own](RecordedChunk& c, Recording& recording) { own.read(c.payload, recording); };
        found = isIt(own) ? std::optional(ChunkReader{ own.kind, read }) : found;
      }
    });
  return found;
}

} // namespace palpate
