// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/common/LinkNotes.h"

#include <system_error>

#include <cmath>

#include "haptics/core/Fault.h"

namespace palpate
{

std::string describeLink(const LinkReport& link)
{
  return std::to_string(std::lround(link.inputRate_Hz)) + " reports per second, " + std::to_string(link.restarts) +
         " effects renewed, " + std::to_string(link.stalls) + " stalls, " + std::to_string(link.losses) + " losses, " +
         std::to_string(link.strange) + " strange, " + std::to_string(link.outOfRange) + " out of range" +
         (link.attached ? "" : "; not attached") + (link.message.empty() ? "" : ": " + link.message);
}

std::string describeFailedWrite(const std::string& error)
{
  const std::string gone = std::make_error_code(std::errc::no_such_device).message();
  return error.find(gone) != std::string::npos ? "the cable was unplugged"
                                               : "the device rejects force commands: " + error;
}

namespace
{

/// Steps of a person are whole sentences.
std::string withoutStop(std::string text)
{
  if (text.ends_with('.'))
  {
    text.pop_back();
  }
  return text;
}

std::string describeLoss(const LinkReport& link)
{
  if (link.attached && !link.endedFor.empty())
  {
    const bool needsStep = !link.message.empty() && link.message != link.endedFor;
    return "the force has ended: " + link.endedFor + (needsStep ? ": " + withoutStop(link.message) : "") +
           "; then engage again";
  }
  const std::string& why = link.attached ? link.lostFor : link.message;
  if (why.empty())
  {
    return describe(Fault::DeviceLost);
  }
  if (!link.attached)
  {
    return "the device is lost: " + why + "; then engage again";
  }
  const std::string joint = link.message.ends_with('.') ? ": " : ", but ";
  const bool saysMore = !link.message.empty() && link.message != why;
  return "the device was lost: " + why + "; the device is attached again" +
         (saysMore ? joint + withoutStop(link.message) + ", then engage again" : ": engage again");
}

} // namespace

std::string describeFault(Fault fault, const LinkReport& link)
{
  const bool waits = fault == Fault::NoHand && !link.message.empty();
  return fault == Fault::DeviceLost ? describeLoss(link) : waits ? withoutStop(link.message) : describe(fault);
}

} // namespace palpate
