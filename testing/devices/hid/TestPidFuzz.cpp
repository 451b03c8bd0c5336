// SPDX-License-Identifier: GPL-3.0-or-later
// Real descriptors with bytes of them changed, and the engine's output for commands of any kind.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "devices/hid/pid/PidOutput.h"
#include "testing/devices/hid/AskedForce.h"
#include "testing/devices/hid/ModelCases.h"
#include "testing/devices/hid/PidRig.h"
#include "testing/devices/hid/RealDescriptors.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

/// Takes all reports and answers with anything; remembers whether a report was of another length than its layout.
class AnyDevice final : public HidConnection
{
public:
  AnyDevice(const ReportDescriptor& descriptor, test::Random& random) : descriptor_(descriptor), random_(random) {}

  int read(std::span<std::uint8_t>, int) noexcept override { return 0; }
  bool write(std::span<const std::uint8_t> report) noexcept override
  {
    return this->take(HidReportKind::Output, report);
  }
  bool setFeature(std::span<const std::uint8_t> report) noexcept override
  {
    return this->take(HidReportKind::Feature, report);
  }
  int getFeature(std::span<std::uint8_t> report) noexcept override
  {
    for (std::size_t i = 1; i < report.size(); ++i)
    {
      report[i] = static_cast<std::uint8_t>(this->random_.below(4));
    }
    return static_cast<int>(report.size());
  }
  std::string error() const override { return "no"; }
  void wait(int) noexcept override {}

  int wrong = 0;

private:
  bool take(HidReportKind kind, std::span<const std::uint8_t> report)
  {
    const auto fits = [&](const HidReport& one)
    { return one.kind == kind && one.id == report[0] && one.bytes() == report.size(); };
    this->wrong += std::any_of(this->descriptor_.reports.begin(), this->descriptor_.reports.end(), fits) ? 0 : 1;
    return true;
  }

  const ReportDescriptor& descriptor_;
  test::Random& random_;
};

std::vector<std::uint8_t> mutated(std::vector<std::uint8_t> bytes, test::Random& random)
{
  for (std::uint32_t changes = 1 + random.below(8); changes > 0; --changes)
  {
    bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] ^= static_cast<std::uint8_t>(1U << random.below(8));
  }
  if (random.below(4) == 0)
  {
    bytes.resize(1 + random.below(static_cast<std::uint32_t>(bytes.size())));
  }
  return bytes;
}

double anyNumber(test::Random& random, double scale)
{
  switch (random.below(8))
  {
    case 0:
      return 0.0;
    case 1:
      return 1e9;
    case 2:
      return std::nan("");
    default:
      return random.uniform(-scale, scale);
  }
}

DeviceCommand anyCommand(test::Random& random, const PidScale& scale)
{
  DeviceCommand command;
  command.wrench_D.force = random.inCube(scale.maxForce_N);
  command.wallCount = static_cast<std::uint8_t>(random.below(5));
  for (DeviceWall& wall : command.walls)
  {
    const Vec3 axis = random.below(2) == 0 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    const Vec3 across = random.below(4) == 0 ? random.direction() : axis;
    wall = { random.below(2) == 0 ? across : Vec3(-across), anyNumber(random, scale.halfTravel_m),
      anyNumber(random, scale.springStiffness_N_per_m) };
  }
  command.viscosity_Ns_per_m = anyNumber(random, scale.damperViscosity_Ns_per_m);
  command.signal = random.below(4) == 0 ? Signal::Oscillation : Signal::None;
  return command;
}

/// Opens, makes its effects and carries out commands: every report must be one that the descriptor describes.
void drive(const ReportDescriptor& descriptor, test::Random& random)
{
  AnyDevice connection(descriptor, random);
  PidEngine engine(connection, descriptor);
  if (!engine.open().empty())
  {
    return;
  }
  const PidOutputOptions options;
  PidOutput output(engine, options, pidKind(descriptor));
  if (output.begin().empty())
  {
    for (int step = 0; step < 20; ++step)
    {
      const PidOutput::Wish wish{ anyCommand(random, options.scale), static_cast<std::uint64_t>(step / 2),
        random.inCube(options.scale.halfTravel_m), { true, true } };
      static_cast<void>(output.step(step * 10'000'000LL, wish));
    }
  }
  engine.close();
  EXPECT_EQ(connection.wrong, 0);
}

