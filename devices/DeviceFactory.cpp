// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/DeviceFactory.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "devices/FedDevice.h"
#include "devices/ReplayDevice.h"
#include "devices/arm/ArmDevice.h"
#include "devices/arm/kit/Kits.h"
#include "devices/calibration/CalibratedDevice.h"
#include "devices/calibration/CalibrationFiles.h"
#include "devices/calibration/SelfTest.h"
#include "devices/common/DeviceSteps.h"
#include "devices/evdev/EvdevDevice.h"
#include "devices/evdev/EvdevDiscovery.h"
#include "devices/hid/HidapiBus.h"
#include "devices/hid/NamedDevices.h"
#include "devices/hid/pid/PidEngine.h"
#include "devices/io/HidDiscovery.h"
#include "devices/io/PidDevice.h"
#include "devices/io/SpaceMouseDevice.h"
#include "devices/simulated/AdmittanceDevice.h"

namespace palpate
{
namespace
{

struct Kind
{
  std::string name;
  std::string what;
  std::function<MadeDevice(const DeviceOptions&)> make;
  std::string problem = {}; ///< why it cannot be used now
  bool hasTwin = false, hasGrip = false, forPrograms = false, isAssumed = false;
};

/// Calls make(hand) with the hand that holds the device, if there is one of that name.
template<class Make>
MadeDevice makeHeld(const DeviceOptions& options, const Make& make)
{
  if (const HandModel* const hand = handModel(options.hand))
  {
    return { make(*hand), "" };
  }
  std::string names;
  for (const HandModel& known : handModels())
  {
    names += (names.empty() ? "" : ", ") + known.name;
  }
  return { nullptr, "hand \"" + options.hand + "\" is unknown; valid names: " + names };
}

MadeDevice makeSimulated(const DeviceModel& model, const DeviceOptions& options)
{
  return makeHeld(options,
    [&](const HandModel& hand)
    {
      SimulationOptions simulation;
      simulation.period_s = options.period_s;
      simulation.delay_ticks = options.delay_ticks;
      return std::make_unique<SimulatedDevice>(model, hand, options.stroke, simulation);
    });
}

MadeDevice makeAdmittance(const DeviceOptions& options)
{
  return makeHeld(options,
    [&](const HandModel& hand)
    {
      AdmittancePlan plan;
      plan.period_s = options.period_s;
      plan.noise_N = 0.02; // typical of a small sensor of 50 N
      return std::make_unique<AdmittanceDevice>(plan, hand, options.stroke);
    });
}

std::vector<Kind> builtIn()
{
  std::vector<Kind> all{
    { "fed", "poses set by a program",
      [](const DeviceOptions&) {
        return MadeDevice{ std::make_unique<FedDevice>(), "" };
      },
      "", false, false, true },
    { "mouse", "the mouse in the view",
      [](const DeviceOptions&) {
        return MadeDevice{ FedDevice::mouse(), "" };
      } },
  };
  for (const std::vector<DeviceModel>* models : { &deviceModels(), &armModels() })
  {
    for (const DeviceModel& model : *models)
    {
      all.push_back({ model.name, "a simulated hand on " + model.what,
        [&model](const DeviceOptions& options) { return makeSimulated(model, options); }, "", false, true, true });
    }
  }
  all.push_back({ "simulated-admittance", "a simulated hand on a robot with a force sensor: 2 kg and 10 N s/m, virtual",
    makeAdmittance, "", false, true, true });
  all.push_back({ "replay", "the hand of a recording", [](const DeviceOptions& o) {
                   return MadeDevice{ std::make_unique<ReplayDevice>(o.recordingFile), "" };
                 } });
  return all;
}

std::unique_ptr<HapticDevice> makePluggedIn(
  FoundHid::Kind kind, const std::string& name, const std::shared_ptr<HidBus>& bus, const HidEntry& entry)
{
  if (kind == FoundHid::Kind::SpaceMouse)
  {
    return std::make_unique<SpaceMouseDevice>(name, bus, entry);
  }
  return std::make_unique<PidDevice>(name, bus, entry);
}

Kind kindOf(const FoundHid& found, const std::shared_ptr<HidBus>& bus)
{
  const auto make = [bus, found](const DeviceOptions&) {
    return MadeDevice{ makePluggedIn(found.kind, found.name, bus, found.entry), "", "", found.hasTwin };
  };
  const std::string what = found.kind == FoundHid::Kind::ForceFeedback ? "force feedback through USB: "
                           : found.kind == FoundHid::Kind::SpaceMouse  ? "six axes, no force: "
                                                                       : "cannot be used: ";
  return { found.name, what + found.entry.name, make, found.problem, found.hasTwin,
    PidEngine::hasSafetySwitch(found.descriptor) };
}

Kind kindOf(const FoundEvdev& found, const std::shared_ptr<EvdevBus>& bus)
{
  const auto make = [bus, found](const DeviceOptions&) {
    return MadeDevice{ std::make_unique<EvdevDevice>(found.name, bus, found.entry), "", "", found.hasTwin };
  };
  const bool pushes = found.kind.pushes.problem.empty();
  const std::string what = pushes ? "force feedback through the kernel's driver: " : "cannot be used: ";
  return { found.name, what + found.entry.name, make, found.problem, found.hasTwin };
}

Kind kindOf(const FoundArm& found)
{
  ArmSetup setup = found.setup;
  setup.problem = found.problem;
  const auto make = [name = found.name, entry = found.entry, hasTwin = found.hasTwin, bus = found.kit->bus, setup](
                      const DeviceOptions&) {
    return MadeDevice{ std::make_unique<ArmDevice>(name, bus, entry, setup), "", "", hasTwin };
  };
  const std::string what = setup.what + (found.note.empty() ? "" : ", " + found.note);
  Kind kind{ found.name, what, make, found.problem, found.hasTwin, setup.grips };
  kind.isAssumed = found.isAssumed;
  return kind;
}

/// The kits of arms, each with the places where its arm is searched.
std::shared_ptr<const std::vector<ArmKit>> armKits(const DeviceOptions& options)
{
  if (options.arms != nullptr || options.hid != nullptr || options.evdev != nullptr)
  {
    return options.arms;
  }
  return std::make_shared<const std::vector<ArmKit>>(systemArmKits());
}

std::shared_ptr<EvdevBus> eventDevices(const DeviceOptions& options)
{
  return options.hid != nullptr || options.evdev != nullptr ? options.evdev : systemEvdevBus();
}

/// One device is listed once: a device that HID cannot use may be one that the kernel's driver pushes, and one that an
/// owner's arm file names is that arm.
std::vector<Kind> pluggedIn(const DeviceOptions& options)
{
  const std::shared_ptr<const std::vector<ArmKit>> kits = armKits(options);
  const auto isOthers = [&kits](const HidEntry& entry) { return kits != nullptr && isClaimed(*kits, entry); };
  const std::shared_ptr<HidBus> bus = options.hid != nullptr ? options.hid : systemHidBus();
  const std::shared_ptr<EvdevBus> events = eventDevices(options);
  const std::vector<FoundEvdev> driven = events != nullptr ? findEvdevDevices(*events) : std::vector<FoundEvdev>{};
  std::vector<Kind> all;
  for (const FoundHid& found : findHidDevices(*bus))
  {
    const auto isIt = [&](const FoundEvdev& other) { return sameKind(found.entry, other.entry); };
    const bool isDriven = found.kind == FoundHid::Kind::Unusable && std::any_of(driven.begin(), driven.end(), isIt);
    if (!isDriven && !isOthers(found.entry))
    {
      all.push_back(kindOf(found, bus));
    }
  }
  for (const FoundEvdev& found : driven)
  {
    if (!isOthers(found.entry))
    {
      all.push_back(kindOf(found, events));
    }
  }
  for (const FoundArm& found : kits != nullptr ? findArms(*kits) : std::vector<FoundArm>{})
  {
    all.push_back(kindOf(found));
  }
  return all;
}

constexpr const char* toDo = "; remove the file, or check the device again";

/// The kept calibration, and the trust from this session's check where the device has no serial number.
KeptCalibration knownOf(const DeviceInfo& info, const std::string& folder, const std::optional<Calibration>& felt)
{
  KeptCalibration kept = loadCalibration(folder, info.name, info.serial);
  if (kept.value && felt && info.serial.empty() && felt->serial.empty() && felt->device == info.name)
  {
    kept.value->held = felt->held;
  }
  return kept;
}

void makeWheelIfSaid(MadeDevice& made, bool wheel)
{
  if (wheel && made.device->info().deviceClass == DeviceClass::Joystick2D)
  {
    const Calibration one = wheelCalibration(made.device->info(), today());
    made.device = std::make_unique<CalibratedDevice>(std::move(made.device), one);
  }
}

/// An arm whose pushes have passed along each of its axes gives all of its force. Without a serial number a file may be
/// another arm's: then only a check of this session counts.
void proveIfChecked(HapticDevice& device, const Calibration& kept, const std::optional<Calibration>& felt)
{
  auto* const unproven = dynamic_cast<ProvenDevice*>(&device);
  const DeviceInfo& info = device.info();
  const Calibration* const checked = !info.serial.empty()                ? &kept
                                     : felt && felt->device == info.name ? &*felt
                                                                         : nullptr;
  const int axes = SelfTestPlan::forDevice(info).axes;
  if (unproven != nullptr && checked != nullptr && checked->serial == info.serial && checked->axisCount == axes)
  {
    unproven->prove();
  }
}

/// Puts the calibration that is kept of a device around it. One whose calibration cannot be read is taken away.
void calibrate(MadeDevice& made, const DeviceOptions& options)
{
  if (!made.device || !made.device->info().rendersForce)
  {
    return;
  }
  const DeviceInfo& info = made.device->info();
  if (options.wheel && info.deviceClass == DeviceClass::Joystick2D && info.knowsAxes)
  {
    made.problem = info.name + ": " + armIsNoWheel;
    made.device = nullptr;
    return;
  }
  KeptCalibration kept = knownOf(info, options.calibrationFolder, options.felt);
  const bool isUnsure = made.hasTwin && (kept.value || !kept.problem.empty());
  if (isUnsure || (!kept.value && kept.problem.empty()))
  {
    makeWheelIfSaid(made, options.wheel);
    if (isUnsure)
    {
      made.warning = twinNote;
    }
    return;
  }
  if (!kept.value)
  {
    made.device = nullptr;
    made.problem = kept.problem + toDo;
    return;
  }
  if (options.wheel && info.deviceClass == DeviceClass::Joystick2D)
  {
    kept.value->axisCount = 1;
  }
  proveIfChecked(*made.device, *kept.value, options.felt);
  made.device = std::make_unique<CalibratedDevice>(std::move(made.device), *kept.value);
  made.warning = std::move(kept.problem);
}

} // namespace

std::vector<KnownDevice> knownDevices(const DeviceOptions& options)
{
  std::vector<KnownDevice> known;
  for (const std::vector<Kind>& kinds : { builtIn(), pluggedIn(options) })
  {
    for (const Kind& kind : kinds)
    {
      known.push_back({ kind.name, kind.what, kind.make({}).device->info(), kind.problem, kind.hasTwin, kind.hasGrip,
        kind.forPrograms, kind.isAssumed });
    }
  }
  return known;
}

std::string preferredDevice(const std::vector<KnownDevice>& devices)
{
  const auto isThere = [](const KnownDevice& d)
  { return d.problem.empty() && !d.info.simulated && !d.forPrograms && !d.isAssumed; };
  const auto pushes = [&](const KnownDevice& d) { return isThere(d) && d.info.rendersForce; };
  auto best = std::find_if(devices.begin(), devices.end(), pushes);
  best = best == devices.end() ? std::find_if(devices.begin(), devices.end(), isThere) : best;
  return best == devices.end() ? "mouse" : best->name;
}

void applyCalibrations(
  std::vector<KnownDevice>& devices, const std::string& calibrationFolder, const std::optional<Calibration>& felt)
{
  for (KnownDevice& device : devices)
  {
    const KeptCalibration kept =
      device.info.rendersForce && !device.hasTwin ? knownOf(device.info, calibrationFolder, felt) : KeptCalibration{};
    if (kept.value)
    {
      device.info = calibratedInfo(device.info, *kept.value);
    }
    else if (!kept.problem.empty() && device.problem.empty())
    {
      device.problem = kept.problem + toDo;
    }
  }
}

MadeDevice makeDevice(const std::string& name, const DeviceOptions& options)
{
  std::string names;
  // Plugged devices are looked for only where nothing else has the name: looking means opening them.
  for (const auto& list : { std::function(builtIn), std::function([&options] { return pluggedIn(options); }) })
  {
    for (const Kind& kind : list())
    {
      if (name == kind.name)
      {
        MadeDevice made = kind.make(options);
        calibrate(made, options);
        return made;
      }
      names += (names.empty() ? "" : ", ") + kind.name;
    }
  }
  return { nullptr, "device \"" + name + "\" is unknown; valid names: " + names };
}

} // namespace palpate
