// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/Experiments.h"

namespace palpate::lab
{

std::vector<Experiment> experiments()
{
  return {};
}

} // namespace palpate::lab
