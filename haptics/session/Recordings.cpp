// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/Recordings.h"

#include <utility>

namespace palpate
{

std::string Recordings::begin(const std::string& file, const std::string& device,
  const std::shared_ptr<const Scene>& scene, const std::shared_ptr<const Brick>& brick)
{
  auto next = std::make_unique<Recorder>();
  std::string problem = next->open(file, device, !this->virtualTime_);
  if (problem.empty())
  {
    this->end();
    this->current_ = Going{ file, std::move(next) };
    this->storeScene(scene);
    this->storeBrick(brick);
    this->link_.store(this->current_->recorder.get(), std::memory_order_release);
  }
  return problem;
}

void Recordings::end()
{
  if (this->current_)
  {
    this->link_.store(nullptr, std::memory_order_release);
    this->ending_.push_back(std::move(*this->current_));
    this->current_.reset();
  }
}

void Recordings::storeScene(const std::shared_ptr<const Scene>& scene)
{
  if (this->current_)
  {
    this->current_->recorder->storeScene(scene);
  }
}

void Recordings::storeBrick(const std::shared_ptr<const Brick>& brick)
{
  if (this->current_)
  {
    this->current_->recorder->storeBrick(brick);
  }
}

/// The servo may have taken what is stored before it saw the end of a recording.
template<class Store>
void Recordings::inEach(const Store& store)
{
  if (this->current_)
  {
    store(*this->current_->recorder);
  }
  for (const Going& going : this->ending_)
  {
    store(*going.recorder);
  }
}

void Recordings::storeBody(const std::shared_ptr<const PressedBody>& body)
{
  this->inEach([&body](Recorder& recorder) { recorder.storeBody(body); });
}

void Recordings::storeMechanism(const std::shared_ptr<const FeltMechanism>& mechanism)
{
  this->inEach([&mechanism](Recorder& recorder) { recorder.storeMechanism(mechanism); });
}

void Recordings::pump()
{
  this->inEach([](Recorder& recorder) { recorder.pump(); });
}

EndedRecording Recordings::close(const Going& going)
{
  std::string problem = going.recorder->close();
  return { going.recorder->isKept() ? going.file : std::string(), std::move(problem) };
}

std::optional<EndedRecording> Recordings::takeEnded()
{
  if (this->current_ && this->current_->recorder->isFull())
  {
    this->end();
  }
  if (this->ending_.empty() || !this->ending_.front().recorder->hasEnded())
  {
    return std::nullopt;
  }
  EndedRecording ended = close(this->ending_.front());
  this->ending_.erase(this->ending_.begin());
  return ended;
}

std::optional<EndedRecording> Recordings::finish()
{
  this->end();
  std::optional<EndedRecording> last;
  for (const Going& going : this->ending_)
  {
    EndedRecording ended = close(going);
    ended.problem = ended.problem.empty() && last ? last->problem : ended.problem;
    last = std::move(ended);
  }
  this->ending_.clear();
  return last;
}

} // namespace palpate
