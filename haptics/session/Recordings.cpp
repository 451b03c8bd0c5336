// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/Recordings.h"

#include <utility>

namespace palpate
{

std::string Recordings::begin(
  const std::string& file, const std::string& device, const TickInputs::Each<input::OwnedInput>& felt)
{
  auto next = std::make_unique<Recorder>();
  std::string problem = next->open(file, device, !this->virtualTime_);
  if (problem.empty())
  {
    this->end();
    this->current_ = Going{ file, std::move(next) };
    TickInputs::forEach([&]<input::ComesFromOwner K>(std::type_identity<K>)
      { this->current_->recorder->store<K>(std::get<input::OwnedInput<K>>(felt).value); });
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
