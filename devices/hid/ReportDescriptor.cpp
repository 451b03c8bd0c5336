// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/ReportDescriptor.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{

constexpr std::size_t longestDescriptor = 16384;
constexpr std::size_t deepestCollection = 32;
constexpr std::size_t deepestPush = 16;
constexpr std::uint32_t longestRange = 4096;
constexpr std::uint32_t mostBitsAValue = 64;
constexpr std::uint32_t largestCount = 4096;
constexpr std::uint32_t mostBitsAReport = 16384;

/// A number of an item as it stands and with its sign.
struct ItemValue
{
  std::uint32_t plain = 0;
  std::int32_t withSign = 0;
  std::size_t bytes = 0;
};

/// A range whose upper end is read without sign once the lower one turns out not to be negative: many descriptors write
/// 255 in one byte, which would be -1.
struct Range
{
  ItemValue low;
  ItemValue high;

  [[nodiscard]] std::int64_t min() const noexcept { return this->low.withSign; }
  [[nodiscard]] std::int64_t max() const noexcept
  {
    return this->low.withSign >= 0 ? std::int64_t{ this->high.plain } : std::int64_t{ this->high.withSign };
  }
};

struct GlobalState
{
  std::uint32_t page = 0;
  Range logical;
  Range physical;
  int exponent = 0;
  std::uint32_t unit = 0;
  std::uint32_t bitCount = 0;
  std::uint32_t count = 0;
  std::uint8_t report = 0;
};

struct LocalState
{
  std::vector<HidUsage> usages;
  HidUsage rangeStart = 0;
  bool rangeOpen = false;
};

class Parser
{
public:
  explicit Parser(std::span<const std::uint8_t> bytes) noexcept : bytes_(bytes) {}

  ReportDescriptor parse()
  {
    while (this->at_ < this->bytes_.size() && this->problem_.empty())
    {
      this->begin_ = this->at_;
      this->item();
    }
    if (this->problem_.empty() && !this->path_.empty())
    {
      this->refuse("a collection is not closed");
    }
    if (this->problem_.empty() && this->result_.reports.empty())
    {
      this->refuse("it describes no report");
    }
    if (!this->problem_.empty())
    {
      return { {}, std::move(this->problem_) };
    }
    return std::move(this->result_);
  }

private:
  enum class Type : std::uint8_t
  {
    Main,
    Global,
    Local,
  };

  void refuse(const std::string& why)
  {
    if (this->problem_.empty())
    {
      this->problem_ = "report descriptor of " + std::to_string(this->bytes_.size()) + " bytes, at byte " +
                       std::to_string(this->begin_) + ": " + why;
    }
  }

  void item()
  {
    const std::uint8_t prefix = this->bytes_[this->at_++];
    constexpr std::uint8_t longItem = 0xFE;
    if (prefix == longItem)
    {
      this->skipLongItem();
      return;
    }
    const std::size_t size = (prefix & 3) == 3 ? 4 : prefix & 3;
    if (size > this->bytes_.size() - this->at_)
    {
      this->refuse("an item runs past the end");
      return;
    }
    const ItemValue value = this->valueOf(size);
    const int tag = prefix >> 4;
    switch (static_cast<Type>((prefix >> 2) & 3))
    {
      case Type::Main:
        this->mainItem(tag, value);
        this->local_ = {};
        break;
      case Type::Global:
        this->globalItem(tag, value);
        break;
      case Type::Local:
        this->localItem(tag, value);
        break;
    }
  }

  /// Its second byte says how many follow its tag; no meaning has ever been given to one.
  void skipLongItem()
  {
    const std::size_t left = this->bytes_.size() - this->at_;
    if (left < 2 || left - 2 < this->bytes_[this->at_])
    {
      this->refuse("a long item runs past the end");
      return;
    }
    this->at_ += 2 + std::size_t{ this->bytes_[this->at_] };
  }

  ItemValue valueOf(std::size_t size)
  {
    ItemValue value{ 0, 0, size };
    for (std::size_t i = 0; i < size; ++i)
    {
      value.plain |= std::uint32_t{ this->bytes_[this->at_++] } << (8 * i);
    }
    const auto unusedBits = static_cast<std::uint32_t>(32 - 8 * size);
    value.withSign = size == 0 ? 0 : static_cast<std::int32_t>(value.plain << unusedBits) >> unusedBits;
    return value;
  }

