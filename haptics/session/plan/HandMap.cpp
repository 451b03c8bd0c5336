// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/plan/HandMap.h"

namespace palpate
{
namespace
{

/// Sine of half an angle: less cannot be seen in any view, and rounding is not a turn.
constexpr double sameTurn = 1e-9;

bool turnsTheSame(const Quat& a, const Quat& b)
{
  return (a * b.conjugate()).vec().norm() <= sameTurn;
}

} // namespace

std::optional<Quat> viewRotation(const Vec3& right_W, const Vec3& up_W)
{
  const Vec3 toward_W = right_W.cross(up_W);
  if (!toward_W.allFinite() || toward_W.norm() <= sameTurn * right_W.norm() * up_W.norm())
  {
    return std::nullopt;
  }
  Mat3 axes_W;
  axes_W.col(0) = right_W.normalized();
  axes_W.col(2) = toward_W.normalized();
  axes_W.col(1) = axes_W.col(2).cross(axes_W.col(0));
  return Quat(axes_W).normalized();
}

WorkspaceMap keepingHand(WorkspaceMap map, const HandPlace& hand)
{
  map.offset_W = hand.p_W - map.scale_u_per_m * (map.q_WD * hand.p_D);
  return map;
}

std::array<Vec3, 8> workspaceCorners(const WorkspaceMap& map, double radius_m)
{
  std::array<Vec3, 8> corners_W;
  for (std::size_t i = 0; i < corners_W.size(); ++i)
  {
    const auto side = [i](unsigned bit) { return (i >> bit & 1u) != 0 ? 1.0 : -1.0; };
    corners_W[i] = map.toScene(radius_m * Vec3(side(0), side(1), side(2)));
  }
  return corners_W;
}

std::optional<HandMapChange> HandMap::follow(const HandWishes& wishes, const WorkspaceMap& now, const HandPlace& hand)
{
  if (wishes.clutch)
  {
    const bool begins = !this->clutched_;
    this->clutched_ = true;
    return begins ? std::optional(HandMapChange{ now, true }) : std::nullopt;
  }
  const double factor = wishes.precise ? wishes.precision : 1.0;
  const bool turns = wishes.q_WD && !turnsTheSame(*wishes.q_WD, now.q_WD);
  if (!this->clutched_ && factor == this->factor_ && !turns)
  {
    return std::nullopt;
  }
  WorkspaceMap next = now;
  next.scale_u_per_m *= this->factor_ / factor;
  next.q_WD = turns ? *wishes.q_WD : now.q_WD;
  this->factor_ = factor;
  this->clutched_ = false;
  return HandMapChange{ keepingHand(next, hand), false };
}

} // namespace palpate
