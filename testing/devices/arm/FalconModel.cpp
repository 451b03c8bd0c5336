// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/arm/FalconModel.h"

#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace palpate::test
{
namespace
{

constexpr double deg = std::numbers::pi / 180.0;
constexpr double a = 0.060, b = 0.1025, c = 0.01443, d = 0.01125, e = 0.01125, f = -0.025, r = 0.0400, s = -0.02309;
constexpr std::array<double, 3> legs{ 105.0, -15.0, -135.0 };
constexpr double radPerCount = 2.0 * std::numbers::pi / (320.0 * 4.0) * 14.25 / 110.0;
constexpr double atZero = 35.0 * deg, number_per_Nm = -10000.0;

int wordAt(const std::string& packet, std::size_t at)
{
  int word = 0;
  for (std::size_t k = 0; k < 4; ++k)
  {
    word |= (packet[at + k] - 'A') << 4 * k;
  }
  return word >= 0x8000 ? word - 0x10000 : word;
}

std::string wordOf(int word)
{
  std::string text;
  for (int k = 0; k < 4; ++k)
  {
    text += static_cast<char>('A' + ((word & 0xFFFF) >> 4 * k & 0xF));
  }
  return text;
}

} // namespace

FalconModel::FalconModel()
{
  this->place(anglesAt({ 0.0, 0.0, 0.12 }));
}

Vec3 FalconModel::anglesAt(const Vec3& tip_m)
{
  Vec3 angles;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double phi = legs[i] * deg;
    const double u = tip_m.x() * std::cos(phi) + tip_m.y() * std::sin(phi) - r + c;
    const double v = -tip_m.x() * std::sin(phi) + tip_m.y() * std::cos(phi) + f - s;
    const double w = tip_m.z();
    const double reach = d + e + std::sqrt(b * b - v * v), span = std::hypot(u, w);
    angles[static_cast<int>(i)] =
      std::atan2(w, u) - std::acos((span * span + a * a - reach * reach) / (2.0 * a * span));
  }
  return angles;
}

/// Newton's method on the inverse, from the middle of the work space.
Vec3 FalconModel::tipOf(const Vec3& joints_rad) const
{
  constexpr double h_m = 1e-6;
  Vec3 tip_m(0.0, 0.0, 0.12);
  for (int i = 0; i < 30; ++i)
  {
    const Vec3 left = joints_rad - anglesAt(tip_m);
    if (left.norm() < 1e-12)
    {
      break;
    }
    Mat3 turns;
    for (int k = 0; k < 3; ++k)
    {
      turns.col(k) = (anglesAt(tip_m + h_m * Vec3::Unit(k)) - anglesAt(tip_m - h_m * Vec3::Unit(k))) / (2.0 * h_m);
    }
    tip_m += turns.partialPivLu().solve(left);
  }
  return tip_m;
}

void FalconModel::take(std::span<const std::uint8_t> bytes)
{
  for (const std::uint8_t byte : bytes)
  {
    this->inbox_ = byte == '<' ? "<" : this->inbox_ + static_cast<char>(byte);
    if (this->inbox_.size() == 16 && this->inbox_.front() == '<' && this->inbox_.back() == '>')
    {
      this->answer();
      this->inbox_.clear();
    }
  }
}

void FalconModel::answer()
{
  if (this->frozen)
  {
    return;
  }
  ++this->packets;
  for (std::size_t i = 0; i < 3; ++i)
  {
    this->motor[i] = wordAt(this->inbox_, 1 + 4 * i);
  }
  this->homing = ((this->inbox_[13] - 'A') & 1) != 0;
  std::string packet = "<";
  unsigned homedBits = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double turned_rad = this->joints_rad()[static_cast<int>(i)] - atZero;
    const int offset = this->homed[i] ? 0 : 777; // before it is homed a count means nothing
    packet += wordOf(static_cast<int>(std::floor(turned_rad / radPerCount + 1e-9)) + offset);
    homedBits |= this->homed[i] ? 1U << i : 0U;
  }
  packet += static_cast<char>('A' + (this->buttons | homedBits << 4));
  packet += "A>";
  this->say({ packet.begin(), packet.end() });
}

Vec3 FalconModel::force_N() const
{
  return this->forceOf(Vec3(this->motor[0], this->motor[1], this->motor[2]) / number_per_Nm);
}

double FalconModel::step_N() const
{
  double most_N = 0.0;
  for (int signs = 0; signs < 8; ++signs)
  {
    const Vec3 half(signs & 1 ? 0.5 : -0.5, signs & 2 ? 0.5 : -0.5, signs & 4 ? 0.5 : -0.5);
    most_N = std::max(most_N, this->forceOf(half / number_per_Nm).norm());
  }
  return 2.0 * most_N;
}

} // namespace palpate::test
