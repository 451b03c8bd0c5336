// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "devices/simulated/PlaceMemory.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// How somebody explores a maze by touch. All in the device frame, in the plane z = 0.
struct BlindPlan
{
  double step_m = 0.0;        ///< from place to place: half a corridor, so that bent corridors are found too
  double near_m = 0.0;        ///< a fresh place is reached from this near
  double again_m = 0.0;       ///< and a known one; both together are less than what two sides of a wall are apart
  double speed_m_per_s = 0.0; ///< of the hand
  double touch_N = 0.0;       ///< a push back that is a wall
  double lead_m = 0.0;        ///< of the arm before the handle at most: what the hand pushes with, over its stiffness
  double friction_m = 0.0;    ///< the same for what the device's friction swallows
  double grain_m = 0.0;       ///< as near to its goal along each axis as the hand takes the handle
};

/// What a hand feels and knows at a moment.
struct Felt
{
  Vec3 handle_D = Vec3::Zero();   ///< where the handle is [m]
  Vec3 location_D = Vec3::Zero(); ///< where the wall, if any, holds it: the virtual location [m]
  Vec3 force_D = Vec3::Zero();    ///< on the hand [N]
};

/// A hand that finds its way by force and position alone. The hand knows neither walls nor exit. The hand pushes the
/// handle to the next place; where the handle is stopped, the hand goes back, along its thread where something is in
/// between, and tries another way (PlaceMemory). Deterministic.
class BlindHand
{
public:
  /// Begins at the handle's place.
  BlindHand(const BlindPlan& plan, const Vec3& start_D);

  /// Looks once and moves the arm; returns where the arm leads the handle [m]. `dt_s`: since the last look.
  [[nodiscard]] Vec3 look(const Felt& felt, double dt_s);

  /// It has been everywhere it could reach.
  [[nodiscard]] bool exhausted() const noexcept { return this->exhausted_; }
  /// It could not get back to a place it came from: the world is not what it was.
  [[nodiscard]] bool lost() const noexcept { return this->lost_; }
  [[nodiscard]] const PlaceMemory& memory() const noexcept { return this->memory_; }

private:
  [[nodiscard]] Vec3 centre_D(const PlaceMemory::Place& place) const;
  [[nodiscard]] Vec3 goal_D() const;
  [[nodiscard]] bool known() const;
  void feelAbout(const Felt& felt);
  [[nodiscard]] bool reached(const Felt& felt) const;
  [[nodiscard]] bool stopped(const Felt& felt, double dt_s);
  void set(std::optional<int> way);
  void decide(const Felt& felt, double dt_s);
  void follow(const Felt& felt);
  void startAnew();
  [[nodiscard]] double unfelt_m(double ahead_m, double dt_s) const;
  void choose();
  void lead(const Felt& felt, double dt_s);

  BlindPlan plan_;
  Vec3 start_D_, arm_D_;
  PlaceMemory memory_;
  std::optional<int> way_;     ///< tried now; nothing: back to where it is
  std::vector<Vec3> thread_D_; ///< where it has been since it was at a place, never empty
  bool winds_ = false;         ///< goes back along the thread
  double held_s_ = 0.0, idle_s_ = 0.0, since_s_ = 0.0;
  int tries_ = 0;               ///< to get by something on a known way
  Vec3 aside_D_ = Vec3::Zero(); ///< of the goal, in this try [m]
  double least_m_ = 0.0;        ///< how near to the goal it has come
  bool exhausted_ = false, lost_ = false;
};

} // namespace palpate
