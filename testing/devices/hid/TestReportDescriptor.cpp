// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include <gtest/gtest.h>

#include "devices/hid/report/ReportBits.h"
#include "devices/hid/report/ReportDescriptor.h"
#include "testing/devices/hid/DescriptorWriter.h"
#include "testing/devices/hid/ReportWithId.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::DescriptorWriter;
using Kind = HidReportKind;

constexpr std::uint8_t value = DescriptorWriter::variable, array = DescriptorWriter::array;

/// One input field of page 1 in an application collection.
DescriptorWriter oneField(const std::function<void(DescriptorWriter&)>& globals, std::uint8_t flags = value)
{
  DescriptorWriter writer;
  writer.page(1).usage(4).begin(1).usage(0x30).logical(0, 1).size(8);
  globals(writer);
  writer.main(Kind::Input, flags).end();
  return writer;
}

/// The only field of a descriptor.
HidField onlyField(const DescriptorWriter& writer)
{
  const ReportDescriptor parsed = parseReportDescriptor(writer.bytes());
  EXPECT_EQ(parsed.problem, "");
  EXPECT_EQ(parsed.reports.size(), 1u);
  return parsed.problem.empty() && !parsed.reports[0].fields.empty() ? parsed.reports[0].fields[0] : HidField{};
}

std::string problemOf(const DescriptorWriter& writer)
{
  const ReportDescriptor parsed = parseReportDescriptor(writer.bytes());
  EXPECT_TRUE(parsed.reports.empty());
  return parsed.problem;
}

TEST(ReportDescriptor, AMaximumThatLooksNegativeIsReadUnsignedWhereTheMinimumIsNot)
{
  const HidField small = onlyField(oneField([](DescriptorWriter& w) { w.item(1, 1, 0, 1).item(1, 2, 0xFF, 1); }));
  EXPECT_EQ(small.logicalMin, 0);
  EXPECT_EQ(small.logicalMax, 255);
  const HidField large =
    onlyField(oneField([](DescriptorWriter& w) { w.item(1, 1, 0, 1).item(1, 2, 0xFFFFFFFF, 4).size(32); }));
  EXPECT_EQ(large.logicalMax, 4294967295);
  const HidField both = onlyField(oneField([](DescriptorWriter& w) { w.item(1, 1, 0x80, 1).item(1, 2, 0xFF, 1); }));
  EXPECT_EQ(both.logicalMin, -128);
  EXPECT_EQ(both.logicalMax, -1);
}

TEST(ReportDescriptor, AValueWronglyDeclaredAnArrayIsFoundByItsUsage)
{
  const ReportDescriptor parsed =
    parseReportDescriptor(oneField([](DescriptorWriter& w) { w.size(16).logical(0, 65535); }, array).bytes());
  ASSERT_EQ(parsed.problem, "");
  const HidControl control = findControl(parsed.reports[0], 0x10030);
  ASSERT_TRUE(control);
  const std::vector<std::uint8_t> report{ 0, 0x34, 0x12 };
  EXPECT_EQ(readControl(control, report), 0x1234);
}

TEST(ReportDescriptor, ConstantFieldsThatMeanSomethingAreKeptAndPaddingIsNot)
{
  DescriptorWriter writer;
  writer.page(0x0F).usage(0x7F).begin(1).logical(0, 1).usage(0xA9).size(1).main(Kind::Feature, 3);
  writer.size(7).main(Kind::Feature, 3).end();
  const ReportDescriptor parsed = parseReportDescriptor(writer.bytes());
  ASSERT_EQ(parsed.reports.size(), 1u);
  EXPECT_EQ(parsed.reports[0].fields.size(), 1u);
  EXPECT_TRUE(findControl(parsed.reports[0], 0x0F00A9));
  EXPECT_EQ(parsed.reports[0].bits, 8u);
}

TEST(ReportDescriptor, AUsageOfFourBytesBringsItsOwnPage)
{
  DescriptorWriter writer;
  writer.page(0x0F).usage(0x55).begin(1).wideUsage(0x00010030).usage(0x31).logical(0, 1).size(1, 2);
  writer.main(Kind::Output, value).end();
  EXPECT_EQ(onlyField(writer).usages, (std::vector<HidUsage>{ 0x00010030, 0x000F0031 }));
}

