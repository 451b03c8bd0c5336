// SPDX-License-Identifier: GPL-3.0-or-later
#include <tuple>

#include "haptics/recording/Recording.h"
#include "haptics/recording/bytes/ByteStream.h"
#include "haptics/recording/inputs/SceneLibrary.h"

namespace palpate
{
namespace
{

/// Names the first field whose bits differ in two objects.
struct FirstDifference
{
  const char*& found;

  template<class T>
  void operator()(const char* name, const T& a, const T& b) const
  {
    ByteWriter first, second;
    first.put(a);
    second.put(b);
    if (this->found == nullptr && first.bytes() != second.bytes())
    {
      this->found = name;
    }
  }
};

/// The first quantity that is not as recorded, or null.
const char* firstDifference(const TickRecord& a, const TickRecord& b)
{
  const char* found = nullptr;
  outputFields(FirstDifference{ found }, a, b);
  return found;
}

class Replayer
{
public:
  Replayer(const Recording& recording, const std::vector<std::shared_ptr<const Scene>>& given, unsigned workers)
    : recording_(recording), state_(recording.initialState), parameters_(recording.parameters),
      scenes_(recording, given, workers)
  {
  }

  ReplayResult run(const std::function<void(const TickOutput&)>& visit)
  {
    if (this->recording_.lost > 0)
    {
      this->result_.problem =
        std::to_string(this->recording_.lost) + " ticks were lost while it was recorded: it cannot be recomputed";
    }
    for (const RecordedEntry& entry : this->recording_.entries)
    {
      if (!this->result_.problem.empty() || !this->result_.difference.empty())
      {
        break;
      }
      if (const auto* change = std::get_if<RecordedChange>(&entry))
      {
        this->take(*change);
      }
      else
      {
        this->compute(std::get<TickRecord>(entry), visit);
      }
    }
    return this->result_;
  }

private:
  [[nodiscard]] input::ReplayPlace place() const noexcept
  {
    return { this->scenes_, std::get<input::Scenes::Replay>(this->inputs_).scene(), this->state_ };
  }

  void take(const RecordedChange& change)
  {
    const EventKind kind = change.event.kind;
    bool known = kind == EventKind::Parameters;
    this->parameters_ = known ? change.parameters.value_or(this->parameters_) : this->parameters_;
    TickInputs::forEach(
      [&]<class K>(std::type_identity<K>)
      {
        if (kind == K::event)
        {
          known = true;
          const input::RecordedName name{ change.event.value, change.sceneHash, change.sceneRevision };
          std::string problem = std::get<input::ReplayOf<K>>(this->inputs_).take(name, this->recording_, this->place());
          this->result_.problem = problem.empty() ? this->result_.problem : std::move(problem);
        }
      });
    if (!known)
    {
      this->events_.push_back(change.event);
    }
  }

  void putInputs(TickInput& input)
  {
    TickInputs::forEach(
      [&]<class K>(std::type_identity<K>)
      {
        std::get<input::ReplayOf<K>>(this->inputs_).put(input, this->place());
        std::get<input::WorkspaceOf<K>>(this->workspaces_).put(input);
      });
  }

  void compute(const TickRecord& record, const std::function<void(const TickOutput&)>& visit)
  {
    TickInput input;
    input.tick = record.tick;
    input.hand = record.hand;
    input.dt_s = record.dt_s;
    input.sample = record.sample;
    input.status = record.status;
    this->putInputs(input);
    input.lateness = record.lateness;
    input.events = this->events_;
    const TickOutput output = renderTick(input, this->parameters_, this->state_);
    this->events_.clear();
    ++this->result_.ticks;
    if (visit)
    {
      visit(output);
    }
    if (const char* const what = firstDifference(makeRecord(input, output), record))
    {
      this->result_.difference = "tick " + std::to_string(record.tick) + ": " + what + " differs";
    }
  }

  const Recording& recording_;
  RendererState state_;
  HapticParameters parameters_;
  SceneLibrary scenes_;
  TickInputs::Replays inputs_;
  TickInputs::Each<input::WorkspaceOf> workspaces_;
  std::vector<HapticEvent> events_;
  ReplayResult result_;
};

} // namespace

ReplayResult replay(const Recording& recording, const std::vector<std::shared_ptr<const Scene>>& given,
  unsigned workers, const std::function<void(const TickOutput&)>& visit)
{
  return Replayer(recording, given, workers).run(visit);
}

} // namespace palpate
