// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace palpate
{

struct SoftBodyInput;

/// A soft body that is to be touched.
struct SoftChoice
{
  std::shared_ptr<const SoftBodyInput> input; ///< null: none
  std::string name;
  double rate_Hz = 30.0; ///< snapshots per second, or the highest rate that is possible

  friend bool operator==(const SoftChoice&, const SoftChoice&) = default;
};

} // namespace palpate
