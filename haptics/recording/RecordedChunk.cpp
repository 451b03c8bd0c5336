// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordedChunk.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "haptics/core/Checksum.h"
#include "haptics/recording/Format5.h"
#include "haptics/recording/NamedParts.h"
#include "haptics/recording/RecordedBodies.h"
#include "haptics/recording/RecordedBricks.h"
#include "haptics/recording/RecordedMechanisms.h"
#include "haptics/recording/RecordedScenes.h"
#include "haptics/recording/RecordedStages.h"
#include "haptics/recording/RecordedTools.h"

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

void readBodyChunk(RecordedChunk& chunk, Recording& recording)
{
  constexpr std::uint32_t versionWithBeside = 2, versionWithKnots = 3, versionWithHeld = 4;
  std::shared_ptr<const PressedBody> body = readBody(chunk.payload);
  if (body && chunk.version >= versionWithBeside)
  {
    auto withBeside = std::make_shared<PressedBody>(*body);
    chunk.payload.get(withBeside->beside);
    if (chunk.version >= versionWithKnots)
    {
      readKnots(chunk.payload, *withBeside);
    }
    if (chunk.version >= versionWithHeld)
    {
      readHeld(chunk.payload, *withBeside);
    }
    body = chunk.payload.ok() ? std::move(withBeside) : nullptr;
  }
  recording.bodies.push_back(std::move(body));
}

constexpr ChunkReader readers[] = {
  { chunks::start, readStart },
  { chunks::tick, readTick },
  { chunks::change, readChange },
  { chunks::scene, [](RecordedChunk& c, Recording& recording) { recording.scenes.push_back(readScene(c.payload)); } },
  { chunks::motion,
    [](RecordedChunk& c, Recording& recording) { recording.motions.push_back(readMotion(c.payload)); } },
  { chunks::brick, [](RecordedChunk& c, Recording& recording) { recording.bricks.push_back(readBrick(c.payload)); } },
  { chunks::tool,
    [](RecordedChunk& c, Recording& recording) { recording.tools.push_back(readTool(c.payload, c.version)); } },
  { chunks::body, readBodyChunk },
  { chunks::mechanism,
    [](RecordedChunk& c, Recording& recording) { recording.mechanisms.push_back(readMechanism(c.payload)); } },
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

const ChunkReader* readerOf(const std::string& name)
{
  const auto* const reader =
    std::find_if(std::begin(readers), std::end(readers), [&name](const ChunkReader& r) { return r.kind.name == name; });
  return reader == std::end(readers) ? nullptr : reader;
}

} // namespace palpate
