// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "devices/calibration/Calibration.h"

namespace palpate
{

/// Where a person's calibrations are kept, from the values of XDG_CONFIG_HOME and HOME (null: not set); empty: nowhere.
[[nodiscard]] std::string userCalibrationFolder(const char* xdgConfigHome, const char* home);

/// The file of one device in a folder: one per name and serial number, whatever characters these have.
[[nodiscard]] std::string calibrationFile(
  const std::string& folder, const std::string& device, const std::string& serial);

/// The date here and now, YYYY-MM-DD.
[[nodiscard]] std::string today();

/// The calibration of a device. The problem names a file that cannot be used and why; empty too where there is none.
using KeptCalibration = Outcome<std::optional<Calibration>>;

/// The calibration of a device. Where its file is damaged, the previous file is used, except for its statements
/// of walls that the device holds; `problem` says so.
[[nodiscard]] KeptCalibration loadCalibration(
  const std::string& folder, const std::string& device, const std::string& serial);

/// Keeps a calibration, and beside it the calibration that it replaces. The file is whole at every moment; if it cannot
/// be written, the old one stays. Measured walls are not kept without a serial number: the next
/// device of that name may be another one. Empty, or one sentence that names the file and why.
[[nodiscard]] std::string saveCalibration(const std::string& folder, const Calibration& calibration);

/// A fault of walls or viscosity in a check replaces the statement of a kept calibration:
/// trust ends without being asked for. Empty, or one sentence that names the file and why it could not be written.
[[nodiscard]] std::string takeBackTrust(
  const std::string& folder, const std::string& device, const std::string& serial, HeldProof proof);

} // namespace palpate
