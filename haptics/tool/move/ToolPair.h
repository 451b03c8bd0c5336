// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "haptics/tool/move/ToolMove.h"

namespace palpate
{

/// Two rigid tools, each in a hand of its own, that meet one another. Where they touch both are displaced, each by its
/// own stiffness, so that the two hands feel opposite forces.
///
/// Their goals are the nearest motion of both that their contacts allow: that of the relative motion,
/// whose compliance is the sum of both. Then one goes there while the other stands still, in turn, each step proven
/// as against a scene (see ToolMove): so neither passes the other. Not real-time safe.
class ToolPair
{
public:
  struct Hold
  {
    double characteristic_u = 1.0; ///< lever arm between rotations and displacements [u]
    double stiffness_N_per_u = 1;  ///< of the spring to its hand
  };
  using Poses = std::array<Pose, 2>;
  using Pushes = std::array<Wrench, 2>;

  ToolPair(const ToolMesh& one, const ToolMesh& other, const std::array<Hold, 2>& holds);

  /// Refused in words where the two would touch there.
  [[nodiscard]] std::string place(const Poses& poses_W);
  /// Moves both towards their hands with at most `work` units for a step of each. True: both are at rest.
  bool update(const Poses& hands_W, std::uint64_t work);

  [[nodiscard]] const Poses& poses_W() const noexcept { return this->poses_W_; }
  /// The wrench on each hand, about its tool's centre [N, N u].
  [[nodiscard]] Pushes pushes(const Poses& hands_W) const;
  /// Receives each step of a tool, in the frame of the other; null: no observer.
  void watch(int tool, StepSink* sink) noexcept { this->moves_[static_cast<std::size_t>(tool)].watch(sink); }

private:
  struct Motion
  {
    Poses goals_W;
    Pushes pushes;
    double way_u = 0.0; ///< largest displacement of a point of either
  };
  [[nodiscard]] Motion nearestOfBoth(const Poses& hands_W) const;
  void move(std::size_t tool, const Pose& goal_W, std::uint64_t work);

  std::array<Hold, 2> holds_;
  std::array<ToolMove, 2> moves_; ///< each in the frame of the other
  Poses poses_W_;
};

} // namespace palpate
