// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "devices/arm/kit/Kits.h"
#include "testing/devices/arm/FalconRig.h"
#include "testing/devices/arm/HaplyRig.h"
#include "testing/devices/arm/LibraryRig.h"
#include "testing/devices/arm/TwoDiyRig.h"
#include "testing/devices/arm/WoodenHapticsRig.h"
#include "testing/support/Eventually.h"

namespace palpate::test
{

/// An arm of one kit, whose exchanges a test makes one by one in virtual time, and whose hand and force it has.
class SessionArm
{
public:
  virtual ~SessionArm() = default;

  [[nodiscard]] virtual ArmDevice& device() = 0;
  /// Opens it and brings it as far as to its first push. Empty, or why not.
  [[nodiscard]] virtual std::string open() = 0;
  /// Of its exchanges.
  [[nodiscard]] virtual const Clock& clock() const = 0;
  /// Leads the hand to a place from the middle of the work space.
  virtual void lead(const Vec3& from_m) = 0;
  /// An exchange. False: this computer stalled so long that "no force" may have taken the order's place.
  virtual bool pass() = 0;
  [[nodiscard]] virtual Vec3 force_N() const = 0;
  /// The largest change of the force by one step of the motors' numbers; 0 where the force is a number itself.
  [[nodiscard]] virtual double step_N() const { return 0.0; }
  /// Share of a force by which it is wrong where the place is that of the exchange before, in whole counts.
  [[nodiscard]] virtual double ofThePlace() const { return 0.0; }
  [[nodiscard]] virtual bool inPlane() const { return false; }
};

/// One that may hear its orders and give no reading any more.
class SilentArm : public SessionArm
{
public:
  virtual void fallSilent() = 0;
  /// The reason that is then said.
  [[nodiscard]] virtual const char* silence() const { return "the device does not answer"; }

protected:
  static constexpr int forEver = 1000000; ///< answers
  static constexpr std::int64_t wait_ns = ArmLink::answer_ms * perMs_ns;
};

/// One whose library may report numbers that no hand has.
class LibraryArm : public SilentArm
{
public:
  enum class Number : std::uint8_t
  {
    Place,
    Speed,
    Turn,
  };
  /// From now on it reports that number [m, m/s, 1].
  void report(Number which, double number)
  {
    const Vec3 at_m = which == Number::Place ? Vec3(number, 0.0, 0.0) : this->at_m_;
    this->place_(at_m.x(), at_m.y(), at_m.z(), which == Number::Speed ? number : 0.0);
    this->turn_(which == Number::Turn ? number : 1.0);
  }
  void lead(const Vec3& from_m) override
  {
    this->at_m_ = from_m;
    this->place_(from_m.x(), from_m.y(), from_m.z(), 0.0);
  }

protected:
  explicit LibraryArm(const char* library)
    : place_(fakeFunction<void(double, double, double, double)>(library, "fakePlace")),
      turn_(fakeFunction<void(double)>(library, "fakeTurn"))
  {
  }
  ~LibraryArm() override
  {
    this->place_(0.01, 0.02, -0.03, 0.1); // as other tests have it
    this->turn_(1.0);
  }

private:
  void (*place_)(double, double, double, double);
  void (*turn_)(double);
  Vec3 at_m_ = Vec3::Zero();
};

/// The three that have motors' numbers and counts.
class CountingArm : public SilentArm
{
public:
  [[nodiscard]] double ofThePlace() const override { return 0.015; }
};

class WoodenHapticsArm final : public CountingArm
{
public:
  [[nodiscard]] ArmDevice& device() override { return this->rig_.device; }
  [[nodiscard]] const Clock& clock() const override { return this->rig_.bus->time(); }
  [[nodiscard]] std::string open() override { return this->rig_.open(); }
  void lead(const Vec3& from_m) override { ASSERT_TRUE(this->rig_.model->lead(from_m)); }
  bool pass() override
  {
    this->rig_.pass();
    return true;
  }
  [[nodiscard]] Vec3 force_N() const override { return this->rig_.model->force_N(); }
  [[nodiscard]] double step_N() const override { return 2.0 * this->rig_.model->halfStep_N(); }
  void fallSilent() override { this->rig_.model->silentFor = forEver; }

private:
  WoodenHapticsRig rig_;
};

class FalconArm final : public CountingArm
{
public:
  [[nodiscard]] ArmDevice& device() override { return this->falcon_.rig.device; }
  [[nodiscard]] const Clock& clock() const override { return this->falcon_.time; }
  [[nodiscard]] std::string open() override
  {
    std::string problem = this->device().open();
    this->falcon_.home();
    return problem;
  }
  void lead(const Vec3& from_m) override
  {
    this->falcon_.model->place(FalconModel::anglesAt(from_m + Vec3(0.0, 0.0, 0.125)));
  }
  bool pass() override
  {
    this->falcon_.rig.pass();
    return true;
  }
  [[nodiscard]] Vec3 force_N() const override { return this->falcon_.model->force_N(); }
  [[nodiscard]] double step_N() const override { return this->falcon_.model->step_N(); }
  void fallSilent() override { this->falcon_.model->silentFor = forEver; }

private:
  FalconRig falcon_;
};

class TwoDiyArm final : public CountingArm
{
public:
  [[nodiscard]] ArmDevice& device() override { return this->diy_.rig.device; }
  [[nodiscard]] const Clock& clock() const override { return this->diy_.time; }
  [[nodiscard]] std::string open() override
  {
    std::string problem = this->device().open();
    this->diy_.setInPose();
    return problem;
  }
  void lead(const Vec3& from_m) override { ASSERT_TRUE(this->diy_.model->lead(from_m + Vec3(0.01, 0.085, 0.0))); }
  bool pass() override
  {
    this->diy_.rig.pass();
    return true;
  }
  [[nodiscard]] Vec3 force_N() const override { return this->diy_.model->force_N(); }
  [[nodiscard]] double step_N() const override { return this->diy_.model->step_N(); }
  void fallSilent() override { this->diy_.model->silentFor = forEver; }
  [[nodiscard]] bool inPlane() const override { return true; }

private:
  TwoDiyRig diy_;
};

/// On real sockets: an answer that this computer's stall has kept back for 5 ms counts as none, and no force follows. A
/// test waits for it, so that it answers no later message.
class HaplyArm final : public SilentArm
{
public:
  [[nodiscard]] ArmDevice& device() override { return this->rig_.device; }
  [[nodiscard]] const Clock& clock() const override { return this->rig_.time; }
  [[nodiscard]] std::string open() override
  {
    this->rig_.says.velocity_m_per_s.setZero();
    this->rig_.service.say(this->rig_.says);
    std::string problem = this->device().open();
    return problem.empty() && !this->allAnswered() ? "the service does not answer its greeting" : problem;
  }
  void lead(const Vec3& from_m) override
  {
    this->rig_.says.position_m = from_m + Vec3(0.0, -0.12, 0.15);
    this->rig_.service.say(this->rig_.says);
  }
  bool pass() override
  {
    const bool doubted = this->missed_;
    const std::uint64_t before = this->device().link().answers();
    this->sent_ += this->device().link().pass() ? 1 : 0;
    this->missed_ = this->device().link().answers() == before;
    this->rig_.time.pass(this->rig_.says.answer == FakeService::Says::Answer::Nothing ? wait_ns : perMs_ns);
    return (!this->missed_ || this->allAnswered()) && !doubted;
  }
  [[nodiscard]] Vec3 force_N() const override { return this->rig_.service.force_N(); }
  void fallSilent() override
  {
    this->rig_.says.answer = FakeService::Says::Answer::Nothing;
    this->rig_.service.say(this->rig_.says);
  }

private:
  bool allAnswered()
  {
    return eventually([this] { return this->rig_.service.answered() >= this->sent_; });
  }

