// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "haptics/recording/ByteStream.h"
#include "haptics/recording/RecordedMechanisms.h"
#include "haptics/recording/Recording.h"

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
  if (a.pose && b.pose)
  {
    poseFields(FirstDifference{ found }, *a.pose, *b.pose);
  }
  return found;
}

/// Gives the tree of a surface the bounds of where its vertices come from. False if it cannot come from there.
bool letCome(Surface& surface, const std::shared_ptr<const VertexStart>& from)
{
  const VertexWay way{ from->hash, { &from->vertices_W } };
  surface.tree = surface.tree->refitted(surface.tree->mesh().vertices_W, nullptr, &way).tree;
  surface.from = from;
  return surface.tree != nullptr;
}

/// Whether the packet is of the surface that it says, so that no contact of this scene has a vertex without compliance.
bool fits(const PressedBody& body, const Scene* scene)
{
  const std::uint32_t surface = body.touch.surface;
  return scene != nullptr && surface < scene->surfaces().size() &&
         scene->surfaces()[surface].tree->mesh().vertices_W.size() == body.packet->placeOf.size();
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
      case EventKind::Brick:
        this->takeBrick(change.event.value);
        break;
      case EventKind::Tool:
        this->takeTool(change.event.value);
        break;
      case EventKind::Body:
        this->takeBody(change.event.value);
        break;
      case EventKind::Mechanism:
        this->takeMechanism(change.event.value);
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
    this->scene_ = this->sceneOf(change.sceneHash, change.sceneRevision);
  }

  /// Null where it is not there, which is a problem.
  std::shared_ptr<const Scene> sceneOf(std::uint64_t hash, std::uint64_t revision)
  {
    const auto found = this->scenes_.find(hash);
    if (found == this->scenes_.end())
    {
      this->result_.problem = "its scenes were left out or do not match: give the files they came from with --scene";
      return nullptr;
    }
    return std::make_shared<const Scene>(revision, found->second->surfaces(), found->second->motion_s());
  }

  void takeBrick(std::uint64_t contentHash)
  {
    const auto isIt = [contentHash](const auto& brick) { return brick->contentHash() == contentHash; };
    const auto& bricks = this->recording_.bricks;
    const auto found = std::find_if(bricks.begin(), bricks.end(), isIt);
    this->brick_ = found != bricks.end() ? found->get() : nullptr;
    if (contentHash != 0 && this->brick_ == nullptr)
    {
      this->result_.problem = "a field that was felt is not in it: it cannot be recomputed";
    }
  }

  void takeTool(std::uint64_t revision)
  {
    const auto isIt = [revision](const ToolContacts& set) { return set.revision == revision; };
    const auto& sets = this->recording_.tools;
    const auto found = std::find_if(sets.begin() + this->toolsTaken_, sets.end(), isIt);
    const bool there = revision != 0 && found != sets.end();
    this->tool_ = there ? &*found : nullptr;
    this->toolsTaken_ = there ? found - sets.begin() : this->toolsTaken_;
    if (revision != 0 && !there)
    {
      this->result_.problem = "what a tool touched is not in it: it cannot be recomputed";
    }
  }

  /// Packets lie before what takes them, but for those that were made before the recording began.
  void takeBody(std::uint64_t revision)
  {
    const auto isIt = [revision](const auto& body) { return body->revision == revision; };
    const auto& bodies = this->recording_.bodies;
    const auto found = std::find_if(bodies.begin(), bodies.end(), isIt);
    this->body_ = found != bodies.end() ? *found : nullptr;
    this->takeHeldFaces();
    const bool stops = !this->body_ || !this->body_->heldFaces || this->held_;
    if (revision != 0 && !(this->body_ && stops && fits(*this->body_, this->scene_.get())))
    {
      this->result_.problem = "what a soft body gave way by is not in it: it cannot be recomputed";
    }
  }

  /// From packet to packet they stay, and so does the tree that they are found by.
  void takeHeldFaces()
  {
    const auto now = this->body_ ? this->body_->heldFaces : nullptr;
    const bool same = now && this->heldFaces_ && now->vertices_W == this->heldFaces_->vertices_W &&
                      now->triangles == this->heldFaces_->triangles;
    this->held_ = same ? this->held_ : now ? sceneOfHeld(*now) : nullptr;
    this->heldFaces_ = now;
  }

  /// What the tick of before has left of the same plan is followed into the bodies of this one.
  void takeMechanism(std::uint64_t revision)
  {
    this->mechanism_.reset();
    if (revision == 0)
    {
      return;
    }
    const auto isIt = [revision](const RecordedMechanism& m) { return m.revision == revision; };
    const auto& mechanisms = this->recording_.mechanisms;
    const auto found = std::find_if(mechanisms.begin(), mechanisms.end(), isIt);
    std::vector<std::shared_ptr<const PressedBody>> bodies;
    bool whole = found != mechanisms.end();
    for (std::size_t i = 0; whole && i < found->bodies.size(); ++i)
    {
      const RecordedMechanism::Body& recorded = found->bodies[i];
      auto body = std::make_shared<PressedBody>(*recorded.body);
      body->scene = this->sceneOf(recorded.sceneHash, recorded.sceneRevision);
      whole = fits(*body, body->scene.get());
      bodies.push_back(std::move(body));
    }
    whole = whole && fits(this->state_.mechanism, *found);
    if (whole)
    {
      this->mechanism_ = std::make_shared<const FeltMechanism>(revision, found->plan, std::move(bodies));
    }
    else if (this->result_.problem.empty())
    {
      this->result_.problem = "a mechanism that was held is not in it: it cannot be recomputed";
    }
  }

  /// The body of a tick, in the scene of that tick.
  const PressedBody* bodyInScene()
  {
    if (!this->body_ || !fits(*this->body_, this->scene_.get()))
    {
      return nullptr;
    }
    this->bodyNow_ = *this->body_;
    this->bodyNow_.scene = this->scene_;
    this->bodyNow_.held = this->held_;
    return &this->bodyNow_;
  }

  void compute(const TickRecord& record, const std::function<void(const TickOutput&)>& visit)
  {
    TickInput input;
    input.tick = record.tick;
    input.hand = record.hand;
    input.dt_s = record.dt_s;
    input.sample = record.sample;
    input.status = record.status;
    input.scene = this->scene_.get();
    input.previousScene = this->previous_.get();
    input.brick = this->brick_;
    input.tool = this->tool_;
    input.body = this->bodyInScene();
    input.mechanism = this->mechanism_.get();
    input.mechanismTick = this->mechanismTick_.get();
    input.softRoom = this->softRoom_.get();
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
  const Brick* brick_ = nullptr;
  const ToolContacts* tool_ = nullptr;
  std::ptrdiff_t toolsTaken_ = 0; ///< they stand in the order in which they were taken
  std::shared_ptr<const PressedBody> body_;
  std::shared_ptr<const TriangleMesh> heldFaces_; ///< of that body
  std::shared_ptr<const Scene> held_;             ///< of these
  PressedBody bodyNow_;
  std::shared_ptr<const FeltMechanism> mechanism_;
  std::unique_ptr<MechanismTick> mechanismTick_ = std::make_unique<MechanismTick>();
  std::unique_ptr<SoftRoom> softRoom_ = std::make_unique<SoftRoom>();
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