TEST(PidFuzz, RealDescriptorsWithBytesChangedAreRefusedInOneLineOrDrivenWithinTheirReports)
{
  const std::size_t cases = test::testCount(2000);
  std::size_t driven = 0;
  for (const test::RealDescriptor& real : test::realDescriptors())
  {
    test::Random random(test::testSeed(5401));
    for (std::size_t i = 0; i < cases; ++i)
    {
      const ReportDescriptor parsed = parseReportDescriptor(mutated(real.bytes, random));
      ASSERT_NE(parsed.problem.empty(), parsed.reports.empty());
      ASSERT_EQ(parsed.problem.find('\n'), std::string::npos);
      const std::string refusal = PidEngine::refusal(parsed);
      ASSERT_EQ(refusal.find('\n'), std::string::npos);
      if (refusal.empty())
      {
        ++driven;
        drive(parsed, random);
      }
    }
  }
  EXPECT_GT(driven, cases / 4); // else the engine was not tried
}

/// Commands of any kind at any times, then a servo that stops, then a program that dies.
template<class Felt>
void requireBounded(test::PidRig& rig, test::Random& random, const std::string& name, Felt felt)
{
  test::AskedForce asked;
  const int late_ms = rig.options.output.duration_ms + 10;
  // Walls and viscosity may push with all that the device has: half of the cases are forces alone, each up to a share.
  const bool forcesAlone = random.below(2) == 0;
  const double share = random.uniform();
  std::int64_t now_ms = 0;
  for (int turn = 0; turn < 12; ++turn)
  {
    rig.command = anyCommand(random, rig.scale());
    if (forcesAlone)
    {
      const Vec3 force_D = share * rig.command.wrench_D.force;
      rig.command = DeviceCommand{};
      rig.command.wrench_D.force = force_D;
    }
    rig.device.trust({ random.below(2) == 0, random.below(2) == 0 });
    const bool stands = random.below(4) == 0;
    for (std::uint32_t ms = random.below(60); ms > 0; --ms)
    {
      asked.note(stands ? DeviceCommand{} : rig.command, rig.options.output, ++now_ms);
      if (stands)
      {
        rig.pass();
      }
      else
      {
        rig.run(1);
      }
      ASSERT_LE(felt(), asked.most(now_ms, late_ms) + 0.01) << name;
    }
  }
  rig.bus->advance(250);
  for (int ms = 0; ms < 20; ++ms)
  {
    ASSERT_EQ(felt(), 0.0) << name;
    rig.bus->advance(1);
  }
}

/// Each condition is limited by itself, however hard its walls were asked for.
void requireLimited(test::PidRig& rig, const test::PidLayout& layout)
{
  const test::PidNumber* const saturation = layout.conditionNumber(0x63);
  const double most =
    rig.options.output.largestShare + (saturation == nullptr ? 0.0 : 1.0 / static_cast<double>(saturation->max));
  for (const int block : { 3, 4 }) // after the two forces, where there are such
  {
    for (const int axis : { 0, 1 })
    {
      const Condition& held = rig.stick().condition(block, axis);
      ASSERT_TRUE(held.positiveCoefficient == 0.0 || held.positiveSaturation <= most) << layout.name;
      ASSERT_TRUE(held.negativeCoefficient == 0.0 || held.negativeSaturation <= most) << layout.name;
    }
  }
}

TEST(PidFuzz, NothingIsEverStrongerThanAskedOrWithoutAnEndWhateverTheHabits)
{
  test::Random random(test::testSeed(5402));
  const std::vector<test::PidHabits> habits = test::allHabits();
  for (std::size_t i = 0; i < test::testCount(300); ++i)
  {
    test::PidLayout layout = test::allLayouts()[random.below(8)];
    layout.habits = habits[random.below(static_cast<std::uint32_t>(habits.size()))];
    test::PidRig rig(layout);
    ASSERT_EQ(rig.device.open(), "");
    const auto felt = [&]
    {
      rig.stick().position = {}; // where no spring of its own pulls
      const auto force = rig.stick().force();
      return std::max(std::fabs(force[0]), std::fabs(force[1]));
    };
    requireBounded(rig, random, layout.name + ": " + layout.habits.text(), felt);
    requireLimited(rig, layout);
    ASSERT_EQ(rig.stick().badReports, 0) << layout.name;
  }
}

TEST(PidFuzz, NothingIsEverStrongerThanAskedOrWithoutAnEndOnTheModelsOfFirmwares)
{
  test::Random random(test::testSeed(5403));
  for (std::size_t i = 0; i < test::testCount(40); ++i)
  {
    for (const test::ModelCase& one : test::modelCases())
    {
      test::PidRig rig(one.model, one.descriptor);
      ASSERT_EQ(rig.device.open(), "");
      const auto felt = [&]
      {
        one.model->position = {};
        const auto force = one.model->force();
        return std::max(std::fabs(force[0]), std::fabs(force[1]));
      };
      requireBounded(rig, random, one.name, felt);
    }
  }
}

} // namespace
} // namespace palpate
