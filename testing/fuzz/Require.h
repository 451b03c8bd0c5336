// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

/// A broken requirement is a finding: the fuzzer keeps the bytes that led to it.
inline void require(bool holds)
{
  if (!holds)
  {
    std::abort();
  }
}
