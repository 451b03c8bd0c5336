// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/writing/RecordingFile.h"

#include <cstdio>
#include <filesystem>
#include <system_error>
#include <vector>

#include "haptics/recording/RecordingChunks.h"

namespace palpate
{
namespace
{

/// More than a closing chunk takes: the end of a full disk's file is cut off by so much for that chunk.
constexpr std::uint64_t roomForEnd = 256;

} // namespace

std::string RecordingFile::open(const std::string& path, const std::string& header)
{
  this->path_ = path;
  this->given_ = this->there_ = this->chunks_ = 0;
  this->ends_.clear();
  this->full_ = this->kept_ = false;
  this->file_.open(this->temporary(), std::ios::binary | std::ios::trunc);
  if (!this->file_)
  {
    this->file_.clear();
    this->path_.clear();
    return path + " cannot be written: choose a folder that can";
  }
  this->put(header.data(), header.size());
  return {};
}

void RecordingFile::put(const char* bytes, std::size_t size)
{
  if (!this->isFull())
  {
    this->file_.write(bytes, static_cast<std::streamsize>(size));
    this->given_ += size;
    this->checkDisk();
  }
}

/// The size is asked for before the stream is closed, which would try to write the failed bytes once more.
void RecordingFile::checkDisk()
{
  if (!this->file_.good())
  {
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(this->temporary(), unknown);
    this->there_ = unknown ? 0 : size;
    this->full_.store(true, std::memory_order_relaxed);
  }
}

void RecordingFile::write(const NewChunk& chunk)
{
  const std::vector<char> bytes = recordedChunk(chunk, ++this->chunks_);
  this->put(bytes.data(), bytes.size());
  this->ends_.push_back(this->given_);
}

void RecordingFile::flush()
{
  if (this->isFull())
  {
    return;
  }
  this->file_.flush();
  this->checkDisk();
  while (!this->isFull() && this->ends_.size() > 1 && this->ends_[1] + roomForEnd <= this->given_)
  {
    this->ends_.pop_front();
  }
}

/// To the end of a chunk after which a full disk has space. False if there is no such chunk.
bool RecordingFile::cutBack(std::size_t room)
{
  while (!this->ends_.empty() && this->ends_.back() + room > this->there_)
  {
    this->ends_.pop_back();
    --this->chunks_;
  }
  std::error_code failed;
  if (!this->ends_.empty())
  {
    std::filesystem::resize_file(this->temporary(), this->ends_.back(), failed);
    this->file_.open(this->temporary(), std::ios::binary | std::ios::app);
  }
  return !this->ends_.empty() && !failed && this->file_.good();
}

std::string RecordingFile::close(const NewChunk& endChunk)
{
  this->write(endChunk);
  this->flush();
  this->file_.close();
  this->file_.clear();
  bool whole = true;
  if (this->isFull())
  {
    whole = this->cutBack(recordedChunk(endChunk, this->chunks_).size());
    const std::vector<char> bytes = recordedChunk(endChunk, this->chunks_ + 1);
    this->file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    this->file_.close();
    whole = whole && this->file_.good();
    this->file_.clear();
  }
  this->kept_ = whole && std::rename(this->temporary().c_str(), this->path_.c_str()) == 0;
  const std::string path = std::move(this->path_);
  this->path_.clear();
  if (!this->kept_)
  {
    return path + " could not be written to its end: is the disk full?";
  }
  return this->isFull() ? path + " could not grow, because the disk is full: the recording up to this point is kept"
                        : "";
}

} // namespace palpate
