// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/kit/Kits.h"
#include "devices/arm/kit/WireFile.h"

namespace palpate
{

WiredArm twoDiyArm()
{
  return wiredArmNamed("pantograph").value;
}

ArmKit twoDiyKit(const std::string& sys, FileAccess access)
{
  return wiredKit("2diy", { twoDiyArm(), {} }, { nullptr, sys, access });
}

} // namespace palpate
