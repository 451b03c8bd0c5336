// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/arm/TwoDiyModel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

namespace palpate::test
{
namespace
{

constexpr double deg = std::numbers::pi / 180.0, largest_Nm = 0.123;
constexpr int steps = 4095;

float floatAt(const std::vector<std::uint8_t>& bytes, std::size_t at)
{
  float value = 0.0F;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

void append(std::vector<std::uint8_t>& bytes, float value)
{
  std::array<std::uint8_t, 4> raw;
  std::memcpy(raw.data(), &value, sizeof value);
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

} // namespace

TwoDiyModel::TwoDiyModel(const TwoDiyBody& body) : body_(body)
{
  this->place({ body.pose_deg[0] * deg, body.pose_deg[1] * deg, 0.0 });
}

/// Elbows l from motors that are d apart, forearms L; the origin is the right motor, as the API has it.
Vec3 TwoDiyModel::tipOf(const Vec3& q) const
{
  const double l = this->body_.arm_m, L = this->body_.forearm_m, d = this->body_.base_m;
  // The left arm's motor stands at 0 there and the right arm's at d.
  const double x1 = l * std::cos(q[0]), y1 = l * std::sin(q[0]), x2 = d + l * std::cos(q[1]), y2 = l * std::sin(q[1]);
  const double half = 0.5 * std::hypot(x2 - x1, y2 - y1), up = std::sqrt(std::max(0.0, L * L - half * half));
  const double ex = (x2 - x1) / (2.0 * half), ey = (y2 - y1) / (2.0 * half);
  return { 0.5 * (x1 + x2) - up * ey, 0.5 * (y1 + y2) + up * ex, q[2] };
}

void TwoDiyModel::take(std::span<const std::uint8_t> bytes)
{
  if (this->frozen)
  {
    return;
  }
  this->inbox_.insert(this->inbox_.end(), bytes.begin(), bytes.end());
  while (this->takeOne())
  {
  }
}

bool TwoDiyModel::takeOne()
{
  const std::size_t length = this->commandLength();
  if (this->inbox_.size() < length)
  {
    return false;
  }
  const std::uint8_t command = this->inbox_[0];
  if (command == 0)
  {
    ++this->resets;
    this->device_ = 0;
    this->pins_.clear();
  }
  else if (command == 1)
  {
    this->setUp();
  }
  else if (command == 2)
  {
    this->push();
  }
  this->inbox_.erase(this->inbox_.begin(), this->inbox_.begin() + static_cast<std::ptrdiff_t>(length));
  return true;
}

std::size_t TwoDiyModel::commandLength() const
{
  if (this->inbox_.size() < 2)
  {
    return this->inbox_.empty() || this->inbox_[0] <= 2 ? 2 : 1;
  }
  const bool own = this->device_ != 0 && this->inbox_[1] == this->device_;
  switch (this->inbox_[0])
  {
    case 0:
      return 2;
    case 1:
      return this->setUpIn().length;
    case 2:
      return own ? 2 + this->pins_.size() + 4 * this->torque_Nm.size() : 2;
    default:
      return 1;
  }
}

/// Four ports: a byte for the direction of each motor and each encoder that the masks name, pins of sensors and pulses,
/// then two floats for each encoder.
TwoDiyModel::SetUp TwoDiyModel::setUpIn() const
{
  const auto at = [this](std::size_t i) { return i < this->inbox_.size() ? this->inbox_[i] : std::uint8_t{ 0 }; };
  const auto ports = [](std::uint8_t mask) { return static_cast<std::size_t>(std::popcount(mask & 0xFU)); };
  SetUp found;
  found.motorTurns = 3;
  const std::size_t encoderMask = 3 + ports(at(2));
  found.encoders = ports(at(encoderMask));
  found.encoderTurns = encoderMask + 1;
  const std::size_t sensors = found.encoderTurns + found.encoders;
  found.pulses = sensors + 1 + at(sensors);
  found.parameters = found.pulses + 1 + at(found.pulses);
  found.length = found.parameters + 8 * found.encoders;
  return found;
}

void TwoDiyModel::setUp()
{
  const SetUp found = this->setUpIn();
  ++this->setUps;
  this->device_ = this->inbox_[1];
  for (std::size_t i = found.pulses + 1; i < found.parameters; ++i)
  {
    this->pins_.insert(this->inbox_[i]);
  }
  for (std::size_t i = 0; i < std::min(this->torque_Nm.size(), found.encoders); ++i)
  {
    this->motorTurned_[i] = this->inbox_[found.motorTurns + i] != 0;
    this->encoderTurned_[i] = this->inbox_[found.encoderTurns + i] != 0;
    this->offset_deg_[i] = floatAt(this->inbox_, found.parameters + 8 * i);
    this->countsPerTurn_[i] = floatAt(this->inbox_, found.parameters + 4 + 8 * i);
    this->began_deg_[i] = this->joints_rad()[static_cast<int>(i)] / deg;
  }
}

/// Sent by its number alone: without set-up no motor has that number.
void TwoDiyModel::push()
{
  std::vector<std::uint8_t> answer{ this->inbox_[1] };
  const std::size_t first = 2 + this->pins_.size();
  if (this->inbox_[1] == this->device_)
  {
    for (std::size_t i = 0; i < 2; ++i)
    {
      const double asked_Nm = std::clamp<double>(floatAt(this->inbox_, first + 4 * i), -largest_Nm, largest_Nm);
      this->torque_Nm[i] = std::trunc(steps * asked_Nm / largest_Nm) * largest_Nm / steps;
      append(answer, static_cast<float>(360.0 * this->counts(i) / this->countsPerTurn_[i]));
    }
  }
  this->say(answer);
}

/// The offset is written to the counter in whole counts, and the pins of an encoder that is turned are swapped.
double TwoDiyModel::counts(std::size_t i) const
{
  const double turned_deg = this->joints_rad()[static_cast<int>(i)] / deg - this->began_deg_[i];
  const double sense = this->body_.encoderWiredTurned[i] != this->encoderTurned_[i] ? -1.0 : 1.0;
  const double perDegree = sense * this->body_.gear[i] * this->body_.countsPerTurn / 360.0;
  const double began = std::trunc(this->offset_deg_[i] * this->countsPerTurn_[i] / 360.0);
  return began + std::floor(turned_deg * perDegree + 1e-6);
}

Vec3 TwoDiyModel::forceOfMotors(const std::array<double, 2>& motor_Nm) const
{
  Vec3 joint_Nm = Vec3::Zero();
  for (std::size_t i = 0; i < motor_Nm.size(); ++i)
  {
    const double sense = this->body_.motorWiredTurned[i] != this->motorTurned_[i] ? -1.0 : 1.0;
    joint_Nm[static_cast<int>(i)] = sense * this->body_.gear[i] * motor_Nm[i];
  }
  return this->forceOf(joint_Nm);
}

Vec3 TwoDiyModel::force_N() const
{
  return this->forceOfMotors(this->torque_Nm);
}

double TwoDiyModel::step_N() const
{
  const double step_Nm = largest_Nm / steps;
  return std::max(this->forceOfMotors({ step_Nm, step_Nm }).norm(), this->forceOfMotors({ step_Nm, -step_Nm }).norm());
}

} // namespace palpate::test
