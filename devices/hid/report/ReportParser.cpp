// SPDX-License-Identifier: GPL-3.0-or-later
// From the items of a report descriptor to its reports.
#include <algorithm>
#include <utility>

#include "devices/hid/report/ReportDescriptor.h"
#include "devices/hid/report/ReportItemState.h"
#include "devices/hid/report/ReportItems.h"

namespace palpate
{
namespace
{

constexpr std::size_t longestDescriptor = 16384;
constexpr std::size_t deepestCollection = 32;
constexpr std::uint32_t mostBitsAValue = 64, mostBitsAnElement = 256; // the kernel's; bits beyond a value pad
constexpr std::uint32_t largestCount = 4096;
constexpr std::uint32_t mostBitsAReport = 16384;

class Parser
{
public:
  explicit Parser(std::span<const std::uint8_t> bytes) noexcept : size_(bytes.size()), items_(bytes) {}

  ReportDescriptor parse()
  {
    while (const std::optional<ReportItem> item = this->problem_.empty() ? this->items_.next() : std::nullopt)
    {
      this->take(*item);
    }
    this->refuse(this->items_.problem());
    this->refuse(this->path_.empty() ? "" : "a collection is not closed");
    this->refuse(this->result_.reports.empty() ? "it describes no report" : "");
    if (!this->problem_.empty())
    {
      return { {}, std::move(this->problem_), std::move(this->result_.purposes) };
    }
    return std::move(this->result_);
  }

private:
  /// The first reason counts; an empty one is none.
  void refuse(const std::string& why)
  {
    if (this->problem_.empty() && !why.empty())
    {
      this->problem_ = "report descriptor of " + std::to_string(this->size_) + " bytes, at byte " +
                       std::to_string(this->items_.begin()) + ": " + why;
    }
  }

  void take(const ReportItem& item)
  {
    if (item.type != ReportItem::Type::Main)
    {
      this->refuse(this->state_.take(item));
      return;
    }
    this->mainItem(item.tag, item.value);
    this->state_.forgetLocal();
  }

  void mainItem(int tag, const ItemValue& value)
  {
    if (const std::string problem = this->state_.unfinished(); !problem.empty())
    {
      this->refuse(problem);
      return;
    }
    switch (tag)
    {
      case 8:
        this->field(HidReportKind::Input, value.plain);
        break;
      case 9:
        this->field(HidReportKind::Output, value.plain);
        break;
      case 11:
        this->field(HidReportKind::Feature, value.plain);
        break;
      case 10:
        this->openCollection();
        break;
      case 12:
        this->closeCollection();
        break;
      default:
        break; // no meaning was ever given to it; the Bluetooth stack ends descriptors with an item of zeros
    }
  }

  void openCollection()
  {
    if (this->path_.size() == deepestCollection)
    {
      this->refuse("collections more than 32 deep");
      return;
    }
    this->path_.push_back(this->state_.usages().empty() ? 0 : this->state_.usages().front());
    if (this->path_.size() == 1)
    {
      this->result_.purposes.push_back(this->path_.front());
    }
  }

  void closeCollection()
  {
    if (this->path_.empty())
    {
      this->refuse("a collection is closed that was not opened");
      return;
    }
    this->path_.pop_back();
  }

  void field(HidReportKind kind, std::uint32_t flags)
  {
    const ReportItemState::Global& state = this->state_.global();
    if (state.bitCount > mostBitsAnElement || state.count > largestCount)
    {
      this->refuse("a field of " + std::to_string(state.count) + " times " + std::to_string(state.bitCount) + " bits");
      return;
    }
    HidReport& report = this->reportOf(kind, state.report);
    const std::uint32_t first = report.bits;
    if (state.bitCount * state.count > mostBitsAReport - first)
    {
      this->refuse("report " + std::to_string(state.report) + " is longer than 16384 bits");
      return;
    }
    report.bits += state.bitCount * state.count;
    const bool padding = ((flags & 1U) != 0 && this->state_.usages().empty()) || state.bitCount > mostBitsAValue;
    if (!padding && state.bitCount * state.count > 0)
    {
      this->keep(report, first, flags);
    }
  }

  void keep(HidReport& report, std::uint32_t first, std::uint32_t flags)
  {
    const ReportItemState::Global& state = this->state_.global();
    HidField field;
    field.bit = first;
    field.bitCount = state.bitCount;
    field.count = state.count;
    field.logicalMin = state.logical.min();
    field.logicalMax = state.logical.max();
    if (field.logicalMin > field.logicalMax)
    {
      this->refuse("a range from " + std::to_string(field.logicalMin) + " down to " + std::to_string(field.logicalMax));
      return;
    }
    // Both 0 means that nothing was said; a physical range the wrong way round says nothing either.
    const bool said = state.physical.min() < state.physical.max();
    field.physicalMin = said ? state.physical.min() : field.logicalMin;
    field.physicalMax = said ? state.physical.max() : field.logicalMax;
    field.exponent = state.exponent;
    field.unit = state.unit;
    field.constant = (flags & 1U) != 0;
    field.variable = (flags & 2U) != 0;
    field.relative = (flags & 4U) != 0;
    field.path = this->path_;
    field.usages = this->state_.usages();
    if (field.variable && !field.usages.empty())
    {
      field.usages.resize(field.count, field.usages.back());
    }
    report.fields.push_back(std::move(field));
  }

  HidReport& reportOf(HidReportKind kind, std::uint8_t id)
  {
    for (HidReport& report : this->result_.reports)
    {
      if (report.kind == kind && report.id == id)
      {
        return report;
      }
    }
    return this->result_.reports.emplace_back(HidReport{ kind, id, 0, {} });
  }

  std::size_t size_;
  ReportItems items_;
  ReportItemState state_;
  std::vector<HidUsage> path_;
  ReportDescriptor result_;
  std::string problem_;
};

} // namespace

ReportDescriptor parseReportDescriptor(std::span<const std::uint8_t> bytes)
{
  if (bytes.size() > longestDescriptor)
  {
    return { {}, "report descriptor of " + std::to_string(bytes.size()) + " bytes: longer than 16384" };
  }
  return Parser(bytes).parse();
}

} // namespace palpate
