// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "haptics/realtime/RecordedMailbox.h"
#include "haptics/realtime/SnapshotMailbox.h"
#include "haptics/realtime/TripleBuffer.h"
#include "haptics/recording/bytes/ByteStream.h"
#include "haptics/recording/bytes/RecordingLayout.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate
{

class SceneLibrary;

/// An input of the tick is a value that another thread hands to it. Each is a struct of static members, in a file of
/// its own in recording/inputs/:
///   Value                  its type, immutable
///   of(TickInput&)         the pointer to it there; null: there is none
///   event                  the change that a recording notes when a tick takes another value
///   idOf(const Value&)     its content hash or revision, never 0: by that a recording names it
///   Links                  its buffers: members become members of ServoLinks
///   buffer(Links&)         the one that brings it: a SnapshotMailbox from the session's owner, a RecordedMailbox from
///                          a worker, a TripleBuffer for values that a worker writes
///   chunk                  of a recording that holds it, each value once
///   write(ByteWriter&, const Value&)
///   Recorded               the values that are read: members become members of Recording
///   read(ByteReader&, Recorded&)
///   recorded(Recorded&)    the values that were read
///   missing                why a recording without one cannot be recomputed
/// and, where it has use for them,
///   put(arrivals, TickInput&)  which value the tick has, where that depends on others; of those that come later in the
///                          list there are still the ones of the tick before
///   Workspace              memory that the tick computes with: put(TickInput&)
///   tellWorker(const TickDone&, Links&)                 after a tick
///   replaces(const TickInput&, const RendererState&)    the tick goes over from another one: no recording begins there
///   nameOf(const Value&)   a name of more than its id
///   forEachPart(value, store)           values of other inputs that a recording needs for it
///   writeChunks(value, sink), readers   in place of chunk, write and read: chunks of several kinds
///   Replay                 how it is taken from a recording and put into a tick; else see ReplayedInput
namespace input
{

/// A value as it came from another thread.
template<class K>
struct Arrival
{
  const typename K::Value* value = nullptr;
  const typename K::Value* replaced = nullptr; ///< by it in this tick, still alive
};

/// How a recording names a value.
struct RecordedName
{
  std::uint64_t id = 0; ///< 0: none is felt any more
  std::uint64_t sceneHash = 0;
  std::uint64_t sceneRevision = 0;
};

/// A tick that is over, for workers.
struct TickDone
{
  const TickInput& input;
  const TickOutput& output;
  const RendererState& state;
  const HapticParameters& parameters;
  double time_s = 0.0;
  std::uint32_t maps = 0; ///< workspace maps that were replaced so far
};

template<class K>
using BufferOf = std::remove_reference_t<decltype(K::buffer(std::declval<typename K::Links&>()))>;

/// A worker writes it as a value, not as a snapshot.
template<class K>
concept ComesByValue = std::is_same_v<BufferOf<K>, TripleBuffer<typename K::Value>>;
/// The owner of the session publishes it.
template<class K>
concept ComesFromOwner = std::is_same_v<BufferOf<K>, SnapshotMailbox<typename K::Value>>;
/// A worker publishes it; the owner has it recorded.
template<class K>
concept ComesFromWorker = std::is_same_v<BufferOf<K>, RecordedMailbox<typename K::Value>>;

template<class K>
concept TellsWorker = requires(const TickDone& done, typename K::Links& links)
{
  K::tellWorker(done, links);
};
template<class K>
concept Replaces = requires(const TickInput& tick, const RendererState& state)
{
  K::replaces(tick, state);
};

/// The newest value. The servo; wait-free.
template<class K>
[[nodiscard]] Arrival<K> arrive(typename K::Links& links) noexcept
{
  auto& buffer = K::buffer(links);
  if constexpr (ComesByValue<K>)
  {
    return { &buffer.read(), nullptr };
  }
  else
  {
    const auto* const value = buffer.acquire();
    return { value, buffer.replaced() };
  }
}

/// Puts an arrival into the input of a tick. True if the tick has another value than the tick before.
template<class K, class Arrivals>
[[nodiscard]] bool takeInto(TickInput& input, Arrivals& arrivals) noexcept
{
  const auto* const before = K::of(input);
  Arrival<K>& own = std::get<Arrival<K>>(arrivals);
  if constexpr (requires { K::put(arrivals, input); })
  {
    K::put(arrivals, input);
  }
  else
  {
    K::of(input) = own.value;
  }
  return K::of(input) != before || (K::of(input) != nullptr && own.replaced != nullptr);
}

/// The name of a value, or of none.
template<class K>
[[nodiscard]] RecordedName nameOf(const typename K::Value* value) noexcept
{
  if constexpr (requires { K::nameOf(*value); })
  {
    return value != nullptr ? K::nameOf(*value) : RecordedName{};
  }
  else
  {
    return { value != nullptr ? K::idOf(*value) : 0 };
  }
}

/// The scenes and the state that a replay has when it takes a value.
struct ReplayPlace
{
  const SceneLibrary& scenes;
  const std::shared_ptr<const Scene>& scene; ///< of the next tick
  const RendererState& state;                ///< of the tick before
};

/// Finds the values of a recording by their names. They stand about in the order in which they were taken.
template<class K>
class ReplayedInput
{
public:
  /// Empty, or why the recording cannot be recomputed.
  [[nodiscard]] std::string take(
    const RecordedName& name, const typename K::Recorded& recorded, const ReplayPlace& /*place*/)
  {
    const auto& all = K::recorded(recorded);
    const auto isIt = [&name](const auto& one) { return K::idOf(*pointerTo(one)) == name.id; };
    const auto from = all.begin() + this->last_;
    auto found = std::find_if(from, all.end(), isIt);
    found = found != all.end() ? found : std::find_if(all.begin(), from, isIt);
    const bool there = name.id != 0 && found != all.end() && isIt(*found);
    this->last_ = there ? found - all.begin() : this->last_;
    this->now_ = there ? pointerTo(*found) : nullptr;
    return name.id != 0 && !there ? K::missing : "";
  }
  void put(TickInput& input, const ReplayPlace& /*place*/) noexcept { K::of(input) = this->now_; }

private:
  static const typename K::Value* pointerTo(const typename K::Value& one) noexcept { return &one; }
  static const typename K::Value* pointerTo(const std::shared_ptr<const typename K::Value>& one) noexcept
  {
    return one.get();
  }

  const typename K::Value* now_ = nullptr;
  std::ptrdiff_t last_ = 0; ///< that was taken
};

template<class K>
struct ChosenReplay
{
  using Type = ReplayedInput<K>;
};
template<class K>
requires requires
{
  typename K::Replay;
}
struct ChosenReplay<K>
{
  using Type = typename K::Replay;
};
template<class K>
using ReplayOf = typename ChosenReplay<K>::Type;

/// A kind of chunk, and the function that enters its payload into a recording. The payload is ok() and at its end
/// afterwards, unless it is damaged.
template<class K>
struct InputReader
{
  ChunkKind kind;
  void (*read)(ByteReader& payload, typename K::Recorded& recorded);
};

/// Calls `sink` with the name, the kind and the writer of each chunk that holds the value.
template<class K, class Sink>
void forEachChunk(const typename K::Value& value, const Sink& sink)
{
  if constexpr (requires { K::writeChunks(value, sink); })
  {
    K::writeChunks(value, sink);
  }
  else
  {
    sink(K::idOf(value), K::chunk, K::write);
  }
}

template<class K>
[[nodiscard]] auto readersOf()
{
  if constexpr (requires { K::readers; })
  {
    return K::readers;
  }
  else
  {
    return std::array{ InputReader<K>{ K::chunk, K::read } };
  }
}

/// Workspace of a tick, where that is more than fits on a stack.
template<class K>
struct WorkspaceOf
{
  void put(TickInput& /*input*/) noexcept {}
};
template<class K>
requires requires
{
  typename K::Workspace;
}
struct WorkspaceOf<K> : K::Workspace
{
};

/// A value that the owner of the session publishes, kept over its runs.
template<class K>
struct OwnedInput
{
  std::shared_ptr<const typename K::Value> value;
};

/// Inputs in the order in which a tick takes them.
template<class... K>
struct InputList
{
  struct Links : K::Links...
  {
  };
  struct Recorded : K::Recorded...
  {
  };
  template<template<class> class Part>
  using Each = std::tuple<Part<K>...>; ///< found by its type
  using Replays = std::tuple<ReplayOf<K>...>;

  /// Calls a generic function with std::type_identity of each input in turn, but for those that it does not take.
  template<class Function>
  static constexpr void forEach(const Function& function)
  {
    const auto call = [&function]<class I>(std::type_identity<I> one)
    {
      if constexpr (std::is_invocable_v<const Function&, std::type_identity<I>>)
      {
        function(one);
      }
    };
    (call(std::type_identity<K>{}), ...);
  }
};

} // namespace input
} // namespace palpate
