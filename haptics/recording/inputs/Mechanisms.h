// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptics/mechanism/servo/FeltMechanism.h"
#include "haptics/recording/inputs/InputList.h"

namespace palpate
{

/// A mechanism as a recording keeps it.
struct RecordedMechanism
{
  /// A soft body of it, without its scene.
  struct Body
  {
    std::uint64_t sceneHash = 0;
    std::uint64_t sceneRevision = 0;
    std::shared_ptr<const PressedBody> body;
  };

  std::uint64_t revision = 0;
  MechanismPlan plan;       ///< its wire has no vessel yet
  TriangleMesh vessel_W;    ///< of the wire
  std::vector<Body> bodies; ///< in the plan's order
  FoundContacts found;
  std::uint64_t meshesHash = 0, meshesRevision = 0; ///< of the scene of rigid meshes; 0: there is none
};

/// The payload of the chunk of a mechanism: its plan and the snapshots of its soft bodies, whose scenes are chunks of
/// their own; at the end, and only where there is one, its wire.
void putMechanism(ByteWriter& payload, const FeltMechanism& mechanism);
/// Of no use, with in.ok() false, where the bytes are none.
[[nodiscard]] RecordedMechanism readMechanism(ByteReader& in);

/// Numbers that a tick computes with.
[[nodiscard]] bool isUsable(const MechanismState& state);
/// Whether a tick may go on from this state: of another plan, or at vertices that the bodies have.
[[nodiscard]] bool fits(const MechanismState& state, const RecordedMechanism& mechanism);

/// Between the servo and the thread that computes a mechanism's soft bodies.
struct MechanismLinks
{
  RecordedMailbox<FeltMechanism> felt; ///< worker -> servo
  TripleBuffer<MechanismHand> hand;    ///< servo -> worker
  TripleBuffer<WirePlaces> wire;       ///< likewise, of a wire in the hand: in the frame of its sheath's mouth
};

namespace input
{

struct Scenes;

/// A mechanism in the hand, with the newest snapshots of its soft bodies.
struct Mechanisms
{
  using Value = FeltMechanism;
  [[nodiscard]] static const FeltMechanism*& of(TickInput& tick) noexcept { return tick.mechanism; }
  static constexpr EventKind event = EventKind::Mechanism;
  [[nodiscard]] static std::uint64_t idOf(const FeltMechanism& mechanism) noexcept { return mechanism.revision(); }

  struct Links
  {
    MechanismLinks mechanism;
  };
  [[nodiscard]] static auto& buffer(Links& links) noexcept { return links.mechanism.felt; }
  static void tellWorker(const TickDone& done, Links& links) noexcept
  {
    links.mechanism.hand.write(done.state.mechanismHand);
    if (done.input.mechanism && done.input.mechanism->plan().wire)
    {
      links.mechanism.wire.write(done.state.mechanism.wire.places_M);
    }
  }
  struct Workspace
  {
    void put(TickInput& tick) noexcept { tick.mechanismTick = this->room.get(); }
    std::unique_ptr<MechanismTick> room = std::make_unique<MechanismTick>();
  };

  static constexpr ChunkKind chunk{ "joined", 7 };
  static void write(ByteWriter& payload, const FeltMechanism& mechanism) { putMechanism(payload, mechanism); }
  template<class Store>
  static void forEachPart(const FeltMechanism& mechanism, const Store& store)
  {
    for (const auto& body : mechanism.bodies())
    {
      store(std::type_identity<Scenes>{}, body->scene);
    }
    if (mechanism.meshes())
    {
      store(std::type_identity<Scenes>{}, mechanism.meshes()->scene());
    }
  }

  struct Recorded
  {
    std::vector<RecordedMechanism> mechanisms;
  };
  static void read(ByteReader& payload, Recorded& recorded) { recorded.mechanisms.push_back(readMechanism(payload)); }

  class Replay
  {
  public:
    [[nodiscard]] std::string take(const RecordedName& name, const Recorded& recorded, const ReplayPlace& place);
    void put(TickInput& tick, const ReplayPlace& /*place*/) noexcept { tick.mechanism = this->mechanism_.get(); }

  private:
    std::shared_ptr<const FeltMechanism> mechanism_;
    std::shared_ptr<const StandingMeshes> meshes_; ///< of that one
  };
};

} // namespace input
} // namespace palpate
