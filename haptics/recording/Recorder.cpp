// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/Recorder.h"

#include <chrono>
#include <cstdio>

#include "haptics/recording/RecordingChunks.h"

namespace palpate
{
namespace
{

std::string temporaryOf(const std::string& path)
{
  return path + ".part";
}

} // namespace

std::string Recorder::open(const std::string& path, const std::string& device, const HapticParameters& parameters,
  const RendererState& state, bool background)
{
  this->close();
  this->path_ = path;
  this->ring_ = std::make_unique<SpscRing<Entry, 8192>>();
  this->stored_.clear();
  this->file_.open(temporaryOf(path), std::ios::binary | std::ios::trunc);
  if (!this->file_)
  {
    return path + " cannot be written: choose a folder that can";
  }
  const std::string header = recordingHeader(device);
  this->file_.write(header.data(), static_cast<std::streamsize>(header.size()));
  this->write(startChunk(parameters, state));
  if (background)
  {
    this->writer_ = std::jthread(
      [this](const std::stop_token& stop)
      {
        while (!stop.stop_requested())
        {
          this->pump();
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
      });
  }
  return {};
}

std::string Recorder::close()
{
  if (!this->isOpen())
  {
    return {};
  }
  if (this->writer_.joinable())
  {
    this->writer_.request_stop();
    this->writer_.join();
  }
  this->pump();
  this->write(endChunk(this->ring_->refused()));
  const bool good = this->file_.good();
  this->file_.close();
  if (!good || std::rename(temporaryOf(this->path_).c_str(), this->path_.c_str()) != 0)
  {
    return this->path_ + " could not be written to its end: is the disk full?";
  }
  return {};
}

void Recorder::pushTick(const TickRecord& record) noexcept
{
  Entry entry;
  entry.tick = record;
  this->ring_->tryPush(entry);
}

void Recorder::pushEvent(const HapticEvent& event) noexcept
{
  Entry entry;
  entry.kind = EntryKind::Change;
  entry.event = event;
  this->ring_->tryPush(entry);
}

void Recorder::pushParameters(std::uint64_t tick, const HapticParameters& parameters) noexcept
{
  Entry entry;
  entry.kind = EntryKind::Parameters;
  entry.event = { tick, EventKind::Parameters, 0 };
  entry.parameters = parameters;
  this->ring_->tryPush(entry);
}

void Recorder::pushScene(std::uint64_t tick, const Scene* scene) noexcept
{
  Entry entry;
  entry.kind = EntryKind::Change;
  entry.event = { tick, EventKind::Scene, 0 };
  entry.sceneHash = scene != nullptr ? scene->contentHash() : 0;
  entry.sceneRevision = scene != nullptr ? scene->revision() : 0;
  this->ring_->tryPush(entry);
}

void Recorder::pushBrick(std::uint64_t tick, const Brick* brick) noexcept
{
  this->pushEvent({ tick, EventKind::Brick, brick != nullptr ? brick->contentHash() : 0 });
}

void Recorder::storeBrick(const std::shared_ptr<const Brick>& brick)
{
  if (this->isOpen() && brick && this->stored_.insert(brick->contentHash()).second)
  {
    this->write(brickChunk(*brick));
  }
}

void Recorder::storeScene(const std::shared_ptr<const Scene>& scene)
{
  if (!this->isOpen() || !scene)
  {
    return;
  }
  if (this->stored_.insert(scene->geometryHash()).second)
  {
    this->write(sceneChunk(*scene));
  }
  if (scene->moves() && this->stored_.insert(scene->contentHash()).second)
  {
    this->write(motionChunk(*scene));
  }
}

void Recorder::write(const std::vector<char>& chunk)
{
  const std::lock_guard lock(this->fileMutex_);
  this->file_.write(chunk.data(), static_cast<std::streamsize>(chunk.size()));
}

void Recorder::writeEntry(const Entry& entry)
{
  if (entry.kind == EntryKind::Tick)
  {
    this->write(tickChunk(entry.tick));
    return;
  }
  RecordedChange change{ entry.event, std::nullopt, entry.sceneHash, entry.sceneRevision };
  if (entry.kind == EntryKind::Parameters)
  {
    change.parameters = entry.parameters;
  }
  this->write(changeChunk(change));
}

void Recorder::pump()
{
  Entry entry;
  while (this->ring_->tryPop(entry))
  {
    this->writeEntry(entry);
  }
}

} // namespace palpate
