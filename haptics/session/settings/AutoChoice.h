// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate
{

/// A setting that may be left to what is touched and the device, in the order of its choices.
enum class AutoChoice
{
  Auto,
  Off,
  On
};

} // namespace palpate
