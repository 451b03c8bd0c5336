// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/Mechanism.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{

struct KnownKind
{
  const char* name;
  int rows;
};

/// In the order of ConstraintKind.
constexpr std::array kinds{ KnownKind{ "contact", 1 }, KnownKind{ "attachment", 3 }, KnownKind{ "hinge", 5 },
  KnownKind{ "slider", 4 }, KnownKind{ "break", 3 }, KnownKind{ "friction", 3 }, KnownKind{ "dry friction", 1 },
  KnownKind{ "spring", 1 }, KnownKind{ "limit", 2 }, KnownKind{ "puncture", 4 }, KnownKind{ "insertion", 4 } };

} // namespace

const char* nameOf(ConstraintKind kind) noexcept
{
  return kinds[static_cast<std::size_t>(kind)].name;
}

const char* nameOf(MechanismBodyKind kind) noexcept
{
  constexpr std::array names{ "held", "rigid", "soft", "world", "wire" };
  return names[static_cast<std::size_t>(kind)];
}

int mostRowsOf(ConstraintKind kind) noexcept
{
  return kinds[static_cast<std::size_t>(kind)].rows;
}

std::size_t countOf(const Mechanism& mechanism, MechanismBodyKind kind) noexcept
{
  return static_cast<std::size_t>(std::ranges::count(mechanism.bodies, kind, &MechanismBody::kind));
}

double foundFrictionOf(const Mechanism& mechanism, const MechanismBody& body) noexcept
{
  return body.friction.value_or(mechanism.foundFriction);
}

int roomForFound(const Mechanism& mechanism) noexcept
{
  const bool pairs = countOf(mechanism, MechanismBodyKind::Soft) > 1;
  const bool rubs = (pairs && mechanism.foundFriction > 0.0) ||
                    std::ranges::any_of(mechanism.bodies, [&](const MechanismBody& body)
                      { return body.mesh != nullptr && foundFrictionOf(mechanism, body) > 0.0; });
  int rows = Mechanism::mostRows;
  for (const MechanismConstraint& law : mechanism.laws)
  {
    rows -= mostRowsOf(law.kind);
  }
  const int each = mostRowsOf(rubs ? ConstraintKind::Friction : ConstraintKind::Contact);
  const int free = static_cast<int>(Mechanism::mostConstraints) - static_cast<int>(mechanism.laws.size());
  return std::max(0, std::min(rows / each, free));
}

} // namespace palpate