TEST(ReportDescriptor, AnUnsaidPhysicalRangeIsTheLogicalOneAndAnOldOneStays)
{
  const HidField unsaid = onlyField(oneField([](DescriptorWriter& w) { w.logical(-5, 7); }));
  EXPECT_EQ(unsaid.physicalMin, -5);
  EXPECT_EQ(unsaid.physicalMax, 7);
  DescriptorWriter writer;
  writer.page(1).usage(4).begin(1).physical(0, 10000).logical(0, 255).size(8).usage(0x30).main(Kind::Input, value);
  writer.logical(0, 3).usage(0x31).main(Kind::Input, value).end();
  const ReportDescriptor parsed = parseReportDescriptor(writer.bytes());
  ASSERT_EQ(parsed.reports.at(0).fields.size(), 2u);
  EXPECT_EQ(parsed.reports[0].fields[1].physicalMax, 10000);
  EXPECT_EQ(parsed.reports[0].fields[1].logicalMax, 3);
}

TEST(ReportDescriptor, ExponentsAreFourBitsWithSignAndUnitsAreKept)
{
  for (int power = -8; power < 8; ++power)
  {
    const HidField field = onlyField(oneField([power](DescriptorWriter& w) { w.exponent(power).unit(0x1003); }));
    EXPECT_EQ(field.exponent, power);
    EXPECT_EQ(field.unit, 0x1003u);
  }
}

TEST(ReportDescriptor, TheSameIdInAnotherKindIsAnotherReport)
{
  DescriptorWriter writer;
  writer.page(1).usage(4).begin(1).reportId(7).logical(0, 1);
  writer.usage(0x30).size(8).main(Kind::Input, value);
  writer.usage(0x31).size(16).main(Kind::Output, value);
  writer.usage(0x32).size(24).main(Kind::Feature, value).end();
  const ReportDescriptor parsed = parseReportDescriptor(writer.bytes());
  ASSERT_EQ(parsed.reports.size(), 3u);
  const std::array kinds{ Kind::Input, Kind::Output, Kind::Feature };
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    const HidReport* report = test::reportWithId(parsed, kinds[i], 7);
    ASSERT_NE(report, nullptr);
    EXPECT_EQ(report->bytes(), i + 2);
    EXPECT_TRUE(findControl(*report, static_cast<HidUsage>(0x10030 + i)));
  }
  EXPECT_TRUE(parsed.numbered());
}

TEST(ReportDescriptor, PushAndPopBringTheGlobalStateBack)
{
  DescriptorWriter writer;
  writer.page(1).usage(4).begin(1).logical(-100, 100).size(8).item(1, 10, 0, 0);
  writer.page(9).usage(1).logical(0, 1).size(1, 8).main(Kind::Input, value).item(1, 11, 0, 0);
  writer.usage(0x30).main(Kind::Input, value).end();
  const ReportDescriptor parsed = parseReportDescriptor(writer.bytes());
  ASSERT_EQ(parsed.problem, "");
  const HidControl x = findControl(parsed.reports[0], 0x10030);
  ASSERT_TRUE(x);
  EXPECT_EQ(x.field->logicalMin, -100);
  EXPECT_EQ(x.field->bit, 8u);
}

TEST(ReportDescriptor, LongItemsAreStepedOver)
{
  DescriptorWriter writer = oneField([](DescriptorWriter&) {});
  std::vector<std::uint8_t> bytes{ 0xFE, 3, 0x42, 0xA1, 0xA1, 0xA1 };
  bytes.insert(bytes.end(), writer.bytes().begin(), writer.bytes().end());
  EXPECT_EQ(parseReportDescriptor(bytes).problem, "");
}

TEST(ReportDescriptor, FewerUsagesThanElementsRepeatTheLastAndRangesCount)
{
  const HidField few = onlyField(oneField([](DescriptorWriter& w) { w.usage(0x31).size(8, 4); }));
  EXPECT_EQ(few.usages, (std::vector<HidUsage>{ 0x10030, 0x10031, 0x10031, 0x10031 }));
  DescriptorWriter writer;
  writer.page(9).usageRange(1, 8).logical(0, 1).size(1, 8).main(Kind::Input, value);
  EXPECT_EQ(onlyField(writer).usages.back(), 0x90008u);
}

TEST(ReportDescriptor, TheSameUsageInTwoPlacesIsToldApartByItsCollection)
{
  DescriptorWriter writer;
  writer.page(0x0F).usage(0x21).begin(1).logical(0, 1).size(8);
  writer.usage(0x57).begin().wideUsage(0x000A0001).main(Kind::Output, value).end();
  writer.usage(0x58).begin().wideUsage(0x000A0001).main(Kind::Output, value).end().end();
  const ReportDescriptor parsed = parseReportDescriptor(writer.bytes());
  ASSERT_EQ(parsed.problem, "");
  EXPECT_EQ(findControl(parsed.reports[0], 0x000A0001, 0x0F0057).field->bit, 0u);
  EXPECT_EQ(findControl(parsed.reports[0], 0x000A0001, 0x0F0058).field->bit, 8u);
  EXPECT_FALSE(findControl(parsed.reports[0], 0x000A0001, 0x0F0055));
}

