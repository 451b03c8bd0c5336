// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/arm/ArmLine.h"
#include "devices/arm/library/GripSwitch.h"
#include "devices/arm/library/SharedLibrary.h"

namespace palpate
{

/// The functions of Force Dimension's library that are called, declared by hand: metres, newtons; below 0: an error.
struct DhdFunctions
{
  explicit DhdFunctions(const std::string& name);

  /// The library's text for the last error.
  [[nodiscard]] std::string why() const;

  SharedLibrary library;
  int (*count)() = nullptr;
  int (*openAt)(char) = nullptr;
  int (*close)(char) = nullptr;
  const char* (*lastError)() = nullptr;
  int (*place)(double*, double*, double*, double (*)[3], char) = nullptr;
  int (*velocity)(double*, double*, double*, char) = nullptr;
  int (*buttons)(char) = nullptr;
  int (*push)(double, double, double, double, double, double, double, char) = nullptr;
  int (*enable)(unsigned char, char) = nullptr;
  int (*watchdog)(unsigned char, char) = nullptr;
  int (*gripper)(double*, char) = nullptr; ///< [rad]; null in a library without it
};

/// An arm of Force Dimension's: the library is called once an exchange. Its watchdog ends the force of a program that
/// dies. A gripper is a switch, and is never pushed: a session has one force at one point.
class DhdLine final : public ArmLine
{
public:
  [[nodiscard]] static ArmBus::Opened open(const std::shared_ptr<DhdFunctions>& dhd, int index);
  ~DhdLine() override;
  DhdLine(const DhdLine&) = delete;
  DhdLine& operator=(const DhdLine&) = delete;

  [[nodiscard]] Answer exchange(const WireOrder& order, int timeout_ms) override;
  void letGo() noexcept override;
  [[nodiscard]] std::string error() const override { return this->error_; }

private:
  DhdLine(std::shared_ptr<DhdFunctions> dhd, char id) : dhd_(std::move(dhd)), id_(id) {}
  [[nodiscard]] bool failed(int result);
  [[nodiscard]] bool isGripped();

  std::shared_ptr<DhdFunctions> dhd_;
  char id_;
  GripSwitch grip_;
  std::string error_;
};

} // namespace palpate
