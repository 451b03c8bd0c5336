// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/PidLayout.h"

#include <algorithm>

#include "testing/devices/hid/DescriptorWriter.h"

namespace palpate::test
{
namespace
{

using Kind = HidReportKind;

constexpr std::uint8_t value = DescriptorWriter::variable, array = DescriptorWriter::array,
                       constantValue = DescriptorWriter::variable | DescriptorWriter::constant,
                       padding = DescriptorWriter::constant;
constexpr std::uint16_t desktop = 0x01, physicalInterface = 0x0F;
constexpr std::uint32_t seconds = 0x1003;

/// Writes the reports of one layout.
class LayoutWriter
{
public:
  explicit LayoutWriter(const PidLayout& layout) : layout_(layout) {}

  std::vector<std::uint8_t> bytes()
  {
    this->w_.page(desktop).usage(0x04).begin(1);
    this->axes();
    this->w_.page(physicalInterface);
    this->state();
    this->setEffect();
    this->condition();
    this->periodic();
    this->constantForce();
    this->operation();
    this->control();
    this->features();
    this->w_.end();
    return this->w_.bytes();
  }

private:
  void number(Kind kind, const PidNumber& number, std::uint8_t flags = value)
  {
    if (this->layout_.sloppy && number.min == 0 && number.max == 255)
    {
      this->w_.item(1, 1, 0, 1).item(1, 2, 255, 1);
    }
    else
    {
      this->w_.logical(number.min, number.max);
    }
    this->w_.size(number.bitCount);
    if (this->layout_.sloppy)
    {
      this->w_.wideUsage(0x0F0000U | number.usage);
    }
    else
    {
      this->w_.usage(number.usage);
    }
    this->w_.main(kind, flags);
  }

  void pad(Kind kind, std::uint32_t bits)
  {
    if (bits > 0)
    {
      this->w_.size(bits).main(kind, padding);
    }
  }

  void block(Kind kind) { this->number(kind, { 0x22, 8, 1, 40 }); }

  void choice(Kind kind, std::uint8_t collection, const std::vector<std::uint8_t>& usages)
  {
    this->w_.usage(collection).begin().logical(1, static_cast<std::int64_t>(usages.size())).size(8);
    for (const std::uint8_t usage : usages)
    {
      this->w_.usage(usage);
    }
    this->w_.main(kind, array).end();
  }

  void axes()
  {
    const PidNumber& axis = this->layout_.axis;
    this->w_.reportId(this->layout_.inputId)
      .usage(0x01)
      .begin(0)
      .logical(axis.min, axis.max)
      .size(axis.bitCount, this->layout_.axes);
    this->w_.usage(0x30);
    if (this->layout_.axes > 1)
    {
      this->w_.usage(0x31);
    }
    this->w_.main(Kind::Input, value).end();
    this->w_.page(9).usageRange(1, 8).logical(0, 1).size(1, 8).main(Kind::Input, value);
  }

  void state()
  {
    if (this->layout_.stateId == 0)
    {
      return;
    }
    this->w_.reportId(this->layout_.stateId).usage(0x92).begin().logical(0, 1).size(1, 5);
    this->w_.usages({ 0x9F, 0xA0, 0xA4, 0xA5, 0xA6 }).main(Kind::Input, value);
    this->pad(Kind::Input, 3);
    this->number(Kind::Input, { 0x94, 1, 0, 1 });
    this->number(Kind::Input, { 0x22, 7, 1, 40 });
    this->w_.end();
  }

  void times()
  {
    this->w_.unit(seconds).exponent(-3);
    for (const std::uint8_t usage : { 0x50, 0x54, 0x51 })
    {
      this->number(Kind::Output, { usage, 16, 0, this->layout_.longestDuration });
    }
    if (this->layout_.hasStartDelay)
    {
      this->number(Kind::Output, { 0xA7, 16, 0, 65535 });
    }
    this->w_.unit(0).exponent(0);
  }