TEST(ReportDescriptor, SelectorsAreNumbersOfAnArrayOrBitsOfTheirOwn)
{
  DescriptorWriter numbers;
  numbers.page(0x0F).usage(0x96).begin(1).logical(1, 3).size(8).usages({ 0x9A, 0x99, 0x97 }).main(Kind::Output, array);
  numbers.end();
  const ReportDescriptor byNumber = parseReportDescriptor(numbers.bytes());
  const HidSelector number = findSelector(byNumber.reports.at(0), 0x0F0097);
  EXPECT_EQ(number.value, 3);
  EXPECT_EQ(number.control.element, 0u);
  EXPECT_FALSE(findSelector(byNumber.reports[0], 0x0F0098));

  DescriptorWriter bits;
  bits.page(0x0F).usage(0x96).begin(1).logical(0, 1).size(1, 3).usages({ 0x9A, 0x99, 0x97 }).main(Kind::Output, value);
  bits.end();
  const ReportDescriptor byBit = parseReportDescriptor(bits.bytes());
  const HidSelector bit = findSelector(byBit.reports.at(0), 0x0F0097);
  EXPECT_EQ(bit.value, 1);
  EXPECT_EQ(bit.control.element, 2u);
}

// As by the Bluetooth stack, which ends a descriptor with a zero.
TEST(ReportDescriptor, MainItemsWithoutAMeaningAndZerosAtTheEndArePassedOver)
{
  DescriptorWriter writer = oneField([](DescriptorWriter& w) { w.item(0, 3, 5, 1).usage(0x30); });
  std::vector<std::uint8_t> bytes = writer.bytes();
  bytes.insert(bytes.end(), 3, 0x00);
  const ReportDescriptor parsed = parseReportDescriptor(bytes);
  EXPECT_EQ(parsed.problem, "");
  EXPECT_TRUE(findControl(parsed.reports.at(0), 0x10030));
}

// vJoy's is 120 bits wide.
TEST(ReportDescriptor, WhatIsWiderThanAValueHasItsPlaceAndIsNoField)
{
  for (const std::uint32_t wide : { 65U, 120U, 256U })
  {
    DescriptorWriter writer;
    writer.page(1).usage(4).begin(1).logical(0, 1).size(wide).usage(0x31).main(Kind::Input, value);
    writer.usage(0x30).size(8).main(Kind::Input, value).end();
    const ReportDescriptor parsed = parseReportDescriptor(writer.bytes());
    ASSERT_EQ(parsed.problem, "");
    EXPECT_EQ(findControl(parsed.reports[0], 0x10030).field->bit, wide);
    EXPECT_FALSE(findControl(parsed.reports[0], 0x10031));
  }
}

TEST(ReportDescriptor, TheEndsOfARangeOfUsagesComeInEitherOrder)
{
  DescriptorWriter writer;
  writer.page(9).item(2, 2, 3, 1).item(2, 1, 1, 1).item(2, 1, 7, 1).item(2, 2, 8, 1);
  writer.logical(0, 1).size(1, 5).main(Kind::Input, value);
  EXPECT_EQ(onlyField(writer).usages, (std::vector<HidUsage>{ 0x90001, 0x90002, 0x90003, 0x90007, 0x90008 }));
}

// The kernel's driver counts from 1 whatever the range begins with; 0 is none.
TEST(ReportDescriptor, ASelectorWhoseRangeBeginsWithZeroIsCountedFromOne)
{
  for (const std::int64_t first : { 0, 1, 5 })
  {
    DescriptorWriter numbers;
    numbers.page(0x0F).usage(0x96).begin(1).logical(first, first + 3).size(8).usages({ 0x97, 0x98, 0x99 });
    numbers.main(Kind::Output, array).end();
    const ReportDescriptor parsed = parseReportDescriptor(numbers.bytes());
    EXPECT_EQ(findSelector(parsed.reports.at(0), 0x0F0097).value, std::max<std::int64_t>(first, 1));
    EXPECT_EQ(findSelector(parsed.reports.at(0), 0x0F0099).value, std::max<std::int64_t>(first, 1) + 2);
  }
}

