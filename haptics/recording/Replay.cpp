// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cstring>
#include <map>

#include "haptics/recording/Recording.h"

namespace palpate
{
namespace
{

bool sameBits(double a, double b)
{
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template<class Vector>
bool sameBits(const Vector& a, const Vector& b)
{
  for (int k = 0; k < a.size(); ++k)
  {
    if (!sameBits(a[k], b[k]))
    {
      return false;
    }
  }
  return true;
}

bool sameWalls(const DeviceWalls& a, const DeviceWalls& b)
{
  const auto sameAll = [](const auto& x, const auto& y)
  { return std::equal(x.begin(), x.end(), y.begin(), [](double u, double v) { return sameBits(u, v); }); };
  return sameAll(a.offset_m, b.offset_m) && sameAll(a.largest_N, b.largest_N) && a.mask == b.mask &&
         sameBits(a.stiffness_N_per_m, b.stiffness_N_per_m) && sameBits(a.viscosity_Ns_per_m, b.viscosity_Ns_per_m);
}

/// The first quantity that is not as recorded, or null.
const char* firstDifference(const TickRecord& a, const TickRecord& b)
{
  if (!sameBits(a.wrench_D.force, b.wrench_D.force) || !sameBits(a.wrench_D.torque, b.wrench_D.torque))
  {
    return "force";
  }
  if (!sameBits(a.proxy_W.p, b.proxy_W.p) || !sameBits(a.proxy_W.q.coeffs(), b.proxy_W.q.coeffs()))
  {
    return "proxy";
  }
  if (a.contacts != b.contacts)
  {
    return "contacts";
  }
  if (!sameBits(a.delivered_J, b.delivered_J) || !sameBits(a.excess_J, b.excess_J))
  {
    return "energy";
  }
  if (!sameWalls(a.walls, b.walls))
  {
    return "walls";
  }
  if (a.signal != b.signal)
  {
    return "signal";
  }
  return a.flags != b.flags ? "flags" : nullptr;
}

/// Gives the tree of a surface the room that coming from there takes. False if it cannot come from there.
bool letCome(Surface& surface, const std::shared_ptr<const VertexStart>& from)
{
  const VertexWay way{ from->hash, { &from->vertices_W } };
  surface.tree = surface.tree->refitted(surface.tree->mesh().vertices_W, nullptr, &way).tree;
  surface.from = from;
  return surface.tree != nullptr;
}

class Replayer
{
public:
  Replayer(const Recording& recording, const std::vector<std::shared_ptr<const Scene>>& given, unsigned workers)
    : recording_(recording), state_(recording.initialState), parameters_(recording.parameters)
  {
    SceneBuilder builder(workers);
    for (const auto& scene : given)
    {
      this->scenes_[scene->geometryHash()] = scene;
    }
    for (const RecordedScene& recorded : recording.scenes)
    {
      const auto scene = builder.build(recorded.surfaces).scene;
      if (scene && scene->geometryHash() == recorded.geometryHash)
      {
        this->scenes_[recorded.geometryHash] = scene;
      }
    }
    for (const RecordedMotion& motion : recording.motions)
    {
      this->addMoving(motion);
    }
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
  void take(const RecordedChange& change)
  {
    switch (change.event.kind)
    {
      case EventKind::Parameters:
        this->parameters_ = change.parameters.value_or(this->parameters_);
        break;
      case EventKind::Scene:
        this->takeScene(change);
        break;
      default:
        this->events_.push_back(change.event);
    }
  }

  /// The meshes are there already: only where they are is new.
  void addMoving(const RecordedMotion& recorded)
  {
    const auto still = this->scenes_.find(recorded.geometryHash);
    if (still == this->scenes_.end() || still->second->surfaces().size() != recorded.motions.size() ||
        !std::all_of(
          recorded.motions.begin(), recorded.motions.end(), [](const RigidMotion& m) { return m.isRigid(); }))
    {
      return;
    }
    std::vector<Surface> surfaces = still->second->surfaces();
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
      surfaces[i].motion = recorded.motions[i];
      if (recorded.starts[i] && !letCome(surfaces[i], recorded.starts[i]))
      {
        return;
      }
    }
    auto scene = std::make_shared<const Scene>(0, std::move(surfaces), recorded.motion_s);
    if (scene->contentHash() == recorded.contentHash)
    {
      this->scenes_[recorded.contentHash] = std::move(scene);
    }
  }

  void takeScene(const RecordedChange& change)
  {
    this->previous_ = this->scene_;
    this->scene_.reset();
    if (change.sceneHash == 0)
    {
      return;
    }
    const auto found = this->scenes_.find(change.sceneHash);
    if (found == this->scenes_.end())
    {
      this->result_.problem = "its scenes were left out or do not match: give the files they came from with --scene";
      return;
    }
    this->scene_ =
      std::make_shared<const Scene>(change.sceneRevision, found->second->surfaces(), found->second->motion_s());
  }

  void compute(const TickRecord& record, const std::function<void(const TickOutput&)>& visit)
  {
    TickInput input;
    input.tick = record.tick;
    input.dt_s = record.dt_s;
    input.sample = record.sample;
    input.status = record.status;
    input.scene = this->scene_.get();
    input.previousScene = this->previous_.get();
    input.lateness = record.lateness;
    input.events = this->events_;
    const TickOutput output = renderTick(input, this->parameters_, this->state_);
    this->events_.clear();
    this->previous_.reset();
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
  std::map<std::uint64_t, std::shared_ptr<const Scene>> scenes_;
  std::shared_ptr<const Scene> scene_, previous_;
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
