// SPDX-License-Identifier: GPL-3.0-or-later
// A limp wire that slides round a drum: each corner raises its tension.
#include <cmath>
#include <numbers>

#include "testing/lab/Experiments.h"
#include "testing/support/WireCapstan.h"

namespace palpate::lab
{

void runCapstan(const Conditions&, Table& table)
{
  for (const double friction : { 0.1, 0.2, 0.4 })
  {
    const double belt = std::exp(friction * std::numbers::pi);
    double before = 10.0;
    for (const int bends : { 3, 6, 12 })
    {
      const double half = friction * std::tan(0.5 * std::numbers::pi / bends);
      const double truth = std::pow((1.0 + half) / (1.0 - half), bends);
      const std::string name = caseName({ { "friction", friction }, { "bends", bends } });
      const double ratio = test::capstanRatio(friction, bends);
      table.within({ name, "wire", "tension over that of the slack end" }, ratio, truth, 1e-6 * truth);
      table.atMost({ name, "wire", "off a belt's, over that of half the bends" }, (ratio - belt) / before, 0.3);
      table.atLeast({ name, "a belt's exponential", "off by" }, std::abs(belt / truth - 1.0), 1e-4);
      before = ratio - belt;
    }
  }
}

} // namespace palpate::lab
