// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <dlfcn.h>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "devices/arm/ArmDevice.h"
#include "devices/arm/kit/ArmKit.h"
#include "testing/devices/arm/ServoSide.h"

namespace palpate::test
{

/// The test's own functions of a made-up library.
template<class Function>
Function* fakeFunction(const char* library, const char* name)
{
  void* const open = dlopen(library, RTLD_NOW);
  return reinterpret_cast<Function*>(dlsym(open, name));
}

/// The first device of a kit.
struct LibraryRig : ServoSide
{
  explicit LibraryRig(ArmKit itsKit) : kit(std::move(itsKit)), kits{ kit }
  {
    EXPECT_EQ(this->found.size(), 1U);
    this->device.prove();
  }
  void run(int exchanges) { this->exchange(this->device, this->time, exchanges); }

  ModelTime time;
  ArmKit kit;
  std::vector<ArmKit> kits;
  std::vector<FoundArm> found = findArms(kits);
  ArmDevice device{ "arm", kit.bus, found.at(0).entry, kit.setup, { false, &time } };
};

} // namespace palpate::test
