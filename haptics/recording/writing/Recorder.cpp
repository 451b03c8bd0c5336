// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/writing/Recorder.h"

#include <chrono>
#include <utility>

#include "haptics/recording/RecordingChunks.h"

namespace palpate
{
namespace
{

bool isTool(const HapticEvent& event) noexcept
{
  return event.kind == EventKind::Tool && event.value != 0;
}

} // namespace

std::string Recorder::open(const std::string& path, const std::string& device, bool background)
{
  this->close();
  this->ring_ = std::make_unique<SpscRing<Entry, 8192>>();
  this->tools_ = std::make_unique<SpscRing<ToolContacts, 1024>>();
  this->stored_.clear();
  this->scenes_.clear();
  this->bricks_.clear();
  this->bodies_.clear();
  this->storedBodies_.clear();
  this->mechanisms_.clear();
  this->storedMechanisms_.clear();
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
  this->writeScenes();
  return this->file_.close(endChunk(this->ring_->refused() + this->tools_->refused()));
}

bool Recorder::pushStart(const HapticParameters& parameters, const RendererState& state) noexcept
{
  this->first_ = state;
  Entry entry;
  entry.kind = EntryKind::Start;
  entry.parameters = parameters;
  return this->ring_->tryPush(entry);
}

bool Recorder::pushEnd() noexcept
{
  Entry entry;
  entry.kind = EntryKind::End;
  return this->ring_->tryPush(entry);
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

void Recorder::pushTool(std::uint64_t tick, const ToolContacts* contacts) noexcept
{
  if (contacts == nullptr || this->tools_->tryPush(*contacts))
  {
    this->pushEvent({ tick, EventKind::Tool, contacts != nullptr ? contacts->revision : 0 });
  }
}

void Recorder::pushBody(std::uint64_t tick, const PressedBody* body) noexcept
{
  this->pushEvent({ tick, EventKind::Body, body != nullptr ? body->revision : 0 });
}

void Recorder::pushMechanism(std::uint64_t tick, const FeltMechanism* mechanism) noexcept
{
  this->pushEvent({ tick, EventKind::Mechanism, mechanism != nullptr ? mechanism->revision() : 0 });
}

void Recorder::storeMechanism(const std::shared_ptr<const FeltMechanism>& mechanism)
{
  if (!this->isOpen())
  {
    return;
  }
  for (const auto& body : mechanism->bodies())
  {
    this->storeScene(body->scene);
  }
  const std::lock_guard lock(this->scenesMutex_);
  this->mechanisms_.push_back(mechanism);
}

void Recorder::storeBody(const std::shared_ptr<const PressedBody>& body)
{
  if (this->isOpen() && body)
  {
    this->storeScene(body->scene);
    const std::lock_guard lock(this->scenesMutex_);
    this->bodies_.push_back(body);
  }
}

void Recorder::storeBrick(const std::shared_ptr<const Brick>& brick)
{
  if (this->isOpen() && brick)
  {
    const std::lock_guard lock(this->scenesMutex_);
    this->bricks_.push_back(brick);
  }
}

void Recorder::storeScene(const std::shared_ptr<const Scene>& scene)
{
  if (this->isOpen() && scene)
  {
    const std::lock_guard lock(this->scenesMutex_);
    this->scenes_.push_back(scene);
  }
}

/// After the first chunk, which says how to read them.
void Recorder::writeScenes()
{
  std::vector<std::shared_ptr<const Scene>> scenes;
  std::vector<std::shared_ptr<const Brick>> bricks;
  std::vector<std::shared_ptr<const PressedBody>> bodies;
  std::vector<std::shared_ptr<const FeltMechanism>> mechanisms;
  {
    const std::lock_guard lock(this->scenesMutex_);
    scenes.swap(this->scenes_);
    bricks.swap(this->bricks_);
    bodies.swap(this->bodies_);
    mechanisms.swap(this->mechanisms_);
  }
  for (const auto& body : bodies)
  {
    if (this->storedBodies_.insert(body->revision).second)
    {
      this->file_.write(bodyChunk(*body));
    }
  }
  for (const auto& mechanism : mechanisms)
  {
    if (this->storedMechanisms_.insert(mechanism->revision()).second)
    {
      this->file_.write(mechanismChunk(*mechanism));
    }
  }
  for (const auto& brick : bricks)
  {
    if (this->stored_.insert(brick->contentHash()).second)
    {
      this->file_.write(brickChunk(*brick));
    }
  }
  for (const auto& scene : scenes)
  {
    if (this->stored_.insert(scene->geometryHash()).second)
    {
      this->file_.write(sceneChunk(*scene));
    }
    if (scene->moves() && this->stored_.insert(scene->contentHash()).second)
    {
      this->file_.write(motionChunk(*scene));
    }
  }
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
  if (ToolContacts contacts; isTool(entry.event) && this->tools_->tryPop(contacts))
  {
    this->file_.write(toolChunk(contacts));
  }
  RecordedChange change{ entry.event, std::nullopt, entry.sceneHash, entry.sceneRevision };
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
    this->writeScenes();
  }
  this->file_.flush();
  this->ended_.store(ended || this->hasEnded(), std::memory_order_release);
}

} // namespace palpate
