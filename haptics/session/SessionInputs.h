// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "haptics/session/HapticSession.h"
#include "haptics/session/Recordings.h"
#include "haptics/session/ServoLoop.h"

namespace palpate
{

// The inputs of the tick are of every kind, and with their headers comes most of the core: callers that publish those
// with a method of their own need only HapticSession.h.

/// Over stop() and start(): the inputs that the owner published last, and the last reports.
struct HapticSession::Kept
{
  TickInputs::Each<input::OwnedInput> inputs;
  LoopReport report;
  ToolReport toolReport;
  std::optional<EndedRecording> recorded; ///< with the last run
};

template<class K>
void HapticSession::setInput(std::shared_ptr<const typename K::Value> value)
{
  std::get<input::OwnedInput<K>>(this->kept_->inputs).value = value;
  if (ServoLinks* const links = this->links())
  {
    this->recordings().store<K>(value);
    K::buffer(*links).publish(std::move(value));
  }
}

template<class K>
const std::shared_ptr<const typename K::Value>& HapticSession::inputNow() const noexcept
{
  return std::get<input::OwnedInput<K>>(this->kept_->inputs).value;
}

} // namespace palpate
