// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/report/ReportItemState.h"

namespace palpate
{
namespace
{

constexpr std::size_t deepestPush = 16;
constexpr std::uint32_t longestRange = 4096;

/// Four bits in two's complement: 0xD is -3.
int exponentOf(std::uint32_t plain) noexcept
{
  const int nibble = static_cast<int>(plain & 0xF);
  return nibble < 8 ? nibble : nibble - 16;
}

} // namespace

std::string ReportItemState::take(const ReportItem& item)
{
  return item.type == ReportItem::Type::Global  ? this->takeGlobal(item.tag, item.value)
         : item.type == ReportItem::Type::Local ? this->takeLocal(item.tag, item.value)
                                                : "";
}

std::string ReportItemState::unfinished() const
{
  return this->rangeStart_ ? "a range of usages has no end"
         : this->rangeEnd_ ? "a range of usages has no beginning"
                           : "";
}

void ReportItemState::forgetLocal() noexcept
{
  this->usages_.clear();
  this->rangeStart_.reset();
  this->rangeEnd_.reset();
}

std::string ReportItemState::takeGlobal(int tag, const ItemValue& value)
{
  Global& state = this->global_;
  switch (tag)
  {
    case 0:
      state.page = value.plain & 0xFFFF;
      break;
    case 1:
      state.logical.low = value;
      break;
    case 2:
      state.logical.high = value;
      break;
    case 3:
      state.physical.low = value;
      break;
    case 4:
      state.physical.high = value;
      break;
    case 5:
      state.exponent = exponentOf(value.plain);
      break;
    case 6:
      state.unit = value.plain;
      break;
    default:
      return this->takeReport(tag, value);
  }
  return {};
}

std::string ReportItemState::takeReport(int tag, const ItemValue& value)
{
  switch (tag)
  {
    case 7:
      this->global_.bitCount = value.plain;
      return {};
    case 8:
      return this->setReport(value);
    case 9:
      this->global_.count = value.plain;
      return {};
    case 10:
      return this->push();
    case 11:
      return this->pop();
    default:
      return "an item of unknown kind";
  }
}

std::string ReportItemState::setReport(const ItemValue& value)
{
  this->global_.report = static_cast<std::uint8_t>(value.plain);
  const bool possible = value.plain > 0 && value.plain <= 255;
  return possible ? "" : "report ID " + std::to_string(value.plain) + " is not 1 to 255";
}

std::string ReportItemState::push()
{
  if (this->pushed_.size() == deepestPush)
  {
    return "more than 16 pushes";
  }
  this->pushed_.push_back(this->global_);
  return {};
}

std::string ReportItemState::pop()
{
  if (this->pushed_.empty())
  {
    return "a pop without a push";
  }
  this->global_ = this->pushed_.back();
  this->pushed_.pop_back();
  return {};
}

/// A usage of four bytes brings its own page.
HidUsage ReportItemState::usageOf(const ItemValue& value) const noexcept
{
  return value.bytes == 4 ? value.plain : this->global_.page << 16 | value.plain;
}

std::string ReportItemState::takeLocal(int tag, const ItemValue& value)
{
  switch (tag)
  {
    case 0:
      return this->addUsages(this->usageOf(value), this->usageOf(value));
    case 1:
      this->rangeStart_ = this->usageOf(value);
      return this->closeRange();
    case 2:
      this->rangeEnd_ = this->usageOf(value);
      return this->closeRange();
    default:
      return {}; // designators, strings and delimiters say nothing about bits
  }
}

/// Once both ends are there, whichever came first.
std::string ReportItemState::closeRange()
{
  if (!this->rangeStart_ || !this->rangeEnd_)
  {
    return {};
  }
  const HidUsage first = *this->rangeStart_, last = *this->rangeEnd_;
  this->rangeStart_.reset();
  this->rangeEnd_.reset();
  return last < first ? "a range of usages ends before it begins" : this->addUsages(first, last);
}

std::string ReportItemState::addUsages(HidUsage first, HidUsage last)
{
  if (last - first >= longestRange || this->usages_.size() + (last - first) >= longestRange)
  {
    return "more than 4096 usages for one item";
  }
  for (HidUsage i = 0; i <= last - first; ++i)
  {
    this->usages_.push_back(first + i);
  }
  return {};
}

} // namespace palpate