  void setEffect()
  {
    this->w_.reportId(this->layout_.setEffectId).usage(0x21).begin();
    this->block(Kind::Output);
    this->choice(Kind::Output, 0x25, this->layout_.effects);
    this->times();
    if (this->layout_.hasEffectGain)
    {
      this->w_.physical(0, 10000); // stays behind for the fields that follow
      this->number(Kind::Output, { 0x52, 8, 0, 255 });
    }
    this->number(Kind::Output, { 0x53, 8, this->layout_.firstTrigger, 8 });
    this->axesEnable();
    this->number(Kind::Output, { 0x56, 1, 0, 1 });
    this->pad(Kind::Output, 7 - std::max(1U, this->layout_.forceAxes));
    this->w_.usage(0x57).begin().wideUsage(0x0A0001).wideUsage(0x0A0002).logical(0, this->layout_.wholeTurn);
    this->w_.size(this->layout_.wholeTurn > 255 ? 16 : 8, 2).main(Kind::Output, value).end().end();
  }

  void axesEnable()
  {
    constexpr HidUsage x = 0x010030, y = 0x010031, slider = 0x010036;
    this->w_.usage(0x55).begin().wideUsage(this->layout_.forceAxes > 0 ? x : slider);
    if (this->layout_.forceAxes > 1)
    {
      this->w_.wideUsage(y);
    }
    this->w_.logical(0, 1).size(1, std::max(1U, this->layout_.forceAxes)).main(Kind::Output, value).end();
  }

  void condition()
  {
    this->w_.reportId(this->layout_.conditionId).usage(0x5F).begin();
    this->block(Kind::Output);
    this->number(Kind::Output, { 0x23, 4, 0, 3 });
    this->w_.usage(0x58).begin().wideUsage(0x0A0001).wideUsage(0x0A0002).logical(0, 3).size(2, 2);
    this->w_.main(Kind::Output, value).end();
    for (const PidNumber& field : this->layout_.condition)
    {
      this->number(Kind::Output, field);
    }
    this->w_.end();
  }

  void periodic()
  {
    if (this->layout_.periodicId == 0)
    {
      return;
    }
    this->w_.reportId(this->layout_.periodicId).usage(0x6E).begin();
    this->block(Kind::Output);
    this->number(Kind::Output, { 0x70, 16, 0, 10000 });
    this->number(Kind::Output, { 0x6F, 16, -10000, 10000 });
    this->number(Kind::Output, { 0x71, 16, 0, 36000 });
    this->w_.unit(seconds).exponent(-3);
    this->number(Kind::Output, { 0x72, 16, 0, 65535 });
    this->w_.unit(0).exponent(0).end();
  }

  void constantForce()
  {
    if (this->layout_.constantId == 0)
    {
      return;
    }
    this->w_.reportId(this->layout_.constantId).usage(0x73).begin();
    this->block(Kind::Output);
    this->number(Kind::Output, this->layout_.magnitude);
    this->w_.end();
  }

  void operation()
  {
    this->w_.reportId(this->layout_.operationId).usage(0x77).begin();
    this->block(Kind::Output);
    this->choice(Kind::Output, 0x78, this->layout_.operations);
    this->number(Kind::Output, { 0x7C, 8, 0, 255 });
    this->w_.end();
  }

  void control()
  {
    this->w_.reportId(this->layout_.freeId).usage(0x90).begin();
    this->block(Kind::Output);
    this->w_.end().reportId(this->layout_.controlId).usage(0x95).begin();
    if (this->layout_.controlBits)
    {
      const auto count = static_cast<std::uint32_t>(this->layout_.controls.size());
      this->w_.usage(0x96).begin().logical(0, 1).size(1, count);
      for (const std::uint8_t usage : this->layout_.controls)
      {
        this->w_.usage(usage);
      }
      this->w_.main(Kind::Output, value);
      this->pad(Kind::Output, 8 - count);
      this->w_.end();
    }
    else
    {
      this->choice(Kind::Output, 0x96, this->layout_.controls);
    }
    this->w_.end().reportId(this->layout_.gainId).usage(0x7D).begin();
    this->number(Kind::Output, { 0x7E, 8, 0, 255 });
    this->w_.end();
  }

