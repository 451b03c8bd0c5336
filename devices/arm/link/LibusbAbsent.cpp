// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/link/FtdiPort.h"

namespace palpate
{

std::string ftdiAbsence()
{
  return "this build of the program has no libusb: install libusb-1.0-0-dev and build it again";
}

Outcome<std::unique_ptr<FtdiPort>> openFtdi(const std::string& /*path*/)
{
  return { nullptr, ftdiAbsence() };
}

} // namespace palpate
