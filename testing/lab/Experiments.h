// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/lab/Experiment.h"

namespace palpate::lab
{

// One function per file of experiments/, in the order of a report (Experiments.cpp).

} // namespace palpate::lab
