// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/recording/inputs/Bodies.h"
#include "haptics/recording/inputs/InputList.h"

namespace palpate
{

/// How the surfaces of a scene move, apart from the meshes, which are stored once.
struct RecordedMotion
{
  std::uint64_t contentHash = 0; ///< of the scene as a whole
  std::uint64_t geometryHash = 0;
  double motion_s = 0.0;
  std::vector<RigidMotion> motions;                       ///< one a surface
  std::vector<std::shared_ptr<const VertexStart>> starts; ///< one a surface; null: its vertices stand
};

/// A scene as a recording keeps it: the cleaned surfaces it was built from.
struct RecordedScene
{
  std::uint64_t geometryHash = 0;
  std::vector<SurfaceInput> surfaces;
};

namespace input
{

/// Surfaces. A soft body brings the scene that it is felt in.
struct Scenes
{
  using Value = Scene;
  [[nodiscard]] static const Scene*& of(TickInput& tick) noexcept { return tick.scene; }
  static constexpr EventKind event = EventKind::Scene;
  [[nodiscard]] static RecordedName nameOf(const Scene& scene) noexcept
  {
    return { 0, scene.contentHash(), scene.revision() };
  }

  struct Links
  {
    SnapshotMailbox<Scene> scenes; ///< owner -> servo
  };
  [[nodiscard]] static auto& buffer(Links& links) noexcept { return links.scenes; }
  /// The scene before stays alive for this tick: each mailbox keeps the snapshot that it replaces.
  template<class Arrivals>
  static void put(Arrivals& arrivals, TickInput& tick) noexcept
  {
    const Scene* const before = tick.scene;
    Arrival<Scenes>& own = std::get<Arrival<Scenes>>(arrivals);
    const PressedBody* const body = Bodies::felt(std::get<Arrival<Bodies>>(arrivals), tick);
    tick.scene = body != nullptr ? body->scene.get() : own.value;
    if (body != nullptr || tick.body != nullptr)
    {
      own.replaced = tick.scene != before ? before : nullptr;
    }
    tick.previousScene = own.replaced;
  }
  [[nodiscard]] static bool replaces(const TickInput& tick, const RendererState& /*state*/) noexcept
  {
    return tick.previousScene != nullptr;
  }

  static constexpr ChunkKind chunk{ "scene" };   ///< the meshes and curves, wherever its surfaces are
  static constexpr ChunkKind motion{ "motion" }; ///< where they are and come from, by the hash of the meshes
  static void write(ByteWriter& payload, const Scene& scene);
  static void writeMotion(ByteWriter& payload, const Scene& scene);
  template<class Sink>
  static void writeChunks(const Scene& scene, const Sink& sink)
  {
    sink(scene.geometryHash(), chunk, write);
    if (scene.moves())
    {
      sink(scene.contentHash(), motion, writeMotion);
    }
  }

  struct Recorded
  {
    std::vector<RecordedScene> scenes; ///< each once; empty when they were left out
    std::vector<RecordedMotion> motions;
  };
  static void read(ByteReader& payload, Recorded& recorded);
  static void readMotion(ByteReader& payload, Recorded& recorded);
  static const std::array<InputReader<Scenes>, 2> readers;

  class Replay
  {
  public:
    [[nodiscard]] std::string take(const RecordedName& name, const Recorded& recorded, const ReplayPlace& place);
    void put(TickInput& tick, const ReplayPlace& /*place*/) noexcept
    {
      tick.scene = this->scene_.get();
      tick.previousScene = std::exchange(this->taken_, false) ? this->previous_.get() : nullptr;
    }
    [[nodiscard]] const std::shared_ptr<const Scene>& scene() const noexcept { return this->scene_; }

  private:
    std::shared_ptr<const Scene> scene_, previous_;
    bool taken_ = false; ///< since the last tick
  };
};

inline const std::array<InputReader<Scenes>, 2> Scenes::readers{ { { chunk, read }, { motion, readMotion } } };

} // namespace input
} // namespace palpate
