// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace palpate
{

enum class HidReportKind : std::uint8_t
{
  Input,
  Output,
  Feature,
};

/// Meaning of a control or a collection: page in the upper, number in the lower 16 bits.
using HidUsage = std::uint32_t;

/// Elements of one main item: `count` values of `bitCount` each, side by side.
struct HidField
{
  std::uint32_t bit = 0; ///< of the first element, counted after the byte with the report's ID
  std::uint32_t bitCount = 0;
  std::uint32_t count = 0;
  std::vector<HidUsage>
    usages; ///< Variable: one an element; Array: meanings of the values logicalMin, logicalMin + 1, ...
  std::int64_t logicalMin = 0;
  std::int64_t logicalMax = 0;
  std::int64_t physicalMin = 0; ///< may be left over from an earlier item: never rely on it alone
  std::int64_t physicalMax = 0;
  int exponent = 0; ///< of ten, of the unit
  std::uint32_t unit = 0;
  bool constant = false;
  bool variable = false; ///< else an array of selectors
  bool relative = false;
  std::vector<HidUsage> path; ///< the collections around it, outermost first

  [[nodiscard]] bool isWithin(HidUsage collection) const noexcept;
};

/// Reports are told apart by kind and ID: an ID may come back in another kind.
struct HidReport
{
  HidReportKind kind = HidReportKind::Input;
  std::uint8_t id = 0;    ///< 0: the device has one report a kind and sends no ID
  std::uint32_t bits = 0; ///< after the ID, padding included
  std::vector<HidField> fields;

  /// Of the whole report with its ID in front, as hidapi takes it. (A report without ID is read without that byte.)
  [[nodiscard]] std::size_t bytes() const noexcept { return 1 + (std::size_t{ this->bits } + 7) / 8; }
};

/// One element of a field of a report.
struct HidControl
{
  const HidReport* report = nullptr;
  const HidField* field = nullptr;
  std::uint32_t element = 0;

  [[nodiscard]] explicit operator bool() const noexcept { return this->field != nullptr; }
};

/// A device's description of its reports: Device Class Definition for HID 1.11, sections 6.2.2 and 5.
struct ReportDescriptor
{
  std::vector<HidReport> reports;
  std::string problem;                 ///< empty, or the fault of the bytes and its place; then there are no reports
  std::vector<HidUsage> purposes = {}; ///< of its outermost collections; with a problem of those before it

  /// The first report of that kind with a field within the collection, or null.
  [[nodiscard]] const HidReport* report(HidReportKind kind, HidUsage collection) const noexcept;
  /// Some collection has this usage.
  [[nodiscard]] bool hasCollection(HidUsage collection) const noexcept;
  /// Reports begin with their ID.
  [[nodiscard]] bool numbered() const noexcept;
};

/// Reads the bytes of a report descriptor. Never fails half: a descriptor that is cut, contradicts itself or asks for
/// more than any device has (256 bits an element, 4096 elements a field, 16384 bits a report, 32 collections) is
/// refused whole. Like the kernel it passes over main items without a meaning, and takes the ends of a range of usages
/// in either order. Data wider than 64 bits have their place but are no field.
[[nodiscard]] ReportDescriptor parseReportDescriptor(std::span<const std::uint8_t> bytes);

/// The element with that usage, where its innermost collection is `parent` if one is given: the axes of a joystick
/// stand in several places. Also found where a value is wrongly declared an array.
[[nodiscard]] HidControl findControl(const HidReport& report, HidUsage usage, HidUsage parent = 0) noexcept;

/// The field that selects one of several usages and lists this one: an array, or bits of their own. An array that
/// begins with 0 means none by it, and the first usage by 1: so the kernel drives devices of this kind.
struct HidSelector
{
  HidControl control;
  std::int64_t value = 0; ///< to be written there
  [[nodiscard]] explicit operator bool() const noexcept { return static_cast<bool>(this->control); }
};
[[nodiscard]] HidSelector findSelector(const HidReport& report, HidUsage usage) noexcept;

} // namespace palpate
