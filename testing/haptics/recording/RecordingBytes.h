// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "testing/haptics/recording/RecordingChecks.h"

namespace palpate::test
{

/// A chunk as it lies in a file: 8 letters filled up with zeros, version u32, size u64, number u64, two
/// checksums u32, payload.
struct RawChunk
{
  std::string name;
  std::uint32_t version = 1;
  std::string payload;
};

/// A recording taken apart without the reader that is under test.
struct RawRecording
{
  std::string header;
  std::vector<RawChunk> chunks;
};

template<class T>
std::string raw(T number)
{
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &number, sizeof(T));
  return bytes;
}

/// A named part: length u32, name, size u32, payload.
inline std::string rawPart(const std::string& name, const std::string& payload)
{
  return raw(static_cast<std::uint32_t>(name.size())) + name + raw(static_cast<std::uint32_t>(payload.size())) +
         payload;
}

inline RawRecording takeApart(const std::string& path)
{
  const std::vector<char> content = bytesOf(path);
  const std::string bytes(content.begin(), content.end());
  RawRecording recording;
  std::size_t at = bytes.find("\nend\n") + 5;
  recording.header = bytes.substr(0, at);
  while (at < bytes.size())
  {
    RawChunk chunk;
    std::uint64_t size = 0;
    chunk.name = std::string(bytes.substr(at, 8).c_str());
    std::memcpy(&chunk.version, bytes.data() + at + 8, sizeof(chunk.version));
    std::memcpy(&size, bytes.data() + at + 12, sizeof(size));
    chunk.payload = bytes.substr(at + checkedHead, size);
    at += checkedHead + size;
    recording.chunks.push_back(std::move(chunk));
  }
  return recording;
}

/// With the numbers and the checksums that belong to its chunks.
inline std::vector<char> putTogether(const RawRecording& recording)
{
  std::string bytes = recording.header;
  std::uint64_t number = 0;
  for (const RawChunk& chunk : recording.chunks)
  {
    std::string name = chunk.name;
    name.resize(8, '\0');
    bytes += name + raw(chunk.version) + raw(static_cast<std::uint64_t>(chunk.payload.size())) + raw(++number) +
             std::string(checkedHead - uncheckedHead, '\0') + chunk.payload;
  }
  std::vector<char> checked(bytes.begin(), bytes.end());
  repairChecks(checked, plainCrc32c);
  return checked;
}

} // namespace palpate::test