TEST(ReportDescriptor, ADescriptorCutAnywhereIsRefusedWithThePlace)
{
  const std::vector<std::uint8_t> whole = oneField([](DescriptorWriter&) {}).bytes();
  for (std::size_t length = 0; length < whole.size(); ++length)
  {
    const ReportDescriptor parsed = parseReportDescriptor({ whole.data(), length });
    EXPECT_TRUE(parsed.reports.empty());
    EXPECT_NE(parsed.problem.find("report descriptor of " + std::to_string(length) + " bytes"), std::string::npos);
  }
}

TEST(ReportDescriptor, LyingDescriptorsAreRefusedWithTheReason)
{
  const std::vector<std::pair<std::string, std::function<void(DescriptorWriter&)>>> lies = {
    { "from 5 down to 3", [](DescriptorWriter& w) { w.logical(5, 3); } },
    { "times 257 bits", [](DescriptorWriter& w) { w.size(257); } },
    { "4097 times", [](DescriptorWriter& w) { w.size(1, 4097); } },
    { "longer than 16384", [](DescriptorWriter& w) { w.size(64, 257); } },
    { "report ID 0", [](DescriptorWriter& w) { w.reportId(0); } },
    { "report ID 256", [](DescriptorWriter& w) { w.item(1, 8, 256, 2); } },
    { "pop without", [](DescriptorWriter& w) { w.item(1, 11, 0, 0); } },
    { "ends before", [](DescriptorWriter& w) { w.usageRange(9, 8); } },
    { "ends before", [](DescriptorWriter& w) { w.item(2, 2, 8, 1).item(2, 1, 9, 1); } },
    { "has no beginning", [](DescriptorWriter& w) { w.item(2, 2, 8, 1); } },
    { "has no end", [](DescriptorWriter& w) { w.item(2, 1, 8, 1); } },
    { "4096 usages", [](DescriptorWriter& w) { w.usageRange(0, 4096); } },
    { "was not opened", [](DescriptorWriter& w) { w.end().end(); } },
    { "not closed", [](DescriptorWriter& w) { w.begin(); } },
    { "unknown kind", [](DescriptorWriter& w) { w.item(1, 15, 0, 0); } },
    { "16 pushes",
      [](DescriptorWriter& w)
      {
        for (int i = 0; i < 17; ++i)
        {
          w.item(1, 10, 0, 0);
        }
      } },
    { "32 deep",
      [](DescriptorWriter& w)
      {
        for (int i = 0; i < 33; ++i)
        {
          w.begin();
        }
      } },
    { "long item", [](DescriptorWriter& w) { w.item(3, 15, 0xFFFF, 2); } },
  };
  for (const auto& [reason, lie] : lies)
  {
    EXPECT_NE(problemOf(oneField(lie)).find(reason), std::string::npos) << problemOf(oneField(lie)) << " / " << reason;
  }
}

TEST(ReportDescriptor, WhatDescribesNothingOrGoesOnForeverIsRefused)
{
  EXPECT_NE(parseReportDescriptor({}).problem.find("no report"), std::string::npos);
  const std::vector<std::uint8_t> endless(16385, 0x04);
  EXPECT_NE(parseReportDescriptor(endless).problem.find("longer than 16384"), std::string::npos);
}

/// A field as the test draws it.
struct Drawn
{
  Kind kind;
  std::uint8_t id;
  std::uint32_t bit, bitCount, count;
  std::int64_t min, max;
  HidUsage firstUsage;
};

/// Random fields over random reports in random order, written down; the parser must return each as drawn.
TEST(ReportDescriptor, SaysOfRandomDescriptorsWhatWasWritten)
{
  test::Random random(test::testSeed(5101));
  const std::size_t cases = test::testCount(2000);
  for (std::size_t i = 0; i < cases; ++i)
  {
    DescriptorWriter writer;
    writer.page(1).usage(4).begin(1);
    std::vector<Drawn> drawn;
    std::array<std::array<std::uint32_t, 4>, 3> bits{};
    for (std::uint32_t f = 0; f < 1 + random.below(12); ++f)
    {
      const std::uint32_t kind = random.below(3), id = 1 + random.below(3);
      Drawn field{ static_cast<Kind>(kind), static_cast<std::uint8_t>(id), bits[kind][id], 1 + random.below(32),
        1 + random.below(5), 0, 0, 0x10000 + f };
      const std::int64_t top = std::int64_t{ 1 } << (field.bitCount - 1);
      field.min = random.below(2) == 0 ? 0 : -top;
      field.max = field.min < 0 ? top - 1 : 2 * top - 1;
      bits[kind][id] += field.bitCount * field.count;
      writer.reportId(field.id).logical(field.min, field.max).size(field.bitCount, field.count);
      writer.usage(static_cast<std::uint16_t>(f)).main(field.kind, value);
      drawn.push_back(field);
    }
    writer.end();
    const ReportDescriptor parsed = parseReportDescriptor(writer.bytes());
    ASSERT_EQ(parsed.problem, "");
    for (const Drawn& field : drawn)
    {
      const HidReport* report = test::reportWithId(parsed, field.kind, field.id);
      ASSERT_NE(report, nullptr);
      EXPECT_EQ(report->bits, bits[static_cast<std::size_t>(field.kind)][field.id]);
      const HidControl control = findControl(*report, field.firstUsage);
      ASSERT_TRUE(control);
      EXPECT_EQ(control.field->bit, field.bit);
      EXPECT_EQ(control.field->bitCount, field.bitCount);
      EXPECT_EQ(control.field->count, field.count);
      EXPECT_EQ(control.field->logicalMin, field.min);
      EXPECT_EQ(control.field->logicalMax, field.max);
    }
  }
}

