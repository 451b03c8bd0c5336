// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/solve/ConstraintProblem.h"

namespace palpate
{

void ConstraintProblem::resize(int rows, int freeWays) noexcept
{
  this->count = rows;
  this->ways = freeWays;
  this->compliance.resize(rows, rows);
  this->free.resize(rows);
  this->lowest.resize(rows);
  this->highest.resize(rows);
  this->along.resize(rows, freeWays);
  this->load.resize(freeWays);
  this->turns.setZero(freeWays, freeWays);
}

} // namespace palpate
