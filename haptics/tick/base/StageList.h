// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

namespace palpate
{

struct TickContext;

/// A stage of the tick is a struct of static members, declared in tick/stages/, its functions in tick/steps/:
///   name                    of its part of a recording
///   step(TickContext&)      one tick; real-time safe
/// and, where it has use for them,
///   Plan                    its settings: the members become members of HapticParameters
///   planFields(visit, p...) names each member of one plan, or of several at once, for writing, reading and comparing
///   refuse(const Plan&)     empty, or one sentence that names the value that cannot be used
///   State                   its state from tick to tick: the members become members of RendererState
///   stateFields(visit, s...) names each member that a recording begins with
///   rest(TickContext&)      its step in a tick that does not know where the hand is
///   feels(const TickContext&) whether there is anything that it could push the hand with
template<class S>
concept HasPlan = requires
{
  typename S::Plan;
};

template<class S>
concept HasState = requires
{
  typename S::State;
};

/// Takes a field of any type and does nothing with it.
struct IgnoredField
{
  template<class... T>
  void operator()(const char* /*name*/, T&... /*members*/) const noexcept
  {
  }
};

template<class S>
concept RecordsState = HasState<S> && requires(typename S::State& state)
{
  S::stateFields(IgnoredField{}, state);
};

template<class S>
concept Rests = requires(TickContext& tick)
{
  S::rest(tick);
};

template<class S>
concept Feels = requires(const TickContext& tick)
{
  S::feels(tick);
};

template<class S>
struct PlanOf
{
};
template<HasPlan S>
struct PlanOf<S> : S::Plan
{
};

template<class S>
struct StateOf
{
};
template<HasState S>
struct StateOf<S> : S::State
{
};

/// Stages in the order in which a tick takes them.
template<class... S>
struct StageList
{
  struct Plans : PlanOf<S>...
  {
  };
  struct States : StateOf<S>...
  {
  };

  /// Calls a generic function with std::type_identity of each stage in turn.
  template<class Function>
  static constexpr void forEach(Function&& function)
  {
    (function(std::type_identity<S>{}), ...);
  }
};

} // namespace palpate
