// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/recording/Recording.h"
#include "testing/haptics/recording/RecordingChecks.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// A recording in whose file one bit after the other is flipped and put right again.
class FlippedBits
{
public:
  explicit FlippedBits(const std::string& path)
  {
    this->bytes_ = bytesOf(path);
    EXPECT_EQ(this->problem(), "");
    const std::vector<std::size_t> begins = chunkBegins(this->bytes_);
    for (std::size_t i = 1; i < begins.size(); ++i)
    {
      this->chunks_.push_back({ begins[i - 1], begins[i] });
    }
    EXPECT_GT(this->chunks_.size(), 2u) << "a start, something and an end";
  }

  /// Every bit of the text and of the first and the last head, one in the head and one anywhere in each of `count`
  /// chunks, `count` bits anywhere and as many in the first chunk of a kind that the recording has to have: each is
  /// found, and said with the chunk that it lies in.
  void expectEachIsNamed(std::uint64_t seed, const std::string& kind, int count = 300)
  {
    Random random(seed);
    this->expectAllNamed(0, this->chunks_.front().begin + checkedHead);
    this->expectAllNamed(this->chunks_.back().begin, this->bytes_.size());
    this->expectSomeNamed(this->firstOf(kind), random, count);
    this->expectSomeNamed({ 0, this->bytes_.size() }, random, count);
    for (int i = 0; i < count; ++i)
    {
      const Extent& chunk = this->chunks_[random.below(static_cast<std::uint32_t>(this->chunks_.size()))];
      this->expectSomeNamed({ chunk.begin, chunk.begin + checkedHead }, random, 1);
      this->expectSomeNamed(chunk, random, 1);
    }
  }

private:
  struct Extent
  {
    std::size_t begin = 0, end = 0; ///< bytes of the file
  };

  [[nodiscard]] std::string problem() const
  {
    const auto read = parseRecording(this->bytes_, "it");
    const auto* const problem = std::get_if<std::string>(&read);
    return problem != nullptr ? *problem : "";
  }

  [[nodiscard]] Extent firstOf(const std::string& kind) const
  {
    for (const Extent& chunk : this->chunks_)
    {
      if (kind == std::string(this->bytes_.data() + chunk.begin))
      {
        return chunk;
      }
    }
    ADD_FAILURE() << "the recording has no " << kind;
    return this->chunks_.front();
  }

  void expectSomeNamed(const Extent& where, Random& random, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      const auto size = static_cast<std::uint32_t>(where.end - where.begin);
      this->expectNamed(where.begin + random.below(size), static_cast<int>(random.below(8)));
    }
  }

  void expectAllNamed(std::size_t begin, std::size_t end)
  {
    for (std::size_t at = begin; at < end; ++at)
    {
      for (int bit = 0; bit < 8; ++bit)
      {
        this->expectNamed(at, bit);
      }
    }
  }

  void expectNamed(std::size_t at, int bit)
  {
    const std::string wanted = this->nameOf(at);
    this->bytes_[at] = static_cast<char>(this->bytes_[at] ^ 1 << bit);
    const std::string said = this->problem();
    this->bytes_[at] = static_cast<char>(this->bytes_[at] ^ 1 << bit);
    EXPECT_NE(said.find(wanted), std::string::npos) << "bit " << bit << " of byte " << at << ": " << said;
    EXPECT_NE(said.find("damaged"), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }

  /// The name of the part that has a byte.
  [[nodiscard]] std::string nameOf(std::size_t at) const
  {
    if (at < this->chunks_.front().begin)
    {
      return at < std::strlen("PALPATE-RECORDING ") ? "is not a recording of Palpate" : "its header";
    }
    std::size_t i = 0;
    while (at >= this->chunks_[i].end)
    {
      ++i;
    }
    const auto [begin, end] = this->chunks_[i];
    const std::string number = std::to_string(i + 1), from = ", bytes " + std::to_string(begin) + " to ";
    if (at < begin + checkedHead)
    {
      return "is damaged: the head of its chunk " + number;
    }
    return "is damaged: its chunk " + number + " (" + std::string(this->bytes_.data() + begin) + ")" + from +
           std::to_string(end - 1) + ",";
  }

  std::vector<char> bytes_;
  std::vector<Extent> chunks_;
};

} // namespace palpate::test
