// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include "haptics/recording/Format5.h"
#include "haptics/recording/NamedParts.h"
#include "haptics/recording/RecordedBricks.h"
#include "haptics/recording/RecordedChunk.h"
#include "haptics/recording/RecordedMechanisms.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/RecordingLayout.h"

namespace palpate
{
namespace
{

const char* const cutShort = "is cut short: it ends without its closing mark";
const char* const impossible = "is damaged: its initial state cannot be";

/// Features and history of an untrusted state must not be used as indices; a recording starts without them.
bool isPossible(const Recording& recording)
{
  const RendererState& state = recording.initialState;
  return state.contact.count == 0 && state.velocity.count == 0 && !state.tracked &&
         state.engage <= EngageState::Fault && state.game.phase <= GamePhase::Rests && isUsable(state.mechanism) &&
         recording.parameters.validate().empty();
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
      RecordedChunk chunk = nextChunk(in, this->isFormat5_);
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
  std::string take(RecordedChunk& chunk)
  {
    if (!isPartName(chunk.name))
    {
      return "is damaged: it has a part of unknown kind";
    }
    const ChunkReader* const reader = readerOf(chunk.name);
    if (reader == nullptr)
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

/// The text before the bytes.
struct Header
{
  std::string problem; ///< empty, or why it cannot be read
  int format = 0;
  std::string device;
  std::size_t size = 0;
};

std::string deviceIn(const std::string& text)
{
  const std::string field = "\ndevice: ";
  const std::size_t at = text.find(field);
  return at == std::string::npos ? "" : text.substr(at + field.size(), text.find('\n', at + 1) - at - field.size());
}

Header refused(std::string problem)
{
  return { std::move(problem), 0, "", 0 };
}

Header readHeader(const std::vector<char>& bytes)
{
  constexpr std::size_t longest = 4096;
  const std::string text(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), longest)));
  if (!text.starts_with(recordingMagic))
  {
    return refused("is not a recording of Palpate");
  }
  const std::string version = text.substr(recordingMagic.size(), text.find('\n') - recordingMagic.size());
  const std::optional<int> format = formatOf(version);
  if (!format)
  {
    return refused("is a recording of format " + version.substr(0, 16) + ", this program reads format " +
                   std::to_string(Recording::formatVersion) + " and back to " +
                   std::to_string(Recording::oldestFormatVersion) + ": record it again");
  }
  const std::string mark = "\nend\n";
  const std::size_t end = text.find(mark);
  if (end == std::string::npos)
  {
    return refused("is cut short: its header does not end");
  }
  return { "", *format, deviceIn(text.substr(0, end + 1)), end + mark.size() };
}

} // namespace

std::variant<Recording, std::string> parseRecording(const std::vector<char>& bytes, const std::string& name)
{
  const Header header = readHeader(bytes);
  std::string problem = header.problem;
  Recording recording;
  if (problem.empty())
  {
    const bool isFormat5 = header.format == 5;
    ByteReader in(bytes.data() + header.size, bytes.size() - header.size);
    recording.device = header.device;
    problem = isFormat5 ? readStart5(in, recording) : "";
    problem = problem.empty() ? ChunkParser(recording, isFormat5).parse(in) : problem;
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
