// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "devices/simulated/labyrinth/PlaceMemory.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// Parameters for exploring a maze by touch. All in the device frame, in the plane z = 0.
struct BlindPlan
{
  double step_m = 0.0;        ///< from place to place: half a corridor, so that bent corridors are found too
  double near_m = 0.0;        ///< distance at which a new place is reached
  double again_m = 0.0;       ///< and a known one; the sum of both is less than the distance of two sides of a wall
  double speed_m_per_s = 0.0; ///< of the hand
  double touch_N = 0.0;       ///< force of a wall against the hand
  double lead_m = 0.0;        ///< largest lead of the arm before the handle: the push of the hand over its stiffness
  double friction_m = 0.0;    ///< the same for the friction of the device
  double grain_m = 0.0;       ///< accuracy of the handle at its goal along each axis
};

/// Position and force of a hand at a moment.
struct Felt
{
  Vec3 handle_D = Vec3::Zero();   ///< position of the handle [m]
  Vec3 location_D = Vec3::Zero(); ///< where a wall, if any, stops it: the virtual location [m]
  Vec3 force_D = Vec3::Zero();    ///< on the hand [N]
};

/// A hand that explores by force and position alone. The hand knows neither walls nor exit. The hand pushes the
/// handle to the next place; where the handle is stopped, the hand goes back, along its thread where an obstacle is in
/// between, and tries another passage (PlaceMemory). Deterministic.
class BlindHand
{
public:
  /// Begins at the handle's position.
  BlindHand(const BlindPlan& plan, const Vec3& start_D);

  /// Looks once and moves the arm; returns where the arm leads the handle to [m]. `dt_s`: since the last look.
  [[nodiscard]] Vec3 look(const Felt& felt, double dt_s);

  /// True if the hand has been at every place that it could reach.
  [[nodiscard]] bool exhausted() const noexcept { return this->exhausted_; }
  /// True if the hand could not get back to a place that it came from: the world has changed.
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
  std::optional<int> way_;     ///< tried now; nothing: back to the present place
  std::vector<Vec3> thread_D_; ///< positions since the last place, never empty
  bool winds_ = false;         ///< goes back along the thread
  double held_s_ = 0.0, idle_s_ = 0.0, since_s_ = 0.0;
  int tries_ = 0;               ///< to pass an obstacle in a known passage
  Vec3 aside_D_ = Vec3::Zero(); ///< offset of the goal in this try [m]
  double least_m_ = 0.0;        ///< smallest distance to the goal so far
  bool exhausted_ = false, lost_ = false;
};

} // namespace palpate
