// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "devices/arm/kit/Kits.h"
#include "devices/arm/kit/WoodenHapticsFile.h"
#include "devices/common/AttributeFile.h"

namespace palpate
{

ArmKit woodenHapticsKit(const std::shared_ptr<HidBus>& hid, const std::string& file)
{
  const std::string text = contentOf(file);
  Outcome<WiredArm> arm =
    !text.empty() ? readWoodenHapticsFile(text)
                  : Outcome<WiredArm>{ {}, "it is missing or empty: put the file that came with the arm there" };
  arm.value.wire = woodenHapticsWire();
  arm.problem = arm.ok() ? "" : "the arm's geometry cannot be read from " + file + ": " + arm.problem;
  ArmKit kit = wiredKit("woodenhaptics", arm, { hid });
  kit.setup.what = "WoodenHaptics or Polhem arm";
  return kit;
}

} // namespace palpate
