// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Random.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace palpate::test
{
namespace
{

std::uint64_t numberFromEnvironment(const char* name, std::uint64_t otherwise)
{
  const char* text = std::getenv(name);
  if (text == nullptr)
  {
    return otherwise;
  }
  char* end = nullptr;
  const unsigned long long number = std::strtoull(text, &end, 10);
  if (end == text || *end != '\0')
  {
    throw std::invalid_argument(std::string(name) + "=" + text + " is not a whole number");
  }
  return number;
}

} // namespace

std::uint64_t Random::next() noexcept
{
  std::uint64_t z = (this->state_ += 0x9e3779b97f4a7c15ull);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

double Random::uniform() noexcept
{
  return static_cast<double>(this->next() >> 11) * 0x1p-53;
}

std::uint32_t Random::below(std::uint32_t count) noexcept
{
  return static_cast<std::uint32_t>(
    (static_cast<std::uint64_t>(static_cast<std::uint32_t>(this->next())) * count) >> 32);
}

Vec3 Random::inCube(double half) noexcept
{
  const double x = this->uniform(-half, half), y = this->uniform(-half, half);
  return { x, y, this->uniform(-half, half) };
}

Vec3 Random::direction() noexcept
{
  for (;;)
  {
    const Vec3 v = this->inCube(1.0);
    if (const double norm = v.norm(); norm <= 1.0 && norm > 0.1)
    {
      return v / norm;
    }
  }
}

std::uint64_t testSeed(std::uint64_t ownSeed)
{
  return numberFromEnvironment("PALPATE_TEST_SEED", ownSeed);
}

std::size_t testCount(std::size_t ownCount)
{
  return numberFromEnvironment("PALPATE_TEST_COUNT", ownCount);
}

std::size_t testMeshes(std::size_t ownCount)
{
  return numberFromEnvironment("PALPATE_TEST_MESHES", ownCount);
}

std::size_t testTriangles(std::size_t ownCount)
{
  return numberFromEnvironment("PALPATE_TEST_TRIANGLES", ownCount);
}

} // namespace palpate::test
