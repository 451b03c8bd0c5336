// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "devices/hid/report/ReportDescriptor.h"

namespace palpate::test
{

/// The first report of a kind with an ID, as firmware looks for it; null: there is none.
[[nodiscard]] inline const HidReport* reportWithId(
  const ReportDescriptor& descriptor, HidReportKind kind, std::uint8_t id)
{
  const auto found = std::find_if(descriptor.reports.begin(), descriptor.reports.end(),
    [&](const HidReport& report) { return report.kind == kind && report.id == id; });
  return found != descriptor.reports.end() ? &*found : nullptr;
}

} // namespace palpate::test
