// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/calibration/Calibration.h"
#include "devices/hid/HidConnection.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/core/HapticDevice.h"

namespace palpate
{

class EvdevBus; // its header has the kernel's macros
struct ArmKit;

/// Options for the creation of a device; each kind uses its own part.
struct DeviceOptions
{
  HandPath stroke;             ///< simulated devices
  std::string hand = "stylus"; ///< who holds them: none, light, stylus, firm
  int delay_ticks = 0;         ///< of a simulated link
  std::string recordingFile;   ///< replay
  double period_s = 1e-3;
  std::shared_ptr<HidBus> hid;     ///< where real devices are looked for; null: this computer
  std::optional<Calibration> felt; ///< result of a check in this session for a device without a distinct serial number
  bool wheel = false;              ///< the person says that it is one, whatever it calls itself
  std::shared_ptr<EvdevBus> evdev; ///< the same, behind the kernel's drivers; null: this computer unless `hid` is given
  std::shared_ptr<const std::vector<ArmKit>> arms; ///< the same of arms; null: this computer's unless `hid` is given
  std::string calibrationFolder;                   ///< folder of calibrations that are applied; empty: none
};

/// One device this build knows.
struct KnownDevice
{
  std::string name;
  std::string what; ///< one line for a person
  DeviceInfo info;
  std::string problem;      ///< empty, or the reason against its use now, and the remedy
  bool hasTwin = false;     ///< another one is plugged in that nothing tells apart: see twinNote
  bool hasGrip = false;     ///< it can tell whether it is gripped
  bool forPrograms = false; ///< its hand is led by a program: a person alone cannot use it
  bool isAssumed = false;   ///< its vendor's library may know it, but nothing shows that it is plugged in
};

/// Of a device with a twin, for a person. The calibration of one of the two may be wrong for the other.
inline constexpr const char* twinNote = "Another attached device has the same kind and no distinct serial number: no "
                                        "calibration is used or saved. Attach only one of them.";

/// Of a device without a grip sensor, for a person who chose the grip as dead-man switch.
inline constexpr const char* noGripNote =
  "The device has no grip sensor: with the grip as dead-man switch it renders no force; choose a button.";

/// All devices this build knows and all that are plugged in, usable or not.
[[nodiscard]] std::vector<KnownDevice> knownDevices(const DeviceOptions& options = {});

/// The most likely choice: the first that is plugged in, can be used and pushes, else the first that is
/// plugged in and can be used, else the mouse.
[[nodiscard]] std::string preferredDevice(const std::vector<KnownDevice>& devices);

/// Adds the calibration of each device to its description, or the fault of that file.
void applyCalibrations(
  std::vector<KnownDevice>& devices, const std::string& calibrationFolder, const std::optional<Calibration>& felt = {});

/// A device by name, or null and a sentence that names the known ones. A device whose calibration cannot be read is not
/// given: it may push the wrong way.
struct MadeDevice
{
  std::unique_ptr<HapticDevice> device;
  std::string problem;
  std::string warning = {}; ///< of a usable device: notes for a person
  bool hasTwin = false;     ///< as KnownDevice says
};
[[nodiscard]] MadeDevice makeDevice(const std::string& name, const DeviceOptions& options);

} // namespace palpate
