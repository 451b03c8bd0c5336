// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "devices/common/HeldTrust.h"
#include "devices/common/LinkedDevice.h"
#include "devices/hid/pid/PidOutput.h"
#include "devices/io/ServedLink.h"
#include "haptics/core/HapticDevice.h"

namespace palpate
{

/// Options of a device behind a link; the defaults are for users, other values for tests.
struct PushedDeviceOptions
{
  PidOutputOptions output;
  bool threads = true;          ///< false: no threads, the link's passes are called from outside
  const Clock* clock = nullptr; ///< null: the system's monotonic clock; must outlive the device
};

/// Properties of a device of that kind that are known before it is opened; lengths and forces are assumptions.
[[nodiscard]] inline DeviceInfo pushedInfo(
  const std::string& name, const HidEntry& entry, const PidKind& kind, const PidScale& scale)
{
  DeviceInfo info;
  info.name = name;
  info.serial = entry.serial;
  info.deviceClass = kind.deviceClass;
  info.abilities = promised(kind);
  info.workspaceRadius_m = { scale.halfTravel_m, false };
  info.maxForce_N = { scale.maxForce_N, false };
  if (info.abilities.holdsWalls)
  {
    info.heldStiffness_N_per_m = { scale.springStiffness_N_per_m, false };
    info.heldForce_N = { scale.maxForce_N, false };
  }
  return info;
}

/// A joystick, wheel or base behind a link with a reader and a writer thread of its own. Reading and writing are
/// wait-free whatever the device does. Its lengths and forces are assumptions until they are measured.
template<class Link>
class PushedDevice
  : public HapticDevice
  , public LinkedDevice
  , public WallHolder
{
public:
  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override
  {
    const auto work = [](Link& link)
    {
      return typename ServedLink<Link>::Work{ { [&link] { return link.writePass(); }, writerIdle_ms, writerPriority,
                                                [&link] { link.detach(); }, {} },
        { [&link] { return link.readPass(readTimeout_ms); }, noDevice_ms, 0, {}, {} } };
    };
    this->link_->trust(this->options_.output.trust); // again, as a link that hung was replaced
    std::string problem = this->options_.threads ? this->link_.open(work) : this->link_.open({});
    this->believe();
    return problem;
  }
  void close() noexcept override { this->link_.close(); }
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override
  {
    const auto heard = this->link_->heard();
    if (!heard.hand)
    {
      return heard.there ? DeviceStatus::Waiting : DeviceStatus::Lost;
    }
    sample = {};
    sample.time_s = tickTime_s;
    sample.pose_D.p = heard.hand->p_D;
    sample.buttons = heard.hand->buttons;
    sample.grip = heard.hand->grip;
    return DeviceStatus::Ok;
  }
  void write(const DeviceCommand& command) noexcept override { this->link_->command(command); }

  [[nodiscard]] LinkReport linkReport() const override { return this->link_->report(); }
  [[nodiscard]] DeviceAbilities abilitiesNow() const override
  {
    return believed(this->offered(), this->options_.output.trust);
  }

  void trust(HeldTrust trust) noexcept override
  {
    this->options_.output.trust = trust;
    this->link_->trust(trust);
    this->believe();
  }
  [[nodiscard]] DeviceAbilities offered() const override { return this->link_->abilities().value_or(this->promised_); }

  [[nodiscard]] Link& link() noexcept { return *this->link_; }

protected:
  /// `info`: properties that are known before the device is opened.
  PushedDevice(DeviceInfo info, const PushedDeviceOptions& options, typename ServedLink<Link>::Make make)
    : info_(std::move(info)), options_(options), promised_(this->info_.abilities), link_(options.clock, std::move(make))
  {
    this->info_.effectsEndAfter_s = 1e-3 * options.output.duration_ms;
    this->believe();
  }

  DeviceInfo info_;
  PushedDeviceOptions options_;

private:
  static constexpr int readTimeout_ms = 10; ///< largest delay before a write that hangs is noticed
  static constexpr int writerPriority = 19; ///< just below the servo
  static constexpr int writerIdle_ms = 1, noDevice_ms = 20;

  /// Puts the abilities that the device is trusted with into its info.
  void believe()
  {
    this->info_.offersWalls = this->offered().offersWalls();
    this->info_.abilities = this->abilitiesNow();
  }

  DeviceAbilities promised_; ///< by its descriptor or its driver

protected:
  ServedLink<Link> link_;
};

} // namespace palpate
