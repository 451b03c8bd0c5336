// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a report descriptor: refused with one sentence, or every control it names can be read and written within
// its report and gives back the value that was written.
#include <cstdint>
#include <vector>

#include "devices/hid/report/ReportBits.h"
#include "devices/hid/report/ReportDescriptor.h"
#include "testing/devices/hid/ReportWithId.h"
#include "testing/fuzz/Require.h"

namespace
{

void requireUsable(const palpate::HidReport& report, const palpate::HidField& field)
{
  require(field.bitCount >= 1 && field.bitCount <= 64 && field.count >= 1);
  require(field.bit + field.bitCount * field.count <= report.bits);
  require(field.logicalMin <= field.logicalMax && field.physicalMin <= field.physicalMax);
  require(!field.variable || field.usages.empty() || field.usages.size() == field.count);
  const palpate::HidControl last{ &report, &field, field.count - 1 };
  std::vector<std::uint8_t> bytes(report.bytes());
  palpate::writeControl(last, bytes, field.logicalMax);
  const bool fits = field.bitCount == 64 || field.logicalMax < (std::int64_t{ 1 } << (field.bitCount - 1));
  require(!fits || field.logicalMax < 0 || palpate::readControl(last, bytes) == field.logicalMax);
  for (const palpate::HidUsage usage : field.usages)
  {
    require(static_cast<bool>(palpate::findControl(report, usage)) &&
            static_cast<bool>(palpate::findSelector(report, usage)));
  }
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const palpate::ReportDescriptor parsed = palpate::parseReportDescriptor({ data, size });
  require(parsed.problem.empty() != parsed.reports.empty());
  require(parsed.problem.find('\n') == std::string::npos);
  for (const palpate::HidReport& report : parsed.reports)
  {
    require(palpate::test::reportWithId(parsed, report.kind, report.id) == &report);
    std::size_t checked = 0;
    for (const palpate::HidField& field : report.fields)
    {
      if (++checked > 64)
      {
        break; // a long report has thousands of fields, all made alike
      }
      requireUsable(report, field);
    }
  }
  return 0;
}
