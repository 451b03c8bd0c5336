// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <variant>
#include <vector>

#include "haptics/recording/Recording.h"
#include "testing/haptics/recording/RecordingChecks.h"

namespace palpate::test
{

/// A recording whose chunks can be left out, repeated and exchanged, each with the bytes that were written.
class CutRecording
{
public:
  explicit CutRecording(const std::string& path) : bytes_(bytesOf(path)), begins_(chunkBegins(this->bytes_)) {}

  [[nodiscard]] std::size_t chunks() const { return this->begins_.size() - 1; }

  /// The sentence of the reader about the recording in which `instead` replaces the chunks from `from` up to `until`.
  [[nodiscard]] std::string problemOf(
    std::size_t from, std::size_t until, std::initializer_list<std::size_t> instead) const
  {
    std::vector<char> changed;
    this->append(changed, 0, this->begins_[from]);
    for (const std::size_t chunk : instead)
    {
      this->append(changed, this->begins_[chunk], this->begins_[chunk + 1]);
    }
    this->append(changed, this->begins_[until], this->bytes_.size());
    const auto read = parseRecording(changed, "it");
    const auto* const problem = std::get_if<std::string>(&read);
    return problem != nullptr ? *problem : "";
  }

private:
  void append(std::vector<char>& to, std::size_t begin, std::size_t end) const
  {
    to.insert(to.end(), this->bytes_.begin() + static_cast<std::ptrdiff_t>(begin),
      this->bytes_.begin() + static_cast<std::ptrdiff_t>(end));
  }

  std::vector<char> bytes_;
  std::vector<std::size_t> begins_;
};

} // namespace palpate::test
