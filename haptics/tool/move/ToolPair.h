// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "haptics/tool/move/ToolMove.h"

namespace palpate
{

/// Two rigid tools, each in a hand of its own, that meet one another. Where they touch both give way, each by its own
/// stiffness, so that what one hand feels the other feels the other way round.
///
/// Where they should go is the nearest motion of both that their contacts allow: of the motion of one as the other sees
/// it, whose compliance is the sum of both. Then one goes there while the other stands still, in turn, each step proven
/// as against a scene (see ToolMove): so neither passes the other. Not real-time safe.
class ToolPair
{
public:
  struct Hold
  {
    double characteristic_u = 1.0; ///< what a turn of 1 rad weighs as a way
    double stiffness_N_per_u = 1;  ///< of the spring to its hand
  };
  using Poses = std::array<Pose, 2>;
  using Pushes = std::array<Wrench, 2>;

  ToolPair(const ToolMesh& one, const ToolMesh& other, const std::array<Hold, 2>& holds);

  /// Refused in words where the two would touch there.
  [[nodiscard]] std::string place(const Poses& poses_W);
  /// Moves both towards their hands with at most so much work a step of each. True: they are where they stay.
  bool update(const Poses& hands_W, std::uint64_t work);

  [[nodiscard]] const Poses& poses_W() const noexcept { return this->poses_W_; }
  /// What each hand feels, about its tool's centre [N, N u].
  [[nodiscard]] Pushes pushes(const Poses& hands_W) const;
  /// Told each step of a tool, in the frame of the other; null: nobody.
  void watch(int tool, StepSink* sink) noexcept { this->moves_[static_cast<std::size_t>(tool)].watch(sink); }

private:
  struct Motion
  {
    Poses goals_W;
    Pushes pushes;
    double way_u = 0.0; ///< no point of either goes further
  };
  [[nodiscard]] Motion nearestOfBoth(const Poses& hands_W) const;
  void move(std::size_t tool, const Pose& goal_W, std::uint64_t work);

  std::array<Hold, 2> holds_;
  std::array<ToolMove, 2> moves_; ///< of each in the frame of the other
  Poses poses_W_;
};

} // namespace palpate