  void features()
  {
    if (this->layout_.createId != 0)
    {
      this->w_.reportId(this->layout_.createId).usage(0xAB).begin();
      this->choice(Kind::Feature, 0x25, this->layout_.effects);
      this->w_.wideUsage(0x01003B).logical(0, 511).size(10).main(Kind::Feature, value);
      this->pad(Kind::Feature, 6);
      this->w_.end().reportId(this->layout_.loadId).usage(0x89).begin();
      this->number(Kind::Feature, { 0x22, 8, 0, 40 });
      this->choice(Kind::Feature, 0x8B, { 0x8C, 0x8D, 0x8E });
      this->number(Kind::Feature, { 0xAC, 16, 0, 65535 }, this->layout_.sloppy ? array : value);
      this->w_.end();
    }
    const std::uint8_t readOnly = this->layout_.sloppy ? constantValue : value;
    this->w_.reportId(this->layout_.poolId).usage(0x7F).begin();
    this->number(Kind::Feature, { 0x80, 16, 0, 65535 }, readOnly);
    this->number(Kind::Feature, { 0x83, 8, 0, 255 }, readOnly);
    this->number(Kind::Feature, { 0xA9, 1, 0, 1 }, readOnly);
    this->number(Kind::Feature, { 0xAA, 1, 0, 1 }, readOnly);
    this->pad(Kind::Feature, 6);
    this->w_.end();
  }

