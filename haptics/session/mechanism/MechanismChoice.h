// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace palpate
{

struct MechanismInputs;

/// A mechanism that is to be felt.
struct MechanismChoice
{
  std::shared_ptr<const MechanismInputs> inputs; ///< null: none
  std::string name;
  double rate_Hz = 30.0; ///< snapshots of its soft bodies a second, or as many as can be made

  friend bool operator==(const MechanismChoice&, const MechanismChoice&) = default;
};

} // namespace palpate
