// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <tuple>

#include "haptics/session/HapticSession.h"
#include "haptics/session/background/WorkerList.h"
#include "haptics/session/mechanism/LooseSources.h"
#include "haptics/session/mechanism/MechanismWorker.h"
#include "haptics/session/soft/SoftWorker.h"
#include "haptics/session/tool/ToolWorker.h"

namespace palpate
{

class PressingTool;

using SessionTasks = WorkerList<ToolTask, SoftTask, MechanismTask>;

struct SessionWorkers : SessionTasks
{
  using SessionTasks::SessionTasks;
};

/// The choices that the workers compute.
struct HapticSession::Chosen : SessionTasks::Choices
{
  Chosen();
  ~Chosen();
  std::unique_ptr<PressingTool> pressing; ///< of tool, soft body and loose sources
  LooseSources loose;
};

template<class Task>
void HapticSession::choose(const typename Task::Choice& choice)
{
  const Holding before = this->holding();
  std::get<typename Task::Choice>(*this->chosen_) = choice;
  this->pairTool();
  this->followChoice(Task::isHeld || before != this->holding());
}

template<class Task>
const typename Task::Choice& HapticSession::chosen() const noexcept
{
  return std::get<typename Task::Choice>(*this->chosen_);
}

template<class Task>
typename Task::Status HapticSession::status() const
{
  const SessionWorkers* const workers = this->workers();
  return workers != nullptr ? workers->template statusOf<Task>() : typename Task::Status();
}

} // namespace palpate
