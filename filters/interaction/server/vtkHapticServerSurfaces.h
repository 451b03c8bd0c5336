// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticServerSurfaces_h
#define vtkHapticServerSurfaces_h

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "haptics/session/scene/FeltScene.h"
#include "vtkHapticInteractionModule.h" // for the export macro

namespace palpate
{
class HapticSession;
}

class vtkHapticSceneSurfaces;

/// The surfaces of a session that are on a server: wholes, and of those that are too large the part around the hand.
/// Callers that fetch surfaces ask here which parts are needed, and hand them over here.
class VTKHAPTICINTERACTION_EXPORT vtkHapticServerSurfaces
{
public:
  vtkHapticServerSurfaces(palpate::HapticSession& core, palpate::FeltScene& scene, vtkHapticSceneSurfaces& surfaces)
    : Core(core), Scene(scene), Surfaces(surfaces)
  {
  }

  /// Triangles up to which a surface is fetched whole, and the most of a part.
  void SetLimit(int limit) { this->Limit = limit; }
  [[nodiscard]] int GetLimit() const { return this->Limit; }

  /// Where a program holds the hand that nothing leads yet [u].
  void SetHand(const std::optional<palpate::Vec3>& hand_W) { this->Hand_W = hand_W; }
  /// Around where a part is to be; nothing while there is no hand.
  [[nodiscard]] std::optional<palpate::Vec3> GetCentre() const;
  /// How far it is to reach, so that the next is there before the hand is at its rim: as for fields, twice [u].
  [[nodiscard]] double GetReach() const;
  /// Whether the hand has used up half of its margin in the part that is there.
  [[nodiscard]] bool NeedsPart() const;

  ///@{
  /// Around a request: the servo lets go of a hand that waits too long for its answer.
  void BeginRequest();
  void EndRequest();
  ///@}

  /// The whole of surfaces that are added from now on, by number; 0: they are whole.
  void SetPartNumber(int number);
  /// The loaded parts of the next scene, and their text; "": no remote surface.
  void Take(const palpate::ScenePart& part, const std::string& sentence);

  [[nodiscard]] const std::string& GetSentence() const { return this->Sentence; }
  /// Age of the loaded part [s]; 0 without one.
  [[nodiscard]] double GetAge() const;

private:
  /// Distance from the hand to its contact, and reach of the proxy: the ball, or the tool [u].
  [[nodiscard]] double Pulled() const;

  palpate::HapticSession& Core;
  palpate::FeltScene& Scene;
  vtkHapticSceneSurfaces& Surfaces;
  std::optional<palpate::Vec3> Hand_W;
  palpate::ScenePart Part;
  std::string Sentence;
  std::chrono::steady_clock::time_point Taken{};
  std::uint64_t Requests = 0;
  int Limit = 100000;
};

#endif
