// SPDX-License-Identifier: GPL-3.0-or-later
// palpate-soak [TICKS [SEED]]: one hand after the other, each for a million ticks on bad meshes and rough spheres, with
// and without friction. Says how it stands after each; exit code 1 when anything that must be 0 was not.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "testing/support/LongRun.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/SoupMaker.h"

namespace palpate::test
{
namespace
{

constexpr std::uint64_t ticksOfAHand = 1000000;

/// Every fourth surface is a rough sphere of 1 k to 100 k triangles, which has no defects; the others are bad meshes.
BadMesh surfaceOf(std::uint64_t round, Random& random)
{
  if (round % 4 != 3)
  {
    return makeBadMesh(random);
  }
  BadMesh made;
  made.clean = made.bad = NoisySphere(1000 + random.below(100000), 1.0).mesh();
  made.size_u = 100.0;
  made.edge_u = 100.0 / std::sqrt(static_cast<double>(made.clean.triangles.size()));
  return made;
}

RunFigures runRound(std::uint64_t round, std::uint64_t seed, std::uint64_t ticks)
{
  Random random(seed + 1000003 * round);
  const BadMesh made = surfaceOf(round, random);
  const JudgedMesh touched(cleanMesh(made.bad).mesh), shape(cleanMesh(made.clean).mesh);
  RunTask task = taskOn(made, touched, shape);
  const bool point = made.watertight && round % 5 == 0;
  task.plan.radius_u = point ? 0.0 : std::max(0.55 * made.gap_u, made.edge_u * random.uniform(0.01, 1.0));
  if (round % 2 == 1)
  {
    task.plan.friction = { 0.6, 0.4 };
  }
  task.inside = random.below(2) == 0;
  task.seed = random.next();
  LongRun run(task);
  if (run.placed())
  {
    run.run(ticks);
  }
  return run.figures();
}

int soak(std::uint64_t ticks, std::uint64_t seed)
{
  std::cout << "soak: " << ticks << " ticks, seed " << seed << std::endl;
  RunFigures all;
  for (std::uint64_t round = 0; all.ticks < ticks; ++round)
  {
    const RunFigures figures = runRound(round, seed, std::min(ticksOfAHand, ticks - all.ticks));
    if (!figures.clean())
    {
      std::cout << "hand " << round << ": " << figures.text() << "\n  " << figures.first << std::endl;
    }
    all += figures;
    std::cout << "after hand " << round << ": " << all.text() << std::endl;
  }
  std::cout << (all.clean() ? "soak: passed" : "soak: FAILED") << std::endl;
  return all.clean() ? 0 : 1;
}

} // namespace
} // namespace palpate::test

int main(int count, char** words)
{
  const std::uint64_t ticks = count > 1 ? std::strtoull(words[1], nullptr, 10) : 100000000;
  const std::uint64_t seed = count > 2 ? std::strtoull(words[2], nullptr, 10) : 2601;
  if (count > 3 || ticks == 0)
  {
    std::cerr << "usage: palpate-soak [TICKS [SEED]]\n";
    return 2;
  }
  try
  {
    return palpate::test::soak(ticks, seed);
  }
  catch (const std::exception& problem)
  {
    std::cerr << "palpate-soak: " << problem.what() << '\n';
    return 2;
  }
}
