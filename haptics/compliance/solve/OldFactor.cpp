// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/solve/OldFactor.h"

namespace palpate
{

OldFactorAnswer solveByOldFactor(
  const SparseLower& k, const SingleFactor& old, const Eigen::VectorXd& b, double share, int most)
{
  OldFactorAnswer answer{ Eigen::VectorXd::Zero(b.size()) };
  Eigen::VectorXd residual = b;
  Eigen::VectorXd z = old.solve(residual);
  Eigen::VectorXd way = z;
  double now = residual.dot(z);
  const double enough = share * share * now;
  answer.reached = now <= 0.0;
  while (!answer.reached && answer.iterations < most)
  {
    const Eigen::VectorXd answered = k.times(way);
    const double length = now / way.dot(answered);
    answer.x += length * way;
    residual -= length * answered;
    z = old.solve(residual);
    const double next = residual.dot(z);
    way = z + next / now * way;
    now = next;
    ++answer.iterations;
    answer.reached = now <= enough;
  }
  return answer;
}

} // namespace palpate
