// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/library/ReportedHand.h"

namespace palpate
{
namespace
{

constexpr double farthest_m = 10.0, fastest_m_per_s = 100.0; ///< no arm reaches so far, no hand is so fast
constexpr double roughest = 0.1;                             ///< of a rotation whose numbers are rounded

bool isWithin(const Vec3& v, double largest)
{
  return v.allFinite() && v.cwiseAbs().maxCoeff() <= largest;
}

bool isRotation(const Mat3& turn)
{
  return turn.allFinite() && (turn.transpose() * turn - Mat3::Identity()).cwiseAbs().maxCoeff() <= roughest &&
         turn.determinant() > 0.0;
}

} // namespace

ArmLine::Answer reportedHand(const Vec3& p_D, const Vec3& velocity_D, const Mat3& turn_D, std::uint32_t buttons)
{
  ArmLine::Answer answer{ ArmLine::Said::Nonsense, {} };
  if (!isWithin(p_D, farthest_m) || !isWithin(velocity_D, fastest_m_per_s) || !isRotation(turn_D))
  {
    return answer;
  }
  answer.said = ArmLine::Said::Reading;
  answer.reading.pose_D = Pose{ p_D, Quat(turn_D).normalized() };
  answer.reading.velocity_D = Twist{ velocity_D, Vec3::Zero() };
  answer.reading.buttons = buttons;
  return answer;
}

} // namespace palpate
