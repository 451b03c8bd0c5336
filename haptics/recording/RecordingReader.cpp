// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include "haptics/recording/Format5.h"
#include "haptics/recording/NamedParts.h"
#include "haptics/recording/RecordedScenes.h"
#include "haptics/recording/RecordedStages.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/RecordingLayout.h"

namespace palpate
{
namespace
{

constexpr std::uint32_t versionInFormat5 = 0; // of every chunk

const char* const cutShort = "is cut short: it ends without its closing mark";
const char* const impossible = "is damaged: its initial state cannot be";

struct Chunk
{
  std::string name;
  std::uint32_t version = 0;
  ByteReader payload{ nullptr, 0 };
};

/// Features and history of an untrusted state must not be used as indices; a recording starts without them.
bool isPossible(const Recording& recording)
{
  const RendererState& state = recording.initialState;
  return state.contact.count == 0 && state.velocity.count == 0 && !state.tracked &&
         state.engage <= EngageState::Fault && state.game.phase <= GamePhase::Rests &&
         recording.parameters.validate().empty();
}

void readStart(Chunk& chunk, Recording& recording)
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

void readTick(Chunk& chunk, Recording& recording)
{
  TickRecord record;
  inputFields(Get{ chunk.payload }, record);
  outputFields(Get{ chunk.payload }, record);
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

void readChange(Chunk& chunk, Recording& recording)
{
  RecordedChange change;
  ByteReader& in = chunk.payload;
  layChange(Get{ in }, change);
  if (chunk.version == versionInFormat5)
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

struct ChunkReader
{
  const ChunkKind& kind;
  void (*read)(Chunk&, Recording&);
};

constexpr ChunkReader readers[] = {
  { chunks::start, readStart },
  { chunks::tick, readTick },
  { chunks::change, readChange },
  { chunks::scene, [](Chunk& c, Recording& recording) { recording.scenes.push_back(readScene(c.payload)); } },
  { chunks::motion, [](Chunk& c, Recording& recording) { recording.motions.push_back(readMotion(c.payload)); } },
  { chunks::end, [](Chunk& c, Recording& recording) { c.payload.get(recording.lost); } },
};

void readHead5(ByteReader& in, Chunk& chunk)
{
  std::uint32_t number = 0;
  in.get(number);
  chunk.name = chunkName5(number);
  chunk.version = versionInFormat5;
}

void readHead(ByteReader& in, Chunk& chunk)
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

/// Reads chunks until the closing one.
class ChunkParser
{
public:
  ChunkParser(Recording& recording, bool isFormat5) : recording_(recording), isFormat5_(isFormat5) {}

  /// Empty, or what is wrong.
  std::string parse(ByteReader& in)
  {
    bool first = !this->isFormat5_;
    while (in.ok())
    {
      Chunk chunk = this->next(in);
      if (!in.ok())
      {
        return cutShort;
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
  [[nodiscard]] Chunk next(ByteReader& in) const
  {
    Chunk chunk;
    std::uint64_t size = 0;
    this->isFormat5_ ? readHead5(in, chunk) : readHead(in, chunk);
    in.get(size);
    if (in.has(size))
    {
      chunk.payload = ByteReader(in.at(), size);
      in.skip(size);
    }
    return chunk;
  }

  std::string take(Chunk& chunk)
  {
    if (!isPartName(chunk.name))
    {
      return "is damaged: it has a part of unknown kind";
    }
    const auto* const reader = std::find_if(
      std::begin(readers), std::end(readers), [&chunk](const ChunkReader& r) { return r.kind.name == chunk.name; });
    if (reader == std::end(readers))
    {
      this->recording_.skipped.note(chunk.name);
      return {};
    }
    reader->read(chunk, this->recording_);
    const bool newer = chunk.version > reader->kind.version;
    if (!chunk.payload.ok() || (chunk.payload.left() != 0 && !newer))
    {
      return "is damaged: a part of kind " + chunk.name + " is not what it should be";
    }
    if (chunk.payload.left() != 0)
    {
      this->recording_.skipped.note("end of " + chunk.name);
    }
    return reader->kind.name == chunks::start.name && !isPossible(this->recording_) ? impossible : "";
  }

  Recording& recording_;
  bool isFormat5_;
};

/// What stands before the chunks; empty, or what is wrong.
std::string readStart5(ByteReader& in, Recording& recording)
{
  getParameters5(in, recording.parameters);
  getState5(in, recording.initialState);
  return !in.ok() ? "is cut short: its header does not end" : isPossible(recording) ? "" : impossible;
}

/// The number of a format that this program reads; none: another one.
std::optional<int> formatOf(const std::string& version)
{
  for (int format = Recording::oldestFormatVersion; format <= Recording::formatVersion; ++format)
  {
    if (version == std::to_string(format))
    {
      return format;
    }
  }
  return std::nullopt;
}

std::string deviceIn(const std::string& header)
{
  const std::string field = "\ndevice: ";
  const std::size_t at = header.find(field);
  return at == std::string::npos
           ? ""
           : header.substr(at + field.size(), header.find('\n', at + field.size()) - at - field.size());
}

} // namespace

std::variant<Recording, std::string> parseRecording(const std::vector<char>& bytes, const std::string& name)
{
  const std::string text(
    bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(bytes.size(), 4096)));
  if (!text.starts_with(recordingMagic))
  {
    return name + " is not a recording of Palpate";
  }
  const std::string version = text.substr(recordingMagic.size(), text.find('\n') - recordingMagic.size());
  const std::optional<int> format = formatOf(version);
  if (!format)
  {
    return name + " is a recording of format " + version.substr(0, 16) + ", this program reads format " +
           std::to_string(Recording::formatVersion) + " and back to " + std::to_string(Recording::oldestFormatVersion) +
           ": record it again";
  }
  const std::string headerEnd = "\nend\n";
  const std::size_t end = text.find(headerEnd);
  if (end == std::string::npos)
  {
    return name + " is cut short: its header does not end";
  }
  Recording recording;
  recording.device = deviceIn(text.substr(0, end + 1));
  const std::size_t begin = end + headerEnd.size();
  ByteReader in(bytes.data() + begin, bytes.size() - begin);
  const bool isFormat5 = *format == 5;
  std::string wrong = isFormat5 ? readStart5(in, recording) : "";
  if (wrong.empty())
  {
    wrong = ChunkParser(recording, isFormat5).parse(in);
  }
  if (!wrong.empty())
  {
    return name + " " + wrong;
  }
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
