// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/arm/WoodenHapticsModel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::test
{
namespace
{

constexpr double La = 0.080, Lb = 0.205, Lc = 0.245;
constexpr double capstan = 0.010, counts = 2000.0;
constexpr std::array<double, 3> body{ 0.160, 0.120, 0.120 };
constexpr double ox = 0.22, oz = 0.08;
constexpr std::array<double, 3> poseCounts{ 0.0, 0.0, 6000.0 };

double radPerCount(std::size_t i)
{
  return 2.0 * std::numbers::pi / counts * capstan / body[i];
}

std::int16_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at)
{
  return static_cast<std::int16_t>(bytes[at] | bytes[at + 1] << 8);
}

} // namespace

WoodenHapticsModel::WoodenHapticsModel()
{
  this->standInPose();
  this->say();
}

Vec3 WoodenHapticsModel::tipOf(const Vec3& q) const
{
  const double out = Lb * std::sin(q[1]) + Lc * std::sin(q[2]);
  return { std::cos(q[0]) * out - ox, std::sin(q[0]) * out, La + Lb * std::cos(q[1]) - Lc * std::cos(q[2]) - oz };
}

void WoodenHapticsModel::standInPose()
{
  this->place({ poseCounts[0] * radPerCount(0), poseCounts[1] * radPerCount(1), poseCounts[2] * radPerCount(2) });
  // Its counters began where it was switched on: in the pose they say 0.
  for (std::size_t i = 0; i < 3; ++i)
  {
    this->offset_[i] = -poseCounts[i];
  }
}

std::array<std::int16_t, 6> WoodenHapticsModel::counters() const
{
  std::array<std::int16_t, 6> all{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double count = std::floor(this->joints_rad()[static_cast<int>(i)] / radPerCount(i) + 1e-9) + this->offset_[i];
    all[i] = static_cast<std::int16_t>(static_cast<std::int64_t>(count)); // as a counter wraps
  }
  all[3] = this->fourth;
  return all;
}

void WoodenHapticsModel::say()
{
  if (this->silentFor > 0)
  {
    --this->silentFor;
    return;
  }
  std::vector<std::uint8_t> report;
  for (const std::int16_t count : this->counters())
  {
    report.push_back(static_cast<std::uint8_t>(count & 0xFF));
    report.push_back(static_cast<std::uint8_t>(static_cast<std::uint16_t>(count) >> 8));
  }
  report.push_back(this->pressed ? 1 : 0);
  report.push_back(0);
  const bool cut = this->cutAnswers > 0, wrong = this->wrongAnswers > 0;
  this->cutAnswers -= cut ? 1 : 0;
  this->wrongAnswers -= wrong ? 1 : 0;
  report.resize(cut ? 7 : wrong ? 1 : report.size());
  this->waiting_.push_back(report);
}

bool WoodenHapticsModel::take(HidReportKind kind, std::span<const std::uint8_t> bytes)
{
  if (this->frozen || kind != HidReportKind::Output || bytes.size() != 1 + this->reportBytes || bytes[0] != 0)
  {
    return false;
  }
  const std::span<const std::uint8_t> order = bytes.subspan(1);
  const bool sets = wordAt(order, 6) == 1;
  this->silence_ms_ = 0;
  ++this->orders;
  for (std::size_t i = 0; i < 3; ++i)
  {
    this->current_mA[i] = sets ? 0.0 : std::clamp<double>(wordAt(order, 2 * i), -3000.0, 3000.0);
  }
  if (sets)
  {
    ++this->setOrders;
    this->pressed = false;
    const std::array<std::int16_t, 6> now = this->counters();
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->offset_[i] += wordAt(order, 8 + 2 * i) - now[i];
    }
  }
  this->say();
  return true;
}

std::vector<std::uint8_t> WoodenHapticsModel::nextInput()
{
  if (this->frozen || this->waiting_.empty())
  {
    return {};
  }
  std::vector<std::uint8_t> first = this->waiting_.front();
  this->waiting_.pop_front();
  return first;
}

void WoodenHapticsModel::advance(int duration_ms)
{
  this->silence_ms_ += duration_ms;
  if (this->silence_ms_ > watchdog_ms)
  {
    const bool wasOn = this->current_mA != std::array<double, 3>{};
    this->wentOffAfter_ms = wasOn ? this->silence_ms_ : this->wentOffAfter_ms;
    this->current_mA = {};
  }
}

/// The motor turns the body against its own sense where they are not aligned, as its encoder does.
Vec3 WoodenHapticsModel::force_N() const
{
  Vec3 torque_Nm;
  for (std::size_t i = 0; i < 3; ++i)
  {
    torque_Nm[static_cast<int>(i)] = 1e-3 * this->current_mA[i] * this->constants_Nm_per_A[i] * body[i] / capstan;
  }
  return this->forceOf(torque_Nm);
}

double WoodenHapticsModel::halfStep_N() const
{
  double most_N = 0.0;
  for (int signs = 0; signs < 8; ++signs)
  {
    Vec3 torque_Nm;
    for (std::size_t i = 0; i < 3; ++i)
    {
      torque_Nm[static_cast<int>(i)] =
        ((signs >> i) & 1 ? -1 : 1) * 0.5e-3 * this->constants_Nm_per_A[i] * body[i] / capstan;
    }
    most_N = std::max(most_N, this->forceOf(torque_Nm).norm());
  }
  return most_N;
}

std::string WoodenHapticsModel::file()
{
  return R"({ "variant": 0, "diameter_capstan_a": 0.010, "diameter_capstan_b": 0.010, "diameter_capstan_c": 0.010,
  "length_body_a": 0.080, "length_body_b": 0.205, "length_body_c": 0.245,
  "diameter_body_a": 0.160, "diameter_body_b": 0.120, "diameter_body_c": 0.120,
  "workspace_origin_x": 0.22, "workspace_origin_y": 0, "workspace_origin_z": 0.08, "workspace_radius": 0.1,
  "torque_constant_motor_a": 0.0259, "torque_constant_motor_b": 0.0259, "torque_constant_motor_c": 0.0259,
  "cpr_encoder_a": 2000, "cpr_encoder_b": 2000, "cpr_encoder_c": 2000,
  "cpr_encoder_d": 2000, "cpr_encoder_e": 2000, "cpr_encoder_f": 2000,
  "max_linear_force": 5, "max_linear_stiffness": 1000, "max_linear_damping": 8,
  "mass_body_b": 0.170, "mass_body_c": 0.110, "length_cm_body_b": 0.051, "length_cm_body_c": 0.091,
  "g_constant": 0, "calibrate_enc_a": 0, "calibrate_enc_b": 0, "calibrate_enc_c": 6000,
  "motor_and_body_aligned_a": false, "motor_and_body_aligned_b": false, "motor_and_body_aligned_c": false,
  "current_for_10_v_signal": 3 })";
}

} // namespace palpate::test
