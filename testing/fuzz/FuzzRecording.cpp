// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a recording: refused with one sentence that names the file, or a recording whose parameters may be used
// and which begins without a history.
#include <cstdint>
#include <variant>
#include <vector>

#include "haptics/core/Checksum.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/inputs/Mechanisms.h"
#include "testing/fuzz/Require.h"
#include "testing/haptics/recording/RecordingChecks.h"

namespace
{

/// Whether a recording was read.
bool isReadWell(const std::vector<char>& bytes)
{
  const auto read = palpate::parseRecording(bytes, "the file");
  if (const auto* const problem = std::get_if<std::string>(&read))
  {
    require(problem->starts_with("the file ") && problem->find('\n') == std::string::npos);
    return false;
  }
  const auto& recording = std::get<palpate::Recording>(read);
  require(recording.parameters.validate().empty());
  require(recording.initialState.contact.count == 0 && recording.initialState.velocity.count == 0);
  require(palpate::isUsable(recording.initialState.mechanism));
  for (const palpate::RecordedMechanism& mechanism : recording.mechanisms)
  {
    require(mechanism.plan.held >= 0 && mechanism.plan.held < mechanism.plan.bodyCount);
    for (const palpate::RecordedMechanism::Body& body : mechanism.bodies)
    {
      require(body.body->snapshot->free_W.size() == body.body->snapshot->placeOf.size());
    }
  }
  for (const palpate::RecordedEntry& entry : recording.entries)
  {
    const auto* const change = std::get_if<palpate::RecordedChange>(&entry);
    require(change == nullptr || !change->parameters || change->parameters->validate().empty());
  }
  return true;
}

} // namespace

/// Hardly any bytes that a fuzzer makes up have the right checksums: those that have not come a second time with their
/// checksums repaired, so that all that stands behind them is met as well.
// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::vector<char> bytes(data, data + size);
  if (!isReadWell(bytes) && palpate::test::checkedChunksBegin(bytes) != 0)
  {
    palpate::test::repairChecks(bytes, palpate::crc32c);
    static_cast<void>(isReadWell(bytes));
  }
  return 0;
}
