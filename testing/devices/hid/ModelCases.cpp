// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/ModelCases.h"

#include "testing/devices/hid/AdaptFfbJoyModel.h"
#include "testing/devices/hid/ArduinoLibraryModel.h"
#include "testing/devices/hid/OpenFFBoardModel.h"
#include "testing/devices/hid/PidLayout.h"
#include "testing/devices/hid/RealDescriptors.h"
#include "testing/devices/hid/SunFfbModel.h"

namespace palpate::test
{
namespace
{

template<class Model>
ModelCase caseOf(const std::string& name, const std::vector<std::uint8_t>& descriptor, bool holds)
{
  return { name, std::make_shared<Model>(descriptor), descriptor, holds };
}

/// The ranges of SunFFB, with the numbers of reports that the models share.
PidLayout sunLayout()
{
  PidLayout layout = hobbyLayout();
  layout.name = "SunFFB";
  layout.wholeTurn = 36000;
  layout.sloppy = false;
  layout.effects.resize(11);
  return layout;
}

} // namespace

std::vector<ModelCase> modelCases()
{
  return { caseOf<OpenFFBoardModel>("OpenFFBoard", realDescriptor("openffboard-2axis").bytes, true),
    caseOf<SunFfbModel>("SunFFB", descriptorOf(sunLayout()), true),
    caseOf<AdaptFfbJoyModel>("adapt-ffb-joy 0.3.0", realDescriptor("adapt-ffb-joy-0.3.0-stick").bytes, false),
    caseOf<AdaptFfbJoyModel>("adapt-ffb-joy 0.5.0", realDescriptor("adapt-ffb-joy-0.5.0b1-stick").bytes, false),
    caseOf<ArduinoLibraryModel>("Arduino library", descriptorOf(hobbyLayout()), false) };
}

} // namespace palpate::test
