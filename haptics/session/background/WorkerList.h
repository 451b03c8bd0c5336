// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <tuple>

#include "haptics/contact/view/LoadedRegion.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/mechanism/Mechanism.h"
#include "haptics/session/background/BackgroundWorker.h"

namespace palpate
{

/// The session as workers see it, beside the choices of a person.
struct WorkSurroundings
{
  std::shared_ptr<const Scene> scene; ///< that is touched
  LoadedRegion known;                 ///< how much of a whole that scene has
  MechanismGrip grip;                 ///< how the hand would hold a mechanism
  double period_s = 1e-3;             ///< of a tick
};

/// The workers of a session, one a task (BackgroundWorker.h). Beside that a task has
///   Choice                       the object that a person chooses to feel
///   isHeld                       whether the choice is in the hand: how stiff the hand can be depends on it
///   Order::of(choice, around)    the order for a choice
///   linksOf(Links&)              its part of the servo's links
template<class... Task>
class WorkerList : BackgroundWorker<Task>...
{
public:
  using Choices = std::tuple<typename Task::Choice...>;

  template<class Links>
  WorkerList(Links& links, bool virtualTime) : BackgroundWorker<Task>(Task::linksOf(links), virtualTime)...
  {
  }
  template<class One>
  [[nodiscard]] typename One::Status statusOf() const
  {
    return BackgroundWorker<One>::status();
  }
  void order(const Choices& choices, const WorkSurroundings& around)
  {
    (BackgroundWorker<Task>::order(Task::Order::of(std::get<typename Task::Choice>(choices), around)), ...);
  }
  /// In virtual time, after a tick at that time.
  void step(double time_s) { (BackgroundWorker<Task>::step(time_s), ...); }
};

} // namespace palpate