  void globalItem(int tag, const ItemValue& value)
  {
    GlobalState& state = this->global_;
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
        this->reportItem(tag, value);
    }
  }

  /// Four bits in two's complement: 0xD is -3.
  static int exponentOf(std::uint32_t plain) noexcept
  {
    const int nibble = static_cast<int>(plain & 0xF);
    return nibble < 8 ? nibble : nibble - 16;
  }

  void reportItem(int tag, const ItemValue& value)
  {
    GlobalState& state = this->global_;
    switch (tag)
    {
      case 7:
        state.bitCount = value.plain;
        break;
      case 8:
        state.report = static_cast<std::uint8_t>(value.plain);
        if (value.plain == 0 || value.plain > 255)
        {
          this->refuse("report ID " + std::to_string(value.plain) + " is not 1 to 255");
        }
        break;
      case 9:
        state.count = value.plain;
        break;
      case 10:
        this->push();
        break;
      case 11:
        this->pop();
        break;
      default:
        this->refuse("an item of unknown kind");
    }
  }

  void push()
  {
    if (this->pushed_.size() == deepestPush)
    {
      this->refuse("more than 16 pushes");
      return;
    }
    this->pushed_.push_back(this->global_);
  }

  void pop()
  {
    if (this->pushed_.empty())
    {
      this->refuse("a pop without a push");
      return;
    }
    this->global_ = this->pushed_.back();
    this->pushed_.pop_back();
  }

  /// A usage of four bytes brings its own page.
  [[nodiscard]] HidUsage usageOf(const ItemValue& value) const noexcept
  {
    return value.bytes == 4 ? value.plain : this->global_.page << 16 | value.plain;
  }

  void localItem(int tag, const ItemValue& value)
  {
    switch (tag)
    {
      case 0:
        this->addUsages(this->usageOf(value), this->usageOf(value));
        break;
      case 1:
        this->local_.rangeStart = this->usageOf(value);
        this->local_.rangeOpen = true;
        break;
      case 2:
        this->closeRange(this->usageOf(value));
        break;
      default:
        break; // designators, strings and delimiters say nothing about bits
    }
  }

  void closeRange(HidUsage last)
  {
    if (!this->local_.rangeOpen || last < this->local_.rangeStart)
    {
      this->refuse("a range of usages ends before it begins");
      return;
    }
    this->addUsages(this->local_.rangeStart, last);
    this->local_.rangeOpen = false;
  }

  void addUsages(HidUsage first, HidUsage last)
  {
    if (last - first >= longestRange || this->local_.usages.size() + (last - first) >= longestRange)
    {
      this->refuse("more than 4096 usages for one item");
      return;
    }
    for (HidUsage i = 0; i <= last - first; ++i)
    {
      this->local_.usages.push_back(first + i);
    }
  }

  void mainItem(int tag, const ItemValue& value)
  {
    if (this->local_.rangeOpen)
    {
      this->refuse("a range of usages has no end");
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
        this->refuse("an item of unknown kind");
    }
  }

  void openCollection()
  {
    if (this->path_.size() == deepestCollection)
    {
      this->refuse("collections more than 32 deep");
      return;
    }
    this->path_.push_back(this->local_.usages.empty() ? 0 : this->local_.usages.front());
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
    const GlobalState& state = this->global_;
    if (state.bitCount > mostBitsAValue || state.count > largestCount)
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
    const bool padding = (flags & 1U) != 0 && this->local_.usages.empty();
    if (!padding && state.bitCount * state.count > 0)
    {
      this->keep(report, first, flags);
    }
  }

  void keep(HidReport& report, std::uint32_t first, std::uint32_t flags)
  {
    const GlobalState& state = this->global_;
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
    field.usages = this->local_.usages;
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

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0; ///< of the item that is read
  GlobalState global_;
  LocalState local_;
  std::vector<GlobalState> pushed_;
  std::vector<HidUsage> path_;
  ReportDescriptor result_;
  std::string problem_;
};

} // namespace

bool HidField::isWithin(HidUsage collection) const noexcept
{
  return std::find(this->path.begin(), this->path.end(), collection) != this->path.end();
}

const HidReport* ReportDescriptor::report(HidReportKind kind, HidUsage collection) const noexcept
{
  for (const HidReport& candidate : this->reports)
  {
    for (const HidField& field : candidate.fields)
    {
      if (candidate.kind == kind && field.isWithin(collection))
      {
        return &candidate;
      }
    }
  }
  return nullptr;
}

const HidReport* ReportDescriptor::reportById(HidReportKind kind, std::uint8_t id) const noexcept
{
  for (const HidReport& candidate : this->reports)
  {
    if (candidate.kind == kind && candidate.id == id)
    {
      return &candidate;
    }
  }
  return nullptr;
}

bool ReportDescriptor::hasCollection(HidUsage collection) const noexcept
{
  return std::any_of(this->reports.begin(), this->reports.end(),
    [collection](const HidReport& report)
    {
      return std::any_of(report.fields.begin(), report.fields.end(),
        [collection](const HidField& field) { return field.isWithin(collection); });
    });
}

bool ReportDescriptor::numbered() const noexcept
{
  return std::any_of(
    this->reports.begin(), this->reports.end(), [](const HidReport& report) { return report.id != 0; });
}

ReportDescriptor parseReportDescriptor(std::span<const std::uint8_t> bytes)
{
  if (bytes.size() > longestDescriptor)
  {
    return { {}, "report descriptor of " + std::to_string(bytes.size()) + " bytes: longer than 16384" };
  }
  return Parser(bytes).parse();
}

HidControl findControl(const HidReport& report, HidUsage usage, HidUsage parent) noexcept
{
  for (const HidField& field : report.fields)
  {
    const bool placed = parent == 0 || (!field.path.empty() && field.path.back() == parent);
    const auto found = std::find(field.usages.begin(), field.usages.end(), usage);
    if (placed && found != field.usages.end())
    {
      const auto index = static_cast<std::uint32_t>(found - field.usages.begin());
      return { &report, &field, field.variable ? index : std::min(index, field.count - 1) };
    }
  }
  return {};
}

HidSelector findSelector(const HidReport& report, HidUsage usage) noexcept
{
  const HidControl control = findControl(report, usage);
  if (!control || control.field->variable)
  {
    return { control, 1 };
  }
  const auto& usages = control.field->usages;
  const std::int64_t index = std::find(usages.begin(), usages.end(), usage) - usages.begin();
  return { { control.report, control.field, 0 }, control.field->logicalMin + index };
}

} // namespace palpate
