// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/VirtualSpaceMouse.h"

#include <algorithm>

#include "testing/devices/hid/DescriptorWriter.h"

namespace palpate::test
{
namespace
{

using Kind = HidReportKind;

constexpr std::uint8_t translationId = 1, rotationId = 2, buttonId = 3, batteryId = 0x17;
constexpr std::uint8_t oneValue = DescriptorWriter::variable, keyList = DescriptorWriter::array, relativeFlag = 0x04;
constexpr int every_ms = 16, batteryEvery_ms = 500;
constexpr std::size_t keysAtOnce = 4;

void axes(DescriptorWriter& w, const CapLayout& layout, std::uint16_t first, std::uint16_t last)
{
  w.page(1).logical(-layout.range, layout.range).physical(-4 * layout.range, 4 * layout.range);
  w.size(16, static_cast<std::uint32_t>(last - first + 1));
  for (std::uint16_t usage = first; usage <= last; ++usage)
  {
    w.usage(usage);
  }
  w.main(Kind::Input, static_cast<std::uint8_t>(oneValue | (layout.relative ? relativeFlag : 0)));
}

void buttons(DescriptorWriter& w, const CapLayout& layout)
{
  w.page(9).physical(0, 0);
  if (layout.buttonArray)
  {
    w.logical(1, 8).size(8, keysAtOnce).usageRange(1, 8).main(Kind::Input, keyList);
    return;
  }
  w.logical(0, 1).size(1, 8).usageRange(1, 8).main(Kind::Input, oneValue);
}

} // namespace

CapLayout wiredCap()
{
  return { "wired cap" };
}

CapLayout newerCap()
{
  CapLayout layout{ "newer cap" };
  layout.split = layout.relative = false;
  return layout;
}

CapLayout radioCap()
{
  CapLayout layout = newerCap();
  layout.name = "radio cap";
  layout.battery = true;
  return layout;
}

CapLayout manyKeyCap()
{
  CapLayout layout = newerCap();
  layout.name = "many-key cap";
  layout.buttonArray = true;
  return layout;
}

CapLayout plainCap()
{
  CapLayout layout = newerCap();
  layout.name = "plain cap";
  layout.numbered = false;
  layout.range = 32767;
  return layout;
}

std::vector<CapLayout> allCaps()
{
  return { wiredCap(), newerCap(), radioCap(), manyKeyCap(), plainCap() };
}

std::vector<std::uint8_t> descriptorOf(const CapLayout& layout)
{
  DescriptorWriter w;
  const auto begin = [&](std::uint8_t id) { layout.numbered ? w.reportId(id) : w; };
  w.page(1).usage(0x08).begin(1).begin(0);
  begin(translationId);
  axes(w, layout, 0x30, layout.split ? 0x32 : 0x35);
  w.end();
  if (layout.split)
  {
    w.begin(0);
    begin(rotationId);
    axes(w, layout, 0x33, 0x35);
    w.end();
  }
  w.begin();
  begin(buttonId);
  buttons(w, layout);
  w.end();
  if (layout.battery)
  {
    w.begin().reportId(batteryId).page(6).logical(0, 100).size(8).usage(0x20).main(Kind::Input, oneValue).end();
  }
  return w.end().bytes();
}

std::vector<std::uint8_t> VirtualSpaceMouse::nextInput()
{
  if (this->inputs.empty())
  {
    return {};
  }
  std::vector<std::uint8_t> oldest = std::move(this->inputs.front());
  this->inputs.pop_front();
  return oldest;
}

void VirtualSpaceMouse::advance(int duration_ms)
{
  for (int i = 0; i < duration_ms; ++i)
  {
    ++this->age_ms_;
    if (this->silent)
    {
      continue;
    }
    const bool pressed = std::any_of(this->cap.begin(), this->cap.end(), [](std::int64_t at) { return at != 0; });
    if (this->age_ms_ % every_ms == 0 && (pressed || this->told_ != this->cap))
    {
      this->tellAxes();
    }
    if (this->buttons != this->toldButtons_)
    {
      this->tellButtons();
    }
    if (this->layout_.battery && this->age_ms_ % batteryEvery_ms == 0)
    {
      this->inputs.push_back({ batteryId, 80 });
    }
  }
}

void VirtualSpaceMouse::tell(std::uint8_t id, std::size_t first, std::size_t count)
{
  std::vector<std::uint8_t> bytes;
  if (this->layout_.numbered)
  {
    bytes.push_back(id);
  }
  for (std::size_t axis = first; axis < first + count; ++axis)
  {
    const auto plain = static_cast<std::uint16_t>(this->cap[axis]);
    bytes.push_back(static_cast<std::uint8_t>(plain & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(plain >> 8));
  }
  if (!this->layout_.numbered)
  {
    this->appendButtons(bytes);
  }
  this->inputs.push_back(std::move(bytes));
}

void VirtualSpaceMouse::tellAxes()
{
  this->told_ = this->cap;
  this->tell(translationId, 0, this->layout_.split ? 3 : 6);
  if (this->layout_.split)
  {
    this->tell(rotationId, 3, 3);
  }
}

void VirtualSpaceMouse::tellButtons()
{
  this->toldButtons_ = this->buttons;
  if (!this->layout_.numbered)
  {
    this->tell(0, 0, 6);
    return;
  }
  std::vector<std::uint8_t> bytes{ buttonId };
  this->appendButtons(bytes);
  this->inputs.push_back(std::move(bytes));
}

void VirtualSpaceMouse::appendButtons(std::vector<std::uint8_t>& bytes) const
{
  if (!this->layout_.buttonArray)
  {
    bytes.push_back(this->buttons);
    return;
  }
  const std::size_t end = bytes.size() + keysAtOnce;
  for (std::uint8_t button = 0; button < 8 && bytes.size() < end; ++button)
  {
    if ((this->buttons >> button & 1) != 0)
    {
      bytes.push_back(static_cast<std::uint8_t>(button + 1));
    }
  }
  bytes.resize(end, 0);
}

} // namespace palpate::test
