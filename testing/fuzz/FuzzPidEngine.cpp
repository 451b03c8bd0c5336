// SPDX-License-Identifier: GPL-3.0-or-later
// Any commands at any times to a device of any habits: no force is ever stronger than asked for, and none is without an
// end, whichever button is pressed then.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "devices/hid/pid/PidOutput.h"
#include "testing/devices/hid/AskedForce.h"
#include "testing/devices/hid/VirtualPidDevice.h"
#include "testing/fuzz/Require.h"

namespace
{

using palpate::test::VirtualPidDevice;

/// A report takes a millisecond.
class Wire final : public palpate::HidConnection
{
public:
  explicit Wire(VirtualPidDevice& device) : device_(device) {}

  int read(std::span<std::uint8_t>, int) noexcept override { return 0; }
  bool write(std::span<const std::uint8_t> report) noexcept override
  {
    this->device_.advance(1);
    return this->device_.take(palpate::HidReportKind::Output, report);
  }
  bool setFeature(std::span<const std::uint8_t> report) noexcept override
  {
    return this->device_.take(palpate::HidReportKind::Feature, report);
  }
  int getFeature(std::span<std::uint8_t> report) noexcept override
  {
    const std::vector<std::uint8_t> feature = this->device_.feature(report[0]);
    std::copy_n(feature.begin(), std::min(feature.size(), report.size()), report.begin());
    return static_cast<int>(feature.size());
  }
  std::string error() const override { return "none"; }
  void wait(int duration_ms) noexcept override { this->device_.advance(duration_ms); }

private:
  VirtualPidDevice& device_;
};

class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size) : left_(data, size) {}
  [[nodiscard]] bool any() const { return !this->left_.empty(); }
  unsigned next()
  {
    const unsigned byte = this->left_.empty() ? 0U : this->left_.front();
    this->left_ = this->left_.empty() ? this->left_ : this->left_.subspan(1);
    return byte;
  }
  /// -1 .. 1.
  double share() { return static_cast<double>(this->next()) / 127.5 - 1.0; }

private:
  std::span<const std::uint8_t> left_;
};

palpate::PidOutput::Wish wishOf(Bytes& bytes, const palpate::PidScale& scale)
{
  palpate::PidOutput::Wish wish;
  wish.command.wrench_D.force = { scale.maxForce_N * bytes.share(), scale.maxForce_N * bytes.share(), 0.0 };
  const unsigned flags = bytes.next();
  wish.command.wallCount = static_cast<std::uint8_t>(std::min(flags & 7U, 4U));
  for (std::size_t i = 0; i < wish.command.wallCount; ++i)
  {
    const palpate::Vec3 axis = i < 2 ? palpate::Vec3::UnitX() : palpate::Vec3::UnitY();
    wish.command.walls[i] = { i % 2 == 0 ? axis : palpate::Vec3(-axis), scale.halfTravel_m * bytes.share(),
      scale.springStiffness_N_per_m * bytes.share() };
  }
  wish.command.viscosity_Ns_per_m = (flags & 8U) != 0 ? scale.damperViscosity_Ns_per_m * bytes.share() : 0.0;
  wish.command.signal = (flags & 16U) != 0 ? palpate::Signal::Oscillation : palpate::Signal::None;
  wish.trust = { (flags & 32U) != 0, (flags & 64U) != 0 };
  return wish;
}

double felt(VirtualPidDevice& device)
{
  device.position = {}; // where no spring of its own pulls
  const auto force = device.force();
  return std::max(std::fabs(force[0]), std::fabs(force[1]));
}

palpate::test::PidLayout layoutOf(Bytes& bytes)
{
  const std::vector<palpate::test::PidLayout> layouts = palpate::test::allLayouts();
  const std::vector<palpate::test::PidHabits> habits = palpate::test::allHabits();
  palpate::test::PidLayout layout = layouts[bytes.next() % layouts.size()];
  layout.habits = habits[(bytes.next() * 256U + bytes.next()) % habits.size()];
  return layout;
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const palpate::test::PidLayout layout = layoutOf(bytes);
  VirtualPidDevice device(layout);
  const palpate::ReportDescriptor descriptor = palpate::parseReportDescriptor(palpate::test::descriptorOf(layout));
  Wire wire(device);
  palpate::PidEngine engine(wire, descriptor);
  require(engine.open().empty());
  const palpate::PidOutputOptions options;
  palpate::PidOutput output(engine, options, palpate::pidKind(descriptor));
  require(output.begin().empty());
  palpate::test::AskedForce asked;
  constexpr int mostTurns = 40;
  std::int64_t now_ms = 0;
  std::uint64_t beat = 0;
  for (int turn = 0; turn < mostTurns && bytes.any(); ++turn)
  {
    palpate::PidOutput::Wish wish = wishOf(bytes, options.scale);
    const unsigned duration_ms = bytes.next() / 4;
    const bool stands = duration_ms % 4 == 0;
    for (unsigned ms = 0; ms < duration_ms; ++ms)
    {
      wish.beat = stands ? beat : ++beat;
      asked.note(wish.command, options, ++now_ms);
      if (output.step(now_ms * 1'000'000, wish) == palpate::PidStep::Idle)
      {
        device.advance(1);
      }
      require(felt(device) <= asked.most(now_ms, options.duration_ms + 10) + 0.01);
    }
  }
  device.advance(250);
  require(felt(device) == 0.0);
  device.buttons = 0xFF;
  device.advance(2);
  require(felt(device) == 0.0 && device.badReports == 0);
  return 0;
}
