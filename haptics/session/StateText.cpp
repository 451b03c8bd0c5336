// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/StateText.h"

#include <cctype>

#include "haptics/core/Fault.h"
#include "haptics/session/settings/Setting.h"

namespace palpate
{
namespace
{

/// A name of a file or a source at the head of a text stays as it is written: it ends with a colon or has a dot in it.
bool beginsWithName(const std::string& text)
{
  const std::string word = text.substr(0, text.find(' '));
  return !word.empty() && (word.find('.') < word.size() - 1 || word.back() == ':');
}

std::string asSentence(std::string text)
{
  if (text.empty())
  {
    return text;
  }
  const bool ended = text.back() == '.' || text.back() == '!';
  const bool named = beginsWithName(text);
  text[0] = named ? text[0] : static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return ended ? text : text + ".";
}

const std::string& first(const std::string& one, const std::string& other)
{
  return one.empty() ? other : one;
}

} // namespace

std::string stateText(const SessionGlance& glance)
{
  const bool nothingLeft = glance.fault == describe(Fault::SceneRefused);
  const bool waits = glance.preparing && glance.touching && glance.engage != EngageState::Engaged;
  if (waits && (glance.fault.empty() || nothingLeft))
  {
    return "Preparing the visible data: the force starts when they are ready.";
  }
  const std::string& stops = first(glance.refusal, nothingLeft ? first(glance.refused, glance.fault) : glance.fault);
  if (!stops.empty())
  {
    return "No force: " + asSentence(stops);
  }
  if (!glance.touching)
  {
    const std::string& trouble = first(glance.problem, glance.damaged);
    const std::string limited = glance.limitedFrom_m > 0.0 ? " The force grows no more from a depth of " +
                                                               quantity(1e3 * glance.limitedFrom_m, "mm") + " on."
                                                           : "";
    return trouble.empty() ? "Press Touch to touch the visible data." + limited : asSentence(trouble);
  }
  const std::string& trouble = first(glance.warning, glance.problem);
  if (glance.engage == EngageState::Engaged)
  {
    const std::string& note = first(trouble, glance.damaged);
    const std::string touching =
      glance.limitedTo_N > 0.0 ? "Touching, force limited to " + quantity(glance.limitedTo_N, "N") + "." : "Touching.";
    return note.empty() ? touching : touching + " " + asSentence(note);
  }
  return trouble.empty() ? "Waiting: move the hand out of the data it overlaps, then the force starts."
                         : "No force: " + asSentence(trouble);
}

} // namespace palpate
