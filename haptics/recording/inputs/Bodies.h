// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptics/compliance/servo/PressedBody.h"
#include "haptics/recording/inputs/InputList.h"
#include "haptics/tick/SoftProxy.h"

namespace palpate
{

/// The part of a soft body's snapshot that a mechanism records, too. Its scene and the places of its vertices are those
/// of the scene.
void putBody(ByteWriter& payload, const PressedBody& body);
/// Null, with in.ok() false, where the bytes are none.
[[nodiscard]] std::shared_ptr<const PressedBody> readBody(ByteReader& in);

/// How its springs go on between their knots.
void putKnots(ByteWriter& payload, const PressedBody& body);
void readKnots(ByteReader& in, PressedBody& body);

/// The faces of it that nothing moves.
void putHeld(ByteWriter& payload, const PressedBody& body);
void readHeld(ByteReader& in, PressedBody& body);

/// Whether the snapshot is of the surface that it says, so that no contact of this scene has a vertex without
/// compliance.
[[nodiscard]] bool fits(const PressedBody& body, const Scene* scene);

/// Between the servo and the thread that computes a soft body.
struct SoftLinks
{
  RecordedMailbox<PressedBody> bodies; ///< worker -> servo
  TripleBuffer<BodyHand> hand;         ///< servo -> worker
};

namespace input
{

struct Scenes;

/// A soft body, snapshot by snapshot.
struct Bodies
{
  using Value = PressedBody;
  [[nodiscard]] static const PressedBody*& of(TickInput& tick) noexcept { return tick.body; }
  static constexpr EventKind event = EventKind::Body;
  [[nodiscard]] static std::uint64_t idOf(const PressedBody& body) noexcept { return body.revision; }

  struct Links
  {
    SoftLinks soft;
  };
  [[nodiscard]] static auto& buffer(Links& links) noexcept { return links.soft.bodies; }
  /// That tick's, which has its mechanism already.
  [[nodiscard]] static const PressedBody* felt(const Arrival<Bodies>& arrival, const TickInput& tick) noexcept
  {
    return tick.mechanism == nullptr ? arrival.value : nullptr;
  }
  template<class Arrivals>
  static void put(Arrivals& arrivals, TickInput& tick) noexcept
  {
    tick.body = felt(std::get<Arrival<Bodies>>(arrivals), tick);
  }
  static void tellWorker(const TickDone& done, Links& links) noexcept
  {
    links.soft.hand.write(bodyHandOf(done.input, done.output, done.state));
  }
  struct Workspace
  {
    void put(TickInput& tick) noexcept { tick.softScratch = this->room.get(); }
    std::unique_ptr<SoftScratch> room = std::make_unique<SoftScratch>();
  };

  static constexpr ChunkKind chunk{ "body", 4 };
  static void write(ByteWriter& payload, const PressedBody& body);
  template<class Store>
  static void forEachPart(const PressedBody& body, const Store& store)
  {
    store(std::type_identity<Scenes>{}, body.scene);
  }

  struct Recorded
  {
    std::vector<std::shared_ptr<const PressedBody>> bodies; ///< without their scenes
  };
  static void read(ByteReader& payload, Recorded& recorded);

  /// Snapshots lie before the ticks that take them, but for those that were made before the recording began.
  class Replay
  {
  public:
    [[nodiscard]] std::string take(const RecordedName& name, const Recorded& recorded, const ReplayPlace& place);
    /// In the scene of that tick, which it has already.
    void put(TickInput& tick, const ReplayPlace& place) noexcept;

  private:
    void takeHeldFaces();

    std::shared_ptr<const PressedBody> body_;
    std::shared_ptr<const TriangleMesh> heldFaces_; ///< of that body
    std::shared_ptr<const Scene> held_;             ///< of these
    PressedBody now_;
  };
};

} // namespace input
} // namespace palpate
