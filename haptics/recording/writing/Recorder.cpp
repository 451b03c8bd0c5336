// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/writing/Recorder.h"

#include <chrono>
#include <utility>

#include "haptics/recording/RecordingChunks.h"

namespace palpate
{
std::string Recorder::open(const std::string& path, const std::string& device, bool background)
{
  this->close();
  this->ring_ = std::make_unique<SpscRing<Entry, 8192>>();
  this->stored_ = {};
  this->started_ = false;
  this->ended_ = false;
  std::string problem = this->file_.open(path, recordingHeader(device));
  if (problem.empty() && background)
  {
    this->writer_ = std::jthread(
      [this](const std::stop_token& stop)
      {
        while (!stop.stop_requested() && !this->hasEnded())
        {
          this->pump();
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
      });
  }
  return problem;
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
  if (!this->started_)
  {
    this->writeStart(HapticParameters{}); // no tick came
  }
  this->writeStored();
  std::uint64_t lost = this->ring_->refused();
  TickInputs::forEach([this, &lost]<input::ComesByValue K>(std::type_identity<K>)
    { lost += std::get<input::Stored<K>>(this->stored_).values->refused(); });
  return this->file_.close(endChunk(lost));
}

bool Recorder::pushStart(const HapticParameters& parameters, const RendererState& state) noexcept
{
  this->first_ = state;
  return this->ring_->tryPush({ EntryKind::Start, {}, {}, {}, parameters });
}

bool Recorder::pushEnd() noexcept
{
  return this->ring_->tryPush({ EntryKind::End, {}, {}, {}, {} });
}

void Recorder::pushTick(const TickRecord& record) noexcept
{
  this->ring_->tryPush({ EntryKind::Tick, record, {}, {}, {} });
}

void Recorder::pushEvent(const HapticEvent& event, const input::RecordedName& name) noexcept
{
  this->ring_->tryPush({ EntryKind::Change, {}, event, name, {} });
}

void Recorder::pushParameters(std::uint64_t tick, const HapticParameters& parameters) noexcept
{
  this->ring_->tryPush({ EntryKind::Parameters, {}, { tick, EventKind::Parameters, 0 }, {}, parameters });
}

template<class K>
void Recorder::writeChunk(
  const ChunkKind& kind, const typename K::Value& value, void (*write)(ByteWriter&, const typename K::Value&))
{
  ByteWriter payload;
  write(payload, value);
  this->file_.write({ kind, std::move(payload) });
}

/// After the first chunk, which says how to read them.
void Recorder::writeStored()
{
  TickInputs::forEach([this]<class K>(std::type_identity<K>) requires(!input::ComesByValue<K>) {
    input::Stored<K>& stored = std::get<input::Stored<K>>(this->stored_);
    std::vector<std::shared_ptr<const typename K::Value>> waiting;
    {
      const std::lock_guard lock(this->storedMutex_);
      waiting.swap(stored.waiting);
    }
    for (const auto& value : waiting)
    {
      const auto write = [&](
                           std::uint64_t id, const ChunkKind& kind, void (*put)(ByteWriter&, const typename K::Value&))
      {
        if (stored.written.insert(id).second)
        {
          this->writeChunk<K>(kind, *value, put);
        }
      };
      input::forEachChunk<K>(*value, write);
    }
  });
}

/// A value that came through a ring lies before its event.
void Recorder::writeValueOf(const HapticEvent& event)
{
  TickInputs::forEach(
    [&]<input::ComesByValue K>(std::type_identity<K>)
    {
      typename K::Value value;
      if (event.kind == K::event && event.value != 0 && std::get<input::Stored<K>>(this->stored_).values->tryPop(value))
      {
        this->writeChunk<K>(K::chunk, value, K::write);
      }
    });
}

void Recorder::writeStart(const HapticParameters& parameters)
{
  this->file_.write(startChunk(parameters, this->first_));
  this->started_ = true;
}

void Recorder::writeEntry(const Entry& entry)
{
  if (entry.kind == EntryKind::Start)
  {
    this->writeStart(entry.parameters);
    return;
  }
  if (entry.kind == EntryKind::Tick)
  {
    this->file_.write(tickChunk(entry.tick));
    return;
  }
  this->writeValueOf(entry.event);
  RecordedChange change{ entry.event, std::nullopt, entry.name.sceneHash, entry.name.sceneRevision };
  if (entry.kind == EntryKind::Parameters)
  {
    change.parameters = entry.parameters;
  }
  this->file_.write(changeChunk(change));
}

void Recorder::pump()
{
  Entry entry;
  bool ended = false;
  while (!ended && this->ring_->tryPop(entry))
  {
    ended = entry.kind == EntryKind::End;
    if (!ended)
    {
      this->writeEntry(entry);
    }
  }
  if (this->started_)
  {
    this->writeStored();
  }
  this->file_.flush();
  this->ended_.store(ended || this->hasEnded(), std::memory_order_release);
}

} // namespace palpate