  HaplyRig rig_;
  int sent_ = 1; ///< messages, of which the greeting is the first
  bool missed_ = false;
};

/// Its library reports an error instead of falling silent.
class ForceDimensionArm final : public LibraryArm
{
public:
  ForceDimensionArm() : LibraryArm(PALPATE_FAKE_DHD) {}
  ~ForceDimensionArm() override
  {
    this->grip_(0.0, -1);
    this->fail_(0);
  }
  ForceDimensionArm(const ForceDimensionArm&) = delete;
  ForceDimensionArm& operator=(const ForceDimensionArm&) = delete;

  [[nodiscard]] ArmDevice& device() override { return this->rig_.device; }
  [[nodiscard]] const Clock& clock() const override { return this->rig_.time; }
  [[nodiscard]] std::string open() override { return this->device().open(); }
  bool pass() override
  {
    static_cast<void>(this->device().link().pass());
    this->rig_.time.pass(perMs_ns);
    return true;
  }
  [[nodiscard]] Vec3 force_N() const override { return { this->force_(0), this->force_(1), this->force_(2) }; }
  void fallSilent() override { this->fail_(1); }
  [[nodiscard]] const char* silence() const override { return "made-up failure"; }
  /// It has a gripper, which is open so far [rad].
  void openGripper(double rad) { this->grip_(rad, 0); }

private:
  LibraryRig rig_{ forceDimensionKit(PALPATE_FAKE_DHD) };
  double (*force_)(int) = fakeFunction<double(int)>(PALPATE_FAKE_DHD, "fakeForce");
  void (*fail_)(int) = fakeFunction<void(int)>(PALPATE_FAKE_DHD, "fakeFail");
  void (*grip_)(double, int) = fakeFunction<void(double, int)>(PALPATE_FAKE_DHD, "fakeGrip");
};

/// Its scheduler calls once an exchange, with the order of that exchange. An order that waits for longer than 20 ms for
/// the call, by this computer's clock, has ended.
class OpenHapticsArm final : public LibraryArm
{
public:
  OpenHapticsArm() : LibraryArm(PALPATE_FAKE_HD) { this->rate_(0); }
  ~OpenHapticsArm() override { this->rate_(1000); }
  OpenHapticsArm(const OpenHapticsArm&) = delete;
  OpenHapticsArm& operator=(const OpenHapticsArm&) = delete;

