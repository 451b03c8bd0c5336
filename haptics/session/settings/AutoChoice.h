// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate
{

/// A setting with an automatic choice by data and device, in the order of its choices.
enum class AutoChoice
{
  Auto,
  Off,
  On
};

} // namespace palpate