/// Bit by bit, the slow way.
std::uint64_t bitByBit(const std::vector<std::uint8_t>& bytes, std::size_t bit, std::uint32_t bitCount)
{
  std::uint64_t found = 0;
  for (std::uint32_t i = 0; i < bitCount; ++i)
  {
    const std::size_t at = bit + i;
    found |= std::uint64_t{ (bytes[at / 8] >> (at % 8)) & 1U } << i;
  }
  return found;
}

TEST(ReportBits, InsertingAnywhereGivesTheValueBackAndTouchesNoOtherBit)
{
  test::Random random(test::testSeed(5102));
  const std::size_t cases = test::testCount(20000);
  for (std::size_t i = 0; i < cases; ++i)
  {
    std::vector<std::uint8_t> bytes(20);
    for (std::uint8_t& byte : bytes)
    {
      byte = static_cast<std::uint8_t>(random.below(256));
    }
    const std::vector<std::uint8_t> before = bytes;
    const std::uint32_t bitCount = 1 + random.below(64);
    const std::size_t bit = random.below(160 - bitCount + 1);
    const std::uint64_t mask = bitCount == 64 ? ~std::uint64_t{ 0 } : (std::uint64_t{ 1 } << bitCount) - 1;
    const std::uint64_t wanted = random.next();
    ASSERT_EQ(extractBits(bytes, bit, bitCount), bitByBit(bytes, bit, bitCount));
    insertBits(bytes, bit, bitCount, wanted);
    ASSERT_EQ(bitByBit(bytes, bit, bitCount), wanted & mask);
    insertBits(bytes, bit, bitCount, bitByBit(before, bit, bitCount));
    ASSERT_EQ(bytes, before);
  }
}

TEST(ReportBits, NegativeValuesComeBackWhereTheRangeHasThem)
{
  DescriptorWriter writer;
  writer.page(1).usage(4).begin(1).logical(-512, 511).size(10, 2).usages({ 0x30, 0x31 }).main(Kind::Input, value).end();
  const ReportDescriptor parsed = parseReportDescriptor(writer.bytes());
  const HidControl y = findControl(parsed.reports.at(0), 0x10031);
  for (std::int64_t wanted = -512; wanted <= 511; ++wanted)
  {
    std::vector<std::uint8_t> report(parsed.reports[0].bytes(), 0xFF);
    writeControl(y, report, wanted);
    ASSERT_EQ(readControl(y, report), wanted);
  }
}

TEST(ReportBits, ValuesAreCutToTheirRangeAndNoneIsWrittenAsItIs)
{
  DescriptorWriter writer;
  writer.page(0x0F).usage(0x21).begin(1).logical(1, 8).size(4).usage(0x53).main(Kind::Output, value).end();
  const ReportDescriptor parsed = parseReportDescriptor(writer.bytes());
  const HidControl trigger = findControl(parsed.reports.at(0), 0x0F0053);
  std::vector<std::uint8_t> report(2);
  writeControl(trigger, report, 99);
  EXPECT_EQ(readControl(trigger, report), 8);
  writeControl(trigger, report, -99);
  EXPECT_EQ(readControl(trigger, report), 1);
  writeRaw(trigger, report, 0);
  EXPECT_EQ(readControl(trigger, report), 0);
}

TEST(ReportBits, ShortReportsReadAsZeroBeyondTheirEndAndAreNotWrittenThere)
{
  std::vector<std::uint8_t> bytes{ 0xFF, 0xFF };
  EXPECT_EQ(extractBits(bytes, 12, 8), 0x0Fu);
  EXPECT_EQ(extractBits(bytes, 16, 8), 0u);
  insertBits(bytes, 12, 8, 0);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{ 0xFF, 0x0F }));
}

} // namespace
} // namespace palpate
