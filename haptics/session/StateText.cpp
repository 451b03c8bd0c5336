// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/StateText.h"

#include <cctype>

#include "haptics/core/Fault.h"
#include "haptics/session/settings/Setting.h"

namespace palpate
{
namespace
{

std::string asSentence(std::string text)
{
  const bool ended = text.empty() || text.back() == '.' || text.back() == '!';
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return ended ? text : text + ".";
}

const std::string& first(const std::string& one, const std::string& other)
{
  return one.empty() ? other : one;
}

} // namespace

std::string stateText(const SessionGlance& glance)
{
  const bool waits = glance.preparing && glance.touching && glance.engage != EngageState::Engaged;
  if (waits && (glance.fault.empty() || glance.fault == describe(Fault::SceneRefused)))
  {
    return "Preparing the visible data: the force starts when they are ready.";
  }
  const std::string& stops = first(glance.refusal, glance.fault);
  if (!stops.empty())
  {
    return "No force: " + asSentence(stops);
  }
  if (!glance.touching)
  {
    return glance.problem.empty() ? "Press Touch to touch the visible data." : asSentence(glance.problem);
  }
  const std::string& note = first(glance.warning, glance.problem);
  if (glance.engage == EngageState::Engaged)
  {
    const std::string touching =
      glance.limitedTo_N > 0.0 ? "Touching, force limited to " + quantity(glance.limitedTo_N, "N") + "." : "Touching.";
    return note.empty() ? touching : touching + " " + asSentence(note);
  }
  return note.empty() ? "Waiting: move the hand out of the data it overlaps, then the force starts."
                      : "No force: " + asSentence(note);
}

} // namespace palpate
