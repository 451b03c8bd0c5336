// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <iterator>
#include <utility>

#include "haptics/recording/NamedParts.h"
#include "haptics/recording/RecordedChunk.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/bytes/RecordingLayout.h"
#include "haptics/recording/reading/RecordingHeader.h"

namespace palpate
{
namespace
{

const char* const cutShort = "is cut short: it ends without its closing mark";
const char* const otherProgram = ", which this program does not know: read it with the program that recorded it";
const char* const impossible = "is damaged: its initial state cannot be";

/// Features and history of an untrusted state must not be used as indices; a recording starts without them.
bool isPossible(const Recording& recording)
{
  const RendererState& state = recording.initialState;
  return state.contact.count == 0 && state.velocity.count == 0 && !state.tracked &&
         state.engage <= EngageState::Fault && state.game.phase <= GamePhase::Rests && isUsable(state.mechanism) &&
         recording.parameters.validate().empty();
}

/// Says which chunk is damaged, by its number from 1 on, and where it lies, by its first byte and the first after it.
/// The name in a head that is damaged is said only if a kind has that name, for the name itself may be damaged.
std::string damageOf(const RecordedChunk& chunk, std::uint64_t number, std::size_t begin, std::size_t end)
{
  const std::string kind = !chunk.headDamaged || readerOf(chunk.name) ? " (" + chunk.name + ")" : "";
  const std::string which = "chunk " + std::to_string(number) + kind;
  const std::string bytes = "bytes " + std::to_string(begin) + " to " + std::to_string(end - 1);
  return std::string("is damaged: ") + (chunk.headDamaged ? "the head of its " : "its ") + which + ", " + bytes +
         ", is not as it was written" + otherCopy;
}

/// Says which chunk stands in the place of another one.
std::string orderOf(const RecordedChunk& chunk, std::uint64_t number)
{
  return "is damaged: in the place of its chunk " + std::to_string(number) + " stands its chunk " +
         std::to_string(chunk.number) + ", so chunks are missing, doubled or exchanged" + otherCopy;
}

/// Reads chunks until the closing one.
class ChunkParser
{
public:
  ChunkParser(Recording& recording, std::size_t fileSize) : recording_(recording), fileSize_(fileSize) {}

  /// Empty, or the fault.
  std::string parse(ByteReader& in)
  {
    bool first = true;
    for (std::uint64_t number = 1; in.ok(); ++number)
    {
      const std::size_t begin = this->fileSize_ - in.left();
      RecordedChunk chunk = nextChunk(in);
      if (!in.ok())
      {
        return cutShort;
      }
      if (chunk.headDamaged || chunk.payloadDamaged)
      {
        return damageOf(chunk, number, begin, this->fileSize_ - in.left());
      }
      if (chunk.number != number)
      {
        return orderOf(chunk, number);
      }
      if (first && chunk.name != chunks::start.name)
      {
        return "is damaged: it does not begin with its first parameters";
      }
      first = false;
      if (std::string problem = this->take(chunk); !problem.empty())
      {
        return problem;
      }
      if (chunk.name == chunks::end.name)
      {
        return in.left() == 0 ? "" : "is damaged: something follows its closing mark";
      }
    }
    return cutShort;
  }

private:
  std::string take(RecordedChunk& chunk)
  {
    if (!isPartName(chunk.name))
    {
      return "is damaged: it has a part of unknown kind";
    }
    const std::optional<ChunkReader> reader = readerOf(chunk.name);
    if (!reader)
    {
      return "has a part of kind " + chunk.name + otherProgram;
    }
    if (chunk.version != reader->kind.version)
    {
      return "has a part of kind " + chunk.name + " in version " + std::to_string(chunk.version) + otherProgram;
    }
    reader->read(chunk, this->recording_);
    if (!chunk.payload.ok() || chunk.payload.left() != 0)
    {
      return "is damaged: a part of kind " + chunk.name +
             " has unexpected content, or comes from another version of the program";
    }
    return reader->kind.name == chunks::start.name && !isPossible(this->recording_) ? impossible : "";
  }

  Recording& recording_;
  std::size_t fileSize_;
};

} // namespace

std::variant<Recording, std::string> parseRecording(const std::vector<char>& bytes, const std::string& name)
{
  const RecordingHeader header = readRecordingHeader(bytes);
  std::string problem = header.problem;
  Recording recording;
  if (problem.empty())
  {
    ByteReader in(bytes.data() + header.size, bytes.size() - header.size);
    recording.device = header.device;
    problem = ChunkParser(recording, bytes.size()).parse(in);
  }
  if (!problem.empty())
  {
    return name + " " + problem;
  }
  keepCellsWithin(recording.bricks, recording.initialState.field);
  return recording;
}

std::variant<Recording, std::string> readRecording(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    return path + " cannot be opened";
  }
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  return parseRecording(bytes, path);
}

} // namespace palpate
