// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "testing/devices/hid/FirmwareModel.h"

namespace palpate::test
{

/// A model of a firmware that was just plugged in.
struct ModelCase
{
  std::string name;
  std::shared_ptr<FirmwareModel> model;
  std::vector<std::uint8_t> descriptor; ///< the real one where its licence lets us have it, else one with its ranges
  bool holds = false;                   ///< walls and dampers that push back
};
[[nodiscard]] std::vector<ModelCase> modelCases();

} // namespace palpate::test