  [[nodiscard]] ArmDevice& device() override { return this->rig_.device; }
  [[nodiscard]] const Clock& clock() const override { return this->rig_.time; }
  [[nodiscard]] std::string open() override
  {
    std::string problem = this->device().open();
    this->call_();
    return problem;
  }
  bool pass() override
  {
    const auto began = std::chrono::steady_clock::now();
    static_cast<void>(this->device().link().pass());
    if (!this->silent_)
    {
      this->call_();
    }
    this->rig_.time.pass(this->silent_ ? wait_ns : perMs_ns);
    return std::chrono::steady_clock::now() - began < std::chrono::milliseconds(20);
  }
  [[nodiscard]] Vec3 force_N() const override { return { this->force_(0), this->force_(1), this->force_(2) }; }
  void fallSilent() override { this->silent_ = true; }
  [[nodiscard]] const char* silence() const override { return "the vendor's scheduler does not call back"; }

private:
  bool silent_ = false; ///< its scheduler
  LibraryRig rig_{ openHapticsKit(PALPATE_FAKE_HD) };
  double (*force_)(int) = fakeFunction<double(int)>(PALPATE_FAKE_HD, "fakeForce");
  void (*rate_)(int) = fakeFunction<void(int)>(PALPATE_FAKE_HD, "fakeRate");
  void (*call_)() = fakeFunction<void()>(PALPATE_FAKE_HD, "fakeCall");
};

/// One of each kit.
using SessionArms = testing::Types<WoodenHapticsArm, FalconArm, TwoDiyArm, HaplyArm, ForceDimensionArm, OpenHapticsArm>;

/// Force Dimension's library as it is called by a thread of the device: a call may not return.
class HangingArm final : public SessionArm
{
public:
  HangingArm() { this->device_.prove(); }
  ~HangingArm() override
  {
    this->goOn();
    this->place_(0.01, 0.02, -0.03, 0.1);
  }
  HangingArm(const HangingArm&) = delete;
  HangingArm& operator=(const HangingArm&) = delete;

  [[nodiscard]] ArmDevice& device() override { return this->device_; }
  [[nodiscard]] const Clock& clock() const override { return this->rig_.time; }
  [[nodiscard]] std::string open() override { return this->device_.open(); }
  void lead(const Vec3& from_m) override { this->place_(from_m.x(), from_m.y(), from_m.z(), 0.0); }
  /// Waits for an answer to the newest order.
  bool pass() override
  {
    const std::uint64_t answers = this->device_.link().answers() + 2; // the first may be that of an order before
    for (int i = 0; i < 5000 && !this->hangs_ && this->device_.link().answers() < answers; ++i)
    {
      this->device_.await();
    }
    this->rig_.time.pass(perMs_ns);
    return true;
  }
  [[nodiscard]] Vec3 force_N() const override { return { this->force_(0), this->force_(1), this->force_(2) }; }
  /// Returns when a call hangs.
  [[nodiscard]] bool hang()
  {
    this->hold_(1);
    this->hangs_ = eventually([this] { return this->isHeld_() != 0; });
    return this->hangs_;
  }
  void goOn() { this->hold_(0); }

private:
  LibraryRig rig_{ forceDimensionKit(PALPATE_FAKE_DHD) };
  ArmDevice device_{ "arm", rig_.kit.bus, rig_.found[0].entry, rig_.kit.setup, { true, &rig_.time } };
  double (*force_)(int) = fakeFunction<double(int)>(PALPATE_FAKE_DHD, "fakeForce");
  void (*hold_)(int) = fakeFunction<void(int)>(PALPATE_FAKE_DHD, "fakeHold");
  int (*isHeld_)() = fakeFunction<int()>(PALPATE_FAKE_DHD, "fakeIsHeld");
  void (*place_)(double, double, double, double) = fakeFunction<void(double, double, double, double)>(
    PALPATE_FAKE_DHD, "fakePlace");
  bool hangs_ = false;
};

} // namespace palpate::test