  const PidLayout& layout_;
  DescriptorWriter w_;
};

} // namespace

const PidNumber* PidLayout::conditionNumber(std::uint8_t usage) const noexcept
{
  const auto found = std::find_if(
    this->condition.begin(), this->condition.end(), [usage](const PidNumber& n) { return n.usage == usage; });
  return found == this->condition.end() ? nullptr : &*found;
}

std::vector<std::uint8_t> descriptorOf(const PidLayout& layout)
{
  return LayoutWriter(layout).bytes();
}

PidLayout plainLayout()
{
  PidLayout layout;
  layout.name = "plain";
  return layout;
}

PidLayout adapterLayout()
{
  PidLayout layout;
  layout.name = "adapter";
  layout.inputId = 8;
  layout.axis = { 0x30, 16, -512, 511 };
  layout.setEffectId = 1, layout.conditionId = 3, layout.periodicId = 4, layout.constantId = 5;
  layout.operationId = 10, layout.freeId = 11, layout.controlId = 12, layout.gainId = 13;
  layout.createId = 5, layout.loadId = 6, layout.poolId = 7;
  layout.effects.push_back(0x28);
  layout.controls = { 0x97, 0x98, 0x99, 0x9A };
  layout.longestDuration = 32767;
  layout.hasStartDelay = false;
  layout.firstTrigger = 1;
  layout.wholeTurn = 180;
  layout.condition = { { 0x60, 8, -128, 127 }, { 0x61, 8, -128, 127 } };
  layout.magnitude = { 0x70, 16, -255, 255 };
  layout.sloppy = true;
  layout.slots = 16;
  layout.habits.bindsTrigger = layout.habits.wakesCentred = layout.habits.wipesSilently = true;
  return layout;
}

PidLayout hobbyLayout()
{
  PidLayout layout;
  layout.name = "hobby";
  layout.inputId = 3;
  layout.setEffectId = 1, layout.conditionId = 3, layout.periodicId = 4, layout.constantId = 5;
  layout.operationId = 10, layout.freeId = 11, layout.controlId = 12, layout.gainId = 13;
  layout.createId = 5, layout.loadId = 6, layout.poolId = 7;
  layout.effects = { 0x26, 0x27, 0x30, 0x31, 0x32, 0x33, 0x34, 0x40, 0x41, 0x42, 0x43, 0x28, 0x28 };
  layout.hasStartDelay = false;
  layout.firstTrigger = 1;
  layout.wholeTurn = 255;
  layout.sloppy = true;
  layout.slots = 14;
  layout.habits.wipesSilently = true;
  return layout;
}

PidLayout driverManagedLayout()
{
  PidLayout layout;
  layout.name = "driver-managed";
  layout.axis = { 0x30, 16, 0, 4096 };
  layout.setEffectId = 0x0B, layout.conditionId = 0x0F, layout.constantId = 0x0D, layout.poolId = 0x0B;
  layout.createId = layout.loadId = 0;
  layout.effects = { 0x26, 0x30, 0x32, 0x31, 0x33, 0x34, 0x40, 0x41 };
  layout.operations = { 0x7B, 0x79, 0x7A };
  layout.controls = { 0x9A, 0x99, 0x97, 0x98 };
  layout.hasEffectGain = false;
  layout.firstTrigger = 1;
  layout.wholeTurn = 255;
  layout.condition = { { 0x61, 8, -100, 100 }, { 0x62, 8, -100, 100 }, { 0x60, 16, -500, 500 }, { 0x65, 16, 0, 1000 },
    { 0x63, 8, 0, 100 }, { 0x64, 8, 0, 100 } };
  layout.magnitude = { 0x70, 8, -127, 127 };
  layout.deviceManaged = false;
  layout.sloppy = true;
  return layout;
}

PidLayout officeLayout()
{
  PidLayout layout = driverManagedLayout();
  layout.name = "office";
  layout.createId = 5, layout.loadId = 6;
  layout.deviceManaged = true;
  return layout;
}

PidLayout flightLayout()
{
  PidLayout layout;
  layout.name = "flight";
  layout.axis = { 0x30, 16, -4096, 4096 };
  layout.setEffectId = 101, layout.conditionId = 103, layout.periodicId = 104, layout.constantId = 105;
  layout.operationId = 110, layout.freeId = 111, layout.controlId = 112, layout.gainId = 113;
  layout.createId = 5, layout.loadId = 6, layout.poolId = 7;
  layout.controls = { 0x98, 0x97, 0x99, 0x9A };
  layout.wholeTurn = 255;
  layout.condition = { { 0x60, 16, -4096, 4096 }, { 0x61, 16, -4096, 4096 }, { 0x62, 16, -4096, 4096 },
    { 0x63, 16, 0, 4096 }, { 0x64, 16, 0, 4096 }, { 0x65, 16, 0, 4096 } };
  layout.magnitude = { 0x70, 16, -4096, 4096 };
  return layout;
}

PidLayout openBoardLayout()
{
  PidLayout layout;
  layout.name = "open board";
  layout.setEffectId = 1, layout.conditionId = 3, layout.constantId = 5;
  layout.createId = 0x11, layout.loadId = 0x12, layout.poolId = 0x13;
  layout.condition = { { 0x60, 16, -32767, 32767 }, { 0x61, 16, -32767, 32767 }, { 0x62, 16, -32767, 32767 },
    { 0x63, 16, 0, 32767 }, { 0x64, 16, 0, 32767 }, { 0x65, 16, 0, 32767 } };
  layout.magnitude = { 0x70, 16, -32767, 32767 };
  layout.habits.stopAllDisables = true;
  layout.habits.conditions = ConditionOrder::OnlyWithSetEffect;
  return layout;
}

PidLayout oneSidedLayout()
{
  PidLayout layout = plainLayout();
  layout.name = "one-sided";
  layout.condition.pop_back();
  return layout;
}

PidLayout wheelLayout()
{
  PidLayout layout = plainLayout();
  layout.name = "wheel";
  layout.axes = 1;
  return layout;
}

PidLayout pedalWheelLayout()
{
  PidLayout layout = plainLayout();
  layout.name = "wheel with pedals";
  layout.forceAxes = 1;
  return layout;
}

PidLayout rumbleLayout()
{
  PidLayout layout = plainLayout();
  layout.name = "rumble pad";
  layout.effects = { 0x30, 0x31, 0x32 };
  layout.constantId = 0;
  return layout;
}

PidLayout buzzerLayout()
{
  PidLayout layout = plainLayout();
  layout.name = "buzzer";
  layout.effects = { 0x26 };
  layout.periodicId = 0;
  layout.forceAxes = 0;
  return layout;
}

PidLayout bitControlLayout()
{
  PidLayout layout = plainLayout();
  layout.name = "bit control";
  layout.controlBits = true;
  return layout;
}

std::vector<PidLayout> allLayouts()
{
  return { plainLayout(), adapterLayout(), hobbyLayout(), officeLayout(), flightLayout(), openBoardLayout(),
    oneSidedLayout(), bitControlLayout() };
}

} // namespace palpate::test
