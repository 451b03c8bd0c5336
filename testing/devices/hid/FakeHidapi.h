// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/devices/hid/FakeHidBus.h"

namespace palpate::test
{

/// The bus behind the functions of hidapi that FakeHidapi.cpp puts in the place of the library's, for as long as this
/// object lives. One at a time: a C interface has no other place for it.
class FakeHidapi
{
public:
  explicit FakeHidapi(FakeHidBus& bus) noexcept;
  ~FakeHidapi();
  FakeHidapi(const FakeHidapi&) = delete;
  FakeHidapi& operator=(const FakeHidapi&) = delete;
};

} // namespace palpate::test
